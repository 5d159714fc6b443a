// The page in LaTeX: a document for pdflatex on A4, or a fragment of one. TeX breaks the lines, so
// that the page fits whatever it is set in: equations are a list whose formulas go on behind the
// sign, tables that are too wide have columns with a share of the line. How wide things are is
// estimated; what cannot be broken is kept narrower than the narrowest column.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "equations/report/latex_expression.h"
#include "equations/report/latex_text.h"
#include "equations/report/messages.h"
#include "equations/report/page.h"
#include "text/joined.h"
#include "text/version.h"

namespace grafwire {

namespace {

/// In points: a line of A4 between margins of 20 mm, and the blank between two columns.
constexpr double line_width = 483;
constexpr double column_gap = 12;
/// Room for what cannot be broken: in a column of a table with four of them, and behind the sign of
/// an equation; and for the name before it.
constexpr double room_in_column = 100;
constexpr double room_in_equation = 320;
constexpr double room_before_sign = 110;
/// A table with more lines may be broken between two pages, and a row with more lines has to be.
constexpr double longest_whole_table = 24;
constexpr double longest_row = 40;

constexpr std::string_view packages = "\\usepackage{amsmath,array,booktabs,longtable}\n";

/// What the lists of equations have in common.
constexpr std::string_view list_settings =
    R"(\providecommand{\equationlist}[1]{\raggedright
  \settowidth{\labelwidth}{#1}\setlength{\leftmargin}{\labelwidth}%
  \addtolength{\leftmargin}{\labelsep}\setlength{\itemsep}{3pt}\setlength{\parsep}{0pt}}
)";

/// LaTeX: formulas in mathematical mode, equations aligned at the sign.
class LatexPage : public Page {
  public:
    LatexPage(const Grafcet& grafcet, const Expressions& pool, Language language, bool standalone)
        : grafcet_(grafcet), pool_(pool), language_(language), standalone_(standalone) {}

    std::string expression(ExprId id) override { return in_room(id, room_in_equation); }
    Cell cell(ExprId id) override { return formula(in_room(id, room_in_column)); }
    std::string name(Variable variable) const override { return latex_name(grafcet_, variable); }
    std::string name(VarId var) const override { return latex_identifier(grafcet_.vars[var].name); }
    std::string quantity(std::string_view quantity) const override {
        return latex_symbol(quantity);
    }
    std::string of_step(std::string_view quantity, StepId step) const override {
        return latex_indexed(quantity, grafcet_.steps[step].name);
    }
    std::string held() const override {
        return "\\overline{" + quantity("CDX") + "} \\cdot " + quantity("X");
    }
    std::string passage(std::span<const StepId> from, std::span<const StepId> to) const override {
        return product(from) + (from.empty() ? "\\to " : " \\to ") + product(to);
    }
    std::string write(Variable target, const StoredWrite& write) override {
        const std::string value =
            write.sum.empty() ? cell(write.value).text : latex_sum(grafcet_, write.sum);
        return name(target) + " := " + value;
    }

    void title(std::string_view text) override;
    void heading(std::string_view text) override {
        text_ += "\n\\subsection*{\\raggedright " + latex_words(text) + "}\n";
        after_heading_ = true;
    }
    void paragraph(std::string_view text) override {
        text_ += "\n\\noindent " + latex_words(text) + "\n";
        after_heading_ = false;
    }

    void begin_table(const std::vector<Cell>& head) override {
        rows_.clear();
        row(head);
    }
    void row(const std::vector<Cell>& cells) override {
        std::vector<std::string>& row = rows_.emplace_back();
        for (const Cell& cell : cells) {
            row.push_back(cell.is_formula ? "$" + cell.text + "$" : latex_words(cell.text));
        }
    }
    void begin_map(const std::string& rows, const std::vector<std::string>& columns,
                   const std::vector<std::string>& labels) override;
    void end_table() override;

    void begin_equations() override { equations_.clear(); }
    void equation(const std::string& left, const std::string& right) override {
        equations_.push_back({left, right});
    }
    void end_equations() override;

    std::string finish() override;

  private:
    struct Equation {
        std::string left;
        std::string right;
    };

