// Programs in Python, run, are the reference scan by scan.

#include <doctest/doctest.h>

#include <algorithm>

#include "evolution/run.h"
#include "plc/compile.h"
#include "plc/run_language.h"
#include "random/read_text.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::vector<std::string> run_python(const Grafcet& grafcet, const ScanProgram& program,
                                    const std::vector<std::string>& scans) {
    const ScratchFolder folder;
    // Alone, and with warnings as errors.
    return run_on({"/usr/bin/python3", "-I", "-S", "-W", "error",
                   folder.file("program.py", written("python", grafcet, program))},
                  scans);
}

}  // namespace

TEST_CASE("a program in Python is the reference") {
    check_language(run_python, 950'000, 200);
}

TEST_CASE("the examples in Python pass a type checker") {
    const ScratchFolder folder;
    std::vector<std::string> command = {"mypy", "--no-error-summary", "--cache-dir=/dev/null"};
    for (const std::string& name : example_names()) {
        const auto grafcet = read_grafcet(example_case(name).chart);
        REQUIRE(grafcet);
        std::string file = name + ".py";
        std::replace(file.begin(), file.end(), '-', '_');
        command.push_back(
            folder.file(file, written("python", *grafcet, program_from(*grafcet, {}))));
    }
    const Ran ran = run_program(command);
    CHECK(ran.status == 0);
    CHECK(ran.out + ran.err == "");
}

TEST_CASE("no name of a chart is the encoding of its program in Python") {
    for (const std::string name :
         {"x coding: nosuch", R"(coding: raw_unicode_escape \u000aimport os\u000a#)",
          "-*- coding: utf-16 -*-", "vim: set fileencoding=nosuch :"}) {
        INFO("name: " << name);
        const auto grafcet = read_grafcet("grafcet \"" + name + "\" \"" + name +
                                          "\"\ninput a\ngraph G { initial 0 step 1 "
                                          "0 -> 1 : a 1 -> 0 : /a }\n");
        REQUIRE(grafcet);
        const auto stimuli = read_stimuli("0ms:\n10ms: a=1\n20ms: end\n", *grafcet);
        REQUIRE(stimuli);
        const std::string expected =
            write_csv(run_scans(*grafcet, *stimuli, 10 * millisecond).trace);
        CHECK(run_python(*grafcet, program_from(*grafcet, {}), {expected}).front() == expected);
        CHECK(written("python", *grafcet, program_from(*grafcet, {}))
                  .starts_with("# -*- coding: utf-8 -*-\n#\n"));
    }
}

}  // namespace grafwire::testing
