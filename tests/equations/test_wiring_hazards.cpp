// What the structure of a chart puts at risk in wiring, and that good charts are left alone.

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "equations/concurrent_steps.h"
#include "equations/messages.h"
#include "equations/wiring_hazards.h"
#include "parsed.h"

namespace grafwire::testing {

namespace {

std::string warnings(std::string_view text, CdxForm cdx = CdxForm::successor) {
    const Grafcet grafcet = parsed(text);
    Diagnostics diagnostics;
    warn_of_wiring(grafcet, cdx, diagnostics);
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics.items()) {
        CHECK(diagnostic.severity == Severity::warning);
        CHECK(diagnostic.code == code::wiring_hazard);
        all += diagnostic.message.english.substr(0, diagnostic.message.english.find(':')) + "\n";
    }
    return all;
}

/// The pairs of steps that are active together in any situation that clearing one transition after
/// the other reaches (receptivities apart).
std::set<std::pair<std::size_t, std::size_t>> pairs_reached(const Grafcet& grafcet) {
    using Situation = std::set<StepId>;
    Situation start;
    for (std::size_t i = 0; i < grafcet.steps.size(); ++i) {
        if (grafcet.steps.items()[i].initial) start.insert(grafcet.steps.id_at(i));
    }
    std::set<Situation> seen{start};
    std::vector<Situation> open{start};
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    while (!open.empty()) {
        const Situation situation = open.back();
        open.pop_back();
        for (const StepId a : situation) {
            for (const StepId b : situation) {
                if (a < b) pairs.emplace(index_of(a), index_of(b));
            }
        }
        for (const Transition& transition : grafcet.transitions) {
            Situation next = situation;
            bool is_enabled = true;
            for (const StepId step : grafcet.preceding(transition)) {
                is_enabled &= situation.contains(step);
                next.erase(step);
            }
            if (!is_enabled) continue;
            for (const StepId step : grafcet.following(transition)) next.insert(step);
            if (seen.insert(next).second) open.push_back(next);
        }
    }
    return pairs;
}

const std::string parallels = R"(
input a, b, c, d
graph G {
  initial 1
  step 2 step 3 step 4 step 5 step 6 step 7 step 8
  1 -> 2, 3 : a
  2 -> 4, 5 : b
  4 -> 6 : c
  5, 6 -> 7 : d
  3 -> 8 : c
  7, 8 -> 1 : a
})";

}  // namespace

TEST_CASE("sequences, selections and parallels that are well formed have no warning") {
    CHECK(warnings(R"(
input a, b, c
graph G { initial 0 step 1 step 2 step 3
  0 -> 1 : a
  0 -> 2 : b
  1 -> 3 : c
  2 -> 3 : c
  3 -> 0 : a })")
              .empty());
    CHECK(warnings(parallels).empty());
    // Two graphs side by side, and two sequences in one graph.
    CHECK(warnings(R"(
input a, b
graph G { initial 0 step 1 step 2
  0 -> 1 : a  1 -> 2 : b  2 -> 0 : a }
graph H { initial 10 initial 20 step 11 step 12 step 21 step 22
  10 -> 11 : a  11 -> 12 : b  12 -> 10 : a
  20 -> 21 : a  21 -> 22 : b  22 -> 20 : a })")
              .empty());
}

TEST_CASE("a loop of two steps, either way round once") {
    const std::string loop = R"(
input a, b, c
graph G { initial 0 step 1 step 2
  0 -> 1 : a
  1 -> 0 : b
  1 -> 2 : c
  2 -> 0 : a })";
    CHECK(warnings(loop) == "steps 0 and 1 follow each other\n");
    CHECK(warnings(loop, CdxForm::transition).empty());
    // A parallel of single steps is one as well: 0 is set by the very steps that reset it.
    CHECK(warnings(R"(
input a, b
graph G { initial 0 step 1 step 2
  0 -> 1, 2 : a
  1, 2 -> 0 : b })") == "steps 0 and 1, 2 follow each other\n");
    // With a further step in one branch it is none.
    CHECK(warnings(R"(
input a, b, c
graph G { initial 0 step 1 step 2 step 3
  0 -> 1, 2 : a
  2 -> 3 : c
  1, 3 -> 0 : b })")
              .empty());
}

TEST_CASE("a step that follows itself") {
    CHECK(warnings("input a graph G { initial 0 0 -> 0 : a }") == "step 0 follows itself\n");
}

