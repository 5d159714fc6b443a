// A session step by step: what each line does, what is refused, and that a saved session is a run.

#include <doctest/doctest.h>

#include "evolution/run.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "story/session.h"

namespace grafwire::testing {

namespace {

const std::string chart = R"(
input a, "b c", scan
output L
graph G {
  initial 0
  step 1 : L
  step 2
  step 3
  0 -> 1 : a
  1 -> 0 : 50ms/X1
  0 -> 2 : scan
  2 -> 3 : 1
  3 -> 2 : 1
})";

/// A session whose lines must be obeyed, or refused.
class Typed {
  public:
    explicit Typed(std::optional<Time> period = std::nullopt, Language language = Language::english)
        : grafcet_(*read_grafcet(chart)), session_(grafcet_, period, language) {}

    std::string obeyed(const std::string& line) {
        const SessionReply reply = session_.answer(line);
        INFO(line << ": " << reply.text);
        CHECK(!reply.is_refusal);
        return reply.text;
    }
    std::string refused(const std::string& line) {
        const std::string before = session_.answer("show").text;
        const SessionReply reply = session_.answer(line);
        INFO(line);
        CHECK(reply.is_refusal);
        CHECK(session_.answer("show").text == before);
        return reply.text;
    }
    std::string saved() {
        const SessionReply reply = session_.answer("save x.stim");
        CHECK(reply.save_path == "x.stim");
        return reply.save_stimuli;
    }
    Session& session() { return session_; }

