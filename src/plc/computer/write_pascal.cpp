// A program in Free Pascal: its types and variables, a procedure for each section of the scan, and
// the main program, which reads scans and writes the trace.
//
// The tables of the steps are sets, so that the formulas of the method stand there as they are on
// paper: `Ts := (Tp - Td) + Ta`. A set of Free Pascal holds 256 elements, which limits the charts.

#include <fmt/format.h>

#include <cassert>
#include <string>
#include <string_view>
#include <vector>

#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/messages.h"
#include "plc/computer/pascal_blocks.h"
#include "plc/shared/condition_text.h"
#include "plc/shared/language_words.h"
#include "plc/shared/program_names.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"
#include "program/bit_names.h"
#include "program/messages.h"
#include "program/program.h"
#include "text/joined.h"

namespace grafwire {

namespace {

namespace say = messages::plc_computer;

/// What a set of Free Pascal can hold.
constexpr std::size_t most_steps = 256;

/// A text in Pascal, between apostrophes.
std::string pascal_string(std::string_view text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'') result += '\'';
        result += c;
    }
    return result + "'";
}

ConditionSpelling pascal_spelling() {
    ConditionSpelling result;
    result.negation = "not ";
    result.conjunction = " and ";
    result.disjunction = " or ";
    result.exclusive_or = " xor ";
    result.one = "True";
    result.zero = "False";
    result.relations = {"=", "<>", "<", "<=", ">", ">="};
    result.relations_bind_weakest = true;
    result.before_first_number = "Int64(";
    result.after_first_number = ")";
    return result;
}

/// Writes a program in Free Pascal.
class PascalProgram {
  public:
    PascalProgram(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options);

    std::string write();

  private:
    std::string name(Bit bit) const;
    std::string name(IntegerCell cell) const {
        return cell.is_scratch ? names_[cell] : "counters." + names_[cell];
    }
    // What surrounds the scan.
    void write_head();
    void write_types();
    void write_variables();
    /// `name: record a, b: type; end;`, where there is any field.
    void write_record(std::string_view name, const std::vector<std::string>& fields,
                      std::string_view type, const Message<>& comment);
    std::vector<std::string> names_of(BitKind kind, std::size_t count) const;
    void write_row();
    void write_main();
    // The scan.
    void write_section(SectionKind section);
    void write_scratch(SectionKind section);
    void clear_unwritten_vars();
    void write_scan();
    void write(const Statement& statement);
    std::vector<std::string> actions_of(const Statement& statement) const;
    void write_table(TableOperation operation);

    const Grafcet& grafcet_;
    ScanProgram program_;
    const PlcOptions& options_;
    Language language_;
    ProgramNames names_;
    ConditionText conditions_;
    SourceText out_{"//"};
};

PascalProgram::PascalProgram(const Grafcet& grafcet, const ScanProgram& program,
                             const PlcOptions& options)
    : grafcet_(grafcet),
      program_(without_idle_tables(program)),
      options_(options),
      language_(options.language),
      names_(grafcet, program_, {false, is_pascal_word}),
      conditions_(
          pascal_spelling(), [this](Bit bit) { return name(bit); },
          [this](IntegerCell cell) { return name(cell); }) {}

std::string PascalProgram::name(Bit bit) const {
    if (bit.kind == BitKind::scratch) return names_[bit];
    const std::string_view in = holder_name(bit.kind);
    if (is_step_table(bit.kind)) return fmt::format("({} in {})", names_[bit], in);
    return fmt::format("{}.{}{}", in, names_[bit], bit.kind == BitKind::time_value ? ".value" : "");
}

void PascalProgram::write_head() {
    write_title(out_, grafcet_, say::program_in_pascal(), options_);
    out_.comment({});
    out_.comment(say::how_to_try_pascal.in(language_));
    write_changed_names(out_, names_, language_);
}