TEST_CASE("two tokens side by side") {
    const std::string two = R"(
input a, b, c
graph G { initial 1 initial 2 step 3 step 4
  1 -> 2 : a
  2 -> 3 : b
  3 -> 4 : c
  4 -> 1 : b })";
    CHECK(warnings(two) == R"(steps 1 and 2 can be active together
steps 2 and 3 can be active together
steps 3 and 4 can be active together
steps 4 and 1 can be active together
)");
    CHECK(warnings(two, CdxForm::transition).empty());
    // A source feeds a sequence as often as it likes.
    CHECK(warnings(R"(
input a, b, c
graph G { step 1 step 2
  -> 1 : a
  1 -> 2 : b
  2 -> : c })") == "steps 1 and 2 can be active together\n");
    // A branch that runs into the other one.
    CHECK(warnings(R"(
input a, b, c
graph G { initial 1 step 2 step 3 step 4
  1 -> 2, 3 : a
  2 -> 3 : b
  3 -> 4 : c
  4 -> 1 : a })")
              .find("steps 2 and 3 can be active together\n") != std::string::npos);
    // A forcing order sets both.
    CHECK(warnings(R"(
input a, b, c
graph G { initial 1 step 2 step 3
  1 -> 2 : a
  2 -> 3 : b
  3 -> 1 : c }
graph F { initial 10 step 11 : G{1, 2} step 12
  10 -> 11 : a
  11 -> 12 : b
  12 -> 10 : c })")
              .find("steps 1 and 2 can be active together\n") == 0);
    // A transition that is never cleared leads nowhere.
    CHECK(warnings(R"(
input a, b, c
graph G { initial 1 step 2 step 3 step 4
  1 -> 2 : a
  1 -> 2, 3 : =0
  2 -> 3 : b
  3 -> 4 : c
  4 -> 1 : b })")
              .empty());
}

TEST_CASE("an edge that is read twice in succession") {
    const auto twice = [](const std::string& once, const std::string& again) {
        return warnings("input a, b\nvar v\ngraph G { initial 0 step 1 step 2\n  0 -> 1 : " + once +
                            "\n  1 -> 2 : " + again + "\n  2 -> 0 : b }",
                        CdxForm::transition);
    };
    const std::string warned = "↑a is read again right after step 1 was activated by it\n";
    CHECK(twice("↑a", "↑a") == warned);
    CHECK(twice("↑a.b", "↑a + b").empty());  // cleared by b, with the edge or without it
    CHECK(twice("↑a", "↑a + b") == warned);
    CHECK(twice("↑a.b", "↑a./b").empty());
    CHECK(twice("↑a", "↓a").empty());
    CHECK(twice("↑a", "↑b").empty());
    CHECK(twice("↑a", "a").empty());
    CHECK(twice("↑a", "↑a./a").empty());  // the edge leaves a at 1
    CHECK(twice("↑(a.b)", "↑(a.b)./b").empty());
    CHECK(twice("↑a./v", "↑a.v") == warned);  // v may change in between
}

TEST_CASE("the relation of concurrency is that of the situations reached") {
    for (const std::string& text : {parallels, std::string(R"(
input a
graph G { initial 1 initial 9 step 2 step 3 step 4
  1, 9 -> 2 : a  2 -> 3, 9 : a  3 -> 4 : a  4 -> 1 : a })"),
                                    std::string(R"(
input a
graph G { initial 1 step 2 step 3 step 4 step 5 step 6
  1 -> 2, 3 : a  2 -> 4 : a  2 -> 5 : a  4 -> 6 : a  5 -> 6 : a  6, 3 -> 1 : a })")}) {
        const Grafcet grafcet = parsed(text);
        const ConcurrentSteps concurrent(grafcet);
        CHECK(concurrent.is_complete());
        const auto pairs = pairs_reached(grafcet);
        for (std::size_t a = 0; a < grafcet.steps.size(); ++a) {
            for (std::size_t b = a + 1; b < grafcet.steps.size(); ++b) {
                CHECK(concurrent.are_concurrent(grafcet.steps.id_at(a), grafcet.steps.id_at(b)) ==
                      pairs.contains({a, b}));
            }
        }
    }
}

TEST_CASE("where too many pairs are found the search ends, and says nothing wrong") {
    const Grafcet grafcet = parsed(parallels);
    const ConcurrentSteps concurrent(grafcet, 2);
    CHECK_FALSE(concurrent.is_complete());
}

TEST_CASE("the warnings of every example") {
    std::map<std::string, std::string> found;
    const std::string folder = std::string(GRAFWIRE_ROOT) + "/examples";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".grafcet") continue;
        std::ifstream file(entry.path());
        std::ostringstream text;
        text << file.rdbuf();
        const std::string told = warnings(text.str());
        if (!told.empty()) found[entry.path().stem().string()] = told;
    }
    const std::map<std::string, std::string> expected{
        {"batch-counter", "steps 2 and 3 follow each other\n"},
        {"level-crossing",
         "step 0 follows itself\nstep 0 follows itself\n"
         "↑approach is read again right after step 0 was activated by it\n"
         "↑leave is read again right after step 0 was activated by it\n"},
        {"manipulator-modes",
         "steps 30 and 31 follow each other\nsteps 30 and 32 follow each other\n"},
        {"positioning-axis", "steps 0 and 3 follow each other\n"},
        {"rule-5", "steps 1 and 2 can be active together\n"}};
    CHECK(found == expected);
}

}  // namespace grafwire::testing
