// The printer keeps its own stack of what is still to be written, so that its depth does not grow
// with the expression.

#include "equations/report/latex_expression.h"

#include <algorithm>
#include <vector>

#include "text/characters.h"

namespace grafwire {

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

std::string latex_identifier(std::string_view name) {
    if (name.size() == 1 && is_ascii_letter(name.front())) return std::string(name);
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
        return is_ascii_letter(c) || is_digit(c) || c == '_';
    });
    return (plain ? "\\mathrm{" : "\\text{") + latex_words(name) + "}";
}

std::string latex_subscript(std::string_view name) {
    if (std::all_of(name.begin(), name.end(), is_digit)) return "_{" + std::string(name) + "}";
    return "_{" + latex_identifier(name) + "}";
}

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

class Printer {
  public:
    Printer(const Grafcet& grafcet, const Expressions& pool) : grafcet_(grafcet), pool_(pool) {}

    std::string print(ExprId root) {
        later(root, loosest);
        while (!pending_.empty()) {
            const Piece piece = std::move(pending_.back());
            pending_.pop_back();
            if (piece.id == no_expr) {
                text_ += piece.text;
            } else {
                expand(piece.id, piece.least);
            }
        }
        return std::move(text_);
    }

  private:
    // Either an expression in a place that asks for a binding, or a text.
    struct Piece {
        ExprId id = no_expr;
        Binding least = loosest;
        std::string text;
    };

    void later(ExprId id, Binding least) { pending_.push_back({id, least, {}}); }
    void later(std::string text) { pending_.push_back({no_expr, loosest, std::move(text)}); }

    // Pieces are pushed last first.
    void expand(ExprId id, Binding least) {
        const Binding binding = binding_of(pool_.kind(id));
        if (binding < least) {
            later(")");
            text_ += '(';
        }
        switch (pool_.kind(id)) {
            case ExprKind::constant:
                text_ += pool_.constant_value(id) ? '1' : '0';
                break;
            case ExprKind::variable:
                text_ += latex_name(grafcet_, pool_.variable_of(id));
                break;
            case ExprKind::negation:
                text_ += "\\overline{";
                later("}");
                later(pool_.operands(id).front(), loosest);
                break;
            case ExprKind::conjunction:
                join(id, " \\cdot ", binding);
                break;
            case ExprKind::disjunction:
                join(id, " + ", binding);
                break;
            case ExprKind::exclusive_or:
                join(id, " \\oplus ", binding);
                break;
            case ExprKind::rise:
                text_ += "\\uparrow ";
                later(pool_.operands(id).front(), tightest);
                break;
            case ExprKind::fall:
                text_ += "\\downarrow ";
                later(pool_.operands(id).front(), tightest);
                break;
            case ExprKind::time_condition:
                time_condition(pool_.time_condition_of(id));
                break;
            case ExprKind::comparison:
                text_ += latex_comparison(grafcet_, pool_.comparison_of(id));
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

    void time_condition(const TimeCondition& condition) {
        text_ += latex_duration(condition.on_delay) + "/";
        if (condition.off_delay != 0) later("/" + latex_duration(condition.off_delay));
        later(condition.operand, tightest);
    }

    const Grafcet& grafcet_;
    const Expressions& pool_;
    std::vector<Piece> pending_;
    std::string text_;
};

}  // namespace

std::string latex_expression(const Grafcet& grafcet, const Expressions& expressions, ExprId id) {
    return Printer(grafcet, expressions).print(id);
}

std::string latex_name(const Grafcet& grafcet, Variable variable) {
    if (variable.kind == VariableKind::step) {
        return latex_of_step(grafcet, "X", static_cast<StepId>(variable.index));
    }
    return latex_identifier(variable_name(grafcet, variable));
}

std::string latex_of_step(const Grafcet& grafcet, std::string_view quantity, StepId step) {
    const std::string symbol =
        quantity.size() == 1 ? std::string(quantity) : "\\mathit{" + std::string(quantity) + "}";
    return symbol + latex_subscript(grafcet.steps[step].name);
}

std::string latex_sum(const Grafcet& grafcet, const Sum& sum) {
    std::string text;
    for (const SumTerm& term : sum) {
        if (term.negative) text += text.empty() ? "-" : " - ";
        if (!term.negative && !text.empty()) text += " + ";
        text += term.counter == SumTerm::no_counter
                    ? std::to_string(term.value)
                    : latex_name(grafcet, {VariableKind::counter, term.counter});
    }
    return text;
}

std::string latex_words(std::string_view words) {
    std::string text;
    for (const char c : words) {
        if (std::string_view("{}$&#%_").find(c) != std::string_view::npos) {
            text += '\\';
            text += c;
        } else if (c == '\\') {
            text += "\\textbackslash{}";
        } else if (c == '^') {
            text += "\\textasciicircum{}";
        } else if (c == '~') {
            text += "\\textasciitilde{}";
        } else if (c == '<') {
            text += "\\textless{}";
        } else if (c == '>') {
            text += "\\textgreater{}";
        } else if (c == '|') {
            text += "\\textbar{}";
        } else {
            text += c;
        }
    }
    return text;
}

}  // namespace grafwire
