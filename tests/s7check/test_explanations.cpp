// How a difference is explained.

#include <doctest/doctest.h>

#include "random/read_text.h"
#include "s7check/application.h"
#include "s7check/explain_listing.h"

namespace grafwire::testing {

namespace {

/// Two steps; the listing keeps them in M0.0 and M0.1, in a student's own way.
const std::string lamp_chart = R"(
    input go, back
    output lamp
    graph G {
      initial 0
      step 1 : lamp
      0 -> 1 : go
      1 -> 0 : back
    })";
const std::string lamp_table = "E0.0 = go\nE0.1 = back\nA0.0 = lamp\nM0.0 = X0\nM0.1 = X1\n";

/// How a listing that differs is explained.
std::string explained(const std::string& text, Language language) {
    const auto grafcet = read_grafcet(lamp_chart);
    Diagnostics diagnostics;
    const auto binding = s7::bind(*grafcet, read_assignment(lamp_table), diagnostics);
    REQUIRE(binding);
    const s7::Listing listing = read_listing(text);
    const ListingDevice device(listing, s7::Cpu::cpu_214, *binding);
    const CheckResult result = check_scans(*grafcet, device, 10 * millisecond, {});
    REQUIRE(result.witness);
    const auto diagnosis =
        localize_fault(*grafcet, listing, s7::Cpu::cpu_214, *binding, *result.witness);
    return explain_listing_witness(*grafcet, listing, *result.witness, diagnosis,
                                   last_scan(*grafcet, device, *result.witness).stop, language);
}

const std::string good_lamp = R"(NETWORK1 // First scan
LD SM0.1
S M0.0 K1
NETWORK2 // Both transitions, from the steps as they were
LD M0.0
U E0.0
= M1.0
LD M0.1
U E0.1
= M1.1
NETWORK3 // Steps
LD M1.0
S M0.1 K1
R M0.0 K1
LD M1.1
S M0.0 K1
R M0.1 K1
NETWORK4 // Lamp
LD M0.1
= A0.0
MEND
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("a listing of a student's own is judged too") {
    const auto grafcet = read_grafcet(lamp_chart);
    Diagnostics diagnostics;
    const auto binding = s7::bind(*grafcet, read_assignment(lamp_table), diagnostics);
    REQUIRE(binding);
    const s7::Listing listing = read_listing(good_lamp);
    const ListingDevice device(listing, s7::Cpu::cpu_214, *binding);
    CHECK_FALSE(device.has_modes());
    const CheckResult result = check_scans(*grafcet, device, 10 * millisecond, {});
    CHECK(result.verdict == Verdict::equivalent);
    CHECK(result.complete);
    CHECK(result.coverage.situations == 2);
}

TEST_CASE("its mistake: the network that wrote the step, and what it had read") {
    CHECK(explained(replaced(good_lamp, "LD M0.1\nU E0.1\n= M1.1", "LD E0.1\n= M1.1"),
                    Language::english) == R"(At 0 ms: go=1 back=1.
The reference:
  before: X0
  scan at 0 ms: clears (0) 0 -> 1. Situation: X1
Where they part:
  X0: the reference gives 0, the listing 1
  X1: the reference gives 1, the listing 0
  lamp: the reference gives 1, the listing 0
Where it comes from in the listing:
  X0 (M0.0) is 1 after the scan at 0 ms, and should be 0
  it was written by: network 3 (Steps), line 10
  network 3 reads M1.0 = 1, written by network 2
  network 3 reads M1.1 = 1, written by network 2
  if it is right, look at network 2
The instructions:
  network 3 (Steps), line 10
       11  LD    M1.0
       13  R     M0.0    K1
       14  LD    M1.1
       15  S     M0.0    K1
  network 2 (Both transitions, from the steps as they were), line 4
        5  LD    M0.0
        6  U     E0.0
        7  =     M1.0
        8  LD    E0.1
        9  =     M1.1
)");
}

TEST_CASE("its mistake, in French: an output that no network writes") {
    CHECK(explained(replaced(good_lamp, "LD M0.1\n= A0.0\n", ""), Language::french) ==
          R"(À 0 ms : go=1.
La référence :
  avant : X0
  scrutation à 0 ms : franchit (0) 0 -> 1. Situation : X1
Écart constaté :
  lamp : la référence donne 1, la liste d'instructions 0
D'où cela vient dans la liste d'instructions :
  lamp (A0.0) vaut 0 après la scrutation à 0 ms, et devrait valoir 1
  aucun réseau ne l'écrit
)");
}

TEST_CASE("a scan that does not come to an end") {
    CHECK(explained(replaced(good_lamp, "NETWORK4 // Lamp\n",
                             "NETWORK4 // Lamp\nLBL K0\nLD M0.1\nJMP K0\n"),
                    Language::english) == R"(At 0 ms: go=1.
The reference:
  before: X0
  scan at 0 ms: clears (0) 0 -> 1. Situation: X1
The listing stops (network 4, line 21): the scan does not come to an end: more than 100000 instructions
)");
}

TEST_CASE("the manipulator as printed: the story") {
    const Application application("manipulator");
    const s7::Listing listing = read_listing(example_text("s7-200/manipulator.printed.awl"));
    const CheckResult result = application.check(listing);
    const auto diagnosis = application.cause(listing, result);
    CHECK(explain_listing_witness(application.grafcet, listing, *result.witness, diagnosis, {},
                                  Language::english) == R"(At 0 ms, no input changes.
The reference:
  before: X0
Where they part:
  X0: the reference gives 1, the listing 0
Where it comes from in the listing:
  Tf0 of X0 (V70.0) is 1 after the scan at 0 ms, and should be 0
  it was written by: network 49 (Traitement des forçages etape par etape), line 187
The instructions:
  network 49 (Traitement des forçages etape par etape), line 187
      188  LD    V20.0
      189  S     V70.0   K4
)");
}

}  // namespace grafwire::testing
