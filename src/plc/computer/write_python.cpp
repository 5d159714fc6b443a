// A program in Python 3, to be read in class: the steps, a class of inputs, a class of the chart
// with its tables, and what reads scans and writes the trace. The scan itself is in
// python_statements.cpp.

#include <fmt/format.h>

#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/python_blocks.h"
#include "plc/computer/python_program.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/section_titles.h"

namespace grafwire {

namespace {

/// A text in Python, between quotation marks.
std::string python_string(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

}  // namespace

std::string PythonProgram::write() {
    // Python reads `coding: …` in the first two lines of a file as its encoding, in a comment too
    // (PEP 263): no name of the chart may stand there.
    out_.comment("-*- coding: utf-8 -*-");
    out_.comment({});
    write_title(out_, grafcet_, "a program in Python 3");
    out_.comment({});
    out_.comment("To use it:");
    out_.comment("  inputs = Inputs(...)       those that are not named are False");
    out_.comment("  chart = Grafcet(inputs)");
    out_.comment("  chart.scan(inputs, now)    over and over; now: a clock in us");
    out_.comment("  chart.outputs");
    out_.comment("To try it on scans from a trace of the reference:");
    out_.comment("  grafwire run CHART STIMULI --scan 10ms -o trace.csv");
    out_.comment("  python3 THIS_FILE < trace.csv | diff - trace.csv");
    write_changed_names(out_, names_);
    out_.block(python::imports);
    write_steps();
    const std::string head = out_.take();
    write_inputs();
    write_class();
    const std::string classes = out_.take();
    write_run();
    std::string text = head + std::string(python::is_in_function);
    if (calls(classes, "through")) text += python::through_function;
    if (has_statements(program_, Statement::Kind::time)) text += python::time_class;
    return text + classes + out_.take();
}

void PythonProgram::write_steps() {
    out_.blank();
    out_.comment("The steps, as bits of the tables.");
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        out_.line(fmt::format("{} = 1 << {}", names_[Bit{BitKind::step, s}], s));
    }
    out_.line(fmt::format("STEP_COUNT = {}", grafcet_.steps.size()));
}

void PythonProgram::write_inputs() {
    out_.block("\n\nclass Inputs(SimpleNamespace):\n");
    out_.indent();
    for (const Bit bit : names_.inputs()) out_.line(fmt::format("{} = False", names_[bit]));
    if (names_.inputs().empty()) out_.line("pass");
    out_.outdent();
}

void PythonProgram::write_class() {
    out_.block("\n\nclass Grafcet:\n");
    out_.indent();
    write_start();
    for (std::size_t s = 1; s < section_count; ++s) write_section(static_cast<SectionKind>(s));
    write_scan();
    out_.outdent();
}

void PythonProgram::write_group(BitKind kind, std::size_t count, std::string_view value,
                                std::string_view comment) {
    // Variables that nothing uses stand in the trace all the same.
    const bool is_shown = kind == BitKind::var || kind == BitKind::output;
    if (count == 0 || (!is_shown && !uses(program_, kind))) return;
    std::string attributes;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i != 0) attributes += ", ";
        attributes += fmt::format("{}={}", names_[Bit{kind, i}], value);
    }
    out_.comment(comment);
    out_.line(fmt::format("self.{} = SimpleNamespace({})", holder_name(kind), attributes));
}

void PythonProgram::write_start() {
    out_.comment(section_title(SectionKind::start));
    out_.line("def __init__(self, inputs):");
    out_.indent();
    out_.line("self.inputs = inputs");
    out_.line("self.now = 0  # the moment of the scan, in us");
    write_group(BitKind::output, grafcet_.outputs.size(), "False", "Outputs.");
    out_.line("self.Ts = 0  # the situation");
    out_.line("self.Tp = 0  # the situation that the scan began with");
    out_.line("self.Ta = self.Td = 0  # to activate, to deactivate");
    if (uses(program_, BitKind::forced_off)) {
        out_.line("self.Tf1 = self.Tf0 = 0  # forced to 1, forced to 0");
    }
    if (uses(program_, BitKind::pulse)) out_.line("self.Tpulse = 0  # activated in this scan");
    write_group(BitKind::transition, grafcet_.transitions.size(), "False",
                "The receptivities of the transitions.");
    write_group(BitKind::may_evolve, grafcet_.graphs.size(), "False",
                "Whether a graph may evolve; False: frozen.");
    const std::size_t edges = grafcet_.expressions.edges().size();
    write_group(BitKind::edge, edges, "False", "Edges, True in the scan in which they occur, and");
    write_group(BitKind::edge_memory, edges, "False",
                "what their operands were in the scan before.");
    write_group(BitKind::time_value, grafcet_.expressions.time_conditions().size(),
                "TimeCondition()", "Time conditions.");
    write_group(BitKind::var, grafcet_.vars.size(), "False", "Internal variables.");
    if (!grafcet_.counters.empty()) {
        out_.comment("Counters.");
        out_.line("self.counters = SimpleNamespace()");
    }
    for (const Statement& statement : program_.section(SectionKind::start)) write(statement);
    out_.outdent();
}

/// What the chart's own names are needed for in reading and writing scans.
void PythonProgram::write_run() {
    out_.block("\n\nHEADING = (\n");
    out_.indent();
    for (const std::string& part : trace_heading(grafcet_)) out_.whole_line(python_string(part));
    out_.outdent();
    out_.line(")");
    out_.line(fmt::format("INPUT_COLUMNS = {}  # Init, AUdur and AUdoux included",
                          grafcet_.all_input_count()));
    out_.block("\n\ndef inputs_of(values):\n");
    out_.indent();
    out_.line("return Inputs(");
    out_.indent();
    for (const Bit bit : names_.inputs()) {
        const std::size_t column =
            bit.kind == BitKind::control ? grafcet_.inputs.size() + bit.index : bit.index;
        out_.line(fmt::format("{}=values[{}],", names_[bit], column));
    }
    out_.outdent();
    out_.line(")");
    out_.outdent();
    out_.block("\n\ndef values_of(chart):\n");
    out_.indent();
    out_.line("return [");
    out_.indent();
    out_.line("*(is_in(1 << step, chart.Ts) for step in range(STEP_COUNT)),");
    const auto write_values = [&](std::string_view object, const std::vector<std::string>& names) {
        for (const std::string& name : names) out_.line(fmt::format("chart.{}.{},", object, name));
    };
    std::vector<std::string> outputs;
    for (std::uint32_t o = 0; o < grafcet_.outputs.size(); ++o) {
        outputs.push_back(names_[Bit{BitKind::output, o}]);
    }
    write_values("outputs", outputs);
    std::vector<std::string> vars;
    for (std::uint32_t v = 0; v < grafcet_.vars.size(); ++v) {
        vars.push_back(names_[Bit{BitKind::var, v}]);
    }
    write_values("vars", vars);
    std::vector<std::string> counters;
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        counters.push_back(names_[IntegerCell{false, c}]);
    }
    write_values("counters", counters);
    out_.outdent();
    out_.line("]");
    out_.outdent();
    out_.block(python::reading_and_writing);
}

std::string write_python(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions&,
                         Diagnostics&) {
    return PythonProgram(grafcet, program).write();
}

}  // namespace grafwire
