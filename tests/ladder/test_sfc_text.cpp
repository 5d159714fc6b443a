// What stands in the sequential function chart of a PLCopen project.

#include <doctest/doctest.h>

#include <algorithm>

#include "ladder/run_sfc.h"
#include "ladder/sfc_editor.h"
#include "plcopen/write_project.h"
#include "random/read_text.h"
#include "sfc/remarks.h"

namespace grafwire::testing {

namespace {

using Kind = sfc::Remark::Kind;

struct Read {
    explicit Read(const std::string& text) : grafcet(read(text)), written(grafcet) {}

    static Grafcet read(const std::string& text) {
        std::string messages;
        auto grafcet = read_grafcet(text, &messages);
        REQUIRE_MESSAGE(grafcet, messages);
        return *grafcet;
    }
    /// The actions of a step, a line each: qualifier, duration, what.
    std::string actions(const std::string& step) const {
        std::string text;
        for (const SfcPou::Action& action : written.sfc.actions) {
            if (written.sfc.steps[action.step].name != step) continue;
            text += action.qualifier + " ";
            if (action.duration != 0) text += format_duration(action.duration) + " ";
            text += action.reference + action.statements;
            if (text.back() != '\n') text += "\n";
        }
        return text;
    }
    /// The documentation of a step.
    std::string note(const std::string& step) const {
        const std::size_t begin =
            written.xml.find("name=\"" + step + "\"", written.xml.find("<SFC>"));
        const std::string text =
            written.xml.substr(begin, written.xml.find("</step>", begin) - begin);
        const std::size_t from = text.find("<xhtml:p>") + 9;
        return text.substr(from, text.find("</xhtml:p>") - from);
    }
    const std::string& condition(std::size_t transition) const {
        return written.sfc.transitions[transition].condition;
    }
    std::vector<std::string> remarks(Kind kind) const {
        std::vector<std::string> texts;
        for (const auto& remark : sfc::remarks_of(grafcet)) {
            if (remark.kind == kind) texts.push_back(remark.text.english);
        }
        return texts;
    }

