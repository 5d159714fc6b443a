// Programs in Free Pascal, compiled and run, are the reference scan by scan.

#include <doctest/doctest.h>

#include "plc/compile.h"
#include "plc/run_language.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// What runs programs compiled with these settings besides.
LanguageRunner pascal_with(const std::string& setting) {
    return [setting](const Grafcet& grafcet, const ScanProgram& program,
                     const std::vector<std::string>& scans) {
        const ScratchFolder folder;
        const std::string source = folder.file("program.pas", written("pascal", grafcet, program));
        // Overflow and ranges are checked as it runs.
        compile({"fpc", "-v0e", setting, "-Cro", source, "-o" + folder.path("program")});
        return run_on({folder.path("program")}, scans);
    };
}

}  // namespace

// Without warnings as errors: a chart may have conditions that are never 1 and vars that nothing
// writes, and Free Pascal warns of both.
TEST_CASE("a program in Pascal is the reference") {
    check_language(pascal_with("-vw-"), 940'000, 200);
}

TEST_CASE("the examples in Pascal compile without a warning") {
    for (const std::string& name : example_names()) {
        INFO("example " << name);
        CHECK(compare_with_reference(example_case(name), pascal_with("-Sew")) == "");
    }
}

}  // namespace grafwire::testing
