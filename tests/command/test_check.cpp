// The verdicts of `check`, their bounds, and witnesses that replay.

#include <doctest/doctest.h>

#include "support/csv.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// Two steps that are each other's follower: in the successor form one resets the other.
const std::string two_step_loop = R"(grafcet loop
input a, b
output A
graph G {
  initial 0
  step 1 : A
  0 -> 1 : a
  1 -> 0 : b
}
)";

/// Checks, and replays the witness: reference and netlist end differently on its stimuli.
void check_replay(const std::string& chart, const std::string& style) {
    const ScratchFolder folder;
    const std::string place = folder.path("a/b");
    const Ran checked = grafwire_with({"check", chart, "--style", style, "--witness", place});
    CHECK(checked.status == 1);
    CHECK(checked.err.empty());
    CHECK(contains(checked.out, ": different (style " + style + ", "));
    const std::string stim = place + "/witness.stim";
    const Ran run = grafwire_with({"run", chart, stim});
    const Ran gates = grafwire_with({"simulate", chart, stim, "--style", style});
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    const auto expected = read_csv(run.out);
    const auto got = read_csv(gates.out);
    REQUIRE(expected.size() >= 2);
    CHECK(got.back() != expected.back());
    if (gates.status == 0) {
        // The same inputs at the same instants; something else came of them.
        CHECK(got.size() == expected.size());
        CHECK(got.back().front() == expected.back().front());
    } else {
        CHECK(gates.status == 1);
        CHECK(contains(gates.err, "does not settle"));
    }
    // The other files say the same.
    CHECK(text_of(place + "/expected.csv") == run.out);
    CHECK(text_of(place + "/got.csv") == gates.out);
    CHECK(contains(text_of(place + "/expected.vcd"), "$enddefinitions"));
    CHECK(contains(text_of(place + "/got.vcd"), "$enddefinitions"));
    CHECK(contains(text_of(place + "/witness.txt"), "The reference:"));
    // The story of the report stands in it, stimuli included.
    CHECK(contains(checked.out, "Witness:\n"));
}

}  // namespace

TEST_CASE("equivalent is status 0, with what was covered") {
    const Ran ran = grafwire_with({"check", example("single-sequence.grafcet"), "--style", "nand"});
    CHECK(ran.status == 0);
    CHECK(ran.err.empty());
    CHECK(contains(ran.out, ": equivalent (style nand, CDX successor)\n"));
    CHECK(contains(ran.out, " stable situations, "));
    // With m, a and b all at 1 the token goes round for ever.
    CHECK(contains(ran.out, "the GRAFCET itself has no stable situation here"));
}

TEST_CASE("nand is the style where none is asked for") {
    const std::string chart = example("rule-5.grafcet");
    CHECK(grafwire_with({"check", chart}).out ==
          grafwire_with({"check", chart, "--style", "nand"}).out);
}

TEST_CASE("rule 5 holds in latches of NAND gates and not in those of NOR gates") {
    CHECK(grafwire_with({"check", example("rule-5.grafcet"), "--style", "nand"}).status == 0);
    check_replay(example("rule-5.grafcet"), "nor");
}

TEST_CASE("a loop of two steps is not sound in the successor form") {
    const ScratchFolder folder;
    check_replay(folder.file("loop.grafcet", two_step_loop), "gates");
    check_replay(folder.file("loop.grafcet", two_step_loop), "nor");
    CHECK(grafwire_with({"check", folder.path("loop.grafcet"), "--style", "clocked"}).status == 0);
}

TEST_CASE("the loops of the positioning axis are not sound in gates") {
    check_replay(example("positioning-axis.grafcet"), "gates");
}

TEST_CASE("two tokens side by side: the one behind is lost in the successor form") {
    const ScratchFolder folder;
    check_replay(folder.file("tokens.grafcet",
                             "input a, b\ngraph G {\n  initial 1\n  initial 2\n  step 3\n"
                             "  1 -> 2 : a\n  2 -> 3 : b\n}\n"),
                 "nand");
}

TEST_CASE("an equivalent netlist leaves no witness") {
    const ScratchFolder folder;
    CHECK(grafwire_with({"check", example("rule-5.grafcet"), "--style", "nand", "--witness",
                         folder.path("w")})
              .status == 0);
    CHECK(folder.names().empty());
}

