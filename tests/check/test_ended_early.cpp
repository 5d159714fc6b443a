// A check that is told to end has seen only a part, whenever that is: between two cases, or while
// the gates of one settle.

#include <doctest/doctest.h>

#include "check/check_equivalence.h"
#include "netlist_from_blif.h"
#include "support/small_netlists.h"

namespace grafwire::testing {

namespace {

/// The output follows the input through so many gates that settling asks whether to go on.
Netlist slow_follower(const Grafcet& grafcet) {
    constexpr int gates = 3'000;
    std::string text = ".model slow\n.inputs a\n.outputs X0 y\n.names X0\n1\n.names a n0\n1 1\n";
    for (int i = 1; i < gates; ++i) {
        text += ".names n" + std::to_string(i - 1) + " n" + std::to_string(i) + "\n1 1\n";
    }
    text += ".names n" + std::to_string(gates - 1) + " y\n1 1\n.end\n";
    return blif(grafcet, text);
}

}  // namespace

TEST_CASE("told to end at whatever moment, a check is undecided") {
    const Grafcet grafcet = grafcet_of(R"(
input a
output y
graph G { initial 0 : y if a }
)");
    const Netlist netlist = slow_follower(grafcet);
    std::size_t questions = 0;
    CheckOptions options;
    options.keep_going = [&] {
        ++questions;
        return true;
    };
    REQUIRE(check_equivalence(grafcet, netlist, options).verdict == Verdict::equivalent);
    const std::size_t all = questions;
    CHECK(all > 8);  // more than one a case
    for (std::size_t last = 1; last <= all; ++last) {
        INFO("told to end at question " << last << " of " << all);
        questions = 0;
        options.keep_going = [&] { return ++questions < last; };
        const CheckResult ended = check_equivalence(grafcet, netlist, options);
        // After the verdict only the remark about many changes is left to be made.
        if (ended.verdict == Verdict::equivalent) {
            REQUIRE(ended.together);
            CHECK(ended.together->verdict == Verdict::undecided);
        } else {
            CHECK(ended.verdict == Verdict::undecided);
        }
        CHECK(questions >= last);
    }
}

}  // namespace grafwire::testing
