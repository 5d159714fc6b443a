// The canonical form: sections in the order of time, in each of them `*` first and then the gates
// in the order of cells. `*` is written where a section gives times to every gate, as the first
// one does, and most of them share theirs.

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "schedule/delays_text.h"
#include "trace/line_cursor.h"

namespace grafwire {

namespace {

/// The changes of one moment, the last of each cell, in the order of cells.
using Section = std::map<CellId, DelayChange>;

/// Quoted where the reader would take it for something else.
void append_name(std::string& out, std::string_view name) {
    const bool is_special = name.empty() || name == "*" || name == "at" || name.front() == '"';
    const bool is_quoted = is_special || LineCursor(name, 1).take_until_blank() != name;
    if (is_quoted) out += '"';
    out += name;
    if (is_quoted) out += '"';
}

class DelaysWriter {
  public:
    explicit DelaysWriter(const Netlist& netlist) : netlist_(netlist) {}

    std::string write(const DelaySchedule& schedule) {
        std::map<Time, Section> sections;
        Section& start = sections[0];
        for (std::size_t i = 0; i < netlist_.cells.size(); ++i) {
            const CellId cell = netlist_.cells.id_at(i);
            start[cell] = {.cell = cell};
        }
        for (const DelayChange& change : schedule.changes) {
            DelayChange& place = sections[std::max<Time>(change.at, 0)][change.cell];
            const Time width = change.width == 0 ? place.width : change.width;
            place = change;
            place.width = width;
            if (is_pulse(netlist_.cells[change.cell].type)) place.fall = place.rise;
        }
        for (const auto& [at, section] : sections) append_section(at, section);
        return std::move(out_);
    }

  private:
    using Times = std::pair<Time, Time>;

    static Times times_of(const DelayChange& change) { return {change.rise, change.fall}; }

    /// Of equally many the shortest.
    static Times most_frequent(const Section& section) {
        std::map<Times, std::size_t> counts;
        for (const auto& [cell, change] : section) ++counts[times_of(change)];
        const auto most =
            std::max_element(counts.begin(), counts.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; });
        return most->first;
    }

    void append_section(Time at, const Section& section) {
        const bool is_start = at == 0;
        if (!is_start) append_moment(at);
        const bool is_whole = !section.empty() && section.size() == netlist_.cells.size();
        const Times others = is_whole ? most_frequent(section) : Times{};
        const bool is_left_out = is_start && others == Times{nanosecond, nanosecond};
        if (is_whole && !is_left_out) {
            out_ += '*';
            append_times(others);
            out_ += '\n';
        }
        for (const auto& [cell, change] : section) {
            // A wire that is not named would take no time at all.
            const bool is_named = is_start && is_wire(netlist_, netlist_.cells[cell]);
            if (change.width == 0 && times_of(change) == others && !is_named) continue;
            append_gate(cell, change);
        }
    }

    void append_moment(Time at) {
        const Time since = at % microsecond;
        out_ += "at ";
        if (at != since) out_ += format_duration(at - since);
        if (at != since && since != 0) out_ += " + ";
        if (since != 0) out_ += format_nanoseconds(since);
        out_ += '\n';
    }

    void append_gate(CellId id, const DelayChange& change) {
        const Cell& cell = netlist_.cells[id];
        append_name(out_, netlist_.names[cell.output]);
        append_times(times_of(change));
        if (change.width != 0) out_ += " width " + format_nanoseconds(change.width);
        out_ += '\n';
    }

    /// The fall where it differs from the rise.
    void append_times(Times times) {
        out_ += ' ' + format_nanoseconds(times.first);
        if (times.second != times.first) out_ += ' ' + format_nanoseconds(times.second);
    }

    const Netlist& netlist_;
    std::string out_;
};

}  // namespace

std::string write_delays(const DelaySchedule& schedule, const Netlist& netlist) {
    return DelaysWriter(netlist).write(schedule);
}

}  // namespace grafwire
