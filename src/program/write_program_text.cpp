// The program as text: one statement a line, bits by the names of their tables.

#include <fmt/format.h>

#include "grafcet/expression.h"
#include "program/bit_names.h"

namespace grafwire {

namespace {

class ProgramText {
  public:
    ProgramText(const Grafcet& grafcet, const ScanProgram& program, Language language)
        : grafcet_(grafcet), program_(program), language_(language) {}

    std::string write() {
        static constexpr const char* names[section_count] = {"start",      "begin",     "edges",
                                                             "conditions", "evolution", "orders",
                                                             "stored",     "times",     "outputs"};
        for (std::size_t s = 0; s < section_count; ++s) {
            for (const Statement& statement : program_.sections[s]) {
                text_ += fmt::format("{}: ", names[s]);
                write_statement(statement);
                text_ += fmt::format("  # {}\n", statement.comment.in(language_));
            }
        }
        return std::move(text_);
    }

  private:
    std::string name(Bit bit) const;
    std::string name(IntegerCell cell) const {
        if (cell.is_scratch) return fmt::format("I{}", cell.index);
        return grafcet_.counters[CounterId{cell.index}].name;
    }
    std::string text(const Sum& sum) const;
    std::string text(const Condition& condition, bool in_product = false) const;
    void write_statement(const Statement& statement);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Language language_;
    std::string text_;
};

std::string ProgramText::name(Bit bit) const {
    const std::string_view table = table_name(bit.kind);
    if (!table.empty()) return fmt::format("{}[{}]", table, name_in_chart(grafcet_, bit));
    switch (bit.kind) {
        case BitKind::edge:
            return fmt::format("edge[{}]", bit.index);
        case BitKind::edge_memory:
            return fmt::format("memory[{}]", bit.index);
        case BitKind::time_value:
            return fmt::format("time[{}]", bit.index);
        case BitKind::scratch:
            return fmt::format("S{}", bit.index);
        default:
            return name_in_chart(grafcet_, bit);
    }
}

std::string ProgramText::text(const Sum& sum) const {
    std::string text;
    for (const SumTerm& term : sum) {
        if (term.negative) {
            text += "-";
        } else if (!text.empty()) {
            text += "+";
        }
        text += term.counter == SumTerm::no_counter ? fmt::format("{}", term.value)
                                                    : name({false, term.counter});
    }
    return text;
}

std::string ProgramText::text(const Condition& condition, bool in_product) const {
    switch (condition.kind) {
        case Condition::Kind::constant:
            return condition.value ? "1" : "0";
        case Condition::Kind::bit:
            return name(condition.bit);
        case Condition::Kind::negation:
            return "/" + text(condition.operands.front(), true);
        case Condition::Kind::comparison:
            return fmt::format("[{} {} {}]", text(condition.comparison.left),
                               text_of(condition.comparison.relation),
                               text(condition.comparison.right));
        default:
            break;
    }
    const char* between = condition.kind == Condition::Kind::conjunction   ? " . "
                          : condition.kind == Condition::Kind::disjunction ? " + "
                                                                           : " xor ";
    std::string joined;
    for (const Condition& operand : condition.operands) {
        if (!joined.empty()) joined += between;
        joined += text(operand, true);
    }
    return in_product ? "(" + joined + ")" : joined;
}

void ProgramText::write_statement(const Statement& statement) {
    std::string targets;
    for (const Bit bit : statement.targets) {
        if (!targets.empty()) targets += " ";
        targets += name(bit);
    }
    switch (statement.kind) {
        case Statement::Kind::assign:
            text_ += fmt::format("{} := {}", targets, text(statement.condition));
            break;
        case Statement::Kind::set:
            text_ += fmt::format("set {} if {}", targets, text(statement.condition));
            break;
        case Statement::Kind::reset:
            text_ += fmt::format("reset {} if {}", targets, text(statement.condition));
            break;
        case Statement::Kind::move:
            text_ +=
                fmt::format("{} := {} within {}..{} if {}", name(statement.integer),
                            statement.sum.empty() ? name(statement.source) : text(statement.sum),
                            statement.low, statement.high, text(statement.condition));
            break;
        case Statement::Kind::time:
            text_ += fmt::format("{} := {}/{}/{}", targets, format_duration(statement.on_delay),
                                 text(statement.condition), format_duration(statement.off_delay));
            break;
        case Statement::Kind::table:
            text_ += "table";
            break;
    }
}

}  // namespace

std::string write_program_text(const Grafcet& grafcet, const ScanProgram& program,
                               Language language) {
    return ProgramText(grafcet, program, language).write();
}

}  // namespace grafwire
