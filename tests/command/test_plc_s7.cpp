// grafwire plc --to s7-200: what its options do, and what it says where something is wrong.

#include <doctest/doctest.h>

#include "support/run_program.h"

namespace grafwire::testing {

namespace {

const std::string manipulator = example("manipulator.grafcet");
const std::string manipulator_io = example("s7-200/manipulator.io");

std::vector<std::string> plc(const std::string& chart, std::vector<std::string> options = {}) {
    std::vector<std::string> arguments{"plc", chart, "--to", "s7-200"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
}

/// Standard error of a request that is refused.
std::string refusal_of_list(const std::vector<std::string>& arguments) {
    const Ran ran = grafwire_with(arguments);
    INFO("standard error: " << ran.err);
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    return ran.err;
}

/// A listing but for the request at its head.
std::string without_request(std::string listing) {
    const std::size_t begin = listing.find("// Written by ");
    REQUIRE(begin != std::string::npos);
    return listing.erase(begin, listing.find('\n', begin) + 1 - begin);
}

}  // namespace

TEST_CASE("addresses come from the assignment, or in order") {
    const Ran given = grafwire_with(plc(manipulator, {"--io", manipulator_io}));
    CHECK(given.status == 0);
    CHECK(given.err.empty());
    CHECK(contains(given.out, "\n// E0.4   = dcy\n"));
    CHECK(!contains(given.out, "AUdur"));
    CHECK(contains(given.out, "\n  144 LD    V6.1\n  147 UN    E0.5\n"));
    CHECK(grafwire_with(plc(manipulator, {"--io", manipulator_io})).out == given.out);

    const Ran in_order = grafwire_with(plc(manipulator));
    CHECK(in_order.status == 0);
    CHECK(contains(in_order.out, "\n// E0.6   = Init\n// E0.7   = AUdur\n// E1.0   = AUdoux\n"));
    const Ran without = grafwire_with(plc(manipulator, {"--modes", "off"}));
    CHECK(without_request(without.out) == without_request(given.out));
}

TEST_CASE("the addresses can be written, and given back") {
    const ScratchFolder folder;
    const std::string io = folder.path("crossing.io");
    const std::string crossing = example("level-crossing.grafcet");
    const Ran first = grafwire_with(plc(crossing, {"--addresses", io}));
    CHECK(first.status == 0);
    const Ran again = grafwire_with(plc(crossing, {"--io", io}));
    CHECK(again.status == 0);
    CHECK(again.err.empty());
    CHECK(without_request(again.out) == without_request(first.out));
    // And the interpreter finds in the listing what the reference does.
    const std::string awl = folder.file("crossing.awl", first.out);
    const std::string stim = example("level-crossing.stim");
    const Ran run = grafwire_with(
        {"s7", "run", awl, "--stim", stim, "--scan", "10ms", "--io", io, "--grafcet", crossing});
    CHECK(run.status == 0);
    CHECK(run.out == grafwire_with({"run", crossing, stim, "--scan", "10ms"}).out);
}

TEST_CASE("either spelling") {
    for (const std::string spelling : {"iec", "en"}) {
        const Ran ran = grafwire_with(plc(manipulator, {"--mnemonics", spelling}));
        CHECK(ran.status == 0);
        CHECK(contains(ran.out, "\n// I0.4   = dcy\n"));
        CHECK(contains(ran.out, " AN    I0.5\n"));
        CHECK(contains(ran.out, " FILL  16#FFFF VW0     1\n"));
        CHECK(!contains(ran.out, "UNDD"));
    }
    const Ran bare = grafwire_with(plc(manipulator, {"--offsets", "off"}));
    CHECK(bare.status == 0);
    CHECK(contains(bare.out, "\n      CALL  K10\n"));
}

TEST_CASE("a partial assignment is completed, with a warning for what is wired") {
    const ScratchFolder folder;
    const std::string io = folder.file("some.io", "E1.0 = dcy\nE1.1 = au\nA0.5 = \"V+\"\n");
    const Ran ran = grafwire_with(plc(manipulator, {"--io", io}));
    CHECK(ran.status == 0);
    CHECK(contains(ran.err, "warning: 'v0' has no address in the assignment; it takes E0.0"));
    CHECK(contains(ran.err, "warning: 'H-' has no address in the assignment; it takes A0.0"));
    CHECK(!contains(ran.err, "'dcy'"));
    CHECK(contains(ran.out, "\n// E1.0   = dcy\n"));
}

TEST_CASE("errors in an assignment have their place") {
    const ScratchFolder folder;
    const std::string io = folder.file("wrong.io", "E0.0 = v0\nE0.9 = v1\n");
    CHECK(contains(refusal_of_list(plc(manipulator, {"--io", io})), "wrong.io:2:1: error: 'E0.9'"));
    const std::string other = folder.file("other.io", "E0.0 = v0\nA0.0 = dcy\n");
    CHECK(contains(refusal_of_list(plc(manipulator, {"--io", other})),
                   "other.io:2:1: error: A0.0 cannot be the address of 'dcy'"));
    CHECK(contains(refusal_of_list(plc(manipulator, {"--io", folder.path("missing.io")})),
                   "missing.io"));
    CHECK(contains(refusal_of_list(plc("-", {"--io", "-"})), "standard input"));
}

TEST_CASE("a program has to fit the controller that is named") {
    CHECK(grafwire_with(plc(manipulator, {"--cpu", "212"})).status == 0);
    const std::string crossing = example("level-crossing.grafcet");
    CHECK(contains(refusal_of_list(plc(crossing, {"--cpu", "212"})),
                   "and the program memory of a CPU 212 holds 1024"));
    CHECK(grafwire_with(plc(crossing, {"--cpu", "214"})).status == 0);
    const Ran wide = grafwire_with(plc(crossing, {"--tables", "wide"}));
    CHECK(wide.status == 0);
    CHECK(contains(wide.out, "// Ts     VB14 … VB17 "));
}

TEST_CASE("an option that a format has no use for is refused") {
    CHECK(contains(refusal_of_list({"plc", manipulator, "--to", "text", "--io", manipulator_io}),
                   "text has no --io; it is for s7-200"));
    CHECK(contains(refusal_of_list({"plc", manipulator, "--to", "stl", "--offsets", "on"}),
                   "stl has no --offsets; it is for s7-200"));
}

TEST_CASE("the other Statement List takes addresses as well") {
    const ScratchFolder folder;
    const std::string io = folder.file("wired.io", "E4.1 = dcy\n");
    const Ran ran = grafwire_with({"plc", manipulator, "--to", "stl", "--io", io});
    CHECK(ran.status == 0);
    CHECK(contains(ran.out, "E 4.1"));
    const std::string wrong = folder.file("wrong.io", "E4.1 = dcv\n");
    CHECK(contains(refusal_of_list({"plc", manipulator, "--to", "stl", "--io", wrong}),
                   "wrong.io:1:1: error: the chart has no 'dcv'; did you mean 'dcy'?"));
}

}  // namespace grafwire::testing
