// The corrected listings are equivalent to their GRAFCETs, by complete exploration. (The
// printed ones are not: test_mistakes.cpp.)

#include <doctest/doctest.h>

#include "s7check/application.h"

namespace grafwire::testing {

TEST_CASE("the corrected listings are equivalent") {
    for (const std::string name : {"positioning-axis", "manipulator", "manipulator-modes"}) {
        CAPTURE(name);
        const Application application(name);
        const CheckResult result =
            application.check(read_listing(example_text("s7-200/" + name + ".awl")));
        CHECK(result.verdict == Verdict::equivalent);
        CHECK(result.complete);
        CHECK(result.coverage.cases > 100);
    }
}

}  // namespace grafwire::testing
