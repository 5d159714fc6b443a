#include "equations/report/latex_expression.h"
#include "equations/report/page.h"

namespace grafwire {

namespace {

class LatexPage : public Page {
  public:
    LatexPage(const Grafcet& grafcet, const Expressions& pool) : grafcet_(grafcet), pool_(pool) {}

    std::string expression(ExprId id) const override {
        return latex_expression(grafcet_, pool_, id);
    }
    std::string name(Variable variable) const override { return latex_name(grafcet_, variable); }
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
