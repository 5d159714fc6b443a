// Programs in C, compiled and run, are the reference scan by scan.

#include <doctest/doctest.h>

#include "plc/compile.h"
#include "plc/run_language.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// A random chart may compare a sum with itself.
const std::string itself = "-Wno-tautological-compare";

std::vector<std::string> run_c(const Grafcet& grafcet, const ScanProgram& program,
                               const std::vector<std::string>& scans) {
    const ScratchFolder folder;
    const std::string source = folder.file("program.c", written("c", grafcet, program));
    const std::string binary = folder.path("program");
    compile({"gcc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", itself,
             "-DGRAFWIRE_MAIN", source, "-o", binary});
    return run_on({binary}, scans);
}

/// The same text as C++, and in C without its main function.
std::vector<std::string> run_cpp(const Grafcet& grafcet, const ScanProgram& program,
                                 const std::vector<std::string>& scans) {
    const ScratchFolder folder;
    const std::string source = folder.file("program.c", written("c", grafcet, program));
    const std::string binary = folder.path("program");
    compile({"gcc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", itself,
             "-c", source, "-o", folder.path("program.o")});
    compile({"g++", "-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror",
             itself, "-DGRAFWIRE_MAIN", "-x", "c++", source, "-o", binary});
    return run_on({binary}, scans);
}

}  // namespace

TEST_CASE("a program in C is the reference") {
    check_language(run_c, 930'000, 200);
}

TEST_CASE("a program in C is one in C++ too") {
    check_language(run_cpp, 931'000, 20);
}

}  // namespace grafwire::testing
