// The pages whose formulas stand in the notation of the `.grafcet` language: plain text, with
// aligned columns, Markdown and HTML. A table of text is kept until its end, since the widths of
// its columns are known only then; Markdown aligns by itself and is written as it comes.

#include <fmt/format.h>

#include <algorithm>

#include "equations/report/page.h"
#include "equations/report/report_parts.h"
#include "grafcet/write_grafcet.h"
#include "text/escape.h"
#include "text/joined.h"
#include "text/utf8.h"
#include "text/wrapped.h"

namespace grafwire {

namespace {

/// A page whose formulas are in the notation of the `.grafcet` language.
class PlainPage : public Page {
  public:
    PlainPage(const Grafcet& grafcet, const Expressions& pool) : grafcet_(grafcet), pool_(pool) {}

    std::string expression(ExprId id) override { return write_expression(grafcet_, pool_, id); }
    std::string name(Variable variable) const override { return shown_name(grafcet_, variable); }
    std::string name(VarId var) const override {
        return quoted_where_needed(grafcet_.vars[var].name);
    }
    std::string quantity(std::string_view quantity) const override { return std::string(quantity); }
    std::string of_step(std::string_view quantity, StepId step) const override {
        return quoted_where_needed(std::string(quantity) + grafcet_.steps[step].name);
    }
    std::string held() const override { return "/CDX.X"; }
    std::string passage(std::span<const StepId> from, std::span<const StepId> to) const override {
        std::string text = product(from);
        text += from.empty() ? "->" : " ->";
        return to.empty() ? text : text + " " + product(to);
    }
    std::string write(Variable target, const StoredWrite& write) override {
        return write_text(grafcet_, pool_, target, write);
    }

  private:
    std::string product(std::span<const StepId> steps) const {
        std::string text;
        for (const StepId step : steps) text += (text.empty() ? "" : ".") + of_step("X", step);
        return text;
    }

    const Grafcet& grafcet_;
    const Expressions& pool_;
};

/// Columns are aligned up to this width; a cell that is wider pushes its own row only, so that one
/// long formula does not pad a million rows.
constexpr std::size_t widest_aligned = 40;
/// A terminal has 80 columns, and so has a printed page.
constexpr std::size_t widest_line = 80;
/// Where a row goes on that does not fit into its line.
constexpr std::size_t continuation = 5;

/// Plain text: aligned columns, a blank line between blocks.
class TextPage : public PlainPage {
  public:
    TextPage(const Grafcet& grafcet, const Expressions& pool) : PlainPage(grafcet, pool) {}

    void title(std::string_view text) override { line(wrapped(text, widest_line)); }
    void heading(std::string_view text) override {
        text_ += '\n';
        line(text);
        after_block_ = false;
    }
    void paragraph(std::string_view text) override {
        separate();
        line(text);
        after_block_ = false;
    }

    void begin_table(const std::vector<Cell>& head) override {
        separate();
        rows_.assign(1, head);
    }
    void begin_map(const std::string& rows, const std::vector<std::string>& columns,
                   const std::vector<std::string>& labels) override {
        separate();
        above_ = joined(columns, " ");
        rows_.assign(1, {words(rows)});
        for (const std::string& label : labels) rows_.front().push_back(words(label));
    }
    void row(const std::vector<Cell>& cells) override { rows_.push_back(cells); }
    void end_table() override {
        std::vector<std::size_t> widths(rows_.front().size(), 0);
        for (const std::vector<Cell>& row : rows_) {
            for (std::size_t i = 0; i < row.size(); ++i) {
                const std::size_t width = count_code_points(row[i].text);
                if (width <= widest_aligned) widths[i] = std::max(widths[i], width);
            }
        }
        if (!above_.empty()) add_row({words(""), words(above_)}, widths);
        for (const std::vector<Cell>& row : rows_) add_row(row, widths);
        rows_.clear();
        above_.clear();
        after_block_ = true;
    }

    void begin_equations() override {
        separate();
        after_block_ = true;
    }
    void equation(const std::string& left, const std::string& right) override {
        line(wrapped_formulas("  " + left + " = " + right, widest_line));
    }
    void end_equations() override {}

    std::string finish() override { return std::move(text_); }

  private:
    // A blank line between one table or group of equations and what follows it.
    void separate() {
        if (after_block_) text_ += '\n';
    }

    void line(std::string_view text) {
        text_ += text;
        text_ += '\n';
    }

    /// A cell that does not fit into the line goes on below, further in, and so does the rest of a
    /// formula that is wider than a line.
    void add_row(const std::vector<Cell>& row, const std::vector<std::size_t>& widths) {
        std::string text = " ";
        std::size_t column = 1;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::size_t width = count_code_points(row[i].text);
            if (i > 0 && column + 1 + width > widest_line) {
                line(wrapped_formulas(without_blanks_behind(text), widest_line));
                text.assign(continuation, ' ');
                column = continuation;
            }
            const std::size_t padding = width < widths[i] ? widths[i] - width : 0;
            text += ' ' + row[i].text;
            text.append(padding + 1, ' ');
            column += 2 + width + padding;
        }
        line(wrapped_formulas(without_blanks_behind(text), widest_line));
    }
    static std::string without_blanks_behind(std::string text) {
        text.erase(text.find_last_not_of(' ') + 1);
        return text;
    }

