// The skeleton: what is the same for every chart (Cordier, chapter V), network by network.
//
// Two things are not as printed. SBR 1 clears 20 words and not 40: Ta, Td, Tf1 and Tf0 end at VB79.
// And the tables are worked on in double words and words as far as they reach, so that the same
// functions serve wide tables.

#include <algorithm>
#include <utility>

#include "s7/generate/listing_build.h"
#include "s7/make_instruction.h"

namespace grafwire::s7 {

namespace {

/// The largest count of FILL and BMW.
constexpr std::uint32_t longest_count = 255;
constexpr std::int64_t all_ones = 0xffff;

}  // namespace

void ListingBuild::main_program() {
    networks_.add(
        Part::skeleton, "First scan only: SBR 0, initialisation",
        {make(Operation::load, {first_scan()}), make(Operation::call, {constant_operand(0)})});
    call(1, "Tables of the scan before");
    call(2, "Preliminary calculations");
    call(3, "Receptivities of the transitions");
    call(4, "Evolution");
    call(5, "Forcing");
    call(6, "Timers and counters");
    call(8, "Outputs");
    networks_.add(Part::skeleton, "", {make(Operation::main_end)});
}

void ListingBuild::subroutine(int number, std::string comment) {
    networks_.add(Part::skeleton, std::move(comment),
                  {make(Operation::subroutine, {constant_operand(number)})});
}

void ListingBuild::call(int number, std::string comment) {
    networks_.add(
        Part::skeleton, std::move(comment),
        {make(Operation::load, {always_on()}), make(Operation::call, {constant_operand(number)})});
}

void ListingBuild::end_subroutine() {
    networks_.add(Part::skeleton, "", {make(Operation::return_)});
}

void ListingBuild::nothing(std::string comment) {
    networks_.add(Part::skeleton, std::move(comment),
                  {make(Operation::no_operation, {constant_operand(0)})});
}

void ListingBuild::fill(std::int64_t value, std::uint32_t first, std::uint32_t bytes,
                        std::vector<Instruction>& out) const {
    for (std::uint32_t words = bytes / 2; words != 0;) {
        const std::uint32_t count = std::min(words, longest_count);
        out.push_back(
            make(Operation::fill, Width::word,
                 {constant_operand(value), v_word(Width::word, first), constant_operand(count)}));
        first += 2 * count;
        words -= count;
    }
}

void ListingBuild::clear_tables() {
    const TableLayout& layout = addresses_.layout();
    std::vector<Instruction> freezing{make(Operation::load, {always_on()})};
    // The document has one word of graphs; FILL does for any number.
    fill(all_ones, layout.graphs, layout.graph_bytes, freezing);
    networks_.add(Part::skeleton, "Tfig = 1: no graph is frozen", std::move(freezing));
    std::vector<Instruction> clearing{make(Operation::load, {always_on()})};
    fill(0, layout.steps, layout.transitions + layout.transition_bytes - layout.steps, clearing);
    networks_.add(Part::skeleton, "All other tables = 0", std::move(clearing));
}

void ListingBuild::make_begin() {
    const TableLayout& layout = addresses_.layout();
    subroutine(1, "SBR 1: tables of the scan before");
    call(10, "Tpulse");
    std::vector<Instruction> copying{make(Operation::load, {always_on()})};
    std::uint32_t done = 0;
    for (std::uint32_t words = layout.step_bytes / 2; words != 0;) {
        const std::uint32_t count = std::min(words, longest_count);
        copying.push_back(make(Operation::block_move, Width::word,
                               {v_word(Width::word, layout.first_byte(BitKind::step) + done),
                                v_word(Width::word, layout.first_byte(BitKind::previous) + done),
                                constant_operand(count)}));
        done += 2 * count;
        words -= count;
    }
    networks_.add(Part::skeleton, "Tp = Ts", std::move(copying));
    std::vector<Instruction> clearing{make(Operation::load, {always_on()})};
    fill(0, layout.first_byte(BitKind::activate), 4 * layout.step_bytes, clearing);
    networks_.add(Part::skeleton, "Ta = Td = Tf1 = Tf0 = 0", std::move(clearing));
    end_subroutine();
}

void ListingBuild::formula(std::string comment, BitKind before, BitKind off, BitKind on,
                           BitKind target) {
    const TableLayout& layout = addresses_.layout();
    std::vector<Instruction> work{make(Operation::load, {always_on()})};
    for (std::uint32_t done = 0; done < layout.step_bytes;) {
        const Width width = layout.step_bytes - done >= 4 ? Width::dword : Width::word;
        const auto part_of = [&](BitKind table) {
            return v_word(width, layout.first_byte(table) + done);
        };
        const Operand accumulator = v_word(width, 2);
        work.push_back(make(Operation::move, width, {part_of(off), accumulator}));
        work.push_back(make(Operation::invert, width, {accumulator}));
        work.push_back(make(Operation::and_words, width, {part_of(before), accumulator}));
        if (on != off) work.push_back(make(Operation::or_words, width, {part_of(on), accumulator}));
        work.push_back(make(Operation::move, width, {accumulator, part_of(target)}));
        done += width == Width::dword ? 4 : 2;
    }
    networks_.add(Part::skeleton, std::move(comment), std::move(work));
}

void ListingBuild::make_pulse() {
    subroutine(10, "SBR 10: Tpulse, the steps that have become active");
    formula("Tpulse = Ts and not Tp", BitKind::step, BitKind::previous, BitKind::previous,
            BitKind::pulse);
    end_subroutine();
}

}  // namespace grafwire::s7
