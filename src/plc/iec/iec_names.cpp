#include "plc/iec/iec_names.h"

#include <fmt/format.h>

#include "grafcet/write_grafcet.h"
#include "iec/keywords.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"
#include "program/bit_names.h"

namespace grafwire {

namespace {

/// The array of a table; empty where the bits have names of their own.
std::string_view array_name(BitKind kind) {
    // Tp would be the standard function block TP.
    return kind == BitKind::previous ? "Tprev" : table_name(kind);
}

}  // namespace

std::string iec_comment(std::string_view text) {
    std::string comment = "(* ";
    for (const char c : comment_text(text)) {
        const char before = comment.back();
        if ((before == '*' && c == ')') || (before == '(' && c == '*')) comment.push_back(' ');
        comment.push_back(c);
    }
    return comment + " *)";
}

IecTimer iec_timer_for(Time on_delay, Time off_delay) {
    if (on_delay == 0) return off_delay == 0 ? IecTimer::copy : IecTimer::tof;
    return off_delay == 0 ? IecTimer::ton : IecTimer::latch;
}

IecNames::IecNames(const Grafcet& grafcet, const ScanProgram& program)
    : grafcet_(grafcet), program_(program), names_(false, iec::is_keyword) {
    claim_interface();
    claim_tables();
    claim_edges();
    claim_times();
    for (std::uint32_t i = 0; i < program.scratch_bits; ++i) {
        names_of(BitKind::scratch).push_back(names_.claim(fmt::format("held_{}", i)));
    }
    for (std::uint32_t i = 0; i < program.scratch_integers; ++i) {
        scratch_integers_.push_back(names_.claim(fmt::format("held_value_{}", i)));
    }
}

std::string IecNames::claim(const std::string& wanted, const std::string& original) {
    const std::string name = names_.claim(wanted);
    if (name != original) changed_.emplace_back(name, original);
    return name;
}

std::string IecNames::claim(const std::string& original) {
    return claim(original, original);
}

void IecNames::claim_interface() {
    for (const Input& input : grafcet_.inputs)
        names_of(BitKind::input).push_back(claim(input.name));
    for (std::size_t c = 0; c < control_input_count; ++c) {
        if (!program_.has_modes) break;
        names_of(BitKind::control)
            .push_back(claim(std::string(input_name(grafcet_, grafcet_.inputs.size() + c))));
    }
    for (const Output& output : grafcet_.outputs)
        names_of(BitKind::output).push_back(claim(output.name));
    for (const Var& var : grafcet_.vars) names_of(BitKind::var).push_back(claim(var.name));
    for (const Counter& counter : grafcet_.counters) counters_.push_back(claim(counter.name));
    block = claim(grafcet_.name);
}

void IecNames::claim_tables() {
    for (std::size_t kind = 0; kind < bit_kind_count; ++kind) {
        const std::string_view word = array_name(static_cast<BitKind>(kind));
        if (!word.empty()) tables_[kind] = names_.claim(word);
    }
    started = names_.claim("started");
    any = names_.claim("i");
    for (const Step& step : grafcet_.steps) {
        steps_.push_back(claim("X" + step.name, "X" + step.name));
    }
    for (const Transition& transition : grafcet_.transitions) {
        const std::string name = names_.claim("T" + transition.name);
        if (name != "T" + transition.name) changed_.emplace_back(name, "(" + transition.name + ")");
        transitions_.push_back(name);
    }
    if (!uses(program_, BitKind::may_evolve)) return;
    for (const Graph& graph : grafcet_.graphs) graphs_.push_back(claim(graph.name));
}

std::string IecNames::operand_word(ExprId operand, std::size_t number) const {
    const Expressions& pool = grafcet_.expressions;
    if (pool.kind(operand) != ExprKind::variable) return fmt::format("{}", number);
    return variable_name(grafcet_, pool.variable_of(operand));
}

void IecNames::claim_edges() {
    const Expressions& pool = grafcet_.expressions;
    for (std::size_t i = 0; i < pool.edges().size(); ++i) {
        const ExprId edge = pool.edges()[i];
        const std::string word = (pool.kind(edge) == ExprKind::rise ? "rise_" : "fall_") +
                                 operand_word(pool.operands(edge).front(), i);
        names_of(BitKind::edge).push_back(names_.claim(word));
        names_of(BitKind::edge_memory).push_back(names_.claim(word + "_memory"));
    }
}

void IecNames::claim_times() {
    const Expressions& pool = grafcet_.expressions;
    for (std::size_t i = 0; i < pool.time_conditions().size(); ++i) {
        const TimeCondition& time = pool.time_condition_of(pool.time_conditions()[i]);
        std::string word = operand_word(time.operand, i);
        if (time.on_delay != 0) word = format_duration(time.on_delay) + "_" + word;
        if (time.off_delay != 0) word += "_" + format_duration(time.off_delay);
        const IecTimer timer = iec_timer_for(time.on_delay, time.off_delay);
        const bool on = timer == IecTimer::ton || timer == IecTimer::latch;
        const bool off = timer == IecTimer::tof || timer == IecTimer::latch;
        const bool own = timer == IecTimer::copy || timer == IecTimer::latch;
        on_timers_.push_back(on ? names_.claim("on_" + word) : "");
        off_timers_.push_back(off ? names_.claim("off_" + word) : "");
        names_of(BitKind::time_value)
            .push_back(own  ? names_.claim("time_" + word)
                       : on ? on_timers_.back() + ".Q"
                            : off_timers_.back() + ".Q");
    }
}

const std::string& IecNames::index_of(Bit bit) const {
    if (bit.kind == BitKind::transition) return transitions_[bit.index];
    if (bit.kind == BitKind::may_evolve) return graphs_[bit.index];
    return steps_[bit.index];
}

std::string IecNames::of(Bit bit) const {
    const std::string& array = table(bit.kind);
    if (!array.empty()) return fmt::format("{}[{}]", array, index_of(bit));
    return bits_[static_cast<std::size_t>(bit.kind)][bit.index];
}

std::string IecNames::of(IntegerCell cell) const {
    return cell.is_scratch ? scratch_integers_[cell.index] : counters_[cell.index];
}

}  // namespace grafwire
