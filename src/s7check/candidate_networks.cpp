// Which networks of a listing may have made a bit what it is: by what instructions read and write,
// and by what the machine recorded of its last scan. From the writer of the bit it goes on to what
// that network read and to who wrote that, two networks deep: a slice of the run, backwards (B.
// Korel, J. Laski, "Dynamic program slicing", Inf. Process. Lett. 29, 1988).
//
//     Network 12  LD V1.0  = V81.0      V81.0 is wrong: 12 wrote it, and read V1.0;
//     Network 7   LD E0.3  = V1.0       7 wrote that, and read an input, which is right
//
// Inputs and the tables of the method are not followed: the former are given, and the latter have
// been compared before (fault_localization.cpp). Where nothing wrote the bit in the last scan, the
// listing is searched instead for what could have.

#include "s7check/candidate_networks.h"

#include <algorithm>

#include "s7/instruction_set.h"
#include "s7check/method_tables.h"

namespace grafwire {

namespace {

using s7::Operand;
using s7::Operation;

/// How many bits an operand of that width has.
constexpr std::int64_t bits_in(s7::Width width) {
    switch (width) {
        case s7::Width::byte:
            return 8;
        case s7::Width::word:
            return 16;
        case s7::Width::dword:
            return 32;
        default:
            return 1;
    }
}

/// The bits of an area that an instruction writes, as a range.
struct WrittenBits {
    s7::Area area = s7::Area::constant;  ///< constant: none
    std::int64_t first = 0;
    std::int64_t end = 0;
};

/// The row of the instruction set says which operand is the place, and whether a count follows it:
/// `S V70.0 K4` writes four bits.
WrittenBits written_by(const s7::Instruction& instruction) {
    const s7::InstructionRow* row = s7::row_of(instruction.operation, instruction.width);
    if (row == nullptr) return {};
    std::int64_t count = 1;
    const s7::Operand* place = nullptr;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
        const s7::OperandKind kind = row->operands[i];
        if (kind == s7::OperandKind::place || kind == s7::OperandKind::place_bit ||
            kind == s7::OperandKind::reset_bit) {
            place = &instruction.operands[i];
        } else if (kind == s7::OperandKind::count) {
            count = instruction.operands[i].address;
        }
    }
    if (place == nullptr) return {};
    const std::int64_t first = std::int64_t{place->address} * 8 + place->bit;
    return {place->area, first, first + bits_in(place->width) * count};
}

/// Whether a network has a set instruction for a bit in some bytes of V.
bool sets_in(const s7::Network& network, CandidateNetworks::Bytes bytes) {
    return std::any_of(network.instructions.begin(), network.instructions.end(),
                       [&](const s7::Instruction& instruction) {
                           return instruction.operation == s7::Operation::set &&
                                  may_write_bytes(instruction, bytes.first, bytes.count);
                       });
}

constexpr CandidateNetworks::Bytes anywhere{0, 4096};  ///< all of V, of either CPU

}  // namespace

bool may_write(const s7::Instruction& instruction, const s7::Operand& place) {
    const WrittenBits written = written_by(instruction);
    const std::int64_t first = std::int64_t{place.address} * 8 + place.bit;
    return written.area == place.area && written.first < first + bits_in(place.width) &&
           written.end > first;
}

bool may_write_bytes(const s7::Instruction& instruction, std::int32_t first, std::int32_t count) {
    const WrittenBits written = written_by(instruction);
    return written.area == s7::Area::variable &&
           written.first < (std::int64_t{first} + count) * 8 &&
           written.end > std::int64_t{first} * 8;
}

bool loads(const s7::Instruction& instruction, const s7::Operand& bit) {
    switch (instruction.operation) {
        case Operation::load:
        case Operation::load_not:
        case Operation::and_:
        case Operation::and_not:
        case Operation::or_:
        case Operation::or_not:
            return instruction.operands[0] == bit;
        default:
            return false;
    }
}

Diagnosis CandidateNetworks::written(Diagnosis::Kind kind, std::string name, const Operand& place,
                                     bool expected) const {
    Diagnosis diagnosis;
    diagnosis.kind = kind;
    diagnosis.name = std::move(name);
    diagnosis.place = place;
    diagnosis.expected = expected;
    diagnosis.at = now_;
    const auto writer = machine_->writer(place);
    if (writer) {
        diagnosis.networks.push_back(number(writer->network));
        follow_reads(diagnosis, writer->network, 2);
        add_networks(diagnosis, jumps_over(writer->network), false);
    }
    // What may write the bit and has not done so in this scan comes next.
    if (!writer || !writer->in_last_scan) {
        diagnosis.should_have_written = !writer;
        add_networks(diagnosis, writers_of(place), false);
    }
    return diagnosis;
}

