#include <algorithm>

#include "equations/report/plain_page.h"

namespace grafwire {

namespace {

/// Columns are aligned up to this width; a cell that is wider pushes its own row only, so that one
/// long formula does not pad a million rows.
constexpr std::size_t widest_aligned = 40;

/// The number of characters of a UTF-8 text.
std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
    }));
}

class TextPage : public PlainPage {
  public:
    TextPage(const Grafcet& grafcet, const Expressions& pool) : PlainPage(grafcet, pool) {}

    void title(std::string_view text) override { line(text); }
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
    void row(const std::vector<Cell>& cells) override { rows_.push_back(cells); }
    void end_table() override {
        std::vector<std::size_t> widths(rows_.front().size(), 0);
        for (const std::vector<Cell>& row : rows_) {
            for (std::size_t i = 0; i < row.size(); ++i) {
                const std::size_t width = width_of(row[i].text);
                if (width <= widest_aligned) widths[i] = std::max(widths[i], width);
            }
        }
        for (const std::vector<Cell>& row : rows_) add_row(row, widths);
        rows_.clear();
        after_block_ = true;
    }

    void begin_equations() override {
        separate();
        after_block_ = true;
    }
    void equation(const std::string& left, const std::string& right) override {
        line("  " + left + " = " + right);
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

    void add_row(const std::vector<Cell>& row, const std::vector<std::size_t>& widths) {
        text_ += ' ';
        for (std::size_t i = 0; i < row.size(); ++i) {
            text_ += ' ';
            text_ += row[i].text;
            const std::size_t width = width_of(row[i].text);
            const std::size_t padding = width < widths[i] ? widths[i] - width : 0;
            if (i + 1 < row.size()) text_.append(padding + 1, ' ');
        }
        text_.erase(text_.find_last_not_of(' ') + 1);
        text_ += '\n';
    }

    std::string text_;
    bool after_block_ = false;
    std::vector<std::vector<Cell>> rows_;  ///< of the table that is open
};

}  // namespace

std::unique_ptr<Page> text_page(const Grafcet& grafcet, const Expressions& pool) {
    return std::make_unique<TextPage>(grafcet, pool);
}

}  // namespace grafwire
