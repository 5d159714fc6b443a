#include <random>
#include <sstream>
#include <vector>

#include "trace/messages.h"
#include "trace/small_grafcet.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

Grafcet two_inputs() {
    return read_grafcet(R"(
input dcy, "a b", été, "end", "5", "H+"
output lamp
graph G { initial 1 : lamp  step 2  1 -> 2 : dcy . "a b" . été . "end" . "5" . "H+" }
)");
}

/// One line per change, `ns: index=value …`, and the end.
std::string shown(const Stimuli& stimuli) {
    std::ostringstream text;
    text << "\n";
    for (const Stimuli::Change& change : stimuli.changes) {
        text << change.at / nanosecond << ":";
        for (const Stimuli::Assignment& assignment : change.assignments) {
            text << " " << assignment.input << "=" << assignment.value;
        }
        text << "\n";
    }
    text << "end " << stimuli.end / nanosecond << "\n";
    return text.str();
}

std::string read(std::string_view text) {
    const Grafcet grafcet = two_inputs();
    const SourceFile source{"t.stim", std::string(text)};
    Diagnostics diagnostics;
    const std::optional<Stimuli> stimuli = parse_stimuli(source, grafcet, diagnostics);
    CHECK(stimuli.has_value() == diagnostics.items().empty());
    if (!stimuli) return format_diagnostics(diagnostics, source);
    return shown(*stimuli);
}

/// The places and codes of the errors.
std::string errors(std::string_view text) {
    const Grafcet grafcet = two_inputs();
    Diagnostics diagnostics;
    CHECK_FALSE(parse_stimuli({"t.stim", std::string(text)}, grafcet, diagnostics).has_value());
    std::string result;
    for (const Diagnostic& item : diagnostics.items()) {
        result += std::to_string(item.where.line) + ":" + std::to_string(item.where.column) + " " +
                  std::string(item.code.name) + "\n";
    }
    return result;
}

std::string at(std::string_view place, Code code) {
    return std::string(place) + " " + std::string(code.name) + "\n";
}

}  // namespace

