// Runs in words: each rule, each kind of order, and what the end of an instant says.

#include <doctest/doctest.h>

#include "grafcet/shown_transition.h"
#include "random/read_text.h"
#include "story/instant_causes.h"
#include "story/instant_story.h"
#include "story/write_story.h"

namespace grafwire::testing {

namespace {

std::string told(const std::string& chart, const std::string& stimuli,
                 std::optional<Time> period = std::nullopt, Language language = Language::english) {
    std::string messages;
    const auto grafcet = read_grafcet(chart, &messages);
    INFO(messages);
    REQUIRE(grafcet);
    const auto read = read_stimuli(stimuli, *grafcet, &messages);
    REQUIRE(read);
    return write_stories(*grafcet, tell_run(*grafcet, *read, period).stories, language);
}

const std::string lamp = R"(
input a, b
output L
graph G {
  initial 0
  step 1 : L
  0 -> 1 : a./b
  1 -> 0 : 50ms/X1
})";

}  // namespace

TEST_CASE("transitions with the steps before and behind them, of sources and sinks too") {
    const auto grafcet = read_grafcet(
        "input a\ngraph G {\n  initial 0\n  step 1\n  (7) 0 -> 1 : a\n  (8) -> 0 : a\n"
        "  (9) 1 -> : a\n  (10) 0, 1 -> 0, 1 : a\n}");
    REQUIRE(grafcet);
    std::string texts;
    for (std::size_t i = 0; i < grafcet->transitions.size(); ++i) {
        texts += shown_transition(*grafcet, grafcet->transitions.id_at(i)) + '|';
    }
    CHECK(texts == "(7) 0 -> 1|(8) -> 0|(9) 1 ->|(10) 0, 1 -> 0, 1|");
}

TEST_CASE("rules 1 to 3, a delay, and what an enabled transition waits for") {
    CHECK(told(lamp, "10ms : a=1\n20ms : a=0\n") == R"(At 0 ms: all inputs are 0
  initial situation: X0 (rule 1)
  stable situation: X0
  outputs at 1: none
  enabled: (0) 0 -> 1, waits for a./b (a=0 b=0)

At 10 ms: a=1
  (0) 0 -> 1 is cleared (rule 2): X0 is active and a./b is 1 (a=1 b=0)
  deactivated: X0; activated: X1 (rule 3)
  the delay of 50ms/X1 begins, until 60 ms
  stable situation: X1
  outputs at 1: L
  enabled: (1) 1 -> 0, waits for 50ms/X1 (50ms/X1=0 until 60 ms)

At 20 ms: a=0
  stable situation: X1
  outputs at 1: L
  enabled: (1) 1 -> 0, waits for 50ms/X1 (50ms/X1=0 until 60 ms)
)");
}

