// grafwire plc as a user meets it: the commands of src/plc/README.md.

#include <doctest/doctest.h>

#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::string trace_of(const ScratchFolder& folder) {
    const std::string trace = folder.path("trace.csv");
    const Ran ran = grafwire_with(
        {"run", example("press.grafcet"), example("press.stim"), "--scan", "10ms", "-o", trace});
    REQUIRE(ran.status == 0);
    return text_of(trace);
}

void write_program(const std::string& format, const std::string& file) {
    const Ran ran = grafwire_with({"plc", example("press.grafcet"), "--to", format, "-o", file});
    CHECK(ran.status == 0);
    CHECK(ran.err == "");
    CHECK(ran.out == "");
}

}  // namespace

TEST_CASE("a trace of the reference goes through a program and comes out the same") {
    const ScratchFolder folder;
    const std::string trace = trace_of(folder);
    CHECK(trace.size() > 1000);

    write_program("c", folder.path("press.c"));
    CHECK(run_program({"cc", "-std=c99", "-DGRAFWIRE_MAIN", folder.path("press.c"), "-o",
                       folder.path("press_c")})
              .err == "");
    CHECK(run_program({folder.path("press_c")}, trace).out == trace);

    write_program("pascal", folder.path("press.pas"));
    CHECK(run_program({"fpc", folder.path("press.pas"), "-o" + folder.path("press_pas")}).status ==
          0);
    CHECK(run_program({folder.path("press_pas")}, trace).out == trace);

    write_program("python", folder.path("press.py"));
    CHECK(run_program({"/usr/bin/python3", folder.path("press.py")}, trace).out == trace);
}

TEST_CASE("a program that a language cannot hold is refused, and nothing is written") {
    const ScratchFolder folder;
    std::string chart = "graph G {\n  initial 0\n";
    for (int step = 1; step <= 256; ++step) chart += "  step " + std::to_string(step) + "\n";
    const std::string file = folder.file("large.grafcet", chart + "}\n");
    const Ran ran = grafwire_with({"plc", file, "--to", "pascal", "-o", folder.path("large.pas")});
    CHECK(ran.status == 2);
    CHECK(contains(ran.err,
                   "large.grafcet:258:8: error: this is step 257 of 257, and a set of Free "
                   "Pascal holds 256; write --to c or --to python"));
    CHECK(folder.names() == std::vector<std::string>{"large.grafcet"});

    const Ran unknown = grafwire_with({"plc", file, "--to", "pyhton"});
    CHECK(unknown.status == 2);
    CHECK(contains(unknown.err, "there is no format 'pyhton'; did you mean 'python'?"));
}

}  // namespace grafwire::testing
