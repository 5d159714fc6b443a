// Structured Text.
//
// The tables are arrays and whole-table formulas are loops over them, as in the method; a statement
// per transition, with the chart's own text above it. Precedence is left to parentheses wherever
// AND, OR and XOR meet: few readers know by heart which binds tighter.

#include <fmt/format.h>

#include <functional>
#include <span>

#include "grafcet/grafcet.h"
#include "iec/identifiers.h"
#include "iec/literals.h"
#include "iec/operators.h"
#include "plc/iec/iec_block.h"
#include "plc/iec/languages.h"
#include "plc/iec/messages.h"
#include "plc/shared/condition_text.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"

namespace grafwire {

namespace {

constexpr ConditionSpelling spelling = {iec::word_of(iec::Precedence::negation),
                                        iec::word_of(iec::Precedence::conjunction),
                                        iec::word_of(iec::Precedence::disjunction),
                                        iec::word_of(iec::Precedence::exclusive_or),
                                        iec::word_true,
                                        iec::word_false,
                                        iec::relation_signs,
                                        true,
                                        "",
                                        ""};

class StWriter {
  public:
    StWriter(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options)
        : grafcet_(grafcet),
          program_(program),
          options_(options),
          language_(options.language),
          names_(grafcet, program, IecTables::arrays, iec::is_keyword),
          conditions_(
              spelling, [this](Bit bit) { return names_.of(bit); },
              [this](IntegerCell cell) { return names_.of(cell); }) {}

    std::string write(Diagnostics& diagnostics) {
        const std::string declarations =
            iec_declarations(grafcet_, program_, names_, messages::plc_iec::structured_text(),
                             options_, diagnostics);
        if (diagnostics.has_errors()) return {};
        for (std::size_t s = 0; s < section_count; ++s) write_section(static_cast<SectionKind>(s));
        return declarations + out_.take() + "\nEND_FUNCTION_BLOCK\n";
    }

  private:
    void write_section(SectionKind kind);
    void write_statement(const Statement& statement);
    void write_table_loop(std::span<const Statement> statements);
    void write_table_formula(TableOperation operation);
    void write_range(const StepRange& range, std::string_view value);
    void write_assignments(const Statement& statement, std::string_view value);
    void write_where(const Condition& condition, const std::function<void()>& body);
    bool is_within(const Statement& statement) const;
    void write_move(const Statement& statement);
    void write_time(const Statement& statement);

    std::string at(BitKind kind) const {
        return fmt::format("{}[{}]", names_.table(kind), names_.any);
    }
    void line(std::string_view written) { out_.line(written); }
    void comment(std::string_view words) { out_.whole_line(iec_comment(words)); }

