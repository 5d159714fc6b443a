#include <algorithm>

#include "equations/report/plain_page.h"

namespace grafwire {

namespace {

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

}  // namespace

std::unique_ptr<Page> markdown_page(const Grafcet& grafcet, const Expressions& pool) {
    return std::make_unique<MarkdownPage>(grafcet, pool);
}

}  // namespace grafwire
