// Damaged listings: whatever is in the text, there is either a listing or an error, and a listing
// that is accepted reads back as it was written and can be executed.

#include <doctest/doctest.h>

#include "random/random_source.h"
#include "s7/write_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

using namespace s7;

namespace {

/// A few characters replaced, removed or put in, or lines exchanged.
std::string damaged(std::string text, RandomSource& random) {
    static const std::string characters = "KVEAMTZSBWD.,01789 \n\"/=<>#NLUO-";
    for (std::size_t edits = random.between(1, 6); edits > 0 && !text.empty(); --edits) {
        const std::size_t at = random.below(text.size());
        const char c = characters[random.below(characters.size())];
        switch (random.below(4)) {
            case 0:
                text[at] = c;
                break;
            case 1:
                text.erase(at, random.between(1, 3));
                break;
            case 2:
                text.insert(at, 1, c);
                break;
            default: {
                const std::size_t line = text.find('\n', at);
                if (line == std::string::npos) break;
                const std::size_t end = text.find('\n', line + 1);
                text += text.substr(line, end == std::string::npos ? end : end - line);
                text.erase(line, end == std::string::npos ? end : end - line);
            }
        }
    }
    return text;
}

}  // namespace

TEST_CASE("damaged listings") {
    std::size_t accepted = 0;
    for (const std::string name : {"manipulator.awl", "positioning-axis.printed.awl"}) {
        const std::string whole = example_text("s7-200/" + name);
        for (std::uint64_t seed = 1; seed <= 600; ++seed) {
            CAPTURE(seed);
            RandomSource random(seed);
            const SourceFile source{"test.awl", damaged(whole, random)};
            Diagnostics diagnostics;
            const auto listing = parse_listing(source, {}, diagnostics);
            REQUIRE(listing.has_value() != diagnostics.has_errors());
            if (!listing) continue;
            ++accepted;
            const std::string written = write_listing(*listing, {});
            REQUIRE(write_listing(read_listing(written), {}) == written);
            Machine machine(*listing, Cpu::cpu_214);
            MachineState state = machine.start();
            machine.scan(state, {}, 0);
        }
    }
    CHECK(accepted > 50);
    CHECK(accepted < 1150);
}

}  // namespace grafwire::testing
