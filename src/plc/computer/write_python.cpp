// A program in Python 3, to be read in class: the steps, a class of inputs, a class of the chart
// with its tables and a method for each section of the scan, and what reads scans and writes the
// trace.
//
// A table is an integer of any length whose bits are the steps, and the formulas of the method are
// its operators: `self.Ts = self.Tp & ~self.Td | self.Ta`. Only this language has no limit for
// integers and for steps.

#include <fmt/format.h>

#include <cassert>
#include <string>
#include <string_view>

#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/messages.h"
#include "plc/computer/python_blocks.h"
#include "plc/shared/condition_text.h"
#include "plc/shared/language_words.h"
#include "plc/shared/program_names.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"
#include "program/bit_names.h"
#include "program/program.h"

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

ConditionSpelling python_spelling() {
    ConditionSpelling result;
    result.negation = "not ";
    result.conjunction = " and ";
    result.disjunction = " or ";
    result.exclusive_or = " ^ ";
    result.one = "True";
    result.zero = "False";
    result.relations = {"==", "!=", "<", "<=", ">", ">="};
    return result;
}

std::string holder(BitKind kind) {
    return fmt::format("self.{}", holder_name(kind));
}

/// Writes a program in Python 3.
class PythonProgram {
  public:
    PythonProgram(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options);

    std::string write();

  private:
    std::string name(Bit bit) const;
    std::string name(IntegerCell cell) const {
        return cell.is_scratch ? names_[cell] : "self.counters." + names_[cell];
    }
    // What surrounds the scan.
    void write_head();
    void write_steps();
    void write_inputs();
    void write_class();
    void write_start();
    /// `self.name = SimpleNamespace(a=value, …)`, where the program has any use for it.
    void write_group(BitKind kind, std::size_t count, std::string_view value,
                     const Message<>& comment);
    void write_run();
    // The scan.
    void write_section(SectionKind section);
    void write_scan();
    void write(const Statement& statement);
    void write_actions(const Statement& statement);
    std::string table_text(TableOperation operation) const;
    /// A line that may need parentheses to go on in the next one.
    void write_line(std::string_view before, std::string_view expression, std::string_view after);

    const Grafcet& grafcet_;
    ScanProgram program_;
    const PlcOptions& options_;
    Language language_;
    ProgramNames names_;
    ConditionText conditions_;
    SourceText out_{"#", SourceText::Breaks::within_parentheses};
};

PythonProgram::PythonProgram(const Grafcet& grafcet, const ScanProgram& program,
                             const PlcOptions& options)
    : grafcet_(grafcet),
      program_(without_idle_tables(program)),
      options_(options),
      language_(options.language),
      names_(grafcet, program_, {true, is_python_word}),
      conditions_(
          python_spelling(), [this](Bit bit) { return name(bit); },
          [this](IntegerCell cell) { return name(cell); }) {}

std::string PythonProgram::name(Bit bit) const {
    if (bit.kind == BitKind::scratch) return names_[bit];
    const std::string in = holder(bit.kind);
    if (is_step_table(bit.kind)) return fmt::format("is_in({}, {})", names_[bit], in);
    return fmt::format("{}.{}{}", in, names_[bit], bit.kind == BitKind::time_value ? ".value" : "");
}

