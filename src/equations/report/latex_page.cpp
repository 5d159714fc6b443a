// The page in LaTeX: a fragment for a document with the package amsmath. Negations are overlines,
// as in the course, so a formula needs fewer parentheses than in the `.grafcet` language: `/(a +
// b)` is
// `\overline{a + b}`.

#include <algorithm>
#include <vector>

#include "equations/report/page.h"
#include "equations/report/report_parts.h"
#include "grafcet/write_grafcet.h"
#include "text/utf8.h"

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

/// Words for LaTeX's text mode, special characters escaped.
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

/// A name in mathematical mode: `m`, `\mathrm{dcy}`, `\text{H+}`.
std::string latex_identifier(std::string_view name) {
    if (name.size() == 1 && is_ascii_letter(name.front())) return std::string(name);
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
        return is_ascii_letter(c) || is_digit(c) || c == '_';
    });
    return (plain ? "\\mathrm{" : "\\text{") + latex_words(name) + "}";
}

/// `_{10}` of step 10, `_{\mathrm{start}}` of a step with a name.
std::string latex_subscript(std::string_view name) {
    if (std::all_of(name.begin(), name.end(), is_digit)) return "_{" + std::string(name) + "}";
    return "_{" + latex_identifier(name) + "}";
}

/// `\mathit{CAX}_{10}`; for X `X_{10}`.
std::string latex_of_step(const Grafcet& grafcet, std::string_view quantity, StepId step) {
    const std::string symbol =
        quantity.size() == 1 ? std::string(quantity) : "\\mathit{" + std::string(quantity) + "}";
    return symbol + latex_subscript(grafcet.steps[step].name);
}

/// The name of a variable in mathematical mode: `X_{10}`, `m`, `\mathrm{dcy}`, `\text{H+}`.
std::string latex_name(const Grafcet& grafcet, Variable variable) {
    if (variable.kind == VariableKind::step) {
        return latex_of_step(grafcet, "X", static_cast<StepId>(variable.index));
    }
    return latex_identifier(variable_name(grafcet, variable));
}

/// `\mathrm{pieces} + 1`
std::string latex_sum(const Grafcet& grafcet, const Sum& sum) {
    return sum_text(sum, [&](Variable counter) { return latex_name(grafcet, counter); });
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

/// An expression in mathematical mode, with overlines for negations. What is still to be written is
/// kept in a stack of its own, so that the depth of calls does not grow with the expression.
class LatexExpression {
  public:
    LatexExpression(const Grafcet& grafcet, const Expressions& pool)
        : grafcet_(grafcet), pool_(pool) {}

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
    /// Either an expression in a place that asks for a binding, or a text.
    struct Piece {
        ExprId id = no_expr;
        Binding least = loosest;
        std::string text;
    };

    void later(ExprId id, Binding least) { pending_.push_back({id, least, {}}); }
    void later(std::string text) { pending_.push_back({no_expr, loosest, std::move(text)}); }

    /// Writes the first piece of an expression, and keeps the rest for later, last first.
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

/// LaTeX: formulas in mathematical mode, equations aligned at the sign.
class LatexPage : public Page {
  public:
    LatexPage(const Grafcet& grafcet, const Expressions& pool) : grafcet_(grafcet), pool_(pool) {}

    std::string expression(ExprId id) const override {
        return LatexExpression(grafcet_, pool_).print(id);
    }
    std::string name(Variable variable) const override { return latex_name(grafcet_, variable); }
    std::string name(VarId var) const override { return latex_identifier(grafcet_.vars[var].name); }
    std::string of_step(std::string_view quantity, StepId step) const override {
        return latex_of_step(grafcet_, quantity, step);
    }
    std::string held(StepId step) const override {
        return "\\overline{" + of_step("CDX", step) + "} \\cdot " + of_step("X", step);
    }
    std::string write(Variable target, const StoredWrite& write) const override {
        const std::string value =
            write.sum.empty() ? expression(write.value) : latex_sum(grafcet_, write.sum);
        return name(target) + " := " + value;
    }

    void title(std::string_view text) override {
        text_ += "% \\usepackage{amsmath}\n\\section*{" + latex_words(text) + "}\n";
    }
    void heading(std::string_view text) override {
        text_ += "\n\\subsection*{" + latex_words(text) + "}\n";
    }
    void paragraph(std::string_view text) override { text_ += "\n" + latex_words(text) + "\n"; }

    void begin_table(const std::vector<Cell>& head) override {
        text_ += "\n\\begin{tabular}{" + std::string(head.size(), 'l') + "}\n";
        row(head);
        text_ += "\\hline\n";
    }
    void row(const std::vector<Cell>& cells) override {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (i > 0) text_ += " & ";
            text_ += cells[i].is_formula ? "$" + cells[i].text + "$" : latex_words(cells[i].text);
        }
        text_ += " \\\\\n";
    }
    void end_table() override { text_ += "\\end{tabular}\n"; }

    void begin_equations() override {
        text_ += "\n\\begin{align*}\n";
        first_equation_ = true;
    }
    void equation(const std::string& left, const std::string& right) override {
        if (!first_equation_) text_ += " \\\\\n";
        first_equation_ = false;
        text_ += left + " &= " + right;
    }
    void end_equations() override { text_ += "\n\\end{align*}\n"; }

    std::string finish() override { return std::move(text_); }

  private:
    const Grafcet& grafcet_;
    const Expressions& pool_;
    std::string text_;
    bool first_equation_ = true;
};

}  // namespace

std::unique_ptr<Page> latex_page(const Grafcet& grafcet, const Expressions& pool) {
    return std::make_unique<LatexPage>(grafcet, pool);
}

}  // namespace grafwire
