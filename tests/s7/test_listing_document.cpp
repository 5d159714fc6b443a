// A generated listing against the listings that Cordier prints: the skeleton of the method, and his
// example 2 with its mistakes corrected.

#include <doctest/doctest.h>

#include <algorithm>

#include "s7/instruction_set.h"
#include "s7/made_listing.h"
#include "s7/write_listing.h"
#include "support/listings.h"

namespace grafwire::testing {

namespace {

/// The networks as text, without their comments; each with its offsets.
std::vector<std::string> networks_of(const s7::Listing& listing) {
    s7::Listing plain = listing;
    plain.head.clear();
    for (std::uint32_t n = 0; n < plain.networks.size(); ++n) {
        s7::Network& network = plain.networks[n];
        network.comment.clear();
        network.number = n + 1;
        for (s7::Instruction& instruction : network.instructions) instruction.comment.clear();
    }
    std::vector<std::string> networks;
    const std::string text = s7::write_listing(plain, {});
    for (std::size_t at = text.find("NETWORK"); at != std::string::npos;) {
        const std::size_t next = text.find("NETWORK", at + 1);
        networks.push_back(text.substr(at, next - at));
        at = next;
    }
    return networks;
}

void replace(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE_MESSAGE(at != std::string::npos, from << " in " << text);
    text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("without a chart to speak of the listing is the document's skeleton") {
    const MadeListing result = make_listing("graph G0 { initial 0 }");
    REQUIRE(result.made);
    std::vector<std::string> expected =
        networks_of(read_listing(example_text("s7-200/method.printed.awl")));
    // Network 19 clears twice the words that the tables have.
    replace(expected.at(18), "K40", "K20");
    CHECK(networks_of(result.made->listing) == expected);
    CHECK(s7::size_of(result.made->listing) == 394);
}

TEST_CASE("the manipulator's listing is the document's example 2, corrected") {
    const MadeListing result = make_listing(example_text("manipulator.grafcet"),
                                            example_text("s7-200/manipulator.io"), {}, true);
    REQUIRE_MESSAGE(result.made, result.messages);
    CHECK(result.messages.empty());
    const std::vector<std::string> got = networks_of(result.made->listing);
    std::vector<std::string> expected =
        networks_of(read_listing(example_text("s7-200/manipulator.awl")));
    // (0): the operands in the order of the chart, ↑dcy . /au.
    expected.at(26) =
        "NETWORK27\n  144 LD    V6.1\n  147 UN    E0.5\n  149 U     V0.0\n"
        "  152 =     V80.0\n";
    // SBR 4 looks at Ts, as in examples 1 and 3, where example 2 looks at Tp, which is the same.
    for (std::size_t n = 36; n < 44; ++n) replace(expected.at(n), "LD    V1", "LD    V2");
    // SBR 8 writes the outputs in the order in which the chart declares them, with the lamp as an
    // action of every step; what follows is moved by that.
    const std::size_t outputs = 57;
    CHECK(std::vector(got.begin(), got.begin() + outputs) ==
          std::vector(expected.begin(), expected.begin() + outputs));
    CHECK(subroutine_text(result.made->listing, 8) == R"(-- // "V+"
  LD    V21.1
  =     A0.0
-- // "H-"
  LD    V21.2
  U     E0.0
  =     A0.1
-- // "H+"
  LD    V21.0
  =     A0.2
-- // "Voyant CI"
  LD    V20.0
  U     E0.0
  U     E0.2
  LD    V20.1
  U     E0.0
  U     E0.2
  OLD
  LD    V20.2
  U     E0.0
  U     E0.2
  OLD
  LD    V20.3
  U     E0.0
  U     E0.2
  OLD
  =     A0.3
-- // Gauto may evolve
  LDN   V20.3
  =     V0.1
)");
    const s7::Listing document = read_listing(example_text("s7-200/manipulator.awl"));
    s7::Listing own = result.made->listing;
    for (s7::Network& network : own.networks) network.comment.clear();
    s7::Listing theirs = document;
    for (s7::Network& network : theirs.networks) network.comment.clear();
    CHECK(subroutine_text(own, 10) == subroutine_text(theirs, 10));
}

TEST_CASE("the head says what memory it takes, and can be read as an assignment") {
    const MadeListing result = make_listing(example_text("manipulator.grafcet"),
                                            example_text("s7-200/manipulator.io"), {}, true);
    REQUIRE(result.made);
    const std::vector<std::string>& head = result.made->listing.head;
    REQUIRE(head.size() > 8);
    CHECK(head[0] == "manipulator: Manipulateur en L");
    CHECK(head[3] == "Program memory: 734 bytes; 380 of them are the skeleton of the method.");
    CHECK(head[4] == "The chart takes 354 bytes, 44.2 a step (usual: 45).");
    CHECK(head[5] == "CPU 212, 1024 bytes of program, 1024 of V memory: fits.");
    CHECK(s7::size_of(result.made->listing) == 734);
    const auto addresses = std::find(head.begin(), head.end(), "Addresses:");
    REQUIRE(addresses != head.end());
    std::string text;
    for (auto line = addresses + 1; line != head.end(); ++line) text += *line + "\n";
    Diagnostics diagnostics;
    const auto read = s7::parse_io_assignment({"head.io", text}, diagnostics);
    REQUIRE(read);
    CHECK(s7::write_io_assignment(*read) == s7::write_io_assignment(result.made->assignment));
    // Given back as an assignment it makes the same listing.
    const MadeListing again = make_listing(example_text("manipulator.grafcet"), text, {}, true);
    REQUIRE_MESSAGE(again.made, again.messages);
    CHECK(s7::write_listing(again.made->listing, {}) ==
          s7::write_listing(result.made->listing, {}));
}

}  // namespace grafwire::testing
