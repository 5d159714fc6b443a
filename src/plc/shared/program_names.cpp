// Names that a language can hold.
//
// A name of the chart becomes a word of ASCII letters, digits and underscores (`arrêt` gives
// `arret`); where that is reserved, or taken in its group, a number is put behind it: `int_2`.

#include "plc/shared/program_names.h"

#include <fmt/format.h>

#include "grafcet/write_grafcet.h"
#include "program/bit_names.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// A short name for an edge or a time condition: `↑dcy` gives `rise_dcy`. Its text stands beside it
/// in the program; the name need not hold all of it.
std::string word_of(const std::string& text) {
    constexpr std::size_t longest = 32;
    std::string spelled;
    for (std::size_t at = 0; at < text.size();) {
        if (text.compare(at, 3, "↑") == 0) {
            spelled += " rise ";
            at += 3;
        } else if (text.compare(at, 3, "↓") == 0) {
            spelled += " fall ";
            at += 3;
        } else {
            spelled += text[at++];
        }
    }
    std::string word = ascii_word(spelled);
    if (word.size() > longest) word.resize(word.find_last_not_of('_', longest - 1) + 1);
    return word;
}

}  // namespace

ProgramNames::ProgramNames(const Grafcet& grafcet, const ScanProgram& program,
                           const NameRules& rules)
    : grafcet_(grafcet), program_(program), rules_(rules) {
    name_chart();
    name_inputs();
    name_parts();
    name_expressions();
    for (std::uint32_t i = 0; i < program.scratch_bits; ++i) {
        group_of(BitKind::scratch).push_back(fmt::format("S{}", i));
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
    add(names, alone, grafcet_.name);
    chart_ = names.front();
}

/// The control inputs first: what they are called is the same in every program.
void ProgramNames::name_inputs() {
    SafeNames inputs = group();
    if (program_.has_modes) {
        for (std::size_t c = 0; c < control_input_count; ++c) {
            add(group_of(BitKind::control), inputs,
                std::string(input_name(grafcet_, grafcet_.inputs.size() + c)));
        }
    }
    for (const Input& input : grafcet_.inputs) add(group_of(BitKind::input), inputs, input.name);
}

void ProgramNames::name_parts() {
    SafeNames outputs = group();
    for (const Output& output : grafcet_.outputs)
        add(group_of(BitKind::output), outputs, output.name);
    SafeNames vars = group();
    for (const Var& var : grafcet_.vars) add(group_of(BitKind::var), vars, var.name);
    SafeNames counters = group();
    for (const Counter& counter : grafcet_.counters) add(counters_, counters, counter.name);
    SafeNames steps = group();
    for (const Step& step : grafcet_.steps) add(group_of(BitKind::step), steps, "X" + step.name);
    SafeNames graphs = group();
    for (const Graph& graph : grafcet_.graphs)
        group_of(BitKind::may_evolve).push_back(graphs.claim(graph.name));
    SafeNames transitions = group();
    for (const Transition& transition : grafcet_.transitions) {
        group_of(BitKind::transition)
            .push_back(transitions.claim((transition.labelled ? "t_" : "t") + transition.name));
    }
}

void ProgramNames::name_expressions() {
    const Expressions& pool = grafcet_.expressions;
    SafeNames edges = group();
    for (const ExprId edge : pool.edges()) {
        group_of(BitKind::edge)
            .push_back(edges.claim(word_of(write_expression(grafcet_, pool, edge))));
    }
    SafeNames times = group();
    for (const ExprId time : pool.time_conditions()) {
        group_of(BitKind::time_value)
            .push_back(times.claim(word_of("t" + write_expression(grafcet_, pool, time))));
    }
}

/// The tables of steps share the names of the steps, an edge and its memory theirs.
std::size_t ProgramNames::place_of(BitKind kind) {
    if (is_step_table(kind)) return static_cast<std::size_t>(BitKind::step);
    return static_cast<std::size_t>(kind == BitKind::edge_memory ? BitKind::edge : kind);
}

const std::string& ProgramNames::operator[](Bit bit) const {
    return bits_[place_of(bit.kind)][bit.index];
}

const std::string& ProgramNames::operator[](IntegerCell cell) const {
    return cell.is_scratch ? scratch_integers_[cell.index] : counters_[cell.index];
}

std::vector<Bit> ProgramNames::inputs() const {
    std::vector<Bit> bits;
    for (const BitKind kind : {BitKind::input, BitKind::control}) {
        const std::size_t count = bits_[place_of(kind)].size();
        for (std::uint32_t i = 0; i < count; ++i) bits.push_back({kind, i});
    }
    return bits;
}

}  // namespace grafwire
