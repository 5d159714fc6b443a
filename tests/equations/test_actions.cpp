#include "equations/parsed.h"

namespace grafwire::testing {

namespace {

// The lines of a CSV report that belong to outputs.
std::string output_lines(std::string_view chart, const EquationOptions& options) {
    const std::string report = csv(chart, options);
    const std::size_t start = report.find(",,,");
    if (start == std::string::npos) return {};
    return report.substr(report.rfind('\n', start) + 1);
}

struct Stored {
    Grafcet grafcet;
    Equations equations;

    explicit Stored(std::string_view chart, const EquationOptions& options = without_modes)
        : grafcet(parsed(chart)), equations(equations_from(grafcet, options)) {}

    std::string text(ExprId id) const {
        return write_expression(grafcet, equations.expressions, id);
    }
    std::string set(std::size_t i) const { return text(equations.stored[i].set); }
    std::string reset(std::size_t i) const { return text(equations.stored[i].reset); }
};

}  // namespace

TEST_CASE("all continuous actions on an output meet in one equation") {
    constexpr std::string_view chart = R"(
        input v0, a, b
        output A, B, unused
        graph G {
          initial 3 : A, B if a + b
          step 5 : A if v0, B if 0
          step 7 : A if 1 + v0
          3 -> 5 : a   5 -> 7 : a   7 -> 3 : a
        })";
    CHECK(output_lines(chart, with_modes) == R"(A,,,(X3 + X5.v0 + X7)./AUdoux
B,,,X3.(a + b)./AUdoux
unused,,,0
)");
    CHECK(output_lines(chart, without_modes) ==
          "A,,,X3 + X5.v0 + X7\nB,,,X3.(a + b)\nunused,,,0\n");
}

TEST_CASE("delayed and time-limited actions") {
    CHECK(output_lines(R"(
        output A, B
        input a
        graph G { initial 5 : A if 3s/X5, B if /(3s/X5)  step 6  5 -> 6 : a  6 -> 5 : a })",
                       with_modes) == "A,,,X5 . 3s/X5./AUdoux\nB,,,X5./3s/X5./AUdoux\n");
}

TEST_CASE("a stored output is an RS memory; AUdoux does not touch it") {
    CHECK(output_lines(R"(
        input a
        output lamp
        graph G { initial 1 : reset lamp  step 2 : set lamp  1 -> 2 : a  2 -> 1 : /a })",
                       with_modes) == "lamp,,,↑X2 + /(↑X1./↑X2).lamp\n");
}

TEST_CASE("the last write wins: deactivation, clearing, activation, event") {
    // Written in the reverse of the order of execution.
    const Stored stored(R"(
        input a, e
        var v
        graph G {
          initial 1 : set v on ↑e, reset v, set v on deactivation
          step 2
          1 -> 2 : a do reset v
          2 -> 1 : /a
        })",
                        with_modes);
    REQUIRE(stored.equations.stored.size() == 1);
    const std::vector<StoredWrite>& writes = stored.equations.stored[0].writes;
    REQUIRE(writes.size() == 4);
    CHECK(writes[0].cause == StoredWrite::Cause::deactivation);
    CHECK(writes[1].cause == StoredWrite::Cause::clearing);
    CHECK(writes[1].transition == TransitionId{0});
    CHECK(writes[2].cause == StoredWrite::Cause::activation);
    CHECK(writes[3].cause == StoredWrite::Cause::event);
    CHECK(stored.text(writes[1].trigger) == "X1.a./Init");
    CHECK(stored.text(writes[3].event) == "↑e");
    CHECK(stored.text(writes[3].trigger) == "X1.↑e");
    // The two resets need not exclude each other.
    CHECK(stored.set(0) == "↓X1./(X1.a./Init + ↑X1) + X1.↑e");
    CHECK(stored.reset(0) == "X1.a./Init./(X1.↑e) + ↑X1./(X1.↑e)");
}

TEST_CASE("within a kind the later action wins, and equal writes do not repeat each other") {
    const Stored stored(R"(
        input a
        var v, w
        graph G {
          initial 1 : set v, set w
          step 2 : set v, reset w
          step 3 : reset v
          1 -> 2, 3 : a   2, 3 -> 1 : /a
        })");
    CHECK(stored.set(0) == "↑X1./↑X3 + ↑X2./↑X3");
    CHECK(stored.reset(0) == "↑X3");
    CHECK(stored.set(1) == "↑X1./↑X2");
    CHECK(stored.reset(1) == "↑X2");
}

TEST_CASE("assigned expressions set and reset") {
    const Stored stored(R"(
        input a, b
        output o
        var v
        graph G { initial 1 : v := a + b, o := 1  step 2 : v := /v, o := 0 on ↑b
                  1 -> 2 : a   2 -> 1 : /a })");
    REQUIRE(stored.equations.stored.size() == 2);
    CHECK(stored.set(0) == "↑X1./(X2.↑b)");
    CHECK(stored.reset(0) == "X2.↑b");
    CHECK(stored.set(1) == "↑X1.(a + b)./↑X2 + ↑X2./v");
    CHECK(stored.reset(1) == "↑X1./(a + b)./↑X2 + ↑X2.v");
}

TEST_CASE("a write on a transition that is never cleared never happens") {
    const Stored stored("input a var v graph G { initial 1 step 2  1 -> 2 : 0 . a do set v }");
    CHECK(stored.set(0) == "0");
    CHECK(stored.reset(0) == "0");
}

TEST_CASE("counters have their writes in order; variables without writes have none") {
    const Stored stored(R"(
        input a
        var idle
        counter n : 0..9
        counter m : -5..5
        graph G {
          initial 1 : n := 0
          step 2 : n := n + 1 on ↑a
          1 -> 2 : a . [n < 3] + idle do n := n + 2   2 -> 1 : [n - m >= 5]
        })");
    REQUIRE(stored.equations.stored.size() == 2);
    const StoredEquation& idle = stored.equations.stored[0];
    CHECK(idle.target == Variable{VariableKind::var, 0});
    CHECK(idle.writes.empty());
    CHECK(stored.set(0) == "0");
    CHECK(stored.reset(0) == "0");
    const StoredEquation& n = stored.equations.stored[1];
    CHECK(n.target == Variable{VariableKind::counter, 0});
    CHECK(n.set == no_expr);
    CHECK(n.reset == no_expr);
    REQUIRE(n.writes.size() == 3);
    CHECK(stored.text(n.writes[0].trigger) == "X1.(a.[n < 3] + idle)");
    REQUIRE(!n.writes[0].sum.empty());
    CHECK(n.writes[0].sum.size() == 2);
    CHECK(n.writes[0].value == no_expr);
    CHECK(stored.text(n.writes[1].trigger) == "↑X1");
    CHECK(stored.text(n.writes[2].trigger) == "X2.↑a");
}

}  // namespace grafwire::testing
