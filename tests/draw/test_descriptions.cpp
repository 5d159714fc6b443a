// What pictures say of themselves, for those who hear them.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "draw/describe_sheet.h"
#include "draw/draw_chart.h"
#include "draw/draw_schematic.h"
#include "draw/timing_diagram.h"
#include "draw/write_drawing.h"
#include "equations/equations.h"
#include "netlist/styles/styles.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

Grafcet drill(const std::string& title = "") {
    auto read = read_grafcet("grafcet drill" + title +
                             "\ninput s\noutput K\ngraph G {\n initial 0\n macro M1 = bore\n"
                             "0 -> M1 : s\nM1 -> 0 : /s\n}\nexpansion bore {\n entry E1 : K\n"
                             " exit S1\n E1 -> S1 : s\n}\n");
    REQUIRE(read);
    return std::move(*read);
}

std::vector<std::string> descriptions(const std::vector<Sheet>& sheets, Language language) {
    std::vector<std::string> all;
    for (const Sheet& sheet : sheets) all.push_back(describe_sheet(sheet, language));
    return all;
}

}  // namespace

TEST_CASE("descriptions: a chart has steps, macro-steps, transitions and a situation") {
    ChartDrawing how;
    CHECK(descriptions(draw_chart(drill(" \"Drill\""), how), how.language) ==
          std::vector<std::string>{"drill – Drill. 3 steps: 0, E1, S1. 1 macro-step: M1. "
                                   "3 transitions: (0), (1), (2)."});
    how.language = Language::french;
    how.situation = {{true, false, false}, {true, false, false}, {}, "à 5 ms"};
    CHECK(descriptions(draw_chart(drill(), how), how.language) ==
          std::vector<std::string>{"drill – à 5 ms. 3 étapes : 0, E1, S1. 1 macro-étape : M1. "
                                   "3 transitions : (0), (1), (2). 1 étape active : 0."});
}

TEST_CASE("descriptions: a schematic has modules, a timing diagram signals, each once") {
    const Grafcet grafcet = drill();
    Diagnostics diagnostics;
    const auto netlist =
        netlist_from(grafcet, equations_from(grafcet, {}), Style::nand, diagnostics);
    REQUIRE(netlist);
    SchematicDrawing schematic;
    schematic.title = "drill, nand";
    const std::vector<std::string> modules =
        descriptions(draw_schematic(*netlist, schematic), schematic.language);
    REQUIRE(modules.size() == 1);
    CHECK(modules[0].rfind("drill, nand. Schematic of ", 0) == 0);
    CHECK(modules[0].find(" modules: X0, XE1, XS1, ") != std::string::npos);

    Trace trace;
    trace.columns = {{"s", 1, Trace::Column::Kind::input}, {"X0", 1, Trace::Column::Kind::step}};
    for (int i = 0; i < 100; ++i) {
        trace.times.push_back(i * millisecond);
        trace.values.insert(trace.values.end(), {i % 2, 1});
    }
    TimingDrawing timing;
    timing.title = "drill";
    timing.language = Language::french;
    const std::vector<std::string> signals =
        descriptions(draw_timing(trace, timing), timing.language);
    CHECK(signals.front().find("Chronogramme de 3 signaux : s, X0, Situation.") !=
          std::string::npos);
}

TEST_CASE("descriptions: an SVG file has those of all sheets; on a page each sheet has its own") {
    std::string text = "grafcet long\ninput a\ngraph G {\n initial 0\n";
    for (int i = 1; i < 200; ++i) text += "step " + std::to_string(i) + '\n';
    for (int i = 0; i < 200; ++i) {
        text += std::to_string(i) + " -> " + std::to_string((i + 1) % 200) + " : a\n";
    }
    const auto grafcet = read_grafcet(text + "}\n");
    REQUIRE(grafcet);
    const std::vector<Sheet> sheets = draw_chart(*grafcet, {});
    REQUIRE(sheets.size() > 1);
    const std::vector<std::string> all = descriptions(sheets, Language::english);
    CHECK(all[0].rfind("long – sheet 1 of ", 0) == 0);
    CHECK(all[0].find(" steps: 0, 1, 2, ") != std::string::npos);
    CHECK(all[0].find(", 199") == std::string::npos);
    CHECK(all.back().find(", 199.") != std::string::npos);

    const std::string whole = write_svg_drawing(sheets, "a < b", papers[0], Language::english);
    CHECK(whole.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
                      "aria-labelledby=\"title description\" lang=\"en\" ",
                      0) == 0);
    CHECK(whole.find("<title id=\"title\">a &lt; b</title>\n<desc id=\"description\">" + all[0] +
                     "\n" + all[1]) != std::string::npos);
    const std::vector<std::string> pictures =
        write_svg_sheets(sheets, "long", Language::french, "chart");
    CHECK(pictures[1].find("aria-labelledby=\"chart-2-title chart-2-description\" lang=\"fr\"") !=
          std::string::npos);
    CHECK(pictures[1].find("<desc id=\"chart-2-description\">") != std::string::npos);
}

}  // namespace grafwire::testing
