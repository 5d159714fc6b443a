// The tables of mistakes in examples/s7-200/README.md: what is said to be found by the check is
// found by it, one after another, in the network named; the rest by reading a listing or its
// offsets, or in no run at all. And with all of them corrected a printed listing is the corrected
// one.

#include <doctest/doctest.h>

#include <algorithm>

#include "s7/instruction_set.h"
#include "s7/write_listing.h"
#include "s7check/application.h"
#include "s7check/mistakes.h"

namespace grafwire::testing {

namespace {

/// The mistake that a diagnosis points at: the first network it names, that is yet to be corrected;
/// where no network writes a bit, the correction that does.
std::vector<Mistake>::iterator meant_by(const Diagnosis& diagnosis, std::vector<Mistake>& left) {
    for (const std::uint32_t network : diagnosis.networks) {
        const auto found = std::find_if(left.begin(), left.end(), [&](const Mistake& mistake) {
            return mistake.found_by == "check" && mistake.concerns(network);
        });
        if (found != left.end()) return found;
    }
    return std::find_if(left.begin(), left.end(), [&](const Mistake& mistake) {
        return mistake.found_by == "check" && mistake.writes(diagnosis.place);
    });
}

std::string instructions_of(const s7::Listing& listing) {
    s7::Listing plain = listing;
    plain.head.clear();
    for (s7::Network& network : plain.networks) network.comment.clear();
    return s7::write_listing(plain, {});
}

void check_mistakes(const std::string& name, const std::string& heading) {
    const Application application(name);
    std::vector<Mistake> left = mistakes_of(heading);
    const std::string printed_text = example_text("s7-200/" + name + ".printed.awl");
    s7::Listing listing = read_listing(printed_text);
    // One after another, until the listing is equivalent. The period divides all delays, those of
    // the mistakes too; the natural one has more scans and shows no more.
    constexpr Time period = 100 * millisecond;
    CheckResult result = application.check(listing, period);
    while (result.verdict == Verdict::different) {
        const auto diagnosis = application.cause(listing, result);
        REQUIRE(diagnosis);
        const auto mistake = meant_by(*diagnosis, left);
        std::string networks;
        for (const std::uint32_t n : diagnosis->networks) networks += std::to_string(n) + " ";
        REQUIRE_MESSAGE(mistake != left.end(), diagnosis->name << ", networks " << networks);
        correct(listing, *mistake);
        left.erase(mistake);
        result = application.check(listing, period);
    }
    CHECK(result.verdict == Verdict::equivalent);
    // The rest.
    for (const Mistake& mistake : left) {
        CAPTURE(mistake.number);
        CHECK(mistake.found_by != "check");
        if (mistake.found_by == "parse") {
            CHECK(messages_of(printed_text, s7::Cpu::cpu_212)
                      .find("error: " + mistake.corrections[0].printed[0]) != std::string::npos);
        } else if (mistake.found_by == "offsets") {
            const auto deviations = s7::offset_deviations(read_listing(printed_text));
            REQUIRE_FALSE(deviations.empty());
            CHECK(deviations[0].network == mistake.corrections[0].network);
        } else {
            CHECK(mistake.found_by == "reading");
        }
        correct(listing, mistake);
    }
    CHECK(instructions_of(listing) ==
          instructions_of(read_listing(example_text("s7-200/" + name + ".awl"))));
}

}  // namespace

TEST_CASE("mistakes: the positioning axis") {
    check_mistakes("positioning-axis", "Positioning axis");
}

TEST_CASE("mistakes: the manipulator") {
    check_mistakes("manipulator", "Manipulator");
}

TEST_CASE("mistakes: the manipulator with modes") {
    check_mistakes("manipulator-modes", "Manipulator with modes");
}

}  // namespace grafwire::testing