    const Grafcet& grafcet_;
    ScanProgram program_;
    const PlcOptions& options_;
    Language language_;
    IecNames names_;
    ConditionText conditions_;
    SourceText out_{"(*"};
};

void StWriter::write_section(SectionKind kind) {
    const std::vector<Statement>& statements = program_.section(kind);
    if (statements.empty() && kind != SectionKind::start) return;
    out_.blank();
    comment(section_title(kind).in(language_));
    const bool first_scan = kind == SectionKind::start;
    if (first_scan) {
        line(fmt::format("IF NOT {} THEN", names_.started));
        out_.indent();
        line(fmt::format("{} := TRUE;", names_.started));
    }
    for (std::size_t at = 0; at < statements.size();) {
        std::size_t end = at;
        while (end < statements.size() && statements[end].kind == Statement::Kind::table) ++end;
        if (end > at) {
            write_table_loop(std::span(statements).subspan(at, end - at));
            at = end;
        } else {
            write_statement(statements[at++]);
        }
    }
    if (!first_scan) return;
    out_.outdent();
    line("END_IF;");
}

/// Whole-table operations that follow each other share one loop.
void StWriter::write_table_loop(std::span<const Statement> statements) {
    const std::size_t steps = grafcet_.steps.size();
    if (steps == 0) return;
    for (const Statement& statement : statements) comment(statement.comment.in(language_));
    line(fmt::format("FOR {} := 0 TO {} DO", names_.any, steps - 1));
    out_.indent();
    for (const Statement& statement : statements) write_table_formula(statement.operation);
    out_.outdent();
    line("END_FOR;");
}

void StWriter::write_table_formula(TableOperation operation) {
    const std::string now = at(BitKind::step);
    const std::string before = at(BitKind::previous);
    switch (operation) {
        case TableOperation::remember:
            line(fmt::format("{} := {};", before, now));
            break;
        case TableOperation::clear:
            line(at(BitKind::activate) + " := FALSE;");
            line(at(BitKind::deactivate) + " := FALSE;");
            if (!has_forcing(program_)) break;
            line(at(BitKind::forced_on) + " := FALSE;");
            line(at(BitKind::forced_off) + " := FALSE;");
            break;
        case TableOperation::evolve:
            line(fmt::format("{} := ({} AND NOT {}) OR {};", now, before, at(BitKind::deactivate),
                             at(BitKind::activate)));
            break;
        case TableOperation::force:
            line(fmt::format("{} := ({} AND NOT {}) OR {};", now, now, at(BitKind::forced_off),
                             at(BitKind::forced_on)));
            break;
        case TableOperation::pulse:
            line(fmt::format("{} := {} AND NOT {};", at(BitKind::pulse), now, before));
            break;
    }
}

void StWriter::write_where(const Condition& condition, const std::function<void()>& body) {
    if (condition.is_constant(true)) return body();
    line(fmt::format("IF {} THEN", conditions_.of(condition)));
    out_.indent();
    body();
    out_.outdent();
    line("END_IF;");
}

/// A loop where it is shorter.
void StWriter::write_range(const StepRange& range, std::string_view value) {
    if (range.last - range.first < 3) {
        for (std::uint32_t step = range.first; step <= range.last; ++step) {
            line(fmt::format("{} := {};", names_.of(Bit{range.table, step}), value));
        }
        return;
    }
    line(fmt::format("FOR {} := {} TO {} DO", names_.any,
                     names_.index_of({range.table, range.first}),
                     names_.index_of({range.table, range.last})));
    out_.indent();
    line(fmt::format("{} := {};", at(range.table), value));
    out_.outdent();
    line("END_FOR;");
}

void StWriter::write_assignments(const Statement& statement, std::string_view value) {
    write_where(statement.condition, [&] {
        for (const StepRange& range : step_ranges(statement.targets)) write_range(range, value);
        for (const Bit bit : single_bits(statement.targets)) {
            line(fmt::format("{} := {};", names_.of(bit), value));
        }
    });
}

/// What lies within the range anyway needs no limits.
bool StWriter::is_within(const Statement& statement) const {
    const IntegerRange range = value_range(grafcet_, statement.sum);
    return range.low >= statement.low && range.high <= statement.high;
}

void StWriter::write_move(const Statement& statement) {
    const std::string value =
        statement.sum.empty() ? names_.of(statement.source) : conditions_.of(statement.sum);
    const bool within = statement.sum.empty() || is_within(statement);
    write_where(statement.condition, [&] {
        const std::string target = names_.of(statement.integer);
        line(within ? fmt::format("{} := {};", target, value)
                    : fmt::format("{} := LIMIT({}, {}, {});", target, statement.low, value,
                                  statement.high));
    });
}

void StWriter::write_time(const Statement& statement) {
    const Bit bit = statement.targets.front();
    const std::string operand = conditions_.of(statement.condition);
    const auto call = [&](const std::string& timer, const std::string& input, Time delay) {
        line(fmt::format("{}(IN := {}, PT := {});", timer, input, iec::time_literal(delay)));
    };
    const std::string value = names_.of(bit);
    switch (iec_timer_for(statement.on_delay, statement.off_delay)) {
        case IecTimer::copy:
            line(fmt::format("{} := {};", value, operand));
            break;
        case IecTimer::ton:
            call(names_.on_timer(bit.index), operand, statement.on_delay);
            break;
        case IecTimer::tof:
            call(names_.off_timer(bit.index), operand, statement.off_delay);
            break;
        case IecTimer::latch:
            call(names_.on_timer(bit.index),
                 conditions_.of(
                     and_condition({statement.condition, not_condition(bit_condition(bit))})),
                 statement.on_delay);
            call(names_.off_timer(bit.index),
                 conditions_.of(
                     and_condition({not_condition(statement.condition), bit_condition(bit)})),
                 statement.off_delay);
            line(fmt::format("{} := ({} AND NOT {}.Q) OR {}.Q;", value, value,
                             names_.off_timer(bit.index), names_.on_timer(bit.index)));
            break;
    }
}

void StWriter::write_statement(const Statement& statement) {
    comment(statement.comment.in(language_));
    switch (statement.kind) {
        case Statement::Kind::assign:
            line(fmt::format("{} := {};", names_.of(statement.targets.front()),
                             conditions_.of(statement.condition)));
            break;
        case Statement::Kind::set:
            write_assignments(statement, "TRUE");
            break;
        case Statement::Kind::reset:
            write_assignments(statement, "FALSE");
            break;
        case Statement::Kind::move:
            write_move(statement);
            break;
        case Statement::Kind::time:
            write_time(statement);
            break;
        case Statement::Kind::table:
            break;
    }
}

}  // namespace

std::string write_st(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     Diagnostics& diagnostics) {
    return StWriter(grafcet, without_idle_tables(program), options).write(diagnostics);
}

}  // namespace grafwire