TEST_CASE("the end of a delay, in French, and an instant at which nothing changes") {
    const std::string text =
        told(lamp, "0s : a=1\n55ms : a=0\n70ms : end\n", std::nullopt, Language::french);
    CHECK(text.substr(text.find("À 50")) == R"(À 50 ms : la temporisation 50ms/X1 est écoulée
  évolution 1 :
    (1) 1 -> 0 est franchie (règle 2) : X1 est active et 50ms/X1 vaut 1
    désactivation : X1 ; activation : X0 (règle 3)
    50ms/X1 passe à 0
  évolution 2 :
    (0) 0 -> 1 est franchie (règle 2) : X0 est active et a./b vaut 1 (a=1 b=0)
    désactivation : X0 ; activation : X1 (règle 3)
    la temporisation 50ms/X1 commence, jusqu'à 100 ms
  situation stable : X1
  sorties à 1 : L
  validée : (1) 1 -> 0, attend 50ms/X1 (50ms/X1=0 jusqu'à 100 ms)

À 55 ms : a=0
  situation stable : X1
  sorties à 1 : L
  validée : (1) 1 -> 0, attend 50ms/X1 (50ms/X1=0 jusqu'à 100 ms)

À 70 ms : rien ne change
)");
}

TEST_CASE("rules 4 and 5: at once, and still active") {
    const std::string text = told(R"(
input s
graph G {
  initial 1
  -> 1 : s
  1 -> 2 : s
  step 2
})",
                                  "10ms : s=1\n");
    CHECK(text.substr(text.find("At 10")) == R"(At 10 ms: s=1
  evolution 1:
    (0) -> 1 is cleared (rule 2): no step precedes it and s is 1
    (1) 1 -> 2 is cleared (rule 2): X1 is active and s is 1
    cleared together: (0), (1) (rule 4)
    activated: X2 (rule 3)
    deactivated and activated at once, so still active: X1 (rule 5)
  evolution 2:
    (0) -> 1 is cleared (rule 2): no step precedes it and s is 1
    (1) 1 -> 2 is cleared (rule 2): X1 is active and s is 1
    cleared together: (0), (1) (rule 4)
    deactivated and activated at once, so still active: X1 (rule 5)
  stable situation: X1, X2
  clearable, without effect: (0) -> 1, since s is 1
  clearable, without effect: (1) 1 -> 2, since s is 1
)");
}

TEST_CASE("scan by scan: scans that change nothing are one line") {
    CHECK(told(lamp, "20ms : a=1\n41ms : end\n", 10 * millisecond) == R"(At 0 ms: all inputs are 0
  initial situation: X0 (rule 1)
  situation: X0
  outputs at 1: none
  enabled: (0) 0 -> 1, waits for a./b (a=0 b=0)

At 10 ms: nothing changes

At 20 ms: a=1
  (0) 0 -> 1 is cleared (rule 2): X0 is active and a./b is 1 (a=1 b=0)
  deactivated: X0; activated: X1 (rule 3)
  the delay of 50ms/X1 begins, until 70 ms
  situation: X1
  outputs at 1: L
  enabled: (1) 1 -> 0, waits for 50ms/X1 (50ms/X1=0 until 70 ms)

From 30 ms to 40 ms: nothing changes (2 scans)
)");
}

TEST_CASE("forcing, freezing, an enclosure, stored actions") {
    const std::string chart = R"(
input a, b
output V
var v
counter n : 0..3
graph Top {
  initial 0
  step 1 : Work{11}
  step 2 : Work{*}, set V on deactivation
  step 3 encloses Inner{20}
  0 -> 1 : ↑a do n := n + 1
  1 -> 2 : b
  2 -> 3 : ↑a
  3 -> 0 : ↑a
}
graph Work {
  initial 10
  step 11 : v := b
  10 -> 11 : 0
  11 -> 10 : b
}
graph Inner {
  step 20
  step 21
  20 -> 21 : 0
})";
    const std::string text =
        told(chart, "10ms : a=1\n20ms : a=0\n30ms : b=1\n40ms : a=1\n50ms : a=0\n60ms : a=1\n");
    const auto part = [&](const std::string& from, const std::string& to) {
        const std::size_t begin = text.find(from);
        const std::size_t end = to.empty() ? text.size() : text.find(to);
        return begin >= end || end == std::string::npos ? text : text.substr(begin, end - begin);
    };
    CHECK(part("At 10 ", "At 20 ") == R"(At 10 ms: a=1
  (0) 0 -> 1 is cleared (rule 2): X0 is active and ↑a is 1
  (4) 10 -> 11 is not cleared: its condition is 0
  deactivated: X0; activated: X1 (rule 3)
  X1 forces Work{11}; deactivated: X10; activated: X11
  stored action on clearing of (0): n := n + 1, gives n=1
  stored action on activation of X11: v := b, gives v=0
  stable situation: X1, X11
  outputs at 1: none
  vars at 1: none
  counters: n=1
  orders in force: Work{11} (X1)
  enabled: (1) 1 -> 2, waits for b
  enabled: (5) 11 -> 10, waits for b

)");
    CHECK(part("At 30 ", "At 40 ") == R"(At 30 ms: b=1
  (1) 1 -> 2 is cleared (rule 2): X1 is active and b is 1
  (5) 11 -> 10 is cleared (rule 2): X11 is active and b is 1
  cleared together: (1), (5) (rule 4)
  deactivated: X1, X11; activated: X2, X10 (rule 3)
  X2 freezes Work
  stable situation: X2, X10
  outputs at 1: none
  vars at 1: none
  counters: n=1
  orders in force: Work{*} (X2)
  enabled: (2) 2 -> 3, waits for ↑a (↑a=0 a=0)
  enabled: (4) 10 -> 11, but Work is frozen

)");
    CHECK(part("At 40 ", "At 50 ") == R"(At 40 ms: a=1
  (2) 2 -> 3 is cleared (rule 2): X2 is active and ↑a is 1
  deactivated: X2; activated: X3 (rule 3)
  X3 has become active and opens Inner, which it encloses; activated: X20
  stored action on deactivation of X2: set V, gives V=1
  stable situation: X3, X10, X20
  outputs at 1: V
  vars at 1: none
  counters: n=1
  enabled: (3) 3 -> 0, waits for ↑a (↑a=0 a=1)
  enabled: (4) 10 -> 11, waits for its condition
  enabled: (6) 20 -> 21, waits for its condition

)");
    CHECK(part("At 60 ", "") == R"(At 60 ms: a=1
  (3) 3 -> 0 is cleared (rule 2): X3 is active and ↑a is 1
  (6) 20 -> 21 is not cleared: its condition is 0
  deactivated: X3; activated: X0 (rule 3)
  X3 is not active, so Inner, which it encloses, is emptied; deactivated: X20
  stable situation: X0, X10
  outputs at 1: V
  vars at 1: none
  counters: n=1
  enabled: (0) 0 -> 1, waits for ↑a (↑a=0 a=1)
  enabled: (4) 10 -> 11, waits for its condition
)");
}

