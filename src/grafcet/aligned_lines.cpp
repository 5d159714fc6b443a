// Lines with columns, as charts on paper have them:
//
//     (0) 0     -> 1, 2 : a            # the first
//     (1) 1, 2  -> 3    : b . /c       # the second
//
// Lines that follow one another without a blank line between them are a group, and a column of a
// group is as wide as its widest cell. A cell of unusual width stands for itself: it neither widens
// the column nor is it filled up, so that one long name does not tear the others apart; likewise a
// comment behind a long line.

#include "grafcet/aligned_lines.h"

#include <algorithm>
#include <array>
#include <span>

#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr std::size_t indentation = 2;
constexpr std::size_t continued_indentation = 4;
constexpr std::size_t widest_cell = 20;
constexpr std::size_t widest_commented = 60;
constexpr std::size_t before_comment = 2;
constexpr std::size_t most_columns = 4;

/// The characters of the widest cell; 0 where no line has anything in the column.
using Widths = std::array<std::size_t, most_columns>;

class GroupWriter {
  public:
    explicit GroupWriter(std::span<TextLine> lines) : lines_(lines) {}

    void write(std::string& out) {
        join_labels();
        for (const TextLine& line : lines_) measure(line);
        std::vector<std::string> texts;
        for (const TextLine& line : lines_) texts.push_back(text_of(line));
        append(out, texts);
    }

  private:
    Widths& widths_of(LineKind kind) { return widths_[static_cast<std::size_t>(kind)]; }

    void join_labels();
    void measure(const TextLine& line);
    std::string text_of(const TextLine& line);
    void append(std::string& out, const std::vector<std::string>& texts) const;

    std::span<TextLine> lines_;
    std::array<Widths, static_cast<std::size_t>(LineKind::goes_on) + 1> widths_{};
    std::size_t hang_ = 0;  ///< of the part that the present line belongs to
};

/// Labels have a column where each transition of the group has one.
void GroupWriter::join_labels() {
    const auto has_no_label = [](const TextLine& line) {
        return line.kind == LineKind::transition && line.cells[0].empty();
    };
    if (std::none_of(lines_.begin(), lines_.end(), has_no_label)) return;
    for (TextLine& line : lines_) {
        if (line.kind != LineKind::transition || line.cells.size() < 2) continue;
        if (!line.cells[0].empty() && !line.cells[1].empty()) line.cells[0] += ' ';
        line.cells[1] = line.cells[0] + line.cells[1];
        line.cells[0].clear();
    }
}

void GroupWriter::measure(const TextLine& line) {
    Widths& widths = widths_of(line.kind);
    for (std::size_t i = 0; i + 1 < line.cells.size(); ++i) {
        const std::size_t width = count_code_points(line.cells[i]);
        if (width <= widest_cell) widths[i] = std::max(widths[i], width);
    }
}

std::string GroupWriter::text_of(const TextLine& line) {
    const std::size_t indent = line.is_indented ? indentation : 0;
    const bool goes_on = line.kind == LineKind::goes_on;
    std::string text(goes_on ? hang_ : indent, ' ');
    const Widths& widths = widths_of(line.kind);
    for (std::size_t i = 0; i < line.cells.size(); ++i) {
        const bool is_last = i + 1 == line.cells.size();
        const std::string& cell = line.cells[i];
        if (cell.empty() && (is_last || widths[i] == 0)) continue;
        if (text.size() > indent && !goes_on) text += ' ';
        if (is_last && line.hang != 0) hang_ = count_code_points(text) + line.hang;
        text += cell;
        const std::size_t width = count_code_points(cell);
        if (!is_last && width < widths[i]) text.append(widths[i] - width, ' ');
    }
    if (!goes_on && line.hang == 0) hang_ = indent + continued_indentation;
    text.erase(text.find_last_not_of(' ') + 1);
    if (line.cells.empty()) text.assign(goes_on ? hang_ : indent, ' ');
    return text;
}

/// The lines with their comments, which begin in one column.
void GroupWriter::append(std::string& out, const std::vector<std::string>& texts) const {
    std::size_t column = 0;
    const auto shares_column = [&](std::size_t i, std::size_t width) {
        return !lines_[i].cells.empty() && !lines_[i].comment.empty() && width <= widest_commented;
    };
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::size_t width = count_code_points(texts[i]);
        if (shares_column(i, width)) column = std::max(column, width);
    }
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (lines_[i].is_behind_blank_line) out += '\n';
        out += texts[i];
        if (!lines_[i].cells.empty() && !lines_[i].comment.empty()) {
            const std::size_t width = count_code_points(texts[i]);
            const std::size_t blanks = shares_column(i, width) ? column - width : 0;
            out.append(blanks + before_comment, ' ');
        }
        out += lines_[i].comment;
        out += '\n';
    }
}

}  // namespace

std::string write_aligned(std::vector<TextLine> lines) {
    std::string out;
    const std::span<TextLine> all(lines);
    for (std::size_t begin = 0; begin < lines.size();) {
        std::size_t end = begin + 1;
        while (end < lines.size() && !lines[end].begins_group) ++end;
        GroupWriter(all.subspan(begin, end - begin)).write(out);
        begin = end;
    }
    return out;
}

}  // namespace grafwire