TEST_CASE("out of bounds is status 3, and says what is left") {
    const std::string chart = example("nine-steps.grafcet");
    const Ran cases = grafwire_with({"check", chart, "--style", "nand", "--max-cases", "100"});
    CHECK(cases.status == 3);
    CHECK(cases.err.empty());
    CHECK(contains(cases.out, ": undecided (style nand, "));
    CHECK(contains(cases.out, " 100 cases compared"));
    CHECK(contains(cases.out, "exploration incomplete within the bounds given: "));
    // More than there are is no bound.
    CHECK(grafwire_with({"check", chart, "--style", "nand", "--max-cases", "10000000"}).status ==
          0);
    // A difference within the bounds is one.
    CHECK(grafwire_with(
              {"check", example("rule-5.grafcet"), "--style", "nor", "--max-cases", "10000000"})
              .status == 1);
    const Ran time = grafwire_with({"check", example("level-crossing.grafcet"), "--style",
                                    "clocked", "--max-seconds", "0.001"});
    CHECK(time.status == 3);
}

TEST_CASE("verdict, witness and counts do not depend on how many cores share the work") {
    const std::vector<std::vector<std::string>> requests = {
        {example("nine-steps.grafcet"), "--style", "nand"},
        {example("positioning-axis.grafcet"), "--style", "gates"},
        {example("manipulator.grafcet"), "--style", "gates", "--changes", "many"},
        {example("selection-convergence.grafcet"), "--style", "gates", "--delay", "1..2"},
        {example("single-sequence.grafcet"), "--style", "nand", "--delay", "any"},
        {example("manipulator.grafcet"), "--style", "nand", "--max-cases", "100"},
        {example("level-crossing.grafcet"), "--style", "clocked", "--max-cases", "2000"},
        {example("manipulator.grafcet"), "--against", example("s7-200/manipulator.printed.awl"),
         "--io", example("s7-200/manipulator.io")}};
    for (std::vector<std::string> request : requests) {
        CAPTURE(request.front());
        request.insert(request.begin(), "check");
        for (const char* form : {"text", "json"}) {
            std::vector<Ran> answers;
            for (const char* jobs : {"1", "2", "5"}) {
                std::vector<std::string> words = request;
                words.insert(words.end(), {"--to", form, "-j", jobs});
                answers.push_back(grafwire_with(words));
            }
            CHECK(answers[0].status != 2);
            for (const Ran& answer : answers) {
                CHECK(answer.status == answers[0].status);
                CHECK(answer.out == answers[0].out);
            }
        }
    }
}

TEST_CASE("--assume leaves out what the plant never does") {
    const ScratchFolder folder;
    const std::string loop = folder.file("loop.grafcet", two_step_loop);
    const std::string chart = example("single-sequence.grafcet");
    const auto checked = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "check");
        return grafwire_with(arguments);
    };
    // The remark on the instant without a stable situation goes with the instant.
    const Ran assumed = checked({chart, "--style", "nand", "--assume", "/(m . a . b)"});
    CHECK(assumed.status == 0);
    CHECK(contains(assumed.out, " 0 without a stable situation"));
    CHECK(!contains(assumed.out, "the GRAFCET itself"));
    CHECK(checked({chart, "--style", "nand", "--assume", "/m + /a", "--assume", "/b"}).status == 0);
    // One that makes the difference, and one on top of the file's own.
    CHECK(checked({loop, "--style", "gates"}).status == 1);
    CHECK(checked({loop, "--style", "gates", "--assume", "/a"}).status == 0);
    std::string own = two_step_loop;
    own.insert(own.find("graph"), "assume /(a . b)\n");
    const std::string own_file = folder.file("own.grafcet", own);
    const Ran of_file = checked({own_file, "--style", "clocked"});
    const Ran of_option = checked({loop, "--style", "clocked", "--assume", "/(a . b)"});
    CHECK(contains(of_file.out, "; assumptions: /(a.b); "));
    CHECK(of_file.out.substr(own_file.size()) == of_option.out.substr(loop.size()));
    // What is no condition on the plant is refused.
    for (const std::string wrong : {"foo", "X0", "↑m", "m .", "2s/m"}) {
        INFO("assumption: " << wrong);
        const Ran ran = checked({chart, "--assume", wrong});
        CHECK(ran.status == 2);
        CHECK(ran.out.empty());
        CHECK(contains(ran.err, "--assume:1:"));
    }
}

TEST_CASE("a GRAFCET from standard input") {
    const Ran ran = grafwire_with({"check", "-", "--style", "gates"}, two_step_loop);
    CHECK(ran.status == 1);
    CHECK(contains(ran.out, ": different ("));
}

TEST_CASE("--modes off and the transition form are checked as well") {
    const std::string chart = example("single-sequence.grafcet");
    const Ran off = grafwire_with({"check", chart, "--style", "nand", "--modes", "off"});
    CHECK(off.status == 0);
    CHECK(!contains(off.out, "Init"));
    const Ran form = grafwire_with({"check", chart, "--style", "nand", "--cdx", "transition"});
    CHECK((form.status == 0 || form.status == 1));
    CHECK(contains(form.out, "CDX transition"));
}

}  // namespace grafwire::testing