/// Puts networks before those found so far, in their order, or behind them.
void CandidateNetworks::add_networks(Diagnosis& diagnosis,
                                     const std::vector<std::uint32_t>& networks,
                                     bool in_front) const {
    std::vector<std::uint32_t> added;
    for (const std::uint32_t n : networks) added.push_back(number(n));
    std::vector<std::uint32_t>& all = diagnosis.networks;
    if (in_front) {
        std::erase_if(all, [&](std::uint32_t n) {
            return std::find(added.begin(), added.end(), n) != added.end();
        });
        all.insert(all.begin(), added.begin(), added.end());
        return;
    }
    for (const std::uint32_t n : added) {
        if (std::find(all.begin(), all.end(), n) == all.end()) all.push_back(n);
    }
}

void CandidateNetworks::put_first(Diagnosis& diagnosis,
                                  const std::vector<std::uint32_t>& networks) const {
    if (networks.empty()) return;
    add_networks(diagnosis, networks, true);
    diagnosis.should_have_written = true;
}

std::vector<std::uint32_t> CandidateNetworks::setters_for(const Operand& bit) const {
    auto networks =
        networks_where(listing_, [&](const auto& instruction) { return loads(instruction, bit); });
    std::erase_if(networks,
                  [&](std::uint32_t n) { return !sets_in(listing_.networks[n], anywhere); });
    return networks;
}

std::vector<std::uint32_t> CandidateNetworks::setters_for_step(std::size_t step,
                                                               Bytes bytes) const {
    const Operand& now = *binding_.steps[step];
    const Operand before = MethodTables::in(MethodTables::previous, now);
    const auto networks = networks_where(listing_, [&](const auto& instruction) {
        return loads(instruction, now) || loads(instruction, before);
    });
    for (const Bytes wanted : {bytes, anywhere}) {
        std::vector<std::uint32_t> setters;
        for (const std::uint32_t n : networks) {
            if (sets_in(listing_.networks[n], wanted)) setters.push_back(n);
        }
        if (!setters.empty()) return setters;
    }
    return {};
}

std::optional<bool> CandidateNetworks::read_as(const Operand& bit, std::uint32_t network) const {
    for (const s7::Machine::Read& read : reads_) {
        if (read.operand == bit && (network == no_network || read.network == network)) {
            return read.value;
        }
    }
    return std::nullopt;
}

std::vector<std::uint32_t> CandidateNetworks::runners_of(const Operand& timer) const {
    return networks_where(listing_, [&](const auto& instruction) {
        return instruction.operation == s7::Operation::on_delay && instruction.operands[0] == timer;
    });
}

std::vector<std::uint32_t> CandidateNetworks::silent_writers_of_ts() const {
    auto networks = networks_where(listing_, [&](const auto& instruction) {
        return instruction.operation == s7::Operation::move &&
               may_write_bytes(instruction, MethodTables::first_byte_of_ts, MethodTables::bytes);
    });
    std::erase_if(networks, [&](std::uint32_t n) { return machine_->wrote_in_last_scan(n); });
    return networks;
}

/// The networks that write a place in some scan, if not in the last.
std::vector<std::uint32_t> CandidateNetworks::writers_of(const Operand& place) const {
    return networks_where(listing_,
                          [&](const auto& instruction) { return may_write(instruction, place); });
}

/// The networks with a jump from before a network to behind it, in the same block.
std::vector<std::uint32_t> CandidateNetworks::jumps_over(std::uint32_t network) const {
    std::vector<std::uint32_t> networks;
    for (const s7::Outline::Block& block : outline_.blocks) {
        for (std::size_t line = block.first; line < block.end; ++line) {
            const s7::Instruction& instruction = outline_.at(line);
            if (instruction.operation != s7::Operation::jump) continue;
            const std::size_t target = block.labels.at(instruction.operands[0].address);
            if (outline_.lines[line].network < network &&
                outline_.lines[target].network > network) {
                networks.push_back(outline_.lines[line].network);
            }
        }
    }
    return networks;
}

/// Whether what a bit should be is known: it is an input, or was compared with the reference.
bool CandidateNetworks::is_told_by_the_tables(const Operand& place) const {
    if (place.area == s7::Area::input || place.area == s7::Area::special) return true;
    for (const auto* list : {&binding_.steps, &binding_.transitions, &binding_.graphs}) {
        if (std::find(list->begin(), list->end(), place) != list->end()) return true;
    }
    return false;
}

/// What a network read in this scan besides inputs and tables, and who had written that.
void CandidateNetworks::follow_reads(Diagnosis& diagnosis, std::uint32_t network, int depth) const {
    if (depth == 0) return;
    for (const s7::Machine::Read& read : reads_) {
        if (read.network != network || is_told_by_the_tables(read.operand)) continue;
        const bool is_known = std::any_of(
            diagnosis.reads.begin(), diagnosis.reads.end(), [&](const Diagnosis::Read& other) {
                return other.place == read.operand && other.network == number(network);
            });
        if (is_known) continue;
        Diagnosis::Read told{number(network), read.operand, read.value, std::nullopt};
        if (read.writer) told.writer = number(read.writer->network);
        diagnosis.reads.push_back(told);
        if (read.writer) {
            add_networks(diagnosis, {read.writer->network}, false);
            follow_reads(diagnosis, read.writer->network, depth - 1);
        }
        add_networks(diagnosis, writers_of(read.operand), false);
    }
}

}  // namespace grafwire
