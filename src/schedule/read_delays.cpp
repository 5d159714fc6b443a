// Reading a `.delays` text, which goes by lines as stimuli do: after an error the reader goes on
// with the next line, so that all errors are reported at once.
//
//     X1$set  0        a gate takes some time: '0' is not more than 0
//     X1$st   3        the netlist has no net 'X1$st'; did you mean 'X1$set'?
//     at 5ms           5ms does not come after 20ms
//
// A section is what holds from one moment on: the lines up to the next `at`. Its gates are known
// once it is over; then `*` stands for those that it has not named.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "schedule/delays_text.h"
#include "schedule/messages.h"
#include "text/messages.h"
#include "text/nearest_name.h"
#include "text/time.h"
#include "text/utf8.h"
#include "trace/line_cursor.h"
#include "trace/messages.h"

namespace grafwire {

namespace say = messages::schedule;

namespace {

/// `3`, `3.5` in nanoseconds, or with a unit.
std::optional<Time> parse_nanoseconds(std::string_view text) {
    if (const std::optional<Time> time = parse_duration(text)) return time;
    return parse_duration(std::string(text) + "ns");
}

/// What a line gives to a gate, or to every other.
struct GateTimes {
    Time rise = 0;
    Time fall = 0;
    Time width = 0;
};

class DelaysReader {
  public:
    DelaysReader(const Netlist& netlist, Diagnostics& diagnostics)
        : netlist_(netlist), diagnostics_(diagnostics), drivers_(drivers_of(netlist)) {
        for (std::size_t i = 0; i < netlist.net_count(); ++i) {
            const auto net = static_cast<NetId>(i);
            nets_.emplace(netlist.names[net], net);
        }
        begin_section();
    }

    void read_line(std::string_view line, std::uint32_t number) {
        LineCursor cursor(line, number);
        cursor.skip_blanks();
        if (cursor.at_end()) return;
        LineCursor ahead = cursor;
        const std::string_view first = ahead.take_until_blank();
        if (first == "at") {
            read_moment(ahead);
        } else if (first == "*") {
            read_others(cursor);
        } else {
            read_gate(cursor);
        }
    }

    DelaySchedule finish() {
        end_section();
        return std::move(schedule_);
    }

  private:
    Diagnostic& error(Code code, Location where, Localized message) {
        return diagnostics_.error(code, where, std::move(message));
    }

    void begin_section() {
        given_at_.assign(netlist_.cells.size(), {});
        times_.assign(netlist_.cells.size(), {});
        others_at_ = {};
    }

    void end_section() {
        for (std::size_t i = 0; i < times_.size(); ++i) {
            const CellId cell = netlist_.cells.id_at(i);
            const bool is_named = given_at_[i].is_known();
            if (!is_named && !others_at_.is_known()) continue;
            GateTimes times = is_named ? times_[i] : others_;
            if (is_pulse(netlist_.cells[cell].type)) times.fall = times.rise;
            schedule_.changes.push_back({now_, cell, times.rise, times.fall, times.width});
        }
    }

    /// Behind `at`.
    void read_moment(LineCursor& cursor) {
        cursor.skip_blanks();
        const Location where = cursor.here();
        std::optional<Time> at = read_part_of_moment(cursor);
        cursor.skip_blanks();
        if (at && cursor.skip_if('+')) {
            cursor.skip_blanks();
            const std::optional<Time> since = read_part_of_moment(cursor);
            if (since) at = add_times(*at, *since);
            if (!since) at.reset();
            cursor.skip_blanks();
        }
        if (!at) return;
        if (!cursor.at_end()) {
            error(code::unexpected_token, cursor.here(), say::text_behind_moment());
            return;
        }
        go_to(*at, where);
    }

    std::optional<Time> read_part_of_moment(LineCursor& cursor) {
        const Location where = cursor.here();
        const std::string_view text = cursor.take_until_blank('+');
        const std::optional<Time> time = parse_nanoseconds(text);
        if (!time) {
            error(code::bad_time, where,
                  text.empty() ? say::no_moment() : say::bad_moment(quoted(text)));
        }
        return time;
    }

    void go_to(Time at, Location where) {
        if (at > now_) {
            end_section();
            begin_section();
            now_ = at;
            now_at_ = where;
        } else if (now_at_.is_known()) {
            error(code::time_order, where,
                  say::moment_order(format_duration(at), format_duration(now_)))
                .notes.push_back({now_at_, say::that_moment_here()});
        } else {
            error(code::time_order, where, say::from_the_start());
        }
    }

    void read_others(LineCursor& cursor) {
        const Location where = cursor.here();
        cursor.skip(1);
        const std::optional<GateTimes> times = read_times(cursor, "*", nullptr);
        if (!times) return;
        if (others_at_.is_known()) {
            error(code::duplicate_name, where, say::others_named_twice())
                .notes.push_back({others_at_, say::given_here()});
            return;
        }
        others_ = *times;
        others_at_ = where;
    }

    void read_gate(LineCursor& cursor) {
        const Location where = cursor.here();
        const std::optional<std::string_view> name = read_name(cursor);
        if (!name) return;
        const std::optional<CellId> cell = find_gate(*name, where);
        const Cell* const known = cell ? &netlist_.cells[*cell] : nullptr;
        const std::optional<GateTimes> times = read_times(cursor, *name, known);
        if (!cell || !times) return;
        const std::size_t index = index_of(*cell);
        if (given_at_[index].is_known()) {
            error(code::duplicate_name, where, say::named_twice(quoted(*name)))
                .notes.push_back({given_at_[index], say::given_here()});
            return;
        }
        given_at_[index] = where;
        times_[index] = *times;
    }