  private:
    Grafcet grafcet_;
    Session session_;
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("until stable: inputs, time, the end of a delay, and the way back") {
    Typed typed;
    CHECK(typed.obeyed("show") == "Not begun: all inputs are 0.\n");
    CHECK(has(typed.obeyed("\"b c\"=1"), "At 0 ms: \"b c\"=1\n  initial situation: X0 (rule 1)\n"));
    CHECK(has(typed.obeyed("a=1 # a comment"), "At 1 ms: a=1\n  (0) 0 -> 1 is cleared"));
    CHECK(typed.session().prompt() == "1 ms> ");
    CHECK(has(typed.obeyed("+10ms a=0"), "At 11 ms: a=0\n  stable situation: X1\n"));
    CHECK(has(typed.obeyed("scan"), "At 51 ms: the delay of 50ms/X1 is over\n"));
    CHECK(has(typed.refused("scan"), "no delay is running"));
    CHECK(typed.saved() == "0s : \"b c\"=1\n1ms : a=1\n11ms : a=0\n51ms : end\n");
    CHECK(has(typed.obeyed("back"), "At 11 ms; inputs at 1: b c\n  stable situation: X1\n"));
    const std::string way = typed.obeyed("+1s");
    CHECK(has(way, "At 51 ms: the delay"));
    CHECK(has(way, "\n\nAt 1011 ms: nothing changes\n"));
    CHECK(has(typed.obeyed("2s : a=1"), "At 2000 ms: a=1\n"));
    for (int i = 0; i < 5; ++i) typed.obeyed("back");
    CHECK(typed.refused("back") == "there is nothing to take back\n");
    CHECK(typed.saved() == "0s : end\n");
}

TEST_CASE("scan by scan") {
    Typed typed(10 * millisecond);
    CHECK(typed.obeyed("a=1") == "The scan at 0 ms will read the inputs.\n");
    CHECK(
        has(typed.obeyed("scan"), "At 0 ms: a=1\n  initial situation: X0 (rule 1)\n  (0) 0 -> 1"));
    CHECK(typed.obeyed("a=0") == "The scan at 10 ms will read the inputs.\n");
    CHECK(typed.saved() == "0s : a=1\n10ms : a=0\n10ms : end\n");
    CHECK(has(typed.obeyed("+25ms a=1"), "At 10 ms: a=0\n"));
    CHECK(typed.session().prompt() == "25 ms> ");
    CHECK(has(typed.obeyed("scan"), "At 30 ms: a=1\n"));
    CHECK(typed.saved() == "0s : a=1\n10ms : a=0\n30ms : a=1\n30ms : end\n");
    CHECK(has(typed.obeyed("+1h"), "a long way: stopped at 1000030 ms\n"));
}

TEST_CASE("lines that are refused change nothing") {
    Typed typed;
    typed.obeyed("a=0");
    CHECK(has(typed.refused("c=1"), "'c' is not an input"));
    CHECK(has(typed.refused("a=2"), "'2'"));
    CHECK(has(typed.refused("+5"), "'5'"));
    CHECK(typed.refused("0ms a=1") == "the instant 0 ms is over: give a later time\n");
    CHECK(has(typed.refused("go"), "'go' is none of a=1, +500ms, scan, "));
    CHECK(has(typed.refused("save"), "save FILE.stim"));
    CHECK(has(typed.refused("back 2"), "nothing may follow here: '2'"));
    CHECK(has(typed.refused("retour"), "'retour' is none of"));
    CHECK(typed.obeyed("") == "");
    CHECK(typed.obeyed("# nothing") == "");
}

TEST_CASE("an input that is called like a command; no way on without a stable situation") {
    Typed typed;
    typed.obeyed("a=0");
    const std::string text = typed.obeyed("scan=1");
    CHECK(has(text, "  no stable situation: X2, X3 keep changing\n"));
    CHECK(typed.refused("a=1") == "there is no stable situation to go on from: go back\n");
    CHECK(has(typed.refused("+1s"), "no stable situation"));
    CHECK(typed.saved() == "0s :\n1ms : scan=1\n1ms : end\n");
    CHECK(has(typed.obeyed("back"), "At 0 ms; inputs at 1: none\n"));
    typed.obeyed("a=1");
}

TEST_CASE("inputs that break an assumption are obeyed with a warning") {
    const auto grafcet = read_grafcet(
        "input a, b\nassume /(a . b)\ngraph G {\n  initial 0\n  step 1\n  0 -> 1 : a\n}");
    REQUIRE(grafcet);
    const std::string warning = "These inputs break what the GRAFCET assumes: /(a.b)\n";
    Session session(*grafcet, std::nullopt, Language::english);
    CHECK(!has(session.answer("a=1").text, "assumes"));
    CHECK(session.answer("b=1").text.ends_with(warning));
    CHECK(!has(session.answer("+1s").text, "assumes"));
    CHECK(!has(session.answer("b=0").text, "assumes"));
    Session scans(*grafcet, 10 * millisecond, Language::french);
    CHECK(scans.answer("a=1 b=1").text ==
          "Ces entrées contredisent ce que le GRAFCET suppose\u00a0: /(a.b)\n"
          "La scrutation à 0\u00a0ms lira les entrées.\n");
    CHECK(!has(scans.answer("scan").text, "suppose"));
}

TEST_CASE("in French, English words are taken as well") {
    Typed typed(std::nullopt, Language::french);
    CHECK(has(typed.obeyed("a=1"), "À 0 ms"));
    CHECK(has(typed.obeyed("scruter"), "la temporisation 50ms/X1 est écoulée"));
    CHECK(has(typed.obeyed("retour"), "entrées à 1"));
    CHECK(has(typed.obeyed("montrer"), "situation stable"));
    CHECK(has(typed.obeyed("show"), "situation stable"));
    CHECK(has(typed.obeyed("aide"), "enregistrer"));
    CHECK(typed.session().answer("quitter").is_over);
    CHECK(typed.session().answer("quit").is_over);
    CHECK(typed.session().beginnings().front() == "scruter");
    CHECK(typed.session().beginnings()[7] == "\"b c\"=");
}

namespace {

/// Types the stimuli line by line; what is saved must give the run of the stimuli.
std::string replay_fault(const RandomCase& random, std::optional<Time> period) {
    const auto grafcet = read_grafcet(random.chart);
    const auto stimuli = grafcet ? read_stimuli(random.stimuli, *grafcet) : std::nullopt;
    if (!stimuli) return "it cannot be read";
    Session session(*grafcet, period, Language::english);
    // One line an instant: what is typed takes effect at once.
    const std::string lines = write_stimuli(*stimuli, *grafcet);
    std::size_t begin = 0;
    while (begin < lines.size()) {
        const std::size_t end = lines.find('\n', begin);
        session.answer(lines.substr(begin, end - begin));
        if (begin % 3 == 0) {
            // There and back again.
            if (!session.answer("+13ms Init=1").is_refusal) session.answer("back");
        }
        begin = end + 1;
    }
    const SessionReply saved = session.answer("save x");
    const auto again = read_stimuli(saved.save_stimuli, *grafcet);
    if (!again) return "what is saved cannot be read";
    const auto run = [&](const Stimuli& given) {
        return period ? run_scans(*grafcet, given, *period) : run_until_stable(*grafcet, given);
    };
    const RunResult expected = run(*stimuli);
    const RunResult got = run(*again);
    if (expected.unstable_at != got.unstable_at) return "unstable elsewhere";
    const std::size_t rows = std::min(expected.trace.row_count(), got.trace.row_count());
    const std::vector<std::int64_t>& values = got.trace.values;
    const auto size = static_cast<std::ptrdiff_t>(rows * got.trace.columns.size());
    if (period) {
        // Its end is the last scan.
        if (rows + 1 < expected.trace.row_count()) return "scans are missing";
        if (!std::equal(values.begin(), values.begin() + size, expected.trace.values.begin())) {
            return "another run by scans";
        }
        return "";
    }
    // An instant 0 without a line is none of the stimuli, but one of the session.
    if (expected.trace.times != got.trace.times) return "other instants";
    return values == expected.trace.values ? "" : "another run";
}

}  // namespace

TEST_CASE("what is saved gives the same run, also after going back") {
    check_property([](const RandomCase& random) { return replay_fault(random, std::nullopt); }, {},
                   63'000, 150);
    check_property([](const RandomCase& random) { return replay_fault(random, 7 * millisecond); },
                   {}, 64'000, 100);
}

}  // namespace grafwire::testing