std::string PascalProgram::write() {
    write_head();
    out_.blank();
    out_.line("{$mode objfpc}{$H+}");
    out_.line(fmt::format("program {}_grafcet;", names_.chart()));
    write_types();
    write_variables();
    if (!grafcet_.counters.empty()) out_.block(pascal::within_function);
    if (has_statements(program_, Statement::Kind::time)) out_.block(pascal::observe_procedure);
    for (std::size_t s = 0; s < section_count; ++s) write_section(static_cast<SectionKind>(s));
    write_scan();
    out_.block(with_texts(
        pascal::reading_and_writing,
        {{"@reads_scans", say::reads_scans_in_pascal.in(language_)},
         {"@in_the_line", say::in_the_line.in(language_)},
         {"@from_ms", say::from_ms.in(language_)},
         {"@bad_line", say::bad_line.in(language_, "', row, '", "', INPUT_COLUMNS,\n    '")}}));
    write_row();
    write_main();
    return out_.take();
}

std::vector<std::string> PascalProgram::names_of(BitKind kind, std::size_t count) const {
    std::vector<std::string> names;
    if (kind != BitKind::output && kind != BitKind::var && !uses(program_, kind)) return names;
    for (std::uint32_t i = 0; i < count; ++i) names.push_back(names_[Bit{kind, i}]);
    return names;
}

void PascalProgram::write_types() {
    out_.blank();
    out_.line("const");
    out_.indent();
    out_.line(fmt::format("INPUT_COLUMNS = {};  // {}", grafcet_.all_input_count(),
                          say::all_input_columns.in(language_)));
    out_.outdent();
    out_.blank();
    out_.line("type");
    out_.indent();
    std::string steps;
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        if (s != 0) steps += ", ";
        steps += names_[Bit{BitKind::step, s}];
    }
    // An enumeration needs a value, even in a chart without steps.
    out_.line(fmt::format("TStep = ({});", steps.empty() ? "no_step" : steps));
    out_.line("TSteps = set of TStep;");
    if (has_statements(program_, Statement::Kind::time)) {
        out_.block(with_texts(pascal::time_type,
                              {{"@time_condition", say::time_condition_true.in(language_)},
                               {"@e_differs", say::e_differs.in(language_)},
                               {"@differs_since", say::differs_since.in(language_)}}));
    }
    out_.outdent();
}

void PascalProgram::write_record(std::string_view name, const std::vector<std::string>& fields,
                                 std::string_view type, const Message<>& comment) {
    if (fields.empty()) return;
    out_.comment(comment.in(language_));
    out_.line(fmt::format("{}: record {}: {}; end;", name, joined(fields, ", "), type));
}

void PascalProgram::write_variables() {
    out_.blank();
    out_.line("var");
    out_.indent();
    const auto line = [&](std::string_view declaration, const Message<>& comment) {
        out_.line(fmt::format("{}  // {}", declaration, comment.in(language_)));
    };
    line("now: Int64;", say::moment_of_scan);
    std::vector<std::string> inputs;
    for (const Bit bit : names_.inputs()) inputs.push_back(names_[bit]);
    write_record("inputs", inputs, "Boolean", say::inputs);
    write_record("outputs", names_of(BitKind::output, grafcet_.outputs.size()), "Boolean",
                 say::outputs);
    line("Ts: TSteps;    ", say::situation);
    line("Tp: TSteps;    ", say::situation_before);
    line("Ta, Td: TSteps;", say::to_activate);
    if (uses(program_, BitKind::forced_off)) {
        line("Tf1, Tf0: TSteps;", say::forced);
    }
    if (uses(program_, BitKind::pulse)) line("Tpulse: TSteps;", say::just_activated);
    write_record("Tt", names_of(BitKind::transition, grafcet_.transitions.size()), "Boolean",
                 say::transition_conditions);
    write_record("Tfig", names_of(BitKind::may_evolve, grafcet_.graphs.size()), "Boolean",
                 say::graphs_false_frozen);
    const std::size_t edges = grafcet_.expressions.edges().size();
    write_record("edge", names_of(BitKind::edge, edges), "Boolean", say::edges_true);
    write_record("memory", names_of(BitKind::edge_memory, edges), "Boolean", say::edge_memories);
    const std::size_t times = grafcet_.expressions.time_conditions().size();
    write_record("time", names_of(BitKind::time_value, times), "TTimeCondition",
                 say::time_conditions);
    write_record("vars", names_of(BitKind::var, grafcet_.vars.size()), "Boolean", say::vars);
    std::vector<std::string> counters;
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        counters.push_back(names_[IntegerCell{false, c}]);
    }
    write_record("counters", counters, "Int64", say::counters);
    out_.outdent();
}

