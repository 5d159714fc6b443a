// OB1 and the subroutines, in the order of the method.
//
// The skeleton is the same for every chart and is that of Cordier, chapter V, network by network;
// what depends on the chart stands where he puts it. Two things are not as printed. SBR 1 clears 20
// words and not 40: Ta, Td, Tf1 and Tf0 end at VB79. And the tables are worked on in double words
// and words as far as they reach, so that the same functions serve wide tables.

#include <algorithm>
#include <utility>

#include "s7/generate/listing_build.h"
#include "s7/generate/messages.h"
#include "s7/make_instruction.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_generate;

/// The largest count of FILL and BMW.
constexpr std::uint32_t longest_count = 255;
constexpr std::int64_t all_ones = 0xffff;

bool is_memory(const Statement& statement) {
    return statement.kind == Statement::Kind::assign &&
           statement.targets[0].kind == BitKind::edge_memory;
}

bool reads(const Condition& condition, BitKind kind) {
    if (condition.kind == Condition::Kind::bit) return condition.bit.kind == kind;
    return std::any_of(condition.operands.begin(), condition.operands.end(),
                       [&](const Condition& operand) { return reads(operand, kind); });
}

}  // namespace

NetworkList ListingBuild::make_networks() {
    main_program();
    make_start();
    make_begin();
    subroutine(2, say::subroutine_2);
    make_plain(SectionKind::edges);
    subroutine(3, say::subroutine_3);
    make_plain(SectionKind::conditions);
    subroutine(4, say::subroutine_4);
    make_evolution();
    subroutine(5, say::subroutine_5);
    make_orders();
    subroutine(6, say::subroutine_6);
    make_plain(SectionKind::times);
    subroutine(8, say::subroutine_8);
    make_plain(SectionKind::outputs);
    make_pulse();
    return std::move(networks_);
}

void ListingBuild::main_program() {
    networks_.add(
        Part::skeleton, say::first_scan_only(),
        {make(Operation::load, {first_scan()}), make(Operation::call, {constant_operand(0)})});
    call(1, say::call_1());
    call(2, say::call_2());
    call(3, say::call_3());
    call(4, say::call_4());
    call(5, say::call_5());
    call(6, say::call_6());
    call(8, say::call_8());
    networks_.add(Part::skeleton, Localized(), {make(Operation::main_end)});
}

void ListingBuild::subroutine(int number, const Message<>& comment) {
    networks_.add(Part::skeleton, comment(),
                  {make(Operation::subroutine, {constant_operand(number)})});
}

void ListingBuild::call(int number, const Localized& comment) {
    networks_.add(
        Part::skeleton, comment,
        {make(Operation::load, {always_on()}), make(Operation::call, {constant_operand(number)})});
}

void ListingBuild::end_subroutine() {
    networks_.add(Part::skeleton, Localized(), {make(Operation::return_)});
}

