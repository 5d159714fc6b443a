// A program in Free Pascal: its types and variables, and the main program, which reads scans and
// writes the trace. The scan itself is in pascal_statements.cpp.

#include <fmt/format.h>

#include "plc/computer/language_parts.h"
#include "plc/computer/languages.h"
#include "plc/computer/messages.h"
#include "plc/computer/pascal_blocks.h"
#include "plc/computer/pascal_program.h"
#include "plc/shared/program_needs.h"
#include "program/messages.h"

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

}  // namespace

void PascalProgram::write_head() {
    write_title(out_, grafcet_, say::program_in_pascal(), language_);
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
    out_.line(fmt::format("{}: record {}: {}; end;", name, fmt::join(fields, ", "), type));
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

std::string write_pascal(const Grafcet& grafcet, const ScanProgram& program,
                         const PlcOptions& options, Diagnostics& diagnostics) {
    if (!check_integers(grafcet, program, "Free Pascal", diagnostics)) return {};
    if (grafcet.steps.size() > most_steps) {
        diagnostics.error(code::beyond_limit,
                          grafcet.steps[StepId{static_cast<std::uint32_t>(most_steps)}].where,
                          say::too_many_steps(most_steps + 1, grafcet.steps.size(), most_steps));
        return {};
    }
    return PascalProgram(grafcet, program, options.language).write();
}

}  // namespace grafwire
