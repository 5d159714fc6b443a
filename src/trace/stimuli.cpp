// Reading and writing a `.stim` text.
//
// Unlike the GRAFCET language this one goes by lines, so that after an error the reader knows where
// it is again at the next line break; within a line it goes on after the next white space. All
// errors are reported at once:
//
//     10ms : a=2 b=1      expected 0 or 1 for 'a', got '2'; b is read all the same
//     5ms  : a=1          5ms comes before 10ms, the time of an earlier line

#include "trace/stimuli.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "grafcet/lexer.h"
#include "text/messages.h"
#include "text/nearest_name.h"
#include "text/utf8.h"
#include "trace/line_cursor.h"
#include "trace/messages.h"

namespace grafwire {

namespace say = messages::trace;

namespace {

/// Reads line by line. The time of a line, the lines before it and the inputs already set at the
/// same instant decide what the line means, so the reader remembers them.
class StimuliReader {
  public:
    StimuliReader(const Grafcet& grafcet, Diagnostics& diagnostics)
        : grafcet_(grafcet), diagnostics_(diagnostics), place_(grafcet.all_input_count()) {
        for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
            inputs_.emplace(input_name(grafcet, i), static_cast<std::uint32_t>(i));
        }
    }

    void read_line(std::string_view line, std::uint32_t number) {
        LineCursor cursor(line, number);
        cursor.skip_blanks();
        if (cursor.at_end()) return;
        const Location where = cursor.here();
        read_time(cursor);
        if (end_at_.is_known() && !reported_after_end_) {
            error(code::time_order, where, say::line_after_end())
                .notes.push_back({end_at_, say::end_here()});
            reported_after_end_ = true;
        }
        last_line_ = where;
        cursor.skip_blanks();
        if (!cursor.skip_if(':')) {
            error(code::unexpected_token, cursor.here(), say::colon_missing());
            return;
        }
        cursor.skip_blanks();
        if (is_end_line(cursor)) {
            read_end(cursor, where);
        } else {
            read_assignments(cursor, where);
        }
    }

    Stimuli finish() {
        stimuli_.end = now_;
        return std::move(stimuli_);
    }

  private:
    Diagnostic& error(Code code, Location where, Localized message) {
        return diagnostics_.error(code, where, std::move(message));
    }

    /// Reads the time of a line into `now_`, which keeps its value if the time is wrong.
    void read_time(LineCursor& cursor) {
        const Location where = cursor.here();
        const bool is_relative = cursor.skip_if('+');
        const std::string_view text = cursor.take_until_blank(':');
        const std::optional<Time> time = parse_duration(text);
        // The language knows no unit below the microsecond.
        const bool is_finer = text.size() > 1 && text.back() == 's' &&
                              (text[text.size() - 2] == 'n' || text[text.size() - 2] == 'p');
        if (!time || is_finer) {
            error(code::bad_time, where,
                  text.empty() ? say::no_time() : say::bad_time(quoted(text)));
            return;
        }
        if (is_relative && !last_line_.is_known()) {
            error(code::bad_time, where, say::relative_first_line());
            return;
        }
        const Time at = is_relative ? add_times(now_, *time) : *time;
        if (at == never) {
            error(code::bad_time, where, say::time_out_of_range());
            return;
        }
        if (at < now_) {
            error(code::time_order, where,
                  say::time_order(format_duration(at), format_duration(now_)))
                .notes.push_back({now_at_, say::that_line_here()});
            return;
        }
        now_ = at;
        now_at_ = where;
    }

    /// Whether the line says `end`; `end=1` sets an input of that name.
    static bool is_end_line(const LineCursor& cursor) {
        LineCursor ahead = cursor;
        if (ahead.take_word() != "end") return false;
        ahead.skip_blanks();
        return ahead.at_end() || ahead.peek() != '=';
    }

    void read_end(LineCursor& cursor, Location where) {
        cursor.skip(3);
        cursor.skip_blanks();
        if (!cursor.at_end()) {
            error(code::unexpected_token, cursor.here(), say::text_behind_end());
        }
        if (!end_at_.is_known()) end_at_ = where;
    }

    void read_assignments(LineCursor& cursor, Location where) {
        if (stimuli_.changes.empty() || stimuli_.changes.back().at != now_) {
            stimuli_.changes.push_back({now_, {}, where});
        }
        while (!cursor.at_end()) {
            if (!read_assignment(cursor)) {
                cursor.take_until_blank();
            }
            cursor.skip_blanks();
        }
    }

