// Traces as tables for a terminal.

#include <doctest/doctest.h>

#include <sstream>

#include "text/utf8.h"
#include "trace/small_grafcet.h"
#include "trace/trace_table.h"

namespace grafwire::testing {

namespace {

struct Shown {
    Grafcet grafcet;
    Trace trace;

    std::string text(std::size_t width, Language language = Language::english) const {
        return write_trace_table(trace, grafcet, {width, false}, language);
    }
};

Shown shown() {
    Shown result{read_grafcet("input a, entrée2\noutput L, moteur_principal\ncounter n : 0..99\n"
                              "graph G {\n  initial 0\n  step 1 : L, moteur_principal\n"
                              "  0 -> 1 : a + entrée2 do n := n + 1\n  1 -> 0 : [n > 5]\n}\n"),
                 {}};
    result.trace = empty_trace(result.grafcet);
    result.trace.times = {0, 1500 * microsecond, 12'000 * millisecond};
    result.trace.values = {0, 0, 0, 0, 0, 1,
                           0, 0, 0, 0,  //
                           1, 1, 0, 0, 0, 0,
                           1, 1, 1, 7,  //
                           0, 1, 1, 0, 0, Trace::unknown,
                           0, 0, 0, 42};
    return result;
}

}  // namespace

TEST_CASE("all columns side by side, where they fit") {
    CHECK(shown().text(80) ==
          "time_ms  a  entrée2  Init  AUdur  AUdoux  X0  X1  L  moteur_principal  n\n"
          "      0  0  0        0     0      0       1   0   0  0                 0\n"
          "    1.5  1  1        0     0      0       0   1   1  1                 7\n"
          "  12000  0  1        1     0      0       x   0   0  0                 42\n");
}

TEST_CASE("in groups, where they do not") {
    CHECK(shown().text(64) ==
          "time_ms  inputs         situation  outputs              counters\n"
          "      0  -              X0         -                    n=0\n"
          "    1.5  a, entrée2     X1         L, moteur_principal  n=7\n"
          "  12000  entrée2, Init  X0=x       -                    n=42\n");
    CHECK(shown().text(52, Language::french) ==
          "time_ms  entrées    situation  sorties     compteurs\n"
          "      0  -          X0         -           n=0\n"
          "    1.5  a,         X1         L,          n=7\n"
          "         entrée2               moteur_pri\n"
          "                               ncipal\n"
          "  12000  entrée2,   X0=x       -           n=42\n"
          "         Init\n");
}

TEST_CASE("no line is wider than the terminal, and nothing is lost") {
    for (std::size_t width = 48; width < 90; ++width) {
        INFO("width: " << width);
        const std::string text = shown().text(width);
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            CHECK(count_code_points(line) <= width);
            CHECK(line.back() != ' ');
        }
        CHECK(text.find("42") != std::string::npos);
    }
}

TEST_CASE("emphasis is the head in bold, and nothing else") {
    const Shown table = shown();
    std::string text = write_trace_table(table.trace, table.grafcet, {80, true}, Language::english);
    CHECK(text.rfind("\033[1mtime_ms  a ", 0) == 0);
    text.erase(0, 4);
    text.erase(text.find("\033[0m"), 4);
    CHECK(text == table.text(80));
}

}  // namespace grafwire::testing