void PythonProgram::write_head() {
    // Python reads `coding: …` in the first two lines of a file as its encoding, in a comment too
    // (PEP 263): no name of the chart may stand there.
    out_.comment("-*- coding: utf-8 -*-");
    out_.comment({});
    write_title(out_, grafcet_, say::program_in_python(), options_);
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

void PythonProgram::write_section(SectionKind section) {
    if (program_.section(section).empty()) return;
    out_.blank();
    out_.comment(section_title(section).in(language_));
    out_.line(fmt::format("def {}(self):", section_function(section)));
    out_.indent();
    for (const Statement& statement : program_.section(section)) write(statement);
    out_.outdent();
}

void PythonProgram::write_line(std::string_view before, std::string_view expression,
                               std::string_view after) {
    if (out_.is_too_long(before.size() + expression.size() + after.size())) {
        out_.line(fmt::format("{}({}){}", before, expression, after));
    } else {
        out_.line(fmt::format("{}{}{}", before, expression, after));
    }
}

void PythonProgram::write(const Statement& statement) {
    if (says_more(statement)) out_.comment(statement.comment.in(language_));
    switch (statement.kind) {
        case Statement::Kind::assign:
            assert(!is_step_table(statement.targets[0].kind));
            write_line(name(statement.targets[0]) + " = ", conditions_.of(statement.condition), "");
            return;
        case Statement::Kind::time:
            out_.line(
                fmt::format("{}.{}.observe({}, {}, {}, self.now)", holder(BitKind::time_value),
                            names_[statement.targets[0]], conditions_.of(statement.condition),
                            microseconds(statement.on_delay), microseconds(statement.off_delay)));
            return;
        case Statement::Kind::table:
            out_.line(table_text(statement.operation));
            return;
        case Statement::Kind::set:
        case Statement::Kind::reset:
        case Statement::Kind::move:
            break;
    }
    if (statement.condition.is_constant(true)) {
        write_actions(statement);
        return;
    }
    write_line("if ", conditions_.of(statement.condition), ":");
    out_.indent();
    write_actions(statement);
    out_.outdent();
}

void PythonProgram::write_actions(const Statement& statement) {
    if (statement.kind == Statement::Kind::move) {
        const std::string target = name(statement.integer);
        if (statement.sum.empty()) {
            out_.line(fmt::format("{} = {}", target, name(statement.source)));
        } else {
            out_.line(fmt::format("{} = max({}, min({}, {}))", target, statement.low,
                                  conditions_.of(statement.sum), statement.high));
        }
        return;
    }
    const bool sets = statement.kind == Statement::Kind::set;
    const std::vector<StepRange> ranges = step_ranges(statement.targets);
    for (std::size_t i = 0; i < ranges.size();) {
        const std::string table = holder(ranges[i].table);
        std::string steps;
        for (; i < ranges.size() && holder(ranges[i].table) == table; ++i) {
            if (!steps.empty()) steps += " | ";
            const std::string& first = names_[Bit{BitKind::step, ranges[i].first}];
            const std::string& last = names_[Bit{BitKind::step, ranges[i].last}];
            steps += ranges[i].first == ranges[i].last
                         ? first
                         : fmt::format("through({}, {})", first, last);
        }
        if (sets) {
            write_line(fmt::format("{} |= ", table), steps, "");
        } else {
            const bool is_union = steps.find('|') != std::string::npos;
            out_.line(is_union ? fmt::format("{} &= ~({})", table, steps)
                               : fmt::format("{} &= ~{}", table, steps));
        }
    }
    for (const Bit bit : single_bits(statement.targets)) {
        out_.line(fmt::format("{} = {}", name(bit), sets ? "True" : "False"));
    }
}

std::string PythonProgram::table_text(TableOperation operation) const {
    switch (operation) {
        case TableOperation::remember:
            return "self.Tp = self.Ts";
        case TableOperation::clear:
            return uses(program_, BitKind::forced_off)
                       ? "self.Ta = self.Td = self.Tf1 = self.Tf0 = 0"
                       : "self.Ta = self.Td = 0";
        case TableOperation::evolve:
            return "self.Ts = self.Tp & ~self.Td | self.Ta";
        case TableOperation::force:
            return "self.Ts = self.Ts & ~self.Tf0 | self.Tf1";
        case TableOperation::pulse:
            return "self.Tpulse = self.Ts & ~self.Tp";
    }
    return {};
}

void PythonProgram::write_scan() {
    out_.blank();
    out_.comment(messages::plc_computer::one_scan_clocked.in(language_));
    out_.line("def scan(self, inputs, now):");
    out_.indent();
    out_.line("self.inputs = inputs");
    out_.line("self.now = now");
    for (std::size_t s = 1; s < section_count; ++s) {
        const auto section = static_cast<SectionKind>(s);
        if (program_.section(section).empty()) continue;
        out_.line(fmt::format("self.{}()", section_function(section)));
    }
    out_.outdent();
}

}  // namespace

std::string write_python(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics&) {
    return PythonProgram(grafcet, program, options).write();
}

}  // namespace grafwire
