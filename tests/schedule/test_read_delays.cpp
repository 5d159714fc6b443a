#include <doctest/doctest.h>
#include <fmt/format.h>

#include <iterator>
#include <string>
#include <string_view>

#include "gates.h"
#include "schedule/delays_text.h"

namespace grafwire::testing {

namespace {

/// A line for each change, `ps: gate rise fall width`, or the messages.
std::string read(std::string_view text, Language language = Language::english) {
    const Netlist netlist = some_gates();
    const SourceFile source{"t.delays", std::string(text)};
    Diagnostics diagnostics;
    const std::optional<DelaySchedule> schedule = read_delays(source, netlist, diagnostics);
    CHECK(schedule.has_value() == diagnostics.items().empty());
    if (!schedule) return format_diagnostics(diagnostics, source, language);
    std::string out;
    for (const DelayChange& change : schedule->changes) {
        fmt::format_to(std::back_inserter(out), "{}: {} {} {} {}\n", change.at,
                       netlist.names[netlist.cells[change.cell].output], change.rise, change.fall,
                       change.width);
    }
    return out;
}

/// The places and messages of the errors, a line each.
std::string errors(std::string_view text) {
    const Netlist netlist = some_gates();
    Diagnostics diagnostics;
    CHECK_FALSE(read_delays({"t.delays", std::string(text)}, netlist, diagnostics).has_value());
    std::string out;
    for (const Diagnostic& item : diagnostics.items()) {
        fmt::format_to(std::back_inserter(out), "{}:{} {}: {}\n", item.where.line,
                       item.where.column, item.code.name, item.message.english);
        for (const auto& note : item.notes) {
            fmt::format_to(std::back_inserter(out), "  {}:{} {}\n", note.where.line,
                           note.where.column, note.message.english);
        }
    }
    return out;
}

}  // namespace

TEST_CASE("gates and how long they take") {
    CHECK(read("") == "");
    CHECK(read("# nothing\n\n   \n") == "");
    CHECK(read("X1$set 3\nX1$q  3.5 7 # rise, fall\n") ==
          "0: X1$set 3000 3000 0\n0: X1$q 3500 7000 0\n");
    CHECK(read("\xef\xbb\xbf\"two words\" 1ps 2us\r\n\"X1$q\" 1s 12ms") ==
          "0: X1$q 1000000000000 12000000000 0\n0: two words 1 2000000 0\n");
    CHECK(read("a$rise 4 width 6\n") == "0: a$rise 4000 4000 6000\n");
    CHECK(read("a$rise 4\n") == "0: a$rise 4000 4000 0\n");
    // é as a letter and its accent.
    CHECK(read("e\xcc\x81te\xcc\x81 2\n") == "0: été 2000 2000 0\n");
}

TEST_CASE("an asterisk stands for every other gate") {
    CHECK(read("X1$q 5\n* 2 3\n") ==
          "0: a$rise 2000 2000 0\n0: X1$set 2000 3000 0\n0: X1$q 5000 5000 0\n"
          "0: two words 2000 3000 0\n0: été 2000 3000 0\n");
    CHECK(read("at 1ms\n* 2\nX1$q 5\n") ==
          "1000000000: a$rise 2000 2000 0\n1000000000: X1$set 2000 2000 0\n"
          "1000000000: X1$q 5000 5000 0\n1000000000: two words 2000 2000 0\n"
          "1000000000: été 2000 2000 0\n");
}

TEST_CASE("from moments on") {
    CHECK(read("X1$q 2\nat 20ms\nX1$set 12\nat 20ms + 3\nX1$set 2\nat 20ms+3.5\nX1$q 1\nat 1s\n") ==
          "0: X1$q 2000 2000 0\n20000000000: X1$set 12000 12000 0\n"
          "20000003000: X1$set 2000 2000 0\n20000003500: X1$q 1000 1000 0\n");
    CHECK(read("at 7 # ns\nX1$q 2") == "7000: X1$q 2000 2000 0\n");
    CHECK(read("at 1ms + 2us\nX1$q 2") == "1002000000: X1$q 2000 2000 0\n");
}

TEST_CASE("what is wrong with a gate is said at its place") {
    CHECK(errors("X1$sett 3\n") ==
          "1:1 unknown-name: the netlist has no net 'X1$sett'; did you mean 'X1$set'?\n");
    CHECK(errors("  whatever 3\n") == "1:3 unknown-name: the netlist has no net 'whatever'\n");
    CHECK(errors("b 3\n") == "1:1 no-gate: 'b' is an input of the netlist: no gate drives it\n");
    CHECK(errors("X1$q 3\n\n X1$q 3\n") ==
          "3:2 duplicate-name: 'X1$q' has its delays already\n  1:1 they are given here\n");
    CHECK(errors("* 3\n* 4\n") ==
          "2:1 duplicate-name: '*', every other gate, has its delays already\n"
          "  1:1 they are given here\n");
    CHECK(errors("\"two words 3\n") ==
          "1:1 unterminated-text: the quoted name is not ended on its line\n");
    CHECK(errors("\"\" 3\n").starts_with("1:1 unexpected-token: expected the name of a net"));
    CHECK(errors("X1$q 3 width 2\n") ==
          "1:8 unexpected-token: 'X1$q' gives no pulses, so it has no width\n");
    CHECK(errors("* 3 width 2\n") ==
          "1:5 unexpected-token: '*' gives no pulses, so it has no width\n");
    CHECK(errors("a$rise 3 4\n") ==
          "1:10 unexpected-token: 'a$rise' gives pulses: it has one delay, and 'width' for how "
          "long they last\n");
    CHECK(errors("X1$q 3 4 5\nX1$set 3 4 what\na$rise 3 width 4 5\n") ==
          "1:10 unexpected-token: nothing may follow the times of a gate but 'width' and the width "
          "of a pulse, got '5'\n"
          "2:12 unexpected-token: nothing may follow the times of a gate but 'width' and the width "
          "of a pulse, got 'what'\n"
          "3:18 unexpected-token: nothing may follow the times of a gate but 'width' and the width "
          "of a pulse, got '5'\n");
}

TEST_CASE("a gate takes some time") {
    CHECK(errors("X1$q 0\nX1$set 3 0ps\ntwo 0\n* -2\na$rise 1 width 0\n") ==
          "1:6 bad-time: a gate takes some time: '0' is not more than 0\n"
          "2:10 bad-time: a gate takes some time: '0ps' is not more than 0\n"
          "3:1 unknown-name: the netlist has no net 'two'\n"
          "3:5 bad-time: a gate takes some time: '0' is not more than 0\n"
          "4:3 bad-time: a gate takes some time: '-2' is not more than 0\n"
          "5:16 bad-time: a gate takes some time: '0' is not more than 0\n");
    CHECK(errors("X1$q\nX1$q 3,5\nX1$q 0.0001\nX1$q 999h 9999999999s\na$rise 3 width\n") ==
          "1:5 bad-time: expected a time such as '3', '3.5' (in ns) or '12us'\n"
          "2:6 bad-time: expected a time such as '3', '3.5' (in ns) or '12us', got '3,5'\n"
          "3:6 bad-time: expected a time such as '3', '3.5' (in ns) or '12us', got '0.0001'\n"
          "4:11 bad-time: expected a time such as '3', '3.5' (in ns) or '12us', got "
          "'9999999999s'\n"
          "5:15 bad-time: expected a time such as '3', '3.5' (in ns) or '12us'\n");
}

TEST_CASE("moments go forwards") {
    CHECK(errors("at 20ms\nat 5ms\nX1$q 2\nat 20ms\n") ==
          "2:4 time-order: 5ms does not come after 20ms: sections stand in the order of time\n"
          "  1:4 that moment is here\n"
          "4:4 time-order: 20ms does not come after 20ms: sections stand in the order of time\n"
          "  1:4 that moment is here\n");
    CHECK(errors("at 0\n") ==
          "1:4 time-order: what holds from the start stands before the first 'at'\n");
    CHECK(errors("at\nat soon\nat 3ms +\nat 3ms + x\nat 4ms now\n") ==
          "1:3 bad-time: expected a moment after 'at', such as '20ms' or '20ms + 3'\n"
          "2:4 bad-time: expected a moment after 'at', such as '20ms' or '20ms + 3', got 'soon'\n"
          "3:9 bad-time: expected a moment after 'at', such as '20ms' or '20ms + 3'\n"
          "4:10 bad-time: expected a moment after 'at', such as '20ms' or '20ms + 3', got 'x'\n"
          "5:8 unexpected-token: nothing may follow the moment on its line\n");
    CHECK(errors("\xff").starts_with("1:1 not-utf8"));
}

TEST_CASE("messages in French") {
    CHECK(read("X1$sett 3\n", Language::french).find("le câblage n'a pas de fil") !=
          std::string::npos);
}

TEST_CASE("a text of nothing but wrong names is read in time") {
    std::string text;
    for (int i = 0; i < 20'000; ++i) text += "X1$sat" + std::to_string(i) + " 3\n";
    CHECK(errors(text).size() > 20'000);
}

}  // namespace grafwire::testing
