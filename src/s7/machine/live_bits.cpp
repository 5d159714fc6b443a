// Which memory bits are alive when a scan begins, by data-flow analysis (Aho, Lam, Sethi, Ullman,
// "Compilers", section 9.2.5), backwards over the flow of control of each block. A block is summed
// up by two sets: `reads`, what may be read in it before it is written, and `writes`, what is
// written on every way through it. A subroutine is summed up before its callers, and there is no
// recursion.
//
// Most of what a listing writes it writes under a condition, and a write that may not happen keeps
// nothing dead. But the condition is mostly `LD SM0.0`, and in subroutines the 1 that CALL leaves
// on the stack: an analysis forwards finds where the top of the stack is 1 in any case.
//
// With B the bits observed after a scan, those alive at its start are reads + (B + alive) - writes,
// the least solution of which is reads + (B - writes).

#include "s7/machine/live_bits.h"

#include <algorithm>
#include <optional>

namespace grafwire::s7 {

namespace {

/// A set of memory bits, eight to the byte.
using BitSet = std::vector<std::uint8_t>;

void unite(BitSet& a, const BitSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<std::uint8_t>(a[i] | b[i]);
}

void subtract(BitSet& a, const BitSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<std::uint8_t>(a[i] & ~b[i]);
}

void intersect(BitSet& a, const BitSet& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = static_cast<std::uint8_t>(a[i] & b[i]);
}

void add_bits(BitSet& set, std::size_t first, std::size_t count) {
    for (std::size_t bit = first; bit < first + count; ++bit) {
        set[bit / 8] = static_cast<std::uint8_t>(set[bit / 8] | 1U << bit % 8);
    }
}

struct Summary {
    BitSet reads;
    BitSet writes;
};

class LiveBits {
  public:
    explicit LiveBits(const Decoded& program)
        : program_(program), summaries_(program.blocks.size()) {}

    const Summary& summary_of(std::size_t block) {
        if (!summaries_[block]) summaries_[block] = sum_up(block);
        return *summaries_[block];
    }

  private:
    BitSet nothing() const { return BitSet(program_.layout.bytes, 0); }

    std::size_t block_at(std::size_t line) const {
        std::size_t block = 0;
        while (program_.blocks[block].first != line) ++block;
        return block;
    }

    bool is_always_one(const Place& place) const {
        return place.kind == Place::Kind::memory && place.bit == 0 &&
               place.at == program_.layout.byte_of(Area::special, 0);
    }

    /// Whether the top of the stack is 1 after an instruction in any case, given that before it.
    bool top_is_one_after(const DecodedInstruction& now, bool before) const {
        switch (now.operation) {
            case Operation::load:
                return is_always_one(now.operands[0]);
            case Operation::and_:
                return before && is_always_one(now.operands[0]);
            case Operation::or_:
                return before || is_always_one(now.operands[0]);
            case Operation::load_not:
            case Operation::load_compare:
            case Operation::and_not:
            case Operation::and_compare:
            case Operation::and_load:
            case Operation::or_load:
            case Operation::read_push:
            case Operation::pop:
            case Operation::negate:
            case Operation::rise:
            case Operation::fall:
                return false;
            default:
                return before;
        }
    }

    /// Where control can go from an instruction of a block; empty where the block ends.
    std::vector<std::size_t> next_of(std::size_t at, bool top_is_one) const {
        const DecodedInstruction& now = program_.code[at];
        switch (now.operation) {
            case Operation::return_:
            case Operation::main_end:
                return {};
            case Operation::jump:
                if (top_is_one) return {now.target};
                return {at + 1, now.target};
            default:
                return {at + 1};
        }
    }

    /// Whether the block may end at an instruction.
    bool may_end(std::size_t at) const {
        switch (program_.code[at].operation) {
            case Operation::return_:
            case Operation::main_end:
            case Operation::conditional_return:
            case Operation::end:
                return true;
            default:
                return false;
        }
    }

    /// Per instruction of a block whether the top of the stack is 1 before it in any case. Starts
    /// from the assumption that it is, and takes back what does not follow.
    std::vector<bool> tops_of(std::size_t block) const {
        const auto [first, end] = program_.blocks[block];
        std::vector<bool> tops(end - first, true);
        tops[0] = block != 0;
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t at = first; at < end; ++at) {
                const bool after = top_is_one_after(program_.code[at], tops[at - first]);
                if (after) continue;
                for (const std::size_t next : next_of(at, tops[at - first])) {
                    if (!tops[next - first]) continue;
                    tops[next - first] = false;
                    changed = true;
                }
            }
        }
        return tops;
    }

