#include "plc/shared/program_names.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

/// A short name for an edge or a time condition: `↑dcy` gives `rise_dcy`. Its text stands beside it
/// in the program; the name need not hold all of it.
std::string word_of(const std::string& text) {
    constexpr std::size_t longest = 32;
    std::string spelt;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, 3, "↑") == 0) {
            spelt += " rise ";
            at += 3;
        } else if (text.compare(at, 3, "↓") == 0) {
            spelt += " fall ";
            at += 3;
        } else {
            spelt += text[at++];
        }
    }
    std::string word = ascii_word(spelt);
    if (word.size() > longest) word.resize(word.find_last_not_of('_', longest - 1) + 1);
    return word;
}

}  // namespace

ProgramNames::ProgramNames(const ScanProgram& program, const NameRules& rules)
    : program_(program), rules_(rules) {
    name_chart();
    name_inputs();
    name_parts();
    name_expressions();
    for (std::uint32_t i = 0; i < program.scratch_bits; ++i) {
        scratch_bits_.push_back(fmt::format("S{}", i));
    }
    for (std::uint32_t i = 0; i < program.scratch_integers; ++i) {
        scratch_integers_.push_back(fmt::format("I{}", i));
    }
}

void ProgramNames::add(std::vector<std::string>& names, SafeNames& group,
                       const std::string& original) {
    names.push_back(group.claim(original));
    if (names.back() != original) {
        changed_.emplace_back(names.back(), quoted_where_needed(original));
    }
}

void ProgramNames::name_chart() {
    SafeNames alone = group();
    std::vector<std::string> names;
    add(names, alone, program_.grafcet->name);
    chart_ = names.front();
}

/// The control inputs first: what they are called is the same in every program.
void ProgramNames::name_inputs() {
    const Grafcet& grafcet = *program_.grafcet;
    SafeNames inputs = group();
    if (program_.has_modes) {
        for (std::size_t c = 0; c < control_input_count; ++c) {
            add(controls_, inputs, std::string(input_name(grafcet, grafcet.inputs.size() + c)));
        }
    }
    for (const Input& input : grafcet.inputs) add(inputs_, inputs, input.name);
}

void ProgramNames::name_parts() {
    const Grafcet& grafcet = *program_.grafcet;
    SafeNames outputs = group();
    for (const Output& output : grafcet.outputs) add(outputs_, outputs, output.name);
    SafeNames vars = group();
    for (const Var& var : grafcet.vars) add(vars_, vars, var.name);
    SafeNames counters = group();
    for (const Counter& counter : grafcet.counters) add(counters_, counters, counter.name);
    SafeNames steps = group();
    for (const Step& step : grafcet.steps) add(steps_, steps, "X" + step.name);
    SafeNames graphs = group();
    for (const Graph& graph : grafcet.graphs) graphs_.push_back(graphs.claim(graph.name));
    SafeNames transitions = group();
    for (const Transition& transition : grafcet.transitions) {
        transitions_.push_back(
            transitions.claim((transition.labelled ? "t_" : "t") + transition.name));
    }
}

void ProgramNames::name_expressions() {
    const Grafcet& grafcet = *program_.grafcet;
    const Expressions& pool = grafcet.expressions;
    SafeNames edges = group();
    for (const ExprId edge : pool.edges()) {
        edges_.push_back(edges.claim(word_of(write_expression(grafcet, pool, edge))));
    }
    SafeNames times = group();
    for (const ExprId time : pool.time_conditions()) {
        times_.push_back(times.claim(word_of("t" + write_expression(grafcet, pool, time))));
    }
}

const std::string& ProgramNames::operator[](Bit bit) const {
    switch (bit.kind) {
        case BitKind::input:
            return inputs_[bit.index];
        case BitKind::control:
            return controls_[bit.index];
        case BitKind::output:
            return outputs_[bit.index];
        case BitKind::var:
            return vars_[bit.index];
        case BitKind::transition:
            return transitions_[bit.index];
        case BitKind::may_evolve:
            return graphs_[bit.index];
        case BitKind::edge:
        case BitKind::edge_memory:
            return edges_[bit.index];
        case BitKind::time_value:
            return times_[bit.index];
        case BitKind::scratch:
            return scratch_bits_[bit.index];
        default:
            return steps_[bit.index];
    }
}

const std::string& ProgramNames::operator[](IntegerCell cell) const {
    return cell.is_scratch ? scratch_integers_[cell.index] : counters_[cell.index];
}

std::vector<Bit> ProgramNames::inputs() const {
    std::vector<Bit> bits;
    for (std::uint32_t i = 0; i < inputs_.size(); ++i) bits.push_back({BitKind::input, i});
    for (std::uint32_t i = 0; i < controls_.size(); ++i) bits.push_back({BitKind::control, i});
    return bits;
}

}  // namespace grafwire
