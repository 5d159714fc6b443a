// The interpreter of sequential function charts, against what was worked out by hand from
// IEC 61131-3 (2nd edition), 2.6.4 and 2.6.5.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "ladder/sfc_machine.h"

namespace grafwire::testing {

namespace {

/// A project with one program `chart`, of few words.
struct Drawing {
    struct Transition {
        std::vector<std::string> from;
        std::vector<std::string> to;
        std::string condition;
    };
    struct Action {
        std::string step;
        std::string qualifier;
        std::string what;  ///< a name, or statements, which end with a semicolon
        std::string duration;
    };
    std::string steps;  ///< a letter each, initial ones in capitals
    std::vector<Transition> transitions;
    std::vector<Action> actions;

    std::string xml() const;
};

std::string name_of(char step) {
    return std::string(1, static_cast<char>(std::tolower(step)));
}

/// An action block of a step.
std::string block_of(const Drawing::Action& action, std::size_t step_id) {
    const std::string duration =
        action.duration.empty() ? "" : " duration=\"" + action.duration + "\"";
    const bool is_text = action.what.back() == ';';
    return fmt::format(
        "<actionBlock localId='900'><connectionPointIn><connection refLocalId='{}'/>"
        "</connectionPointIn><action localId='901' qualifier='{}'{}>{}</action></actionBlock>",
        step_id, action.qualifier, duration,
        is_text ? "<inline><ST><xhtml:p>" + action.what + "</xhtml:p></ST></inline>"
                : "<reference name='" + action.what + "'/>");
}

std::string variables() {
    std::string text = "<interface><inputVars>";
    for (const char* name : {"go", "other"}) {
        text += fmt::format("<variable name='{}'><type><BOOL/></type></variable>", name);
    }
    text += "</inputVars><localVars>";
    for (const char* name : {"lamp", "m"}) {
        text += fmt::format("<variable name='{}'><type><BOOL/></type></variable>", name);
    }
    for (const char* name : {"n", "k"}) {
        text += fmt::format("<variable name='{}'><type><INT/></type></variable>", name);
    }
    return text + "</localVars></interface>";
}

std::string Drawing::xml() const {
    std::map<std::string, std::size_t> ids;
    for (const char step : steps) ids.emplace(name_of(step), ids.size() + 1);
    const auto wire = [](std::size_t id) {
        return fmt::format("<connection refLocalId='{}'/>", id);
    };
    std::string body;
    std::map<std::string, std::string> into;
    std::size_t next = 100;
    for (std::size_t t = 0; t < transitions.size(); ++t) {
        std::string above;
        for (const std::string& from : transitions[t].from) above += wire(ids[from]);
        if (transitions[t].from.size() > 1) {
            body += fmt::format(
                "<simultaneousConvergence localId='{}'><connectionPointIn>{}</connectionPointIn>"
                "</simultaneousConvergence>",
                next, above);
            above = wire(next++);
        }
        body += fmt::format(
            "<transition localId='{}'><position x='{}' y='0'/><connectionPointIn>{}"
            "</connectionPointIn><condition><inline name=''><ST><xhtml:p>{}</xhtml:p></ST></inline>"
            "</condition></transition>",
            next, 100 * t, above, transitions[t].condition);
        for (const std::string& to : transitions[t].to) into[to] += wire(next);
        ++next;
    }
    for (const char step : steps) {
        const std::string name = name_of(step);
        body += fmt::format(
            "<step localId='{}' name='{}'{}><connectionPointIn>{}</connectionPointIn></step>",
            ids[name], name, std::isupper(step) != 0 ? " initialStep='true'" : "", into[name]);
    }
    for (const Action& action : actions) body += block_of(action, ids[action.step]);
    return "<project><types><pous><pou name='chart'>" + variables() + "<body><SFC>" + body +
           "</SFC></body></pou></pous></types></project>";
}

struct Run {
    std::string text;  ///< the value after each scan
    std::vector<SfcScanReport> reports;
};

/// Scans every 10 ms, `go` as given for each (0 or 1); the values of a variable or step.
Run run(const Drawing& drawing, const std::string& go, const std::string& name,
        const SfcDialect& dialect = {}) {
    const SfcPou sfc = read_sfc(drawing.xml(), "chart");
    SfcMachine machine(sfc, dialect);
    Run run;
    for (std::size_t i = 0; i < go.size(); ++i) {
        machine.set_input("go", go[i] == '1');
        run.reports.push_back(machine.scan(static_cast<Time>(10 * i) * millisecond));
        run.text += std::to_string(machine.value(name));
    }
    return run;
}

std::string values(const Drawing& drawing, const std::string& go, const std::string& name,
                   const SfcDialect& dialect = {}) {
    return run(drawing, go, name, dialect).text;
}

constexpr SfcDialect plain{false, false, false};

/// Two steps; `go` leads to the second, its absence back.
Drawing two_steps(std::vector<Drawing::Action> actions) {
    return {"Ab", {{{"a"}, {"b"}, "go"}, {{"b"}, {"a"}, "NOT go"}}, std::move(actions)};
}

}  // namespace

TEST_CASE("SFC machine: steps, one transition a scan") {
    CHECK(values(two_steps({}), "0011100", "b") == "0011100");
    const Drawing row{"Abc", {{{"a"}, {"b"}, "go"}, {{"b"}, {"c"}, "go"}}, {}};
    CHECK(values(row, "0111", "a") == "1000");
    CHECK(values(row, "0111", "b") == "0100");
    CHECK(values(row, "0111", "c") == "0011");
    // A token that follows another: b is left and entered, and stays active.
    const Drawing both{"ABc", {{{"a"}, {"b"}, "go"}, {{"b"}, {"c"}, "go"}}, {}};
    CHECK(values(both, "0111", "b") == "1100");
    CHECK(values(both, "0111", "c") == "0111");
}

TEST_CASE("SFC machine: simultaneous sequences") {
    const Drawing drawing{
        "Abcde",
        {{{"a"}, {"b", "c"}, "go"}, {{"b"}, {"d"}, "NOT go"}, {{"d", "c"}, {"e"}, "TRUE"}},
        {}};
    CHECK(values(drawing, "01100", "a") == "10000");
    CHECK(values(drawing, "01100", "b") == "01100");
    CHECK(values(drawing, "01100", "c") == "01110");
    CHECK(values(drawing, "01100", "d") == "00010");
    CHECK(values(drawing, "01100", "e") == "00001");
}

TEST_CASE("SFC machine: of a selection the leftmost, and it is reported") {
    const Drawing drawing{"Abc", {{{"a"}, {"b"}, "go"}, {{"a"}, {"c"}, "TRUE"}}, {}};
    const Run first = run(drawing, "1", "b");
    CHECK(first.text == "1");
    REQUIRE(first.reports[0].selections.size() == 1);
    CHECK(first.reports[0].selections[0] == std::pair<std::size_t, std::size_t>(0, 1));
    const Run second = run(drawing, "0", "c");
    CHECK(second.text == "1");
    CHECK(second.reports[0].selections.empty());
    // Not in a selection where they wait for different steps.
    const Drawing apart{"Abc", {{{"a"}, {"b"}, "go"}, {{"b"}, {"c"}, "TRUE"}}, {}};
    CHECK(run(apart, "11", "c").reports[1].selections.empty());
}

TEST_CASE("SFC machine: N and the final scan") {
    const Drawing drawing = two_steps({{"b", "N", "n := n + 1;", ""}, {"b", "N", "lamp", ""}});
    CHECK(values(drawing, "0110001", "n", plain) == "0122223");
    CHECK(values(drawing, "0110001", "n") == "0123334");
    // A BOOL variable has no final scan.
    CHECK(values(drawing, "0110001", "lamp") == "0110001");
}

TEST_CASE("SFC machine: several N of one variable") {
    const Drawing drawing{"Abc",
                          {{{"a"}, {"b"}, "go"}, {{"b"}, {"c"}, "NOT go"}},
                          {{"a", "N", "lamp", ""}, {"c", "N", "lamp", ""}}};
    CHECK(values(drawing, "01100", "lamp") == "10011");
}

TEST_CASE("SFC machine: P1 and P0 once") {
    const Drawing p1 = two_steps({{"b", "P1", "n := n + 1;", ""}});
    CHECK(values(p1, "0111001", "n") == "0111112");
    const Drawing p0 = two_steps({{"b", "P0", "n := n + 1;", ""}});
    CHECK(values(p0, "0111001", "n") == "0000111");
    const Drawing initial = two_steps({{"a", "P1", "n := n + 1;", ""}});
    CHECK(values(initial, "00100", "n") == "11122");
    CHECK(values(initial, "00100", "n", plain) == "00011");
    // No pulse where a step is left and entered in one scan.
    const Drawing loop{"Ab",
                       {{{"a"}, {"b"}, "go"}, {{"b"}, {"b"}, "TRUE"}},
                       {{"b", "P1", "n := n + 1;", ""}, {"b", "P0", "k := k + 1;", ""}}};
    CHECK(values(loop, "0111", "n") == "0111");
    CHECK(values(loop, "0111", "k") == "0000");
}

TEST_CASE("SFC machine: S and R act while their step is active, R over all else") {
    const Drawing drawing{"Abc",
                          {{{"a"}, {"b"}, "go"}, {{"b"}, {"c"}, "NOT go"}, {{"c"}, {"a"}, "go"}},
                          {{"b", "S", "lamp", ""}, {"c", "R", "lamp", ""}}};
    CHECK(values(drawing, "0110011", "lamp") == "0110001");
    // c is active with b: lamp is reset as long as c is, then set again by b.
    const Drawing both{"ABcd",
                       {{{"a"}, {"c"}, "go"}, {{"c"}, {"d"}, "NOT go"}},
                       {{"b", "S", "lamp", ""}, {"c", "R", "lamp", ""}}};
    CHECK(values(both, "0110", "lamp") == "1001");
    const Drawing over =
        two_steps({{"a", "N", "lamp", ""}, {"b", "N", "lamp", ""}, {"b", "R", "lamp", ""}});
    CHECK(values(over, "0110", "lamp") == "1001");
}

TEST_CASE("SFC machine: D and L") {
    const Drawing late = two_steps({{"b", "D", "lamp", "T#20ms"}});
    CHECK(values(late, "0111101110", "lamp") == "0001100010");
    const Drawing brief = two_steps({{"b", "L", "lamp", "T#20ms"}});
    CHECK(values(brief, "0111101110", "lamp") == "0110001100");
    const Drawing at_once = two_steps({{"b", "D", "lamp", "T#0s"}});
    CHECK(values(at_once, "0110", "lamp") == "0110");
    // From the first scan on.
    const Drawing initial = two_steps({{"a", "D", "lamp", "T#20ms"}});
    CHECK(values(initial, "0000", "lamp") == "0011");
}

TEST_CASE("SFC machine: the time of a step that is left and entered at once") {
    const Drawing drawing{
        "Ab", {{{"a"}, {"b"}, "go"}, {{"b"}, {"b"}, "NOT go"}}, {{"b", "D", "lamp", "T#20ms"}}};
    CHECK(values(drawing, "0110111", "lamp") == "0001111");
    CHECK(values(drawing, "0110111", "lamp", {true, true, true}) == "0000011");
}

TEST_CASE("SFC machine: statements in the order of the file, meetings reported") {
    const auto meetings = [](const std::string& first, const std::string& second) {
        const Drawing drawing = two_steps({{"b", "P1", first, ""}, {"a", "P0", second, ""}});
        const Run result = run(drawing, "01", "n");
        CHECK(result.reports[0].meetings.empty());
        return result.reports[1].meetings.size();
    };
    CHECK(meetings("n := 1;", "n := 2;") == 1);
    CHECK(meetings("n := k;", "k := 2;") == 1);
    CHECK(meetings("k := 2;", "IF go THEN n := k; END_IF;") == 1);
    CHECK(meetings("k := 2;", "IF NOT go THEN n := k; END_IF;") == 0);
    CHECK(meetings("n := k + 1;", "m := go AND (k = 0);") == 0);
    const Drawing order = two_steps({{"b", "P1", "n := 1;", ""}, {"a", "P0", "n := n + 2;", ""}});
    CHECK(values(order, "01", "n") == "03");
    const Drawing latch = two_steps({{"b", "S", "lamp", ""}, {"a", "P0", "m := lamp;", ""}});
    CHECK(run(latch, "01", "m").reports[1].meetings.size() == 1);
}

TEST_CASE("SFC machine: conditions read the situation that the scan began with") {
    const Drawing drawing{"Abc", {{{"a"}, {"b"}, "go"}, {{"a"}, {"c"}, "b.X"}}, {}};
    CHECK(values(drawing, "011", "c") == "000");
}

TEST_CASE("SFC machine: what it refuses") {
    const auto refuses = [](const Drawing& drawing) {
        CHECK_THROWS_AS(run(drawing, "01", "n"), PlcError);
    };
    CHECK_NOTHROW(run(two_steps({{"b", "N", "lamp", ""}}), "01", "n"));
    refuses(two_steps({{"b", "SD", "lamp", ""}}));
    refuses(two_steps({{"b", "S", "m := TRUE;", ""}}));
    refuses(two_steps({{"b", "P1", "lamp", ""}}));
    refuses(two_steps({{"b", "D", "lamp", ""}}));
    refuses(two_steps({{"b", "N", "lamp", "T#1s"}}));
    refuses(two_steps({{"b", "N", "n", ""}}));
    refuses(two_steps({{"b", "N", "nothing", ""}}));
    refuses(two_steps({{"b", "N", "go := TRUE;", ""}}));
    refuses(two_steps({{"b", "N", "lamp", ""}, {"b", "N", "lamp := TRUE;", ""}}));
    refuses(two_steps({{"a", "D", "lamp", "T#1s"}, {"b", "L", "lamp", "T#2s"}}));
    refuses({"Ab", {{{"a"}, {"b"}, "a.T"}}, {}});
    refuses({"Ab", {{{"a"}, {"b"}, "go go"}}, {}});
    refuses({"Ab", {{{}, {"b"}, "go"}}, {}});
    CHECK_THROWS_AS(read_sfc(two_steps({}).xml(), "elsewhere"), PlcError);
}

}  // namespace grafwire::testing
