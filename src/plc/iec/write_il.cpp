// Instruction List.
//
// A condition is worked out in the current result, operand by operand in the order written; only
// what is compound and not first stands in parentheses. Set and reset act where the result is 1, so
// a transition is its conditions and then one line per step. Conditional moves jump.
//
// Compilers differ in how much of the language they have. None of the following is written: arrays,
// a parenthesis within a parenthesis (what is deeper is worked out beforehand into a bit of its
// own), a call with arguments.

#include <fmt/format.h>

#include <span>

#include "grafcet/grafcet.h"
#include "iec/identifiers.h"
#include "iec/literals.h"
#include "plc/iec/iec_block.h"
#include "plc/iec/languages.h"
#include "plc/iec/messages.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"

namespace grafwire {

namespace {

class IlWriter {
  public:
    IlWriter(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options)
        : grafcet_(grafcet),
          program_(program),
          options_(options),
          language_(options.language),
          names_(grafcet, program, IecTables::bits, iec::is_il_keyword) {}

    std::string write(Diagnostics& diagnostics) {
        // First what is executed: it says how many auxiliary bits there are to declare.
        for (std::size_t s = 0; s < section_count; ++s) write_section(static_cast<SectionKind>(s));
        const std::string declarations =
            iec_declarations(grafcet_, program_, names_, messages::plc_iec::instruction_list(),
                             options_, diagnostics);
        if (diagnostics.has_errors()) return {};
        return declarations + text_ + "\nEND_FUNCTION_BLOCK\n";
    }

  private:
    void write_section(SectionKind kind);
    void write_statement(const Statement& statement);
    void write_table(const Statement& statement);
    void write_move(const Statement& statement);
    void write_time(const Statement& statement);

    void load(const Condition& condition);
    void load_flat(const Condition& condition);
    Condition flat(Condition condition, bool in_parentheses);
    Condition aside(Condition condition);
    void combine(std::string_view operation, const Condition& operand);
    void compare(const Comparison& comparison);
    void load(const Sum& sum);
    std::string text(const SumTerm& term) const;

    void comment(std::string_view words) { text_ += iec_comment(words) + "\n"; }
    void label(std::string_view name) { text_ += fmt::format("{}:\n", name); }
    void op(std::string_view operation, std::string_view operand = {}) {
        const std::string indent(4 + 2 * depth_, ' ');
        text_ += operand.empty() ? fmt::format("{}{}\n", indent, operation)
                                 : fmt::format("{}{:<5} {}\n", indent, operation, operand);
    }
    void op(std::string_view operation, Bit bit) { op(operation, names_.of(bit)); }