    std::string in_room(ExprId id, double room) {
        LatexFormula formula = latex_expression(grafcet_, pool_, id, room);
        has_slash_ = has_slash_ || formula.has_slash;
        return std::move(formula.text);
    }
    std::string product(std::span<const StepId> steps) const {
        std::string text;
        for (const StepId step : steps)
            text += (text.empty() ? "" : " \\cdot ") + of_step("X", step);
        return text;
    }
    void add_row(const std::vector<std::string>& cells) {
        text_ += fmt::format("{} \\\\\n", joined(cells, " & "));
    }
    /// The beginning of a table that no page end breaks.
    void begin_block() {
        text_ += after_heading_ ? "\n\\noindent" : "\n\\medskip\\noindent";
        after_heading_ = false;
    }
    void add_map();
    void add_rows_as_paragraphs();

    const Grafcet& grafcet_;
    const Expressions& pool_;
    Language language_;
    bool standalone_;
    std::string text_;
    bool has_slash_ = false;
    bool after_heading_ = false;
    std::vector<std::vector<std::string>> rows_;  ///< of the table that is open, the head first
    std::string map_columns_;          ///< where it is a map: the variables of its columns
    std::vector<Equation> equations_;  ///< of the list that is open
};

void LatexPage::title(std::string_view text) {
    text_ += "% " + program_and_version() + '\n';
    if (standalone_) {
        text_ +=
            "\\documentclass[a4paper]{article}\n"
            "\\usepackage[T1]{fontenc}\n"
            "\\usepackage[utf8]{inputenc}\n"
            "\\usepackage{lmodern}\n";
        text_ += fmt::format("\\usepackage[{}]{{babel}}\n",
                             language_ == Language::french ? "french" : "english");
        text_ += "\\usepackage[margin=20mm]{geometry}\n";
        text_ += packages;
        text_ += list_settings;
        text_ +=
            "\\renewcommand{\\arraystretch}{1.15}\n"
            "\\begin{document}\n";
        // Names hold such signs, and the blanks before those of sentences are written.
        if (language_ == Language::french) text_ += "\\shorthandoff{:;!?}\n";
        text_ += '\n';
    } else {
        text_ += "% Needs in the preamble: ";
        text_ += packages;
        text_ += list_settings;
    }
    text_ += "\\section*{\\raggedright " + latex_words(text) + "}\n";
}

/// The columns of a table: as wide as what they hold, or all of them as wide as the line together.
struct Columns {
    std::string specification;
    double lines = 0;        ///< of the whole table
    double longest_row = 0;  ///< in lines
};

/// The widths of columns that want more than the line has: narrow ones get what they want, and the
/// others share the rest.
std::vector<double> shared_widths(const std::vector<double>& wanted) {
    std::vector<double> widths(wanted.size(), 0);
    double rest = line_width - column_gap * static_cast<double>(wanted.size() - 1);
    auto open = static_cast<double>(wanted.size());
    for (bool changed = true; changed && open > 0;) {
        changed = false;
        const double share = rest / open;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (widths[i] > 0 || wanted[i] > share) continue;
            widths[i] = wanted[i];
            rest -= wanted[i];
            open -= 1;
            changed = true;
        }
    }
    for (double& width : widths) {
        if (width == 0) width = rest / open;
    }
    return widths;
}

Columns columns_of(const std::vector<std::vector<std::string>>& rows) {
    std::vector<double> wanted(rows.front().size(), 1);
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            wanted[i] = std::max(wanted[i], printed_width(row[i]));
        }
    }
    const std::vector<double> widths = shared_widths(wanted);
    Columns columns;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        columns.specification +=
            widths[i] >= wanted[i]
                ? "l"
                : fmt::format(">{{\\raggedright\\arraybackslash}}p{{{:.2f}\\linewidth}}",
                              std::floor(100 * widths[i] / line_width) / 100);
    }
    for (const std::vector<std::string>& row : rows) {
        double lines = 1;
        for (std::size_t i = 0; i < row.size(); ++i) {
            lines = std::max(lines, std::ceil(printed_width(row[i]) / widths[i]));
        }
        columns.lines += lines;
        columns.longest_row = std::max(columns.longest_row, lines);
    }
    return columns;
}