    void add_place(BitSet& set, const Place& place, Width width, std::size_t count = 1) const {
        if (place.kind != Place::Kind::memory) return;
        const std::size_t bits = width == Width::bit ? 1 : 8 * bytes_of(width);
        add_bits(set, place.at * 8 + (width == Width::bit ? place.bit : 0), bits * count);
    }

    /// What an instruction reads, and what it writes for certain.
    void effect(const DecodedInstruction& now, bool top_is_one, Summary& sum) {
        const auto& [first, second] = now.operands;
        const std::size_t in_block = std::max<std::size_t>(now.count, 1);
        switch (now.operation) {
            case Operation::assign:
                add_place(sum.writes, first, Width::bit);
                return;
            case Operation::set:
            case Operation::reset:
                if (top_is_one) add_place(sum.writes, first, Width::bit, in_block);
                return;
            case Operation::move:
                add_place(sum.reads, first, now.width);
                if (top_is_one) add_place(sum.writes, second, now.width);
                return;
            case Operation::block_move:
                add_place(sum.reads, first, now.width, in_block);
                if (top_is_one) add_place(sum.writes, second, now.width, in_block);
                return;
            case Operation::fill:
                add_place(sum.reads, first, now.width);
                if (top_is_one) add_place(sum.writes, second, now.width, in_block);
                return;
            case Operation::on_delay:
            case Operation::retentive_on_delay:
            case Operation::count_up:
            case Operation::count_up_down:
                add_place(sum.reads, second, Width::word);
                return;
            case Operation::call: {
                const Summary& called = summary_of(block_at(now.target));
                sum.reads = called.reads;
                if (top_is_one) sum.writes = called.writes;
                return;
            }
            default:
                // Logic, and work on words whose place is read too.
                add_place(sum.reads, first, now.width);
                add_place(sum.reads, second, now.width);
                return;
        }
    }

    Summary sum_up(std::size_t block) {
        const auto [first, end] = program_.blocks[block];
        const std::vector<bool> tops = tops_of(block);
        std::vector<Summary> effects(end - first, {nothing(), nothing()});
        std::vector<Summary> sums(end - first, {nothing(), BitSet(program_.layout.bytes, 0xff)});
        for (std::size_t at = first; at < end; ++at) {
            effect(program_.code[at], tops[at - first], effects[at - first]);
        }
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t at = end; at-- > first;) {
                Summary sum{nothing(), BitSet(program_.layout.bytes,
                                              static_cast<std::uint8_t>(may_end(at) ? 0 : 0xff))};
                for (const std::size_t next : next_of(at, tops[at - first])) {
                    unite(sum.reads, sums[next - first].reads);
                    intersect(sum.writes, sums[next - first].writes);
                }
                subtract(sum.reads, effects[at - first].writes);
                unite(sum.reads, effects[at - first].reads);
                unite(sum.writes, effects[at - first].writes);
                Summary& known = sums[at - first];
                if (known.reads == sum.reads && known.writes == sum.writes) continue;
                known = std::move(sum);
                changed = true;
            }
        }
        return sums[0];
    }

    const Decoded& program_;
    std::vector<std::optional<Summary>> summaries_;
};

}  // namespace

std::vector<std::uint8_t> live_bits(const Decoded& program, const std::vector<Operand>& observed) {
    const Summary scan = LiveBits(program).summary_of(0);
    BitSet live(program.layout.bytes, 0);
    for (const Operand& operand : observed) {
        const Place place = program.place_of(operand);
        if (place.kind != Place::Kind::memory) continue;
        const bool is_bit = operand.width == Width::bit;
        add_bits(live, place.at * 8 + (is_bit ? place.bit : 0),
                 is_bit ? 1 : 8 * bytes_of(operand.width));
    }
    subtract(live, scan.writes);
    unite(live, scan.reads);
    const std::size_t inputs = program.layout.byte_of(Area::input, 0);
    const std::size_t outputs = program.layout.byte_of(Area::output, 0);
    std::fill(live.begin() + static_cast<std::ptrdiff_t>(inputs),
              live.begin() + static_cast<std::ptrdiff_t>(outputs), std::uint8_t{0});
    live[program.layout.byte_of(Area::special, 0)] = 0;
    return live;
}

}  // namespace grafwire::s7