void ListingBuild::nothing(const Message<>& comment) {
    networks_.add(Part::skeleton, comment(),
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
    networks_.add(Part::skeleton, say::no_graph_frozen(), std::move(freezing));
    std::vector<Instruction> clearing{make(Operation::load, {always_on()})};
    fill(0, layout.steps, layout.transitions + layout.transition_bytes - layout.steps, clearing);
    networks_.add(Part::skeleton, say::other_tables_cleared(), std::move(clearing));
}

void ListingBuild::formula(const Localized& comment, BitKind before, BitKind off, BitKind on,
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
    networks_.add(Part::skeleton, comment, std::move(work));
}

/// SBR 0: what the first scan begins with. The method keeps its bits in the V memory, which
/// outlives a stop of the controller; so everything that has to begin at 0 is put to 0 here.
/// Memories of edges are filled last, from inputs as they are: "le système est réputé stable depuis
/// longtemps" (Cordier, example 3).
void ListingBuild::make_start() {
    subroutine(0, say::subroutine_0);
    clear_tables();
    make_initial_steps();
    make_initialisation();
    end_subroutine();
}

void ListingBuild::make_initial_steps() {
    std::vector<Instruction> activation{make(Operation::load, {always_on()})};
    for (const Statement& statement : program_.section(SectionKind::start)) {
        if (statement.kind != Statement::Kind::set) continue;
        if (statement.targets[0].kind == BitKind::may_evolve) continue;  // FILL has done it
        for (const Bit bit : statement.targets) {
            activation.push_back(make(Operation::assign, {addresses_[bit]}));
        }
    }
    if (activation.size() == 1) {
        nothing(say::no_initial_steps);
    } else {
        networks_.add(Part::chart, say::initial_steps(), std::move(activation));
    }
}

/// Whether a memory is filled from a bit of that kind.
bool ListingBuild::start_reads(BitKind kind) const {
    const std::vector<Statement>& start = program_.section(SectionKind::start);
    return std::any_of(start.begin(), start.end(), [&](const Statement& statement) {
        return reads(statement.condition, kind);
    });
}

/// Bits whose first value is 0: vars, stored outputs, values of time conditions that are no bits of
/// timers, and edges where a memory is filled from one.
std::vector<Operand> ListingBuild::bits_to_clear() const {
    std::vector<Operand> bits;
    for (std::uint32_t v = 0; v < grafcet_.vars.size(); ++v) {
        bits.push_back(addresses_[Bit{BitKind::var, v}]);
    }
    for (std::uint32_t o = 0; o < grafcet_.outputs.size(); ++o) {
        if (grafcet_.outputs.items()[o].stored) bits.push_back(addresses_[Bit{BitKind::output, o}]);
    }
    for (std::uint32_t t = 0; t < timers_.size(); ++t) {
        if (timers_[t].timer_is_value()) continue;
        bits.push_back(addresses_[Bit{BitKind::time_value, t}]);
    }
    const std::vector<Statement>& start = program_.section(SectionKind::start);
    const bool reads_edges = std::any_of(
        start.begin(), start.end(),
        [](const Statement& statement) { return reads(statement.condition, BitKind::edge); });
    for (std::uint32_t e = 0; reads_edges && e < grafcet_.expressions.edges().size(); ++e) {
        bits.push_back(addresses_[Bit{BitKind::edge, e}]);
    }
    return bits;
}

void ListingBuild::make_initialisation() {
    const std::size_t networks_before = networks_.networks().size();
    std::vector<Instruction> clearing{make(Operation::load, {always_on()})};
    for (const BitRun& run : runs_of(bits_to_clear())) {
        clearing.push_back(make(Operation::reset, {run.first, constant_operand(run.count)}));
    }
    if (clearing.size() > 1) {
        networks_.add(Part::chart, say::memories_cleared(), std::move(clearing));
    }
    const std::vector<Statement>& start = program_.section(SectionKind::start);
    for (const Statement& statement : start) {
        if (statement.kind == Statement::Kind::move) write(statement);
    }
    // The document resets timers last; but a memory may be filled from one.
    const bool timers_first = start_reads(BitKind::time_value);
    if (timers_first) reset_timers();
    for (const Statement& statement : start) {
        if (is_memory(statement)) write(statement);
    }
    if (!timers_first) reset_timers();
    if (networks_.networks().size() == networks_before) {
        nothing(say::no_memories);
    }
}

void ListingBuild::reset_timers() {
    std::vector<Operand> used;
    for (const TimeConditionTimers& condition : timers_) {
        for (const auto& delay : {condition.on, condition.off}) {
            if (delay) used.push_back(timer_operand(static_cast<std::uint32_t>(delay->number)));
        }
    }
    if (used.empty()) return;
    std::vector<Instruction> resets{make(Operation::load, {always_on()})};
    for (const BitRun& run : runs_of(std::move(used))) {
        resets.push_back(make(Operation::reset, {run.first, constant_operand(run.count)}));
    }
    networks_.add(Part::chart, say::timers(), std::move(resets));
}

void ListingBuild::make_begin() {
    const TableLayout& layout = addresses_.layout();
    subroutine(1, say::subroutine_1);
    call(10, Localized::same_in_both("Tpulse"));
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
    networks_.add(Part::skeleton, Localized::same_in_both("Tp = Ts"), std::move(copying));
    std::vector<Instruction> clearing{make(Operation::load, {always_on()})};
    fill(0, layout.first_byte(BitKind::activate), 4 * layout.step_bytes, clearing);
    networks_.add(Part::skeleton, Localized::same_in_both("Ta = Td = Tf1 = Tf0 = 0"),
                  std::move(clearing));
    end_subroutine();
}

void ListingBuild::make_plain(SectionKind section) {
    for (const Statement& statement : program_.section(section)) write(statement);
    end_subroutine();
}

/// The transitions, Ts, then Init.
void ListingBuild::make_evolution() {
    const std::vector<Statement>& statements = program_.section(SectionKind::evolution);
    if (is_table(statements.front(), TableOperation::evolve)) nothing(say::no_transitions);
    for (const Statement& statement : statements) {
        if (is_table(statement, TableOperation::evolve)) {
            formula(say::formula_of_evolution(), BitKind::previous, BitKind::deactivate,
                    BitKind::activate, BitKind::step);
        } else {
            write(statement);
        }
    }
    end_subroutine();
}

/// Orders, Ts, enclosures, AUdur, Tpulse, and stored actions. The formula of forcing stands in
/// every program, as in the skeleton; where nothing is forced it leaves Ts as it is.
void ListingBuild::make_orders() {
    call(10, Localized::same_in_both("Tpulse"));
    const std::vector<Statement>& statements = program_.section(SectionKind::orders);
    const auto force = [&] {
        formula(say::formula_of_forcing(), BitKind::step, BitKind::forced_off, BitKind::forced_on,
                BitKind::step);
    };
    bool forces = false;
    for (const Statement& statement : statements) {
        forces = forces || is_table(statement, TableOperation::force);
    }
    if (!forces) {
        nothing(say::no_forcing_orders);
        force();
    }
    for (const Statement& statement : statements) {
        if (is_table(statement, TableOperation::force)) {
            force();
        } else if (is_table(statement, TableOperation::pulse)) {
            call(10, Localized::same_in_both("Tpulse"));
        } else {
            write(statement);
        }
    }
    make_plain(SectionKind::stored);
}

void ListingBuild::make_pulse() {
    subroutine(10, say::subroutine_10);
    formula(say::formula_of_pulse(), BitKind::step, BitKind::previous, BitKind::previous,
            BitKind::pulse);
    end_subroutine();
}

}  // namespace grafwire::s7