    /// False after an error that leaves the cursor somewhere in the assignment.
    bool read_assignment(LineCursor& cursor) {
        const Location where = cursor.here();
        const std::optional<std::string_view> name = read_name(cursor);
        if (!name) return false;
        const std::optional<std::uint32_t> input = find_input(*name, where);
        cursor.skip_blanks();
        if (!cursor.skip_if('=')) {
            error(code::unexpected_token, cursor.here(), say::no_assignment(quoted(*name)));
            return false;
        }
        cursor.skip_blanks();
        const Location value_at = cursor.here();
        const std::string_view value = cursor.take_until_blank();
        if (value != "0" && value != "1") {
            error(code::bad_value, value_at,
                  value.empty() ? say::no_value(quoted(*name))
                                : say::bad_value(quoted(*name), quoted(value)));
            return true;
        }
        if (input) assign(*input, value == "1");
        return true;
    }

    std::optional<std::string_view> read_name(LineCursor& cursor) {
        const Location where = cursor.here();
        if (cursor.skip_if('"')) {
            const std::string_view rest = cursor.rest();
            const std::size_t length = rest.find('"');
            if (length == std::string_view::npos) {
                error(code::unterminated_text, where, say::unterminated_name());
                cursor.skip(rest.size());
                return std::nullopt;
            }
            cursor.skip(length + 1);
            return rest.substr(0, length);
        }
        const std::string_view name = cursor.take_word();
        if (name.empty()) {
            error(code::unexpected_character, where, say::no_input_name());
            return std::nullopt;
        }
        if (!is_letter(decode_utf8(name, 0).value)) {
            error(code::unexpected_token, where, say::bad_input_name(quoted(name)));
            return std::nullopt;
        }
        return name;
    }

    std::optional<std::uint32_t> find_input(std::string_view name, Location where) {
        const auto found = inputs_.find(normalised(name));
        if (found != inputs_.end()) return found->second;
        Localized message = say::unknown_input(quoted(name));
        const std::string_view nearest = suggestion(name);
        if (!nearest.empty()) {
            message = messages::text::did_you_mean(message, quoted(nearest));
        }
        error(code::unknown_name, where, std::move(message));
        return std::nullopt;
    }

    std::string_view suggestion(std::string_view name) {
        if (++suggestion_count_ > most_suggestions) return {};
        std::vector<std::string_view> names;
        for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
            names.push_back(input_name(grafcet_, i));
        }
        return nearest_name(name, names);
    }

    /// The last assignment to an input within an instant wins.
    void assign(std::uint32_t input, bool value) {
        std::vector<Stimuli::Assignment>& assignments = stimuli_.changes.back().assignments;
        Place& place = place_[input];
        if (place.change == stimuli_.changes.size()) {
            assignments[place.index].value = value;
            return;
        }
        place = {stimuli_.changes.size(), assignments.size()};
        assignments.push_back({input, value});
    }

    /// Where an input was assigned last.
    struct Place {
        std::size_t change = 0;  ///< counted from 1; 0: nowhere yet
        std::size_t index = 0;
    };

    const Grafcet& grafcet_;
    Diagnostics& diagnostics_;
    std::unordered_map<std::string_view, std::uint32_t> inputs_;
    std::vector<Place> place_;
    Stimuli stimuli_;
    Time now_ = 0;
    Location now_at_;     ///< the line that gave `now_`
    Location last_line_;  ///< unknown before the first line
    Location end_at_;     ///< unknown before the line that says `end`
    bool reported_after_end_ = false;
    std::size_t suggestion_count_ = 0;
};

}  // namespace

std::optional<Stimuli> parse_stimuli(const SourceFile& source, const Grafcet& grafcet,
                                     Diagnostics& diagnostics) {
    const std::size_t errors_before = diagnostics.error_count();
    std::string_view text = source.text;
    if (!check_utf8(text, diagnostics)) return std::nullopt;
    text.remove_prefix(byte_order_mark_size(text));

    StimuliReader reader(grafcet, diagnostics);
    for (std::uint32_t number = 1; !text.empty(); ++number) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, length), number);
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    if (diagnostics.error_count() != errors_before) return std::nullopt;
    return reader.finish();
}

namespace {

/// Unquoted where it is a word to the reader of stimuli and cannot be taken for the word `end`.
void append_name(std::string& out, std::string_view name) {
    const bool is_word = name != "end" && is_plain_word(name);
    if (!is_word) out += '"';
    out += name;
    if (!is_word) out += '"';
}

}  // namespace

std::string write_stimuli(const Stimuli& stimuli, const Grafcet& grafcet) {
    std::string out;
    for (const Stimuli::Change& change : stimuli.changes) {
        out += format_duration(change.at);
        out += " :";
        for (const Stimuli::Assignment& assignment : change.assignments) {
            out += ' ';
            append_name(out, input_name(grafcet, assignment.input));
            out += assignment.value ? "=1" : "=0";
        }
        out += '\n';
    }
    out += fmt::format("{} : end\n", format_duration(stimuli.end));
    return out;
}

}  // namespace grafwire
