// The methods of a program in Python 3. A table is an integer of any length whose bits are the
// steps, and the formulas of the method are its operators: `self.Ts = self.Tp & ~self.Td |
// self.Ta`.

#include <fmt/format.h>

#include <cassert>

#include "plc/computer/language_parts.h"
#include "plc/computer/messages.h"
#include "plc/computer/python_program.h"
#include "plc/shared/headings.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/reserved_words.h"
#include "plc/shared/step_ranges.h"
#include "program/bit_names.h"

namespace grafwire {

namespace {

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

}  // namespace

PythonProgram::PythonProgram(const Grafcet& grafcet, const ScanProgram& program, Language language)
    : grafcet_(grafcet),
      program_(without_idle_tables(program)),
      language_(language),
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

}  // namespace grafwire
