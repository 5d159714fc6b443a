// `plc --to ladder…` and `check --against PROGRAM.xml` on the command line.

#include <doctest/doctest.h>

#include "support/run_program.h"

namespace grafwire::testing {

TEST_CASE("a chart's own ladder diagram is equivalent, a damaged one is not") {
    ScratchFolder folder;
    const std::string chart = example("single-sequence.grafcet");
    const std::string file = folder.path("program.xml");
    CHECK(grafwire_with({"plc", chart, "--to", "plcopen", "-o", file}).status == 0);
    const Ran right = grafwire_with({"check", chart, "--against", file});
    CHECK(right.status == 0);
    CHECK(contains(right.out, "equivalent"));

    std::string text = text_of(file);
    const std::size_t reset = text.find("storage=\"reset\"");
    REQUIRE(reset != std::string::npos);
    text.replace(reset, 15, "storage=\"set\"");
    const std::string wrong = folder.file("wrong.xml", text);
    const Ran run = grafwire_with(
        {"check", chart, "--against", wrong, "--scan", "20ms", "--witness", folder.path("w")});
    CHECK(run.status == 1);
    CHECK(contains(run.out, "  scan period: 20ms; "));
    CHECK(contains(run.out, "X0 was last written in network 6"));
    const std::string stimuli = folder.path("w/witness.stim");
    const Ran replayed = grafwire_with({"run", chart, stimuli, "--scan", "20ms"});
    CHECK(replayed.out == text_of(folder.path("w/expected.csv")));
    CHECK(replayed.out != text_of(folder.path("w/got.csv")));
}

TEST_CASE("a program that cannot be compared is refused") {
    ScratchFolder folder;
    const std::string chart = example("single-sequence.grafcet");
    const std::string broken = folder.file("broken.xml", "<project>\n");
    const Ran run = grafwire_with({"check", chart, "--against", broken});
    CHECK(run.status == 2);
    CHECK(contains(run.err, "broken.xml:"));
    const std::string other = folder.path("other.xml");
    grafwire_with({"plc", example("rule-5.grafcet"), "--to", "plcopen", "-o", other});
    const Ran missing = grafwire_with({"check", chart, "--against", other});
    CHECK(missing.status == 2);
    CHECK(contains(missing.err, "no BOOL variable of this name: X0"));
    CHECK(grafwire_with({"check", chart, "--against", other, "--scan", "soon"}).status == 2);
}

TEST_CASE("drawings of a chart") {
    const std::string chart = example("manipulator.grafcet");
    const Ran text = grafwire_with({"plc", chart, "--to", "ladder", "--modes", "off"});
    CHECK(text.status == 0);
    CHECK(contains(text.out, "── Steps: CDX resets, CAX sets"));
    CHECK_FALSE(contains(text.out, "AUdur"));
    const Ran picture = grafwire_with({"plc", chart, "--to", "ladder-svg"});
    CHECK(picture.status == 0);
    CHECK(contains(picture.out, "</svg>"));
}

}  // namespace grafwire::testing