    std::optional<std::string_view> read_name(LineCursor& cursor) {
        const Location where = cursor.here();
        if (!cursor.skip_if('"')) return cursor.take_until_blank();
        const std::string_view rest = cursor.rest();
        const std::size_t length = rest.find('"');
        if (length == std::string_view::npos) {
            error(code::unterminated_text, where, say::unterminated_name());
            return std::nullopt;
        }
        cursor.skip(length + 1);
        if (length == 0) {
            error(code::unexpected_token, where, say::no_gate_name());
            return std::nullopt;
        }
        return rest.substr(0, length);
    }

    std::optional<CellId> find_gate(std::string_view name, Location where) {
        auto found = nets_.find(name);
        if (found == nets_.end()) found = nets_.find(normalised(name));
        if (found == nets_.end()) {
            Localized message = say::unknown_gate(quoted(name));
            const std::string_view nearest = suggestion(name);
            if (!nearest.empty()) {
                message = messages::text::did_you_mean(message, quoted(nearest));
            }
            error(code::unknown_name, where, std::move(message));
            return std::nullopt;
        }
        const CellId driver = drivers_[found->second];
        if (driver == no_cell) {
            error(code::no_gate, where, say::is_an_input(quoted(name)));
            return std::nullopt;
        }
        return driver;
    }

    std::string_view suggestion(std::string_view name) {
        if (++suggestion_count_ > most_suggestions) return {};
        std::vector<std::string_view> names;
        for (const Cell& cell : netlist_.cells) names.push_back(netlist_.names[cell.output]);
        return nearest_name(name, names);
    }

    /// RISE [FALL] [width WIDTH]; `cell` is nullptr for every other gate, and for an unknown one.
    std::optional<GateTimes> read_times(LineCursor& cursor, std::string_view name,
                                        const Cell* cell) {
        GateTimes times;
        const std::optional<Time> rise = read_delay(cursor);
        if (!rise) return std::nullopt;
        times.rise = times.fall = *rise;
        cursor.skip_blanks();
        const Location second_at = cursor.here();
        if (!cursor.at_end() && !is_width(cursor)) {
            const std::optional<Time> fall = read_delay(cursor);
            if (!fall) return std::nullopt;
            times.fall = *fall;
            if (cell != nullptr && is_pulse(cell->type)) {
                error(code::unexpected_token, second_at, say::pulse_has_one_delay(quoted(name)));
                return std::nullopt;
            }
            cursor.skip_blanks();
        }
        if (cursor.at_end()) return times;
        return read_width(cursor, name, cell, times);
    }

    std::optional<GateTimes> read_width(LineCursor& cursor, std::string_view name, const Cell* cell,
                                        GateTimes times) {
        const Location where = cursor.here();
        const std::string_view word = cursor.take_until_blank();
        if (word != "width") {
            error(code::unexpected_token, where, say::text_behind_delays(quoted(word)));
            return std::nullopt;
        }
        const std::optional<Time> width = read_delay(cursor);
        if (!width) return std::nullopt;
        const bool is_every_other = name == "*";
        if (is_every_other || (cell != nullptr && !is_pulse(cell->type))) {
            error(code::unexpected_token, where, say::has_no_width(quoted(name)));
            return std::nullopt;
        }
        cursor.skip_blanks();
        if (!cursor.at_end()) {
            const Location rest_at = cursor.here();
            error(code::unexpected_token, rest_at,
                  say::text_behind_delays(quoted(cursor.take_until_blank())));
            return std::nullopt;
        }
        times.width = *width;
        return times;
    }

    static bool is_width(LineCursor ahead) { return ahead.take_until_blank() == "width"; }

    /// A time that is more than 0.
    std::optional<Time> read_delay(LineCursor& cursor) {
        cursor.skip_blanks();
        const Location where = cursor.here();
        const std::string_view text = cursor.take_until_blank();
        const bool is_negative = text.starts_with('-') && parse_nanoseconds(text.substr(1));
        const std::optional<Time> time = parse_nanoseconds(text);
        if (is_negative || time == 0) {
            error(code::bad_time, where, say::delay_not_positive(quoted(text)));
            return std::nullopt;
        }
        if (!time) {
            error(code::bad_time, where,
                  text.empty() ? say::no_delay() : say::bad_delay(quoted(text)));
        }
        return time;
    }

    const Netlist& netlist_;
    Diagnostics& diagnostics_;
    const Table<NetId, CellId> drivers_;
    std::unordered_map<std::string_view, NetId> nets_;
    DelaySchedule schedule_;

    // The section that is being read.
    Time now_ = 0;
    Location now_at_;                 ///< unknown in the first one
    std::vector<Location> given_at_;  ///< per cell; unknown where it is not named
    std::vector<GateTimes> times_;    ///< per cell
    GateTimes others_;
    Location others_at_;
    std::size_t suggestion_count_ = 0;
};

}  // namespace

std::optional<DelaySchedule> read_delays(const SourceFile& source, const Netlist& netlist,
                                         Diagnostics& diagnostics) {
    const std::size_t errors_before = diagnostics.error_count();
    std::string_view text = source.text;
    if (!check_utf8(text, diagnostics)) return std::nullopt;
    text.remove_prefix(byte_order_mark_size(text));

    DelaysReader reader(netlist, diagnostics);
    for (std::uint32_t number = 1; !text.empty(); ++number) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, length), number);
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    if (diagnostics.error_count() != errors_before) return std::nullopt;
    return reader.finish();
}

}  // namespace grafwire
