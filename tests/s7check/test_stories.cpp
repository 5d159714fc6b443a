// What is told of a difference.

#include <doctest/doctest.h>

#include "random/read_text.h"
#include "s7check/application.h"
#include "s7check/listing_story.h"

namespace grafwire::testing {

TEST_CASE("the manipulator as printed: the story") {
    const Application application("manipulator");
    const s7::Listing listing = read_listing(example_text("s7-200/manipulator.printed.awl"));
    const CheckResult result = application.check(listing);
    const auto finding = application.cause(listing, result);
    CHECK(tell_listing_witness(application.grafcet, listing, *result.witness, finding, {},
                               Language::english) == R"()");
}

}  // namespace grafwire::testing
