// A program in Python 3, to be read in class: the steps, a class of inputs, a class of the chart
// with its tables, and what reads scans and writes the trace. The scan itself is in
// python_statements.cpp.

#include <fmt/format.h>

#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/messages.h"
#include "plc/computer/python_blocks.h"
#include "plc/computer/python_program.h"
#include "plc/shared/headings.h"
#include "plc/shared/program_needs.h"

namespace grafwire {

namespace {

namespace say = messages::plc_computer;

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

void PythonProgram::write_head() {
    // Python reads `coding: …` in the first two lines of a file as its encoding, in a comment too
    // (PEP 263): no name of the chart may stand there.
    out_.comment("-*- coding: utf-8 -*-");
    out_.comment({});
    write_title(out_, grafcet_, say::program_in_python(), language_);
    out_.comment({});
    out_.comment(say::how_to_use_python.in(language_));
    out_.comment(say::how_to_try_python.in(language_));
    write_changed_names(out_, names_, language_);
}

std::string PythonProgram::write() {
    write_head();
    out_.block(python::imports);
    write_steps();
    const std::string head = out_.take();
    write_inputs();
    write_class();
    const std::string classes = out_.take();
    write_run();
    std::string text = head + std::string(python::is_in_function);
    if (calls(classes, "through")) {
        text += with_texts(python::through_function,
                           {{"@steps_through", say::steps_through.in(language_)}});
    }
    if (has_statements(program_, Statement::Kind::time)) {
        text += with_texts(python::time_class,
                           {{"@time_condition", say::time_class.in(language_)},
                            {"@differs_since", say::differs_since_alone.in(language_)}});
    }
    return text + classes + out_.take();
}

void PythonProgram::write_steps() {
    out_.blank();
    out_.comment(say::steps_as_bits.in(language_));
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
                                const Message<>& comment) {
    // Variables that nothing uses stand in the trace all the same.
    const bool is_shown = kind == BitKind::var || kind == BitKind::output;
    if (count == 0 || (!is_shown && !uses(program_, kind))) return;
    std::string attributes;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (i != 0) attributes += ", ";
        attributes += fmt::format("{}={}", names_[Bit{kind, i}], value);
    }
    out_.comment(comment.in(language_));
    out_.line(fmt::format("self.{} = SimpleNamespace({})", holder_name(kind), attributes));
}

void PythonProgram::write_start() {
    const auto line = [&](std::string_view assignment, const Message<>& comment) {
        out_.line(fmt::format("{}  # {}", assignment, comment.in(language_)));
    };
    out_.comment(section_title(SectionKind::start).in(language_));
    out_.line("def __init__(self, inputs):");
    out_.indent();
    out_.line("self.inputs = inputs");
    line("self.now = 0", say::moment_of_scan);
    write_group(BitKind::output, grafcet_.outputs.size(), "False", say::outputs);
    line("self.Ts = 0", say::situation);
    line("self.Tp = 0", say::situation_before);
    line("self.Ta = self.Td = 0", say::to_activate);
    if (uses(program_, BitKind::forced_off)) {
        line("self.Tf1 = self.Tf0 = 0", say::forced);
    }
    if (uses(program_, BitKind::pulse)) line("self.Tpulse = 0", say::just_activated);
    write_group(BitKind::transition, grafcet_.transitions.size(), "False",
                say::transition_conditions);
    write_group(BitKind::may_evolve, grafcet_.graphs.size(), "False", say::graphs_false_frozen);
    const std::size_t edges = grafcet_.expressions.edges().size();
    write_group(BitKind::edge, edges, "False", say::edges_true);
    write_group(BitKind::edge_memory, edges, "False", say::edge_memories);
    write_group(BitKind::time_value, grafcet_.expressions.time_conditions().size(),
                "TimeCondition()", say::time_conditions);
    write_group(BitKind::var, grafcet_.vars.size(), "False", say::vars);
    if (!grafcet_.counters.empty()) {
        out_.comment(say::counters.in(language_));
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
    out_.line(fmt::format("INPUT_COLUMNS = {}  # {}", grafcet_.all_input_count(),
                          say::all_input_columns.in(language_)));
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
    out_.block(
        with_texts(python::reading_and_writing,
                   {{"@from_ms", say::moment_from_ms.in(language_)},
                    {"@reads_scans", say::reads_scans_in_python.in(language_)},
                    {"@bad_line", say::bad_line.in(language_, "{number}", "\n{INPUT_COLUMNS}")}}));
}

std::string write_python(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics&) {
    return PythonProgram(grafcet, program, options.language).write();
}

}  // namespace grafwire