    std::string text_;
    bool after_block_ = false;
    std::vector<std::vector<Cell>> rows_;  ///< of the table that is open
    std::string above_;                    ///< above the columns of a map
};

/// Words with everything escaped that Markdown would read as markup.
std::string escaped(std::string_view words) {
    std::string text;
    for (const char c : words) {
        if (std::string_view("\\`*_{}[]<>#|~&$").find(c) != std::string_view::npos) text += '\\';
        text += c;
    }
    return text;
}

/// A formula as a code span, fenced by more backticks than it contains in a row.
std::string code_span(std::string_view formula) {
    std::size_t longest = 0;
    std::size_t run = 0;
    for (const char c : formula) {
        run = c == '`' ? run + 1 : 0;
        longest = std::max(longest, run);
    }
    const std::string fence(longest + 1, '`');
    const std::string_view space = longest > 0 ? " " : "";
    return fence + std::string(space) + std::string(formula) + std::string(space) + fence;
}

/// In a table a bar ends the cell even within a code span.
std::string cell_text(const Page::Cell& cell) {
    if (!cell.is_formula) return escaped(cell.text);
    std::string text;
    for (const char c : code_span(cell.text)) {
        if (c == '|') text += '\\';
        text += c;
    }
    return text;
}

/// Markdown: formulas are code spans, equations a list.
class MarkdownPage : public PlainPage {
  public:
    MarkdownPage(const Grafcet& grafcet, const Expressions& pool) : PlainPage(grafcet, pool) {}

    void title(std::string_view text) override { text_ += "# " + escaped(text) + "\n"; }
    void heading(std::string_view text) override { text_ += "\n## " + escaped(text) + "\n"; }
    void paragraph(std::string_view text) override { text_ += "\n" + escaped(text) + "\n"; }

    void begin_table(const std::vector<Cell>& head) override {
        text_ += '\n';
        row(head);
        for (std::size_t i = 0; i < head.size(); ++i) text_ += "|---";
        text_ += "|\n";
    }
    void begin_map(const std::string& rows, const std::vector<std::string>& columns,
                   const std::vector<std::string>& labels) override {
        std::vector<Cell> head{words(fmt::format("{} \\ {}", rows, joined(columns, " ")))};
        for (const std::string& label : labels) head.push_back(words(label));
        begin_table(head);
    }
    void row(const std::vector<Cell>& cells) override {
        for (const Cell& cell : cells) text_ += "| " + cell_text(cell) + " ";
        text_ += "|\n";
    }
    void end_table() override {}

    void begin_equations() override { text_ += '\n'; }
    void equation(const std::string& left, const std::string& right) override {
        text_ += "- " + code_span(left + " = " + right) + "\n";
    }
    void end_equations() override {}

    std::string finish() override { return std::move(text_); }

  private:
    std::string text_;
};

/// HTML: formulas are code, equations a list.
class HtmlPage : public PlainPage {
  public:
    HtmlPage(const Grafcet& grafcet, const Expressions& pool) : PlainPage(grafcet, pool) {}

    void title(std::string_view) override {}
    void heading(std::string_view text) override { element("h3", xml_text(text)); }
    void paragraph(std::string_view text) override { element("p", xml_text(text)); }

    void begin_table(const std::vector<Cell>& head) override {
        text_ += "<table>\n<thead>\n";
        write_row(head, "th");
        text_ += "</thead>\n<tbody>\n";
    }
    void begin_map(const std::string& rows, const std::vector<std::string>& columns,
                   const std::vector<std::string>& labels) override {
        std::vector<Cell> head{words(fmt::format("{} \\ {}", rows, joined(columns, " ")))};
        for (const std::string& label : labels) head.push_back(words(label));
        begin_table(head);
    }
    void row(const std::vector<Cell>& cells) override { write_row(cells, "td"); }
    void end_table() override { text_ += "</tbody>\n</table>\n"; }

    void begin_equations() override { text_ += "<ul class=\"equations\">\n"; }
    void equation(const std::string& left, const std::string& right) override {
        element("li", shown(formula(left + " = " + right)));
    }
    void end_equations() override { text_ += "</ul>\n"; }

    std::string finish() override { return std::move(text_); }

  private:
    static std::string shown(const Cell& cell) {
        const std::string text = xml_text(cell.text);
        return cell.is_formula ? "<code>" + text + "</code>" : text;
    }
    void element(std::string_view name, std::string_view content) {
        text_ += fmt::format("<{0}>{1}</{0}>\n", name, content);
    }
    void write_row(const std::vector<Cell>& cells, std::string_view element_name) {
        text_ += "<tr>\n";
        for (const Cell& cell : cells) element(element_name, shown(cell));
        text_ += "</tr>\n";
    }

    std::string text_;
};

}  // namespace

std::unique_ptr<Page> text_page(const Grafcet& grafcet, const Expressions& pool) {
    return std::make_unique<TextPage>(grafcet, pool);
}

std::unique_ptr<Page> markdown_page(const Grafcet& grafcet, const Expressions& pool) {
    return std::make_unique<MarkdownPage>(grafcet, pool);
}

std::unique_ptr<Page> html_page(const Grafcet& grafcet, const Expressions& pool) {
    return std::make_unique<HtmlPage>(grafcet, pool);
}

}  // namespace grafwire
