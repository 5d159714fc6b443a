// SBR 0: what the first scan begins with.
//
// The method keeps its bits in the V memory, which outlives a stop of the controller; so everything
// that has to begin at 0 is put to 0 here. Memories of edges are filled last, from inputs as they
// are: "le système est réputé stable depuis longtemps" (Cordier, example 3).

#include <algorithm>

#include "s7/generate/listing_build.h"
#include "s7/make_instruction.h"

namespace grafwire::s7 {

namespace {

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

void ListingBuild::make_start() {
    subroutine(0, "SBR 0: initialisation");
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
        nothing("There are no initial steps");
    } else {
        networks_.add(Part::chart, "Initial steps", std::move(activation));
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
    const Grafcet& grafcet = *program_.grafcet;
    std::vector<Operand> bits;
    for (std::uint32_t v = 0; v < grafcet.vars.size(); ++v) {
        bits.push_back(addresses_[Bit{BitKind::var, v}]);
    }
    for (std::uint32_t o = 0; o < grafcet.outputs.size(); ++o) {
        if (grafcet.outputs.items()[o].stored) bits.push_back(addresses_[Bit{BitKind::output, o}]);
    }
    for (std::uint32_t t = 0; t < timers_.size(); ++t) {
        if (timers_[t].timer_is_value()) continue;
        bits.push_back(addresses_[Bit{BitKind::time_value, t}]);
    }
    const std::vector<Statement>& start = program_.section(SectionKind::start);
    const bool reads_edges = std::any_of(
        start.begin(), start.end(),
        [](const Statement& statement) { return reads(statement.condition, BitKind::edge); });
    for (std::uint32_t e = 0; reads_edges && e < grafcet.expressions.edges().size(); ++e) {
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
        networks_.add(Part::chart, "Memories of the chart = 0", std::move(clearing));
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
        nothing("There are no memories, counters and timers");
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
    networks_.add(Part::chart, "Timers", std::move(resets));
}

}  // namespace grafwire::s7
