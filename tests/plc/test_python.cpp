// Programs in Python, run, are the reference scan by scan.

#include <doctest/doctest.h>

#include "command/run_program.h"
#include "plc/compile.h"
#include "plc/run_language.h"

namespace grafwire::testing {

namespace {

std::vector<std::string> run_python(const ScanProgram& program,
                                    const std::vector<std::string>& scans) {
    const test::ScratchFolder folder;
    // Alone, and with warnings as errors.
    return run_on({"/usr/bin/python3", "-I", "-S", "-W", "error",
                   folder.file("program.py", written("python", program))},
                  scans);
}

}  // namespace

TEST_CASE("a program in Python is the reference") {
    check_language(run_python, 950'000, 200);
}

}  // namespace grafwire::testing
