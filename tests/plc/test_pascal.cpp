// Programs in Free Pascal, compiled and run, are the reference scan by scan.

#include <doctest/doctest.h>

#include "plc/compile.h"
#include "plc/run_language.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// What runs programs compiled with these settings besides.
LanguageRunner pascal_with(const std::vector<std::string>& settings) {
    return [settings](const Grafcet& grafcet, const ScanProgram& program,
                      const std::vector<std::string>& scans) {
        const ScratchFolder folder;
        const std::string source = folder.file("program.pas", written("pascal", grafcet, program));
        // Overflow and ranges are checked as it runs.
        std::vector<std::string> command = {"fpc", "-v0e", "-Cro", source,
                                            "-o" + folder.path("program")};
        command.insert(command.begin() + 2, settings.begin(), settings.end());
        compile(command);
        return run_on({folder.path("program")}, scans);
    };
}

}  // namespace

// All warnings are errors but that of code which is never reached (6018): a chart may have
// conditions that are never 1.
TEST_CASE("a program in Pascal is the reference") {
    check_language(pascal_with({"-Sew", "-vm6018"}), 940'000, 200);
}

TEST_CASE("the examples in Pascal compile without a warning") {
    for (const std::string& name : example_names()) {
        INFO("example " << name);
        CHECK(compare_with_reference(example_case(name), pascal_with({"-Sew"})) == "");
    }
}

TEST_CASE("a var that nothing writes is no warning in Pascal") {
    const RandomCase chart = {
        "input a\noutput q\nvar m, n\ngraph G {\n  initial 0 : q\n  step 1\n"
        "  0 -> 1 : a . m\n  1 -> 0 : /a . n\n}\n",
        "0ms :\n10ms : a=1\n20ms : end\n"};
    CHECK(compare_with_reference(chart, pascal_with({"-Sew"})) == "");
}

}  // namespace grafwire::testing