    const Grafcet& grafcet_;
    ScanProgram program_;
    const PlcOptions& options_;
    Language language_;
    IecNames names_;
    std::string text_;
    std::size_t depth_ = 0;          ///< of parentheses
    std::uint32_t auxiliaries_ = 0;  ///< taken by the statement so far
};

std::string IlWriter::text(const SumTerm& term) const {
    return term.counter == SumTerm::no_counter ? fmt::format("{}", term.value)
                                               : names_.of(IntegerCell{false, term.counter});
}

void IlWriter::load(const Sum& sum) {
    const SumTerm& first = sum.front();
    if (first.negative && first.counter == SumTerm::no_counter) {
        op("LD", "-" + text(first));
    } else if (first.negative) {
        op("LD", "0");
        op("SUB", text(first));
    } else {
        op("LD", text(first));
    }
    for (const SumTerm& term : std::span(sum).subspan(1)) {
        op(term.negative ? "SUB" : "ADD", text(term));
    }
}

void IlWriter::compare(const Comparison& comparison) {
    static constexpr const char* operations[] = {"EQ", "NE", "LT", "LE", "GT", "GE"};
    const std::string operation = operations[static_cast<std::size_t>(comparison.relation)];
    load(comparison.left);
    const Sum& right = comparison.right;
    if (right.size() == 1 && !right.front().negative) return op(operation, text(right.front()));
    op(operation + "(");
    ++depth_;
    load(right);
    --depth_;
    op(")");
}

/// The current result and the operand, by AND, OR or XOR.
void IlWriter::combine(std::string_view operation, const Condition& operand) {
    const bool negated = operand.kind == Condition::Kind::negation;
    const Condition& inner = negated ? operand.operands.front() : operand;
    const std::string modified = fmt::format("{}{}", operation, negated ? "N" : "");
    if (inner.kind == Condition::Kind::bit) return op(modified, inner.bit);
    op(modified + "(");
    ++depth_;
    load_flat(inner);
    --depth_;
    op(")");
}

/// An auxiliary bit that has been given the value of a condition.
Condition IlWriter::aside(Condition condition) {
    load_flat(flat(std::move(condition), false));
    const Bit bit{BitKind::auxiliary, auxiliaries_++};
    if (bit.index == names_.auxiliary_count()) names_.add_auxiliary();
    op("ST", bit);
    return bit_condition(bit);
}

/// The condition with auxiliary bits where it would open a parenthesis within a parenthesis.
Condition IlWriter::flat(Condition condition, bool in_parentheses) {
    if (condition.kind == Condition::Kind::comparison) {
        const Sum& right = condition.comparison.right;
        const bool opens = right.size() > 1 || right.front().negative;
        return opens && in_parentheses ? aside(std::move(condition)) : condition;
    }
    for (Condition& operand : condition.operands) {
        // The first one is loaded, and opens no parenthesis of its own.
        if (&operand == condition.operands.data()) {
            operand = flat(std::move(operand), in_parentheses);
            continue;
        }
        Condition& inner =
            operand.kind == Condition::Kind::negation ? operand.operands.front() : operand;
        if (inner.kind == Condition::Kind::bit) continue;
        inner = in_parentheses ? aside(std::move(inner)) : flat(std::move(inner), true);
    }
    return condition;
}

void IlWriter::load(const Condition& condition) {
    auxiliaries_ = 0;
    load_flat(flat(condition, false));
}

void IlWriter::load_flat(const Condition& condition) {
    const char* operation = "XOR";
    switch (condition.kind) {
        case Condition::Kind::constant:
            return op("LD", condition.value ? "TRUE" : "FALSE");
        case Condition::Kind::bit:
            return op("LD", condition.bit);
        case Condition::Kind::negation:
            if (condition.operands.front().kind == Condition::Kind::bit) {
                return op("LDN", condition.operands.front().bit);
            }
            load_flat(condition.operands.front());
            return op("NOT");
        case Condition::Kind::comparison:
            return compare(condition.comparison);
        case Condition::Kind::conjunction:
            operation = "AND";
            break;
        case Condition::Kind::disjunction:
            operation = "OR";
            break;
        case Condition::Kind::exclusive_or:
            break;
    }
    load_flat(condition.operands.front());
    for (const Condition& operand : std::span(condition.operands).subspan(1)) {
        combine(operation, operand);
    }
}

void IlWriter::write_section(SectionKind kind) {
    const std::vector<Statement>& statements = program_.section(kind);
    if (statements.empty() && kind != SectionKind::start) return;
    text_ += '\n';
    comment(section_title(kind).in(language_));
    std::string after_start;
    if (kind == SectionKind::start) {
        after_start = names_.new_label("after_start");
        op("LD", names_.started);
        op("JMPC", after_start);
        op("LD", "TRUE");
        op("ST", names_.started);
    }
    for (const Statement& statement : statements) write_statement(statement);
    if (kind == SectionKind::start) label(after_start);
}

/// A whole-table operation, step by step.
void IlWriter::write_table(const Statement& statement) {
    if (grafcet_.steps.size() == 0) return;
    for (const Statement& single : expand_tables(grafcet_, statement)) {
        load(single.condition);
        if (single.kind == Statement::Kind::assign) {
            op("ST", single.targets.front());
            continue;
        }
        for (const Bit bit : single.targets) {
            const bool is_forced =
                bit.kind == BitKind::forced_on || bit.kind == BitKind::forced_off;
            if (!is_forced || has_forcing(program_)) op("R", bit);
        }
    }
}

void IlWriter::write_move(const Statement& statement) {
    const bool always = statement.condition.is_constant(true);
    const std::string after = always ? "" : names_.new_label("kept");
    if (!always) {
        load(statement.condition);
        op("JMPCN", after);
    }
    if (statement.sum.empty()) {
        op("LD", names_.of(statement.source));
    } else {
        load(statement.sum);
        // What lies within the range anyway needs no limits.
        const IntegerRange range = value_range(grafcet_, statement.sum);
        if (range.low < statement.low) op("MAX", fmt::format("{}", statement.low));
        if (range.high > statement.high) op("MIN", fmt::format("{}", statement.high));
    }
    op("ST", names_.of(statement.integer));
    if (!always) label(after);
}

void IlWriter::write_time(const Statement& statement) {
    const Bit value = statement.targets.front();
    const auto call = [&](const std::string& timer, const Condition& input, Time delay) {
        load(input);
        op("ST", timer + ".IN");
        op("LD", iec::time_literal(delay));
        op("ST", timer + ".PT");
        op("CAL", timer);
    };
    switch (iec_timer_for(statement.on_delay, statement.off_delay)) {
        case IecTimer::copy:
            load(statement.condition);
            op("ST", value);
            break;
        case IecTimer::ton:
            call(names_.on_timer(value.index), statement.condition, statement.on_delay);
            break;
        case IecTimer::tof:
            call(names_.off_timer(value.index), statement.condition, statement.off_delay);
            break;
        case IecTimer::latch:
            call(names_.on_timer(value.index),
                 and_condition({statement.condition, not_condition(bit_condition(value))}),
                 statement.on_delay);
            call(names_.off_timer(value.index),
                 and_condition({not_condition(statement.condition), bit_condition(value)}),
                 statement.off_delay);
            op("LD", value);
            op("ANDN", names_.off_timer(value.index) + ".Q");
            op("OR", names_.on_timer(value.index) + ".Q");
            op("ST", value);
            break;
    }
}

void IlWriter::write_statement(const Statement& statement) {
    comment(statement.comment.in(language_));
    switch (statement.kind) {
        case Statement::Kind::assign:
            load(statement.condition);
            op("ST", statement.targets.front());
            break;
        case Statement::Kind::set:
        case Statement::Kind::reset:
            load(statement.condition);
            for (const Bit bit : statement.targets) {
                op(statement.kind == Statement::Kind::set ? "S" : "R", bit);
            }
            break;
        case Statement::Kind::move:
            write_move(statement);
            break;
        case Statement::Kind::time:
            write_time(statement);
            break;
        case Statement::Kind::table:
            write_table(statement);
            break;
    }
}

}  // namespace

std::string write_il(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     Diagnostics& diagnostics) {
    return IlWriter(grafcet, without_idle_tables(program), options).write(diagnostics);
}

}  // namespace grafwire