void PascalProgram::write_row() {
    out_.blank();
    out_.line("procedure write_row;");
    out_.line("begin");
    out_.indent();
    out_.line("write_moment;");
    out_.line("for i := 1 to INPUT_COLUMNS do Write(',', Ord(values[i]));");
    if (!grafcet_.steps.empty()) {
        out_.line("for step := Low(TStep) to High(TStep) do Write(',', Ord(step in Ts));");
    }
    const auto write_bits = [&](BitKind kind, std::size_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            out_.line(fmt::format("Write(',', Ord({}));", name(Bit{kind, i})));
        }
    };
    write_bits(BitKind::output, grafcet_.outputs.size());
    write_bits(BitKind::var, grafcet_.vars.size());
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        out_.line(fmt::format("Write(',', {});", name(IntegerCell{false, c})));
    }
    out_.line("WriteLn;");
    out_.outdent();
    out_.line("end;");
}

void PascalProgram::write_main() {
    out_.blank();
    out_.line("begin");
    out_.indent();
    for (const std::string& part : trace_heading(grafcet_)) {
        out_.whole_line(fmt::format("Write({});", pascal_string(part)));
    }
    out_.line("WriteLn;");
    out_.line("ReadLn(line);");
    out_.line("row := 1;");
    out_.line("while not Eof do");
    out_.line("begin");
    out_.indent();
    out_.line("Inc(row);");
    out_.line("ReadLn(line);");
    out_.line("read_scan;");
    for (const Bit bit : names_.inputs()) {
        const std::size_t column =
            bit.kind == BitKind::control ? grafcet_.inputs.size() + bit.index : bit.index;
        out_.line(fmt::format("{} := values[{}];", name(bit), column + 1));
    }
    out_.line("if row = 2 then start;");
    out_.line("scan;");
    out_.line("write_row;");
    out_.outdent();
    out_.line("end;");
    out_.outdent();
    out_.line("end.");
}

void PascalProgram::write_section(SectionKind section) {
    if (section != SectionKind::start && program_.section(section).empty()) return;
    out_.blank();
    out_.comment(section_title(section).in(language_));
    out_.line(fmt::format("procedure {};", section_function(section)));
    write_scratch(section);
    out_.line("begin");
    out_.indent();
    if (section == SectionKind::start) clear_unwritten_vars();
    for (const Statement& statement : program_.section(section)) write(statement);
    out_.outdent();
    out_.line("end;");
}

/// Free Pascal warns of a record that is read and nowhere assigned.
void PascalProgram::clear_unwritten_vars() {
    std::vector<bool> written(grafcet_.vars.size(), false);
    for (const std::vector<Statement>& section : program_.sections) {
        for (const Statement& statement : section) {
            for (const Bit bit : statement.targets) {
                if (bit.kind == BitKind::var) written[bit.index] = true;
            }
        }
    }
    for (std::uint32_t v = 0; v < grafcet_.vars.size(); ++v) {
        if (!written[v]) out_.line(fmt::format("{} := False;", name(Bit{BitKind::var, v})));
    }
}

/// What holds a value within this section only.
void PascalProgram::write_scratch(SectionKind section) {
    std::vector<std::string> lines;
    for (const Statement& statement : program_.section(section)) {
        if (statement.kind == Statement::Kind::move && statement.integer.is_scratch) {
            lines.push_back(names_[statement.integer] + ": Int64;");
        } else if (statement.kind == Statement::Kind::assign &&
                   statement.targets[0].kind == BitKind::scratch) {
            lines.push_back(names_[statement.targets[0]] + ": Boolean;");
        }
    }
    if (lines.empty()) return;
    out_.line("var");
    out_.indent();
    for (const std::string& line : lines) out_.line(line);
    out_.outdent();
}

