// Expressions and names in the notation of the `.grafcet` language. An expression has the
// parentheses that its reader needs, and no others; reading it back gives the same expression, down
// to the nesting of its operators. Three places need more than the ranks of operators: a chain
// within a chain of its own kind, an off-delay behind a time condition that has none (`1s/2s/a`
// would take it for its own), and a digit after a point, which would be read as part of a duration.

#include <fmt/format.h>

#include "grafcet/expression.h"
#include "grafcet/expression_rank.h"
#include "grafcet/lexer.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

/// Recursive: expressions are nested a few hundred levels deep at most.
class ExpressionWriter {
  public:
    ExpressionWriter(const Grafcet& grafcet, const Expressions& expressions)
        : grafcet_(grafcet), expressions_(expressions) {}

    std::string take() { return std::move(out_); }

    void write(ExprId id) {
        switch (expressions_.kind(id)) {
            case ExprKind::constant:
                out_ += expressions_.constant_value(id) ? '1' : '0';
                break;
            case ExprKind::variable:
                append_variable_name(out_, variable_name(grafcet_, expressions_.variable_of(id)));
                break;
            case ExprKind::negation:
                write_prefix("/", id);
                break;
            case ExprKind::rise:
                write_prefix("↑", id);
                break;
            case ExprKind::fall:
                write_prefix("↓", id);
                break;
            case ExprKind::time_condition:
                write_time(expressions_.time_condition_of(id));
                break;
            case ExprKind::comparison:
                write_comparison(expressions_.comparison_of(id));
                break;
            case ExprKind::conjunction:
                write_chain(id, ".");
                break;
            case ExprKind::exclusive_or:
                write_chain(id, " ⊕ ");
                break;
            case ExprKind::disjunction:
                write_chain(id, " + ");
                break;
        }
    }

  private:
    void write_in_parentheses(ExprId id) {
        out_ += '(';
        write(id);
        out_ += ')';
    }

    /// The operand of a sign: in parentheses where it is a chain.
    void write_unary(ExprId id) {
        if (rank_of(expressions_.kind(id)) == Rank::unary) {
            write(id);
        } else {
            write_in_parentheses(id);
        }
    }

    void write_prefix(std::string_view sign, ExprId id) {
        out_ += sign;
        write_unary(expressions_.operands(id)[0]);
    }

    /// A chain within a chain of the same kind was written with parentheses and keeps them.
    void write_chain(ExprId id, std::string_view sign) {
        const Rank rank = rank_of(expressions_.kind(id));
        bool is_first = true;
        for (const ExprId operand : expressions_.operands(id)) {
            const std::size_t sign_at = out_.size();
            if (!is_first) out_ += sign;
            const std::size_t operand_at = out_.size();
            if (rank_of(expressions_.kind(operand)) <= rank) {
                write_in_parentheses(operand);
            } else {
                write(operand);
            }
            // `1.5s/a` would be read as one duration.
            const bool is_digit = out_[operand_at] >= '0' && out_[operand_at] <= '9';
            if (!is_first && sign == "." && is_digit) out_.replace(sign_at, 1, " . ");
            is_first = false;
        }
    }

    /// `1s/a/2s`
    void write_time(const TimeCondition& time) {
        out_ += format_duration(time.on_delay);
        out_ += '/';
        if (time.off_delay != 0 && takes_off_delay(time.operand)) {
            write_in_parentheses(time.operand);
        } else {
            write_unary(time.operand);
        }
        if (time.off_delay != 0) out_ += '/' + format_duration(time.off_delay);
    }

    /// Whether an off-delay written after this operand would be read as part of it.
    bool takes_off_delay(ExprId id) const {
        while (true) {
            switch (expressions_.kind(id)) {
                case ExprKind::negation:
                case ExprKind::rise:
                case ExprKind::fall:
                    id = expressions_.operands(id)[0];
                    break;
                case ExprKind::time_condition:
                    return expressions_.time_condition_of(id).off_delay == 0;
                default:
                    return false;
            }
        }
    }

    void write_comparison(const Comparison& comparison) {
        out_ += '[';
        append_sum(out_, grafcet_, comparison.left);
        out_ += ' ';
        out_ += text_of(comparison.relation);
        out_ += ' ';
        append_sum(out_, grafcet_, comparison.right);
        out_ += ']';
    }

    const Grafcet& grafcet_;
    const Expressions& expressions_;
    std::string out_;
};

}  // namespace

void append_name(std::string& out, std::string_view name) {
    if (is_plain_word(name) || is_integer(name)) {
        out += name;
        return;
    }
    out += '"';
    out += name;
    out += '"';
}

void append_variable_name(std::string& out, std::string_view name) {
    if (is_integer(name)) {
        out += '"';
        out += name;
        out += '"';
    } else {
        append_name(out, name);
    }
}

void append_sum(std::string& out, const Grafcet& grafcet, const Sum& sum) {
    bool is_first = true;
    for (const SumTerm& term : sum) {
        if (is_first) {
            out += term.negative ? "-" : "";
        } else {
            out += term.negative ? " - " : " + ";
        }
        if (term.counter == SumTerm::no_counter) {
            out += std::to_string(term.value);
        } else {
            append_variable_name(out, grafcet.counters.items()[term.counter].name);
        }
        is_first = false;
    }
}

std::string quoted_where_needed(std::string_view name) {
    std::string out;
    append_name(out, name);
    return out;
}

std::string write_expression(const Grafcet& grafcet, const Expressions& expressions, ExprId id) {
    ExpressionWriter writer(grafcet, expressions);
    writer.write(id);
    return writer.take();
}

}  // namespace grafwire
