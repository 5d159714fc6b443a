// Two tables of the same making: rows of cells, each cell a text, each column as wide as its widest
// cell. The grouped one is made as wide as the terminal by taking from the widest column, one
// character at a time, until the line fits; its cells are then broken at blanks.

#include "trace/trace_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string_view>
#include <vector>

#include "text/utf8.h"
#include "trace/messages.h"

namespace grafwire {

namespace {

namespace words = messages::trace;

using Row = std::vector<std::string>;

constexpr std::string_view gap = "  ";
constexpr std::size_t least_width = 8;  ///< of a column that is made narrower

std::string value_text(std::int64_t value) {
    return value == Trace::unknown ? "x" : fmt::format("{}", value);
}

const std::int64_t* row_of(const Trace& trace, std::size_t row) {
    return trace.values.data() + row * trace.columns.size();
}

std::vector<std::size_t> natural_widths(const std::vector<Row>& rows) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            widths[c] = std::max(widths[c], count_code_points(row[c]));
        }
    }
    return widths;
}

std::size_t line_width(const std::vector<std::size_t>& widths) {
    return std::accumulate(widths.begin(), widths.end(), gap.size() * (widths.size() - 1));
}

/// The first bytes of a text that hold so many characters.
std::size_t bytes_of(std::string_view text, std::size_t characters) {
    std::size_t at = 0;
    while (at < text.size() && characters-- > 0) {
        at += std::max<std::size_t>(decode_utf8(text, at).length, 1);
    }
    return at;
}

/// The text in lines of at most `width` characters, broken at blanks where there are some.
std::vector<std::string> folded(std::string_view text, std::size_t width) {
    std::vector<std::string> lines;
    while (count_code_points(text) > width) {
        const std::size_t most = bytes_of(text, width);
        const std::size_t blank = text.rfind(' ', most);
        const bool is_word = blank == std::string_view::npos || blank == 0;
        lines.emplace_back(text.substr(0, is_word ? most : blank));
        text.remove_prefix(is_word ? most : blank + 1);
    }
    lines.emplace_back(text);
    return lines;
}

/// The first column is one of numbers, which stand to the right.
void append_row(std::string& out, const Row& row, const std::vector<std::size_t>& widths) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 1;
    for (std::size_t c = 0; c < row.size(); ++c) {
        cells.push_back(folded(row[c], widths[c]));
        height = std::max(height, cells.back().size());
    }
    for (std::size_t line = 0; line < height; ++line) {
        std::string text;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string cell = line < cells[c].size() ? cells[c][line] : "";
            const std::string blanks(widths[c] - count_code_points(cell), ' ');
            if (c != 0) text += gap;
            text += c == 0 ? blanks + cell : cell + blanks;
        }
        text.erase(text.find_last_not_of(' ') + 1);
        out += text + '\n';
    }
}

/// The first row is the head.
std::string write_rows(const std::vector<Row>& rows, const std::vector<std::size_t>& widths,
                       bool is_emphasised) {
    std::string out;
    append_row(out, rows.front(), widths);
    if (is_emphasised) out = "\033[1m" + out.substr(0, out.size() - 1) + "\033[0m\n";
    for (std::size_t r = 1; r < rows.size(); ++r) append_row(out, rows[r], widths);
    return out;
}

/// Every column by itself.
std::vector<Row> plain_rows(const Trace& trace) {
    std::vector<Row> rows(1, Row{"time_ms"});
    for (const Trace::Column& column : trace.columns) rows.front().push_back(column.name);
    for (std::size_t r = 0; r < trace.row_count(); ++r) {
        Row row{format_milliseconds(trace.times[r])};
        for (std::size_t c = 0; c < trace.columns.size(); ++c) {
            row.push_back(value_text(row_of(trace, r)[c]));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Some columns of a trace that are shown as one.
struct Group {
    const Message<>& name;
    std::size_t first;
    std::size_t count;
    bool shows_values;  ///< of counters; else what is 1
};

std::vector<Group> groups_of(const Grafcet& grafcet) {
    std::vector<Group> groups;
    std::size_t first = 0;
    const auto add = [&](const Message<>& name, std::size_t count, bool shows_values = false) {
        if (count != 0) groups.push_back({name, first, count, shows_values});
        first += count;
    };
    add(words::inputs, grafcet.all_input_count());
    add(words::situation, grafcet.steps.size());
    add(words::outputs, grafcet.outputs.size());
    add(words::vars, grafcet.vars.size());
    add(words::counters, grafcet.counters.size(), true);
    return groups;
}

std::string group_text(const Trace& trace, const std::int64_t* values, const Group& group) {
    std::string text;
    for (std::size_t c = group.first; c < group.first + group.count; ++c) {
        const bool is_named = group.shows_values || values[c] == Trace::unknown;
        if (!is_named && values[c] == 0) continue;
        if (!text.empty()) text += ", ";
        text += trace.columns[c].name;
        if (is_named) text += "=" + value_text(values[c]);
    }
    return text.empty() ? "-" : text;
}

std::vector<Row> grouped_rows(const Trace& trace, const Grafcet& grafcet, Language language) {
    const std::vector<Group> groups = groups_of(grafcet);
    std::vector<Row> rows(1, Row{"time_ms"});
    for (const Group& group : groups) rows.front().push_back(group.name.in(language));
    for (std::size_t r = 0; r < trace.row_count(); ++r) {
        Row row{format_milliseconds(trace.times[r])};
        for (const Group& group : groups) {
            row.push_back(group_text(trace, row_of(trace, r), group));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Takes from the widest of the columns behind the first, as long as that helps.
void narrow(std::vector<std::size_t>& widths, std::size_t width) {
    while (line_width(widths) > width) {
        const auto widest = std::max_element(widths.begin() + 1, widths.end());
        if (*widest <= least_width) return;
        --*widest;
    }
}

}  // namespace

std::string write_trace_table(const Trace& trace, const Grafcet& grafcet, const TableLook& look,
                              Language language) {
    std::vector<Row> rows = plain_rows(trace);
    std::vector<std::size_t> widths = natural_widths(rows);
    if (line_width(widths) > look.width) {
        rows = grouped_rows(trace, grafcet, language);
        widths = natural_widths(rows);
        narrow(widths, look.width);
    }
    return write_rows(rows, widths, look.is_emphasised);
}

}  // namespace grafwire