    Grafcet grafcet;
    WrittenSfc written;
};

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("SFC text: edges, time conditions, outputs with conditions") {
    const Read chart(R"(
input dcy, v, k
output lamp, motor, pump
graph G {
  initial 1 : lamp
  step 2 : motor if 5s/X2, lamp if v + k
  step 3 : pump if /(3s/X3)
  1 -> 2 : ↑dcy
  2 -> 3 : 2s/X2 . /v + ↓X3
  3 -> 1 : 1s/(v + k)/2s
}
)");
    CHECK(chart.condition(0) == "started AND dcy AND NOT dcy_before");
    CHECK(chart.condition(1) == "n2s_X2 AND NOT v OR (started AND NOT X3_then AND X3_before)");
    CHECK(chart.condition(2) == "n1s_v_plus_k_2s");
    CHECK(chart.actions("x1") == "");
    CHECK(chart.note("X1") == "lamp: assigned by observe");
    CHECK(chart.actions("x2") == "D 5s motor\n");
    CHECK(chart.note("X2") == "lamp if v OR k: assigned by observe");
    CHECK(chart.actions("x3") == "L 3s pump\n");
    CHECK(chart.actions("observe") == R"(N (* Time conditions, as the next scan sees them *)
timer2(IN := X2.X, PT := T#2s);
n2s_X2 := timer2.Q;
timer3(IN := (v OR k) AND NOT n1s_v_plus_k_2s, PT := T#1s);
IF timer3.Q THEN n1s_v_plus_k_2s := TRUE; END_IF;
timer3_off(IN := NOT (v OR k) AND n1s_v_plus_k_2s, PT := T#2s);
IF timer3_off.Q THEN n1s_v_plus_k_2s := FALSE; END_IF;
(* Outputs with conditions *)
lamp := X1.X OR (X2.X AND (v OR k));
(* What the next scan compares with *)
dcy_before := dcy;
X3_before := X3_then;
X3_then := X3.X;
started := TRUE;
)");
    CHECK(chart.remarks(Kind::scope) ==
          Texts{"This chart does without Init, AUdur and AUdoux; otherwise it is the GRAFCET, scan "
                "for scan. The ladder diagram (--to plcopen) is the whole GRAFCET."});
    CHECK(chart.remarks(Kind::observer).size() == 1);
    CHECK(chart.written.sfc.comments.size() == 2);
    CHECK(chart.written.sfc.actions.back().step == 3);
    CHECK(chart.written.sfc.steps[3].name == "observe");
}

TEST_CASE("SFC text: stored actions") {
    const Read chart(R"(
input a, b
output lamp, horn
var m
counter c : -1..9
graph G {
  initial 1 : c := 0, set m
  step 2 : set lamp, c := c + 1 on ↑a
  step 3 : reset lamp, horn := m on deactivation, m := a . /b
  1 -> 2 : a
  2 -> 3 : b
  3 -> 1 : /a
}
)");
    CHECK(chart.actions("x1") == "P1 IF started THEN\n  c := 0;\n  m := TRUE;\nEND_IF;\n");
    CHECK(chart.actions("x2") == R"(S lamp
N IF X2.X THEN
  IF started AND a AND NOT a_before THEN c := LIMIT(-1, c + 1, 9); END_IF;
END_IF;
)");
    // The deactivation of step 3 meets the activation of step 1, which writes m.
    CHECK(chart.actions("x3") == "R lamp\nP0 horn := m_then;\nP1 m := a AND NOT b;\n");
    CHECK(chart.remarks(Kind::meeting_writes).empty());
}

TEST_CASE("SFC text: S and R only where nothing else writes, in one sequence, not at the start") {
    const auto actions = [](const std::string& changed) {
        return Read(
                   "input a, b\noutput lamp\ngraph G {\n  initial 1\n  step 2 : set lamp\n"
                   "  step 3\n  1 -> 2 : a\n  2 -> 3 : b\n  3 -> 1 : /a\n}\n" +
                   changed)
            .actions("x2");
    };
    CHECK(actions("") == "S lamp\n");
    for (const char* more :
         {"graph H { initial 5\n step 6 : reset lamp\n 5 -> 6 : b\n 6 -> 5 : a\n}\n",
          "graph H { initial 5 : reset lamp\n 5 -> 5 : b\n}\n",
          "graph H { initial 5 : lamp := a on deactivation\n 5 -> 5 : b\n}\n",
          "graph H { initial 5\n 5 -> 5 : b do reset lamp\n}\n",
          "graph H { initial 5 : G{3}\n 5 -> 5 : b\n}\n",
          "graph H { initial 5 : G{*}\n 5 -> 5 : b\n}\n",
          "graph H { initial 5 encloses G{1}\n 5 -> 5 : b\n}\n"}) {
        CAPTURE(more);
        CHECK(actions(more) == "P1 lamp := TRUE;\n");
    }
}

TEST_CASE("SFC text: D and L only for one delay of a step of a sequence") {
    const auto actions = [](const std::string& of_3, const std::string& link) {
        return Read(
                   "input a, b\noutput lamp\ngraph G {\n  initial 1\n  step 2 : lamp if 5s/X2\n"
                   "  step 3" +
                   of_3 + "\n  1 -> 2 : a\n  2 -> 3 : b\n  3 -> 1 : /a\n" + link + "}\n")
            .actions("x2");
    };
    CHECK(actions("", "") == "D 5s lamp\n");
    CHECK(actions(" : lamp", "") == "D 5s lamp\n");
    // Elsewhere the output is assigned by the step `observe`.
    CHECK(actions(" : lamp if 3s/X3", "") == "");
    CHECK(actions(" : lamp if a", "") == "");
    CHECK(actions("", "  2 -> 2 : a\n") == "");
    CHECK(actions("", "  1, 2 -> 3 : a\n") == "");
}

TEST_CASE("SFC text: source and sink transitions") {
    const Read chart("input a, b\ngraph G { initial 1\n (in) -> 1 : a\n (out) 1 -> : b\n}\n");
    const SfcPou& sfc = chart.written.sfc;
    REQUIRE(sfc.steps.size() == 3);
    CHECK(sfc.steps[1].name == "source_in");
    CHECK(sfc.steps[1].initial);
    CHECK(sfc.steps[2].name == "end_out");
    CHECK_FALSE(sfc.steps[2].initial);
    std::vector<std::size_t> following = sfc.transitions[0].following;
    std::sort(following.begin(), following.end());
    CHECK(sfc.transitions[0].preceding == std::vector<std::size_t>{1});
    CHECK(following == std::vector<std::size_t>{0, 1});
    CHECK(sfc.transitions[1].following == std::vector<std::size_t>{2});
    CHECK(chart.remarks(Kind::initial_steps) ==
          Texts{"graph G has 2 initial steps here; many tools ask for exactly one"});
}

TEST_CASE("SFC text: remarks on what SFC cannot say") {
    const Read chart(R"(
input a, b
var m
graph G {
  initial 1 : H{6}
  step 2 encloses K{7} : set m
  1 -> 2 : a do m := b
  2 -> 1 : b
}
graph H { initial 5 : reset m
  step 6 : set m on deactivation
  (x) 5 -> 6 : a
  (y) 5 -> 5 : b . /a
  (z) 5 -> 5 : b
  6 -> 5 : b }
graph K { step 7 }
)");
    CHECK(chart.remarks(Kind::order) == Texts{"step 1 gives the order H{6}"});
    CHECK(chart.remarks(Kind::enclosure) == Texts{"step 2 encloses K"});
    CHECK(chart.remarks(Kind::clearing) == Texts{"transition (0): m := b on clearing"});
    CHECK(chart.remarks(Kind::selection) ==
          Texts{"step 5: where several of the transitions (x), (y), (z) can be cleared at once, a "
                "GRAFCET clears them all (rule 4), SFC the leftmost"});
    CHECK(chart.remarks(Kind::meeting_writes) ==
          Texts{"m can be written by several actions in one scan (step 2 on activation; step 5 on "
                "activation; step 6 on deactivation): the last one wins, and SFC leaves their "
                "order open"});
    CHECK(chart.remarks(Kind::initial_steps).empty());
    CHECK(chart.remarks(Kind::scope).front().find("but for what SFC cannot say:") !=
          std::string::npos);
}

TEST_CASE("SFC text: a jump parts the bar below a transition from the bar above a step") {
    const Read chart(R"(
input a, b
output q
graph G {
  initial 1
  step 2 : q
  step 3
  1 -> 2 : a
  2 -> 1 : b
  1 -> 3 : b
  3 -> 2, 1 : a
}
)");
    CHECK_NOTHROW(sfc_as_text(chart.written.xml));
}

TEST_CASE("SFC text: no selection above a bar that joins steps") {
    const Read chart(R"(
input a, b, c
output q
graph G {
  initial 1
  initial 2
  step 3
  1 -> 3 : a
  1, 2 -> 3 : b
  3 -> 1 : c
  2 -> 1 : c
}
)");
    CHECK(sfc_as_text(chart.written.xml).find("TRANSITION FROM (X1, X2) TO X3") !=
          std::string::npos);
}

TEST_CASE("SFC text: steps that no initial one leads to follow a step of their own") {
    const Read chart(
        "input a\ngraph G {\n  initial 1\n  step 2 encloses K{7}\n  1 -> 2 : a\n}\n"
        "graph K {\n  step 7\n  step 8\n  7 -> 8 : a\n}\n");
    CHECK(sfc_as_text(chart.written.xml).find("TRANSITION FROM idle_K TO X7\n  := FALSE;") !=
          std::string::npos);
}

TEST_CASE("SFC text: what reads other steps stands below all of them") {
    const Read chart(R"(
input a
var m
counter c : 0..9
graph G {
  initial 1 : m := X2 on deactivation
  step 2 : c := c + 1 on a . X12, m := 0
  1 -> 2 : a . X11
  2 -> 1 : /a
}
graph H {
  initial 11
  step 12
  11 -> 12 : /X2
}
)");
    CHECK(chart.condition(0) == "a AND X11_then");
    CHECK(chart.actions("x1") == "");
    CHECK(chart.actions("x2") == "P1 m := FALSE;\n");
    CHECK(chart.note("X2") == "c: assigned by observe");
    CHECK(chart.actions("observe") == R"(N (* Stored actions that read the situation *)
IF NOT X1.X AND X1_then THEN m := X2.X; END_IF;
IF X2.X AND (a AND X12.X) THEN c := LIMIT(0, c + 1, 9); END_IF;
(* What the next scan compares with *)
X1_then := X1.X;
X2_then := X2.X;
X11_then := X11.X;
)");
}

TEST_CASE("SFC text: without modes Init is 0") {
    const Grafcet grafcet = Read::read("graph G {\n  initial 1\n  1 -> 1 : Init\n}\n");
    const std::string with = plcopen::write_sfc_project(grafcet);
    CHECK(with.find("<xhtml:p>Init</xhtml:p>") != std::string::npos);
    CHECK(with.find("<variable name=\"Init\">") != std::string::npos);
    const std::string without = plcopen::write_sfc_project(grafcet, {.modes = false});
    CHECK(without.find("<xhtml:p>FALSE</xhtml:p>") != std::string::npos);
    CHECK(without.find("<variable") == std::string::npos);
}

TEST_CASE("SFC text: transitions that evidently exclude each other are no matter of order") {
    const auto remarks = [](const std::string& first, const std::string& second) {
        return Read("input a, b, d\ncounter c : 0..5\ngraph G { initial 1 : c := 1\n 1 -> 1 : " +
                    first + "\n 1 -> 1 : " + second + "\n}\n")
            .remarks(Kind::selection)
            .size();
    };
    CHECK(remarks("a", "/a") == 0);
    CHECK(remarks("a . b", "d . (/a . b)") == 0);
    CHECK(remarks("[c < 3] . a", "[c >= 3]") == 0);
    CHECK(remarks("a . 0", "a") == 0);
    CHECK(remarks("a", "b") == 1);
    CHECK(remarks("a + b", "/a") == 1);
    CHECK(remarks("[c < 3]", "[c > 2]") == 1);
    CHECK(remarks("↑a", "/a") == 1);
}

TEST_CASE("SFC text: names of its own give way to the chart's") {
    const Read chart(R"(
input observe, started, dcy_before, timer0
graph G { initial 1
  1 -> 1 : ↑observe . 2s/started
}
)");
    CHECK(chart.condition(0) == "(started_2 AND observe AND NOT observe_before) AND n2s_started");
    CHECK(chart.actions("observe_2").find("timer0_2(IN := started, PT := T#2s);") !=
          std::string::npos);
}

TEST_CASE("SFC text: an integer type that holds every sum") {
    const auto type = [](const std::string& range, const std::string& sum) {
        const Read chart("input a\ncounter c : " + range + "\ngraph G { initial 1 : c := " + sum +
                         "\n 1 -> 1 : a\n}\n");
        const auto& variables = chart.written.sfc.variables;
        return std::find_if(variables.begin(), variables.end(),
                            [](const auto& variable) { return variable.name == "c"; })
            ->type;
    };
    CHECK(type("0..9", "c + 1") == "int");
    CHECK(type("0..9", "c + 32758") == "int");
    CHECK(type("0..9", "c + 32759") == "dint");
    CHECK(type("0..32768", "c") == "dint");
    CHECK(type("0..9", "c - 2147483648") == "dint");
    CHECK(type("0..9", "c - 2147483649") == "lint");
}

}  // namespace grafwire::testing