TEST_CASE("the example of the manual") {
    CHECK(read(R"(# time : assignments
0ms    : dcy=1 été=1          # values before the first scan
100ms  : dcy=0
+50ms  : dcy=1              # relative to the line before
+1s    : "a b"=1 AUdoux=1
10s    : end                # optional
)") == R"(
0: 0=1 2=1
100000000: 0=0
150000000: 0=1
1150000000: 1=1 8=1
end 10000000000
)");
}

TEST_CASE("times, units, white space, line ends and a byte-order mark") {
    CHECK(
        read(
            "\xEF\xBB\xBF 1us:dcy=1\r\n\t0.5ms :\tdcy = 0\r\n1s:\n1min : Init=1\n2h : AUdur=1#x") ==
        R"(
1000: 0=1
500000: 0=0
1000000000:
60000000000: 6=1
7200000000000: 7=1
end 7200000000000
)");
    // A no-break space before the colon, as French typography has it.
    CHECK(read("1s\u00A0: dcy=1\u202F") == "\n1000000000: 0=1\nend 1000000000\n");
    CHECK(read("") == "\nend 0\n");
    CHECK(read("\n  # nothing\n\r\n") == "\nend 0\n");
    CHECK(read("5s : end") == "\nend 5000000000\n");
    CHECK(read("5s : \"end\"=1 \"5\"=1 \"H+\"=0 \"dcy\"=1\n+0s : end") ==
          "\n5000000000: 3=1 4=1 5=0 0=1\nend 5000000000\n");
    CHECK(read("5s : end=1 dcy=1") == "\n5000000000: 3=1 0=1\nend 5000000000\n");
    CHECK(read("0.000001us : dcy=1\n2548h : end").substr(0, 9) == "\n0: 0=1\ne");
}

TEST_CASE("lines of one instant are one change, and the last assignment wins") {
    CHECK(read("1s : dcy=1 \"a b\"=1\n1000ms : dcy=0\n+0ms : été=1 été=0\n+1ms : dcy=1") == R"(
1000000000: 0=0 1=1 2=0
1001000000: 0=1
end 1001000000
)");
}

TEST_CASE("errors of time") {
    for (const char* const text :
         {"100 : dcy=1", "ms : dcy=1", ": dcy=1", "1 s : dcy=1", "-1s : dcy=1", "1.s : dcy=1",
          ".5s : dcy=1", "5ns : dcy=1", "1000ps : dcy=1", "1d : dcy=1", "0.0000001us : dcy=1",
          "99999999h : dcy=1", "+5ms : dcy=1", "+ 5ms : dcy=1", "1e3ms : dcy=1", "++1s : dcy=1"}) {
        CAPTURE(text);
        const std::string first = errors(text).substr(0, 6);
        CHECK(first == at("1:1", code::bad_time).substr(0, 6));
    }
    CHECK(errors("2548h : dcy=1\n+2548h : dcy=0") == at("2:1", code::bad_time));
    CHECK(errors("2s : dcy=1\n1s : dcy=0\n1.5s : end") ==
          at("2:1", code::time_order) + at("3:1", code::time_order));
    CHECK(errors("2s : end\n3s : dcy=1\n4s : end\n") == at("2:1", code::time_order));
    CHECK(errors("2s : end\n2s : end\n") == at("2:1", code::time_order));
}

TEST_CASE("errors of assignment; all are reported in one go") {
    CHECK(errors("1s : dcy=2\n"
                 "2s : dyc=1 lamp=0 X1=1 dcy=\n"
                 "3s dcy=1\n"
                 "4s\n"
                 "5s : dcy 1 dcy\n"
                 "6s : \"a b=1\n"
                 "7s : end dcy=1\n") ==
          at("1:10", code::bad_value) + at("2:6", code::unknown_name) +
              at("2:12", code::unknown_name) + at("2:19", code::unknown_name) +
              at("2:28", code::bad_value) + at("3:4", code::unexpected_token) +
              at("4:3", code::unexpected_token) + at("5:10", code::unexpected_token) +
              at("5:15", code::unexpected_token) + at("6:6", code::unterminated_text) +
              at("7:10", code::unexpected_token));
    CHECK(errors("1s : ,dcy=1") == at("1:6", code::unexpected_character));
    CHECK(errors("1s : dcy=1, été=1") == at("1:10", code::bad_value));
    CHECK(errors("1s : 5=1") == at("1:6", code::unexpected_token));
    CHECK(errors("1s : \"\"=1") == at("1:6", code::unknown_name));
    CHECK(errors("1s : été=é") == at("1:10", code::bad_value));
    CHECK(errors("1s : dcy=10") == at("1:10", code::bad_value));
    CHECK(errors(std::string("1s : dcy=1 \0=1", 14)) == at("1:12", code::unexpected_character));
    CHECK(errors("1s : dcy=1\n2s : \xff=1") == at("2:6", code::not_utf8));
}

TEST_CASE("messages show the line and suggest what was meant") {
    CHECK(read("1s : dcy=1\n500ms : dci=0 dcy=3\n") ==
          "t.stim:2:1: error: 500ms comes before 1s, the time of an earlier line: lines stand in "
          "the order of time\n"
          "500ms : dci=0 dcy=3\n"
          "^\n"
          "t.stim:1:1: note: that line is here\n"
          "1s : dcy=1\n"
          "^\n"
          "t.stim:2:9: error: 'dci' is not an input of the GRAFCET nor a control input; did you "
          "mean 'dcy'?\n"
          "500ms : dci=0 dcy=3\n"
          "        ^\n"
          "t.stim:2:19: error: expected 0 or 1 for 'dcy', got '3'; assignments are separated by "
          "white space\n"
          "500ms : dci=0 dcy=3\n"
          "                  ^\n");
}

TEST_CASE("stimuli are written as they are read") {
    const Grafcet grafcet = two_inputs();
    Stimuli stimuli;
    stimuli.changes.push_back({0, {{0, true}, {1, false}}, {}});
    stimuli.changes.push_back({1500 * millisecond, {}, {}});
    stimuli.changes.push_back(
        {minute + 1, {{2, true}, {3, true}, {4, true}, {5, true}, {6, false}}, {}});
    stimuli.end = 2 * hour;
    const std::string text = write_stimuli(stimuli, grafcet);
    CHECK(text == R"(0s : dcy=1 "a b"=0
1.5s :
60.000000000001s : été=1 "end"=1 "5"=1 "H+"=1 Init=0
2h : end
)");
    Diagnostics diagnostics;
    const auto again = parse_stimuli({"t.stim", text}, grafcet, diagnostics);
    REQUIRE(again.has_value());
    CHECK(shown(*again) == shown(stimuli));
    CHECK(write_stimuli(*again, grafcet) == text);
}

TEST_CASE("any bytes give stimuli or errors, and stimuli can be written and read back") {
    const Grafcet grafcet = two_inputs();
    const std::vector<std::string> pieces = {"1s",      "+",
                                             "5ms",     "0.25us",
                                             "9h",      ":",
                                             " : ",     "dcy",
                                             "=1",      "=0",
                                             "=",       "\"",
                                             "\"a b\"", "end",
                                             "\n",      "\r\n",
                                             "#",       " ",
                                             "é",       "\xc3",
                                             "été=1 ",  std::string(1, '\0'),
                                             "\u00a0",  "Init=1 ",
                                             "\t",      "5",
                                             "-",       ",",
                                             "dcy=1 ",  "\n+3ms : ",
                                             "\n",      "\n7s: "};
    std::mt19937 random(1);
    int accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        std::string text;
        for (std::size_t count = random() % 12; count > 0; --count) {
            text += pieces[random() % pieces.size()];
        }
        Diagnostics diagnostics;
        const auto stimuli = parse_stimuli({"t.stim", text}, grafcet, diagnostics);
        CAPTURE(text);
        REQUIRE(stimuli.has_value() != diagnostics.has_errors());
        if (!stimuli) continue;
        ++accepted;
        Diagnostics silent;
        const auto again =
            parse_stimuli({"t.stim", write_stimuli(*stimuli, grafcet)}, grafcet, silent);
        REQUIRE(again.has_value());
        REQUIRE(shown(*again) == shown(*stimuli));
    }
    CHECK(accepted > 500);
}

}  // namespace grafwire::testing
