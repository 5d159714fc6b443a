// Negations are overlines, as in the course, so a formula needs fewer parentheses than in the
// `.grafcet` language: `/(a + b)` is `\overline{a + b}`. TeX cannot break a line below an overline,
// so one that is too wide is written as the language does, with a slash.

#include "equations/report/latex_expression.h"

#include <vector>

#include "equations/report/latex_text.h"
#include "equations/report/report_parts.h"
#include "text/time.h"
#include "text/utf8.h"

namespace grafwire {

std::string latex_name(const Grafcet& grafcet, Variable variable) {
    if (variable.kind == VariableKind::step) {
        return latex_indexed("X", grafcet.steps[static_cast<StepId>(variable.index)].name);
    }
    return latex_identifier(variable_name(grafcet, variable));
}

std::string latex_sum(const Grafcet& grafcet, const Sum& sum) {
    return sum_text(sum, [&](Variable counter) { return latex_name(grafcet, counter); });
}

namespace {

/// How tightly an expression binds; what is looser than its place asks for gets parentheses.
enum Binding { loosest, disjunction, exclusive_or, conjunction, prefix, tightest };

Binding binding_of(ExprKind kind) {
    switch (kind) {
        case ExprKind::disjunction:
            return disjunction;
        case ExprKind::exclusive_or:
            return exclusive_or;
        case ExprKind::conjunction:
            return conjunction;
        case ExprKind::rise:
        case ExprKind::fall:
        case ExprKind::time_condition:
            return prefix;
        default:
            return tightest;
    }
}

/// `1.5\,\mathrm{s}`
std::string latex_duration(Time duration) {
    const std::string text = format_duration(duration);
    const std::size_t unit = text.find_first_not_of("0123456789.");
    if (unit == std::string::npos) return text;
    return text.substr(0, unit) + "\\,\\mathrm{" + text.substr(unit) + "}";
}

std::string latex_comparison(const Grafcet& grafcet, const Comparison& comparison) {
    constexpr const char* relations[] = {" = ", " \\neq ", " < ", " \\leq ", " > ", " \\geq "};
    return "[" + latex_sum(grafcet, comparison.left) +
           relations[static_cast<std::size_t>(comparison.relation)] +
           latex_sum(grafcet, comparison.right) + "]";
}

/// Writes an expression. What is still to be written is kept in a stack of its own, so that the
/// depth of calls does not grow with the expression.
class Writer {
  public:
    Writer(const Grafcet& grafcet, const Expressions& pool, double room, bool with_breaks)
        : grafcet_(grafcet), pool_(pool), room_(room), with_breaks_(with_breaks) {}

    LatexFormula write(ExprId root) {
        later(root, loosest);
        while (!pending_.empty()) {
            const Piece piece = std::move(pending_.back());
            pending_.pop_back();
            switch (piece.kind) {
                case Piece::Kind::expression:
                    expand(piece.id, piece.least);
                    break;
                case Piece::Kind::text:
                    formula_.text += piece.text;
                    break;
                case Piece::Kind::closing:
                    formula_.text += ')';
                    --depth_;
                    break;
                case Piece::Kind::end_of_overline:
                    end_overline();
                    break;
            }
        }
        return std::move(formula_);
    }

  private:
    /// What is still to be written: an expression in a place that asks for a binding, a text, a
    /// closing parenthesis, the end of an overline.
    struct Piece {
        enum class Kind { expression, text, closing, end_of_overline };
        Kind kind = Kind::text;
        ExprId id = no_expr;
        Binding least = loosest;
        std::string text;
    };

    void later(ExprId id, Binding least) {
        pending_.push_back({Piece::Kind::expression, id, least, {}});
    }
    void later(std::string text) {
        pending_.push_back({Piece::Kind::text, no_expr, loosest, std::move(text)});
    }
    void later(Piece::Kind kind) { pending_.push_back({kind, no_expr, loosest, {}}); }

    /// Writes the first piece of an expression, and keeps the rest for later, last first.
    void expand(ExprId id, Binding least) {
        const Binding binding = binding_of(pool_.kind(id));
        if (binding < least) {
            later(Piece::Kind::closing);
            formula_.text += '(';
            ++depth_;
        }
        switch (pool_.kind(id)) {
            case ExprKind::constant:
                formula_.text += pool_.constant_value(id) ? '1' : '0';
                break;
            case ExprKind::variable:
                formula_.text += latex_name(grafcet_, pool_.variable_of(id));
                break;
            case ExprKind::negation:
                overlines_.push_back(formula_.text.size());
                later(Piece::Kind::end_of_overline);
                later(pool_.operands(id).front(), loosest);
                break;
            case ExprKind::conjunction:
                join(id, " \\cdot ", binding);
                break;
            case ExprKind::disjunction:
                join(id, is_broken_best_here() ? " \\allowbreak + " : " + ", binding);
                break;
            case ExprKind::exclusive_or:
                join(id, " \\oplus ", binding);
                break;
            case ExprKind::rise:
                formula_.text += "{\\uparrow}";
                later(pool_.operands(id).front(), tightest);
                break;
            case ExprKind::fall:
                formula_.text += "{\\downarrow}";
                later(pool_.operands(id).front(), tightest);
                break;
            case ExprKind::time_condition:
                time_condition(pool_.time_condition_of(id));
                break;
            case ExprKind::comparison:
                comparison(pool_.comparison_of(id));
                break;
        }
    }

    void join(ExprId id, const char* sign, Binding binding) {
        const std::span<const ExprId> operands = pool_.operands(id);
        for (std::size_t i = operands.size(); i-- > 0;) {
            // A nested operator of the same kind is shown as such.
            later(operands[i], static_cast<Binding>(binding + 1));
            if (i > 0) later(sign);
        }
    }

    /// Within parentheses of parentheses TeX is left to find a place, and below an overline it has
    /// none.
    bool is_broken_best_here() const { return with_breaks_ && depth_ < 2 && overlines_.empty(); }

    /// The operand is written by now.
    void end_overline() {
        const std::size_t begin = overlines_.back();
        overlines_.pop_back();
        // What holds a slash already is too wide as well.
        const bool fits = printed_width(formula_.text.substr(begin, longest_measured)) <= room_;
        formula_.text.insert(begin, fits ? "\\overline{" : "/(");
        formula_.text += fits ? '}' : ')';
        formula_.has_slash = formula_.has_slash || !fits;
    }

    void time_condition(const TimeCondition& condition) {
        formula_.text += latex_duration(condition.on_delay) + "/";
        if (condition.off_delay != 0) later("/" + latex_duration(condition.off_delay));
        later(condition.operand, tightest);
    }

    /// In braces TeX breaks no line.
    void comparison(const Comparison& comparison) {
        const std::string text = latex_comparison(grafcet_, comparison);
        formula_.text += printed_width(text) <= room_ ? "{" + text + "}" : text;
    }

    /// More characters than those of anything that fits: what is measured of an operand.
    static constexpr std::size_t longest_measured = 2000;

    const Grafcet& grafcet_;
    const Expressions& pool_;
    double room_;
    bool with_breaks_;
    std::vector<Piece> pending_;
    std::vector<std::size_t> overlines_;  ///< where the operands of those that are open begin
    int depth_ = 0;                       ///< of parentheses
    LatexFormula formula_;
};

}  // namespace

LatexFormula latex_expression(const Grafcet& grafcet, const Expressions& pool, ExprId id,
                              double room) {
    LatexFormula formula = Writer(grafcet, pool, room, false).write(id);
    if (printed_width(formula.text) <= room) return formula;
    return Writer(grafcet, pool, room, true).write(id);
}

}  // namespace grafwire
