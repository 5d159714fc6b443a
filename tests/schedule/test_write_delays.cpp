#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "gates.h"
#include "schedule/delays_text.h"

namespace grafwire::testing {

namespace {

DelaySchedule read_back(const std::string& text, const Netlist& netlist) {
    Diagnostics diagnostics;
    const SourceFile source{"t.delays", text};
    const std::optional<DelaySchedule> schedule = read_delays(source, netlist, diagnostics);
    if (!schedule) FAIL(text << format_diagnostics(diagnostics, source));
    return *schedule;
}

/// A text read and written.
std::string canonical(const std::string& text) {
    const Netlist netlist = some_gates();
    return write_delays(read_back(text, netlist), netlist);
}

/// What each cell takes from each moment on, worked out change by change.
std::vector<DelayChange> in_force(const DelaySchedule& schedule, const Netlist& netlist, Time at) {
    std::vector<DelayChange> cells(netlist.cells.size());
    for (const DelayChange& change : schedule.changes) {
        if (change.at > at) break;
        DelayChange& cell = cells[index_of(change.cell)];
        const Time width = change.width == 0 ? cell.width : change.width;
        cell = {0, change.cell, change.rise, change.fall, width};
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i].cell = netlist.cells.id_at(i);
        if (netlist.cells[cells[i].cell].type == CellType::rise_pulse) cells[i].fall = 0;
    }
    return cells;
}

}  // namespace

TEST_CASE("the canonical form") {
    CHECK(canonical("") == "");
    CHECK(canonical("X1$q 1\n") == "");
    CHECK(canonical("  \"X1$q\" 3500ps 7ns # slow\nX1$set 2 2\na$rise 1 width 0.5\n") ==
          "a$rise 1 width 0.5\nX1$set 2\nX1$q 3.5 7\n");
    CHECK(canonical("* 2 3\nX1$q 4\n") == "* 2 3\na$rise 2\nX1$q 4\n");
    CHECK(canonical("* 2\nX1$q 4\n") == "* 2\nX1$q 4\n");
    CHECK(canonical("at 20000us + 3.5ns\n\"two words\" 3\nat 20ms + 2us\nété 1\nat 21ms+4\n"
                    "X1$q 1\nat 1s\n* 7\nété 8\n") ==
          "at 20ms + 3.5\n\"two words\" 3\nat 20.002ms\nété 1\nat 21ms + 4\nX1$q 1\nat 1s\n* 7\n"
          "été 8\n");
    CHECK(canonical("at 7\nX1$q 2\nat 1us\nX1$q 3\n") == "at 7\nX1$q 2\nat 1us\nX1$q 3\n");
}

TEST_CASE("names that the reader would take for something else are quoted") {
    SmallNetlist small;
    small.input("a");
    for (const char* name : {"at", "*", "width", "a b", "a#b", "#", "V+",
                             "no\xc2\xa0"
                             "break",
                             "x\"y"}) {
        small.cell(CellType::buffer, name, {"a"});
    }
    DelaySchedule schedule;
    Time delay = 2 * nanosecond;
    for (std::size_t i = 0; i < small.netlist.cells.size(); ++i) {
        schedule.changes.push_back({0, small.netlist.cells.id_at(i), delay, delay});
        delay += nanosecond;
    }
    const std::string text = write_delays(schedule, small.netlist);
    CHECK(text ==
          "* 2\n\"*\" 3\nwidth 4\n\"a b\" 5\n\"a#b\" 6\n\"#\" 7\nV+ 8\n\"no\xc2\xa0"
          "break\" 9\nx\"y 10\n");
    CHECK(read_back(text, small.netlist).changes == schedule.changes);
}

TEST_CASE("random schedules come back as they were, in the same bytes") {
    const Netlist netlist = some_gates();
    std::mt19937 random(77);
    for (int round = 0; round < 500; ++round) {
        CAPTURE(round);
        DelaySchedule schedule;
        const std::size_t count = random() % 12;
        const Time units[] = {1, 500, nanosecond, 7 * microsecond, second};
        const auto random_time = [&] {
            const Time unit = units[random() % std::size(units)];
            return static_cast<Time>(1 + random() % 20) * unit;
        };
        for (std::size_t i = 0; i < count; ++i) {
            DelayChange change;
            const bool from_start = random() % 3 == 0;
            change.at = from_start ? 0 : random_time();
            change.cell = netlist.cells.id_at(random() % netlist.cells.size());
            change.rise = random_time();
            change.fall = random() % 2 == 0 ? change.rise : random_time();
            const bool gives_pulses = netlist.cells[change.cell].type == CellType::rise_pulse;
            if (gives_pulses && random() % 2 == 0) change.width = random_time();
            schedule.changes.push_back(change);
        }
        std::stable_sort(schedule.changes.begin(), schedule.changes.end(),
                         [](const DelayChange& a, const DelayChange& b) { return a.at < b.at; });
        const std::string text = write_delays(schedule, netlist);
        const DelaySchedule again = read_back(text, netlist);
        REQUIRE(write_delays(again, netlist) == text);
        for (const DelayChange& change : schedule.changes) {
            REQUIRE(in_force(again, netlist, change.at) == in_force(schedule, netlist, change.at));
        }
    }
}

}  // namespace grafwire::testing
