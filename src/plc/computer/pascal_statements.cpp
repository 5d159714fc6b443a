// The procedures of a program in Free Pascal. The tables of the steps are sets, so that the
// formulas of the method stand there as they are on paper: `Ts := (Tp - Td) + Ta`.

#include <fmt/format.h>

#include <cassert>

#include "plc/computer/language_parts.h"
#include "plc/computer/pascal_program.h"
#include "plc/shared/headings.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/reserved_words.h"
#include "plc/shared/step_ranges.h"
#include "program/bit_names.h"

namespace grafwire {

namespace {

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

}  // namespace

PascalProgram::PascalProgram(const Grafcet& grafcet, const ScanProgram& program, Language language)
    : grafcet_(grafcet),
      program_(without_idle_tables(program)),
      language_(language),
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

void PascalProgram::write_section(SectionKind section) {
    if (section != SectionKind::start && program_.section(section).empty()) return;
    out_.blank();
    out_.comment(section_title(section).in(language_));
    out_.line(fmt::format("procedure {};", section_function(section)));
    write_scratch(section);
    out_.line("begin");
    out_.indent();
    for (const Statement& statement : program_.section(section)) write(statement);
    out_.outdent();
    out_.line("end;");
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

}  // namespace grafwire