TEST_CASE("Init, AUdur and AUdoux") {
    const std::string text = told(lamp,
                                  "0s : a=1\n10ms : AUdoux=1\n20ms : AUdoux=0 AUdur=1\n"
                                  "30ms : AUdur=0 Init=1\n");
    CHECK(text.substr(text.find("At 10")) == R"(At 10 ms: AUdoux=1
  stable situation: X1
  outputs at 1: none
  AUdoux=1: continuous outputs are 0
  enabled: (1) 1 -> 0, waits for 50ms/X1 (50ms/X1=0 until 50 ms)

At 20 ms: AUdur=1 AUdoux=0
  (1) 1 -> 0 is not cleared: 50ms/X1 is 0 (50ms/X1=0 until 50 ms)
  AUdur=1: every step is deactivated; deactivated: X1
  the delay of 50ms/X1 is broken off
  stable situation: no step
  outputs at 1: none
  no transition is enabled

At 30 ms: Init=1 AUdur=0
  Init=1: nothing is cleared, the initial situation is set; activated: X0
  stable situation: X0
  outputs at 1: none
  enabled: (0) 0 -> 1, but Init=1
)");
}

TEST_CASE("no stable situation: the first scans, and what keeps changing") {
    const std::string text = told(R"(
input a
graph G {
  initial 0
  step 1
  0 -> 1 : a
  1 -> 0 : a
})",
                                  "5ms : a=1\n9ms : end\n");
    const std::string end = text.substr(text.find("At 5"));
    CHECK(end.substr(0, end.find("  evolution 2")) == R"(At 5 ms: a=1
  evolution 1:
    (0) 0 -> 1 is cleared (rule 2): X0 is active and a is 1
    deactivated: X0; activated: X1 (rule 3)
)");
    CHECK(end.substr(end.rfind("  no")) == "  no stable situation: X0, X1 keep changing\n");
}

TEST_CASE("an instant of very many scans shows the first") {
    const std::string text = told(R"(
counter n : 0..1000
graph G {
  initial 0
  step 1 : n := n + 1
  0 -> 1 : [n < 1000]
  1 -> 0 : 1
})",
                                  "0s : end\n");
    CHECK(text.find("evolution 20:") != std::string::npos);
    CHECK(text.find("evolution 21:") == std::string::npos);
    CHECK(text.substr(text.find("  … and")) == R"(  … and 1981 more evolutions
  stable situation: X0
  counters: n=1000
  enabled: (0) 0 -> 1, waits for [n < 1000] (n=1000)
)");
}

TEST_CASE("causes: what was read by what happened, and nothing else that changed") {
    const auto grafcet = read_grafcet(R"(
input a, b, c, d
output L, M
graph G {
  initial 0 : M if d
  step 1 : L
  0 -> 1 : a + /b
  1 -> 0 : 2s/X1.c
})");
    REQUIRE(grafcet);
    const auto stimuli = read_stimuli(
        "0ms : b=1 c=1\n100ms : a=1 d=1\n200ms : a=0 c=0\n2200ms : c=1\n2300ms : d=0\n"
        "2400ms : Init=1 d=1 b=0\n3s : end\n",
        *grafcet);
    REQUIRE(stimuli);
    std::string found;
    for (const InstantCauses& causes :
         causes_in(*grafcet, tell_run(*grafcet, *stimuli, std::nullopt).stories)) {
        found += format_milliseconds(causes.at) + ":";
        for (const std::size_t input : causes.inputs) {
            found += ' ' + std::string(input_name(*grafcet, input));
        }
        for (const std::string& ended : causes.ended) found += ' ' + ended;
        found += '\n';
    }
    // At 2100 ms a delay ends without effect: c is 0.
    CHECK(found == "100: a\n2200: c\n2300: d\n2400: d\n");
}

}  // namespace grafwire::testing