void PascalProgram::write(const Statement& statement) {
    if (says_more(statement)) out_.comment(statement.comment.in(language_));
    switch (statement.kind) {
        case Statement::Kind::assign:
            assert(!is_step_table(statement.targets[0].kind));
            out_.line(fmt::format("{} := {};", name(statement.targets[0]),
                                  conditions_.of(statement.condition)));
            return;
        case Statement::Kind::time:
            out_.line(fmt::format("observe(time.{}, {}, {}, {});", names_[statement.targets[0]],
                                  conditions_.of(statement.condition),
                                  microseconds(statement.on_delay),
                                  microseconds(statement.off_delay)));
            return;
        case Statement::Kind::table:
            write_table(statement.operation);
            return;
        case Statement::Kind::set:
        case Statement::Kind::reset:
        case Statement::Kind::move:
            break;
    }
    const std::vector<std::string> actions = actions_of(statement);
    const bool always = statement.condition.is_constant(true);
    const bool is_block = !always && actions.size() > 1;
    if (!always) out_.line(fmt::format("if {} then", conditions_.of(statement.condition)));
    if (is_block) out_.line("begin");
    if (!always) out_.indent();
    for (const std::string& action : actions) out_.line(action);
    if (!always) out_.outdent();
    if (is_block) out_.line("end;");
}

std::vector<std::string> PascalProgram::actions_of(const Statement& statement) const {
    std::vector<std::string> lines;
    if (statement.kind == Statement::Kind::move) {
        const std::string target = name(statement.integer);
        if (statement.sum.empty()) {
            lines.push_back(fmt::format("{} := {};", target, name(statement.source)));
        } else {
            lines.push_back(fmt::format("{} := within({}, {}, {});", target, statement.low,
                                        conditions_.of(statement.sum), statement.high));
        }
        return lines;
    }
    const bool sets = statement.kind == Statement::Kind::set;
    const std::vector<StepRange> ranges = step_ranges(statement.targets);
    for (std::size_t i = 0; i < ranges.size();) {
        const std::string_view table = holder_name(ranges[i].table);
        std::string steps;
        for (; i < ranges.size() && holder_name(ranges[i].table) == table; ++i) {
            if (!steps.empty()) steps += ", ";
            steps += names_[Bit{BitKind::step, ranges[i].first}];
            if (ranges[i].last == ranges[i].first) continue;
            steps += ".." + names_[Bit{BitKind::step, ranges[i].last}];
        }
        lines.push_back(fmt::format("{0} := {0} {1} [{2}];", table, sets ? "+" : "-", steps));
    }
    for (const Bit bit : single_bits(statement.targets)) {
        lines.push_back(fmt::format("{} := {};", name(bit), sets ? "True" : "False"));
    }
    return lines;
}

void PascalProgram::write_table(TableOperation operation) {
    switch (operation) {
        case TableOperation::remember:
            out_.line("Tp := Ts;");
            break;
        case TableOperation::clear:
            out_.line("Ta := [];");
            out_.line("Td := [];");
            if (!uses(program_, BitKind::forced_off)) break;
            out_.line("Tf1 := [];");
            out_.line("Tf0 := [];");
            break;
        case TableOperation::evolve:
            out_.line("Ts := (Tp - Td) + Ta;");
            break;
        case TableOperation::force:
            out_.line("Ts := (Ts - Tf0) + Tf1;");
            break;
        case TableOperation::pulse:
            out_.line("Tpulse := Ts - Tp;");
            break;
    }
}

void PascalProgram::write_scan() {
    out_.blank();
    out_.line("procedure scan;");
    out_.line("begin");
    out_.indent();
    for (std::size_t s = 1; s < section_count; ++s) {
        const auto section = static_cast<SectionKind>(s);
        if (program_.section(section).empty()) continue;
        out_.line(fmt::format("{};", section_function(section)));
    }
    out_.outdent();
    out_.line("end;");
}

}  // namespace

std::string write_pascal(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics& diagnostics) {
    if (!check_integers(grafcet, program, "Free Pascal", diagnostics)) return {};
    if (grafcet.steps.size() > most_steps) {
        diagnostics.error(code::beyond_limit,
                          grafcet.steps[StepId{static_cast<std::uint32_t>(most_steps)}].where,
                          say::too_many_steps(most_steps + 1, grafcet.steps.size(), most_steps));
        return {};
    }
    return PascalProgram(grafcet, program, options).write();
}

}  // namespace grafwire
