// A ladder diagram written as PLCopen XML, read back and executed, is the reference.

#include <doctest/doctest.h>

#include <filesystem>
#include <pugixml.hpp>

#include "evolution/run.h"
#include "ladder/draw/write_drawings.h"
#include "ladder/ladder_from.h"
#include "ladder/run_ladder.h"
#include "plcopen/read_ladder.h"
#include "plcopen/write_project.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "support/chart_files.h"
#include "support/tool_runner.h"

namespace grafwire::testing {

namespace {

/// Written and read back; the names of the chart are put back in place of the identifiers.
std::optional<ladder::Ladder> there_and_back(const ladder::Ladder& ladder, std::string& messages) {
    const SourceFile source{"chart.xml", plcopen::write_ladder_project(ladder)};
    Diagnostics diagnostics;
    auto read = plcopen::read_ladder(source, diagnostics, ladder.name);
    messages = format_diagnostics(diagnostics, source);
    if (!read) return read;
    const std::vector<std::string> identifiers = plcopen::identifiers_of(ladder);
    for (ladder::Variable& variable : read->variables) {
        for (std::size_t v = 0; v < identifiers.size(); ++v) {
            if (identifiers[v] != variable.name) continue;
            variable.name = ladder.variables[v].name;
            break;
        }
    }
    return read;
}

std::string compare(const std::string& chart, const std::string& stimuli_text) {
    const auto grafcet = read_grafcet(chart);
    const auto stimuli = read_stimuli(stimuli_text, *grafcet);
    const ScanProgram program = program_from(*grafcet, {});
    Diagnostics diagnostics;
    const ladder::Ladder written = ladder::ladder_from(*grafcet, program, diagnostics);
    std::string messages;
    const auto read = there_and_back(written, messages);
    if (!read) return "not read back:\n" + messages;
    for (const Time period : {millisecond, 1500 * microsecond}) {
        const std::string expected = write_csv(run_scans(*grafcet, *stimuli, period).trace);
        const std::string got = write_csv(run_ladder(*grafcet, *read, *stimuli, period));
        if (expected != got) {
            return "reference\n" + expected + "ladder\n" + got + ladder::write_text(*read);
        }
    }
    return {};
}

}  // namespace

TEST_CASE("PLCopen XML read back is the reference, on random charts") {
    check_property([](const RandomCase& item) { return compare(item.chart, item.stimuli); },
                   Features(), 940'000, 400, 15);
}

TEST_CASE("PLCopen XML read back is the reference, on the examples") {
    for (const ChartFiles& example : example_charts()) {
        CAPTURE(example.name);
        CHECK(compare(example.chart, example.stimuli) == "");
    }
}

TEST_CASE("a function has EN and ENO, or neither") {
    std::size_t functions = 0;
    for (const ChartFiles& example : example_charts()) {
        CAPTURE(example.name);
        const auto grafcet = read_grafcet(example.chart);
        Diagnostics diagnostics;
        const ladder::Ladder ladder =
            ladder::ladder_from(*grafcet, program_from(*grafcet, {}), diagnostics);
        pugi::xml_document document;
        REQUIRE(document.load_string(plcopen::write_ladder_project(ladder).c_str()));
        for (const pugi::xpath_node& found : document.select_nodes("//block")) {
            const pugi::xml_node block = found.node();
            const auto has = [&](const char* list, const char* name) {
                return !block.child(list)
                            .find_child_by_attribute("variable", "formalParameter", name)
                            .empty();
            };
            CHECK(has("inputVariables", "EN") == has("outputVariables", "ENO"));
            functions += has("inputVariables", "EN") ? 1 : 0;
        }
    }
    CHECK(functions > 0);
}

TEST_CASE("what is read back is drawn as what was written") {
    for (const ChartFiles& example : example_charts()) {
        CAPTURE(example.name);
        const auto grafcet = read_grafcet(example.chart);
        const ScanProgram program = program_from(*grafcet, {});
        Diagnostics diagnostics;
        const ladder::Ladder written = ladder::ladder_from(*grafcet, program, diagnostics);
        std::string messages;
        const auto read = there_and_back(written, messages);
        REQUIRE_MESSAGE(read, messages);
        REQUIRE(read->rungs.size() == written.rungs.size());
        for (std::size_t r = 0; r < read->rungs.size(); ++r) {
            CHECK(write_rung(*read, read->rungs[r], 100) ==
                  write_rung(written, written.rungs[r], 100));
            CHECK(read->rungs[r].number == written.rungs[r].number);
            CHECK(read->rungs[r].comment == written.rungs[r].comment);
            CHECK(read->rungs[r].heading == written.rungs[r].heading);
        }
    }
}

TEST_CASE("PLCopen XML is valid under the schema of PLCopen") {
    const std::string schema =
        std::string(GRAFWIRE_ROOT) + "/../shared/corpus/plcopen/tc6_xml_v201.xsd";
    if (!std::filesystem::exists(schema)) {
        MESSAGE("skipped: the schema is not at " << schema);
        return;
    }
    std::vector<ChartFiles> charts = example_charts();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const RandomCase item = random_case(950'000 + seed, Features(), 1);
        charts.push_back({"random", item.chart, item.stimuli});
    }
    ToolRunner tools;
    std::string command = "xmllint --noout --schema '" + schema + "'";
    for (std::size_t c = 0; c < charts.size(); ++c) {
        const auto grafcet = read_grafcet(charts[c].chart);
        const ScanProgram program = program_from(*grafcet, {});
        Diagnostics diagnostics;
        const std::string file = std::to_string(c) + ".xml";
        tools.write(file, plcopen::write_ladder_project(
                              ladder::ladder_from(*grafcet, program, diagnostics)));
        const std::string sfc_file = std::to_string(c) + "-sfc.xml";
        tools.write(sfc_file, plcopen::write_sfc_project(*grafcet));
        command += " " + sfc_file;
        command += " " + file;
    }
    const auto result = tools.run(command);
    CHECK_MESSAGE(result.status == 0, result.output);
}

}  // namespace grafwire::testing