void LatexPage::end_table() {
    if (!map_columns_.empty()) {
        add_map();
        return;
    }
    const Columns columns = columns_of(rows_);
    if (columns.longest_row > longest_row) {
        add_rows_as_paragraphs();
        return;
    }
    const bool is_long = columns.lines > longest_whole_table;
    if (!is_long) begin_block();
    after_heading_ = false;
    text_ += is_long ? "\n\\begin{longtable}[l]" : "\\begin{tabular}";
    text_ += fmt::format("{{@{{}}{}@{{}}}}\n\\toprule\n", columns.specification);
    add_row(rows_.front());
    text_ += is_long ? "\\midrule\n\\endhead\n\\bottomrule\n\\endfoot\n" : "\\midrule\n";
    for (std::size_t i = 1; i < rows_.size(); ++i) add_row(rows_[i]);
    text_ += is_long ? "\\end{longtable}\n" : "\\bottomrule\n\\end{tabular}\n";
}

/// No table can break a row between two pages.
void LatexPage::add_rows_as_paragraphs() {
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        text_ += "\n{\\raggedright\\noindent ";
        for (std::size_t column = 0; column < rows_[i].size(); ++column) {
            text_ += fmt::format("{}{}: {}", column == 0 ? "" : "\\\\\n", rows_[0][column],
                                 rows_[i][column]);
        }
        text_ += "\\par}\n";
    }
}

void LatexPage::begin_map(const std::string& rows, const std::vector<std::string>& columns,
                          const std::vector<std::string>& labels) {
    map_columns_ = fmt::format("${}$", joined(columns, "\\;"));
    rows_.assign(1, {"$" + rows + "$"});
    rows_.front().insert(rows_.front().end(), labels.begin(), labels.end());
}

/// Cells with a frame each; what stands beside and above them has none.
void LatexPage::add_map() {
    const std::size_t count = rows_.front().size() - 1;
    const std::string line = fmt::format("\\cline{{2-{}}}\n", count + 1);
    std::string frames = "c|";
    for (std::size_t i = 0; i < count; ++i) frames += "c|";
    begin_block();
    text_ +=
        fmt::format("{{\\renewcommand{{\\arraystretch}}{{1.3}}\\begin{{tabular}}{{{}}}\n", frames);
    add_row({"\\multicolumn{1}{c}{}",
             fmt::format("\\multicolumn{{{}}}{{c}}{{{}}}", count, map_columns_)});
    std::vector<std::string> head;
    for (const std::string& cell : rows_.front()) {
        head.push_back("\\multicolumn{1}{c}{" + cell + "}");
    }
    add_row(head);
    text_ += line;
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        add_row(rows_[i]);
        text_ += line;
    }
    text_ += "\\end{tabular}}\n";
    map_columns_.clear();
}

void LatexPage::end_equations() {
    // A name too long for its place begins the line of its equation.
    std::string widest;
    const auto stands_before = [](const Equation& equation) {
        return printed_width(equation.left) <= room_before_sign;
    };
    for (const Equation& equation : equations_) {
        if (stands_before(equation) && printed_width(equation.left) > printed_width(widest)) {
            widest = equation.left;
        }
    }
    text_ += "\n\\begin{list}{}{\\equationlist{$" + widest + " =$}}\n";
    for (const Equation& equation : equations_) {
        text_ += stands_before(equation)
                     ? fmt::format("\\item[${} =$] ${}$\n", equation.left, equation.right)
                     : fmt::format("\\item[] ${} = {}$\n", equation.left, equation.right);
    }
    text_ += "\\end{list}\n";
    after_heading_ = false;
}

std::string LatexPage::finish() {
    if (has_slash_) paragraph(messages::equation_report::slash.in(language_));
    if (standalone_) text_ += "\n\\end{document}\n";
    return std::move(text_);
}

}  // namespace

std::unique_ptr<Page> latex_page(const Grafcet& grafcet, const Expressions& pool, Language language,
                                 bool standalone) {
    return std::make_unique<LatexPage>(grafcet, pool, language, standalone);
}

}  // namespace grafwire
