// Each message is shown with its source line. A line may be as long as the file, so only a window
// around the column is shown, and the places of a sorted list are found by walking on from the
// place before rather than from the beginning of the line each time.

#include "text/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "text/messages.h"
#include "text/utf8.h"

namespace grafwire {

Diagnostic& Diagnostics::error(Code code, Location where, Localized message) {
    ++error_count_;
    return items_.emplace_back(Diagnostic{Severity::error, code, where, std::move(message), {}});
}

Diagnostic& Diagnostics::warning(Code code, Location where, Localized message) {
    return items_.emplace_back(Diagnostic{Severity::warning, code, where, std::move(message), {}});
}

void Diagnostics::sort_by_place() {
    std::stable_sort(items_.begin(), items_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.where.line, a.where.column) < std::tie(b.where.line, b.where.column);
    });
}

namespace {

constexpr std::size_t characters_before_caret = 100;
constexpr std::size_t characters_after_caret = 60;
constexpr std::size_t most_of_message = 1000;  // names and lists of them may be as long as the file

/// The lines of a text, found once, and shown around places in it.
class SourceLines {
  public:
    explicit SourceLines(std::string_view text) : text_(text) {
        starts_.push_back(byte_order_mark_size(text));
        for (std::size_t at = starts_[0]; at < text.size(); ++at)
            if (text[at] == '\n') starts_.push_back(at + 1);
    }

    bool has(Location where) const { return where.is_known() && where.line <= starts_.size(); }

    /// Appends the line and, under it, the caret.
    void append(std::string& out, Location where) {
        const std::string_view line = line_of(where.line);
        const std::size_t column = std::max<std::size_t>(where.column, 1) - 1;
        const std::size_t caret = byte_of(line, where.line, column);
        const std::size_t first = step_back(line, caret, characters_before_caret);
        const std::size_t last = step_on(line, caret, characters_after_caret);
        std::string head;
        if (first != 0) head = "…";
        head += visible(line.substr(first, caret - first));
        out += head;
        out += visible(line.substr(caret, last - caret));
        if (last != line.size()) out += "…";
        out += '\n';
        for (std::size_t at = 0; at < head.size();) {
            out += head[at] == '\t' ? '\t' : ' ';
            at += std::max<std::size_t>(decode_utf8(head, at).length, 1);
        }
        out += "^\n";
    }

  private:
    std::string_view line_of(std::uint32_t line) const {
        const std::size_t start = starts_[line - 1];
        const std::size_t end = line < starts_.size() ? starts_[line] - 1 : text_.size();
        std::string_view result = text_.substr(start, end - start);
        if (!result.empty() && result.back() == '\r') result.remove_suffix(1);
        return result;
    }

    /// The byte at which a column (from 0) begins, at most the end of the line.
    std::size_t byte_of(std::string_view line, std::uint32_t number, std::size_t column) {
        if (number != last_line_ || column < last_column_) {
            last_line_ = number;
            last_column_ = 0;
            last_byte_ = 0;
        }
        while (last_column_ < column && last_byte_ < line.size()) {
            last_byte_ += std::max<std::size_t>(decode_utf8(line, last_byte_).length, 1);
            ++last_column_;
        }
        return last_byte_;
    }

    /// `count` characters before or after a byte, at most the ends of the line.
    static std::size_t step_back(std::string_view line, std::size_t at, std::size_t count) {
        for (; at > 0 && count > 0; --count) {
            do --at;
            while (at > 0 && !begins_character(line[at]));
        }
        return at;
    }
    static std::size_t step_on(std::string_view line, std::size_t at, std::size_t count) {
        for (; at < line.size() && count > 0; --count) {
            do ++at;
            while (at < line.size() && !begins_character(line[at]));
        }
        return at;
    }

    std::string_view text_;
    std::vector<std::size_t> starts_;  ///< of the lines
    // The place that was found last: the next one is most often further on in the same line.
    std::uint32_t last_line_ = 0;
    std::size_t last_column_ = 0;
    std::size_t last_byte_ = 0;
};

/// `chart.grafcet:5:12: error: …`, the line, and a caret below the column.
void append_message(std::string& out, SourceLines& lines, std::string_view file, Location where,
                    const Message<std::string>& labelled, std::string_view message,
                    Language language) {
    out += visible(file);
    if (where.is_known()) out += fmt::format(":{}:{}", where.line, where.column);
    out += ": ";
    out += labelled.in(language, visible(shortened(message, most_of_message)));
    out += '\n';
    if (lines.has(where)) lines.append(out, where);
}

}  // namespace

std::string format_diagnostics(const Diagnostics& diagnostics, const SourceFile& source,
                               Language language, std::size_t limit) {
    std::string out;
    if (diagnostics.items().empty()) return out;
    // Notes lie elsewhere: they must not disturb the walk along the places of the messages.
    SourceLines lines(source.text);
    SourceLines note_lines(lines);
    const std::string_view file = source.name == "-" ? "<stdin>" : std::string_view(source.name);
    std::size_t errors = 0;
    std::size_t warnings = 0;
    for (const Diagnostic& item : diagnostics.items()) {
        const bool is_error = item.severity == Severity::error;
        std::size_t& count = is_error ? errors : warnings;
        if (++count > limit && limit != 0) {
            continue;
        }
        append_message(out, lines, file, item.where,
                       is_error ? messages::text::error : messages::text::warning,
                       item.message.in(language), language);
        for (const Diagnostic::Note& note : item.notes) {
            append_message(out, note_lines, file, note.where, messages::text::note,
                           note.message.in(language), language);
        }
    }
    const auto count_rest = [&](std::size_t count, const CountedMessage<>& message) {
        if (limit != 0 && count > limit) {
            out += fmt::format("{}: {}\n", visible(file), message.in(language, count - limit));
        }
    };
    count_rest(errors, messages::text::more_errors);
    count_rest(warnings, messages::text::more_warnings);
    return out;
}

}  // namespace grafwire
