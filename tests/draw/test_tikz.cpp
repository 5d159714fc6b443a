// TikZ pictures, set by pdflatex.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "draw/draw_chart.h"
#include "draw/draw_schematic.h"
#include "draw/write_drawing.h"
#include "equations/equations.h"
#include "netlist/styles/styles.h"
#include "random/random_grafcet.h"
#include "random/read_text.h"
#include "support/chart_files.h"
#include "support/files.h"
#include "support/tool_runner.h"

namespace grafwire::testing {

namespace {

/// One document with all of these drawings, since most of the time goes into starting pdflatex.
std::string document_of(const std::vector<std::vector<Sheet>>& drawings) {
    std::string all;
    std::string end;
    for (const std::vector<Sheet>& sheets : drawings) {
        const std::string whole = write_tikz_drawing(sheets, "drawing", papers[0], true);
        const std::size_t begin = whole.find("\\begin{document}");
        const std::size_t last = whole.find("\\end{document}");
        REQUIRE(begin != std::string::npos);
        if (all.empty()) all = whole.substr(0, begin) + "\\begin{document}\n";
        all += whole.substr(begin + 17, last - begin - 17) + "\n\\clearpage\n";
        end = whole.substr(last);
    }
    return all + end;
}

std::string document_of_charts(const std::vector<std::string>& charts) {
    std::vector<std::vector<Sheet>> drawings;
    for (const std::string& text : charts) {
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        drawings.push_back(draw_chart(*grafcet, {}));
    }
    return document_of(drawings);
}

void set_in_type(const std::string& document) {
    ToolRunner runner;
    runner.write("chart.tex", document);
    const auto done = runner.run("pdflatex -interaction=nonstopmode -halt-on-error chart.tex");
    CAPTURE(done.output.substr(done.output.size() > 2000 ? done.output.size() - 2000 : 0));
    CHECK(done.status == 0);
}

}  // namespace

TEST_CASE("TikZ: pdflatex sets the examples") {
    std::vector<std::string> charts;
    for (const ChartFiles& example : example_charts()) charts.push_back(example.chart);
    set_in_type(document_of_charts(charts));
}

TEST_CASE("TikZ: pdflatex sets random charts, whatever the names") {
    RandomSource random(4);
    std::vector<std::string> charts;
    for (int i = 0; i < 20; ++i) charts.push_back(random_grafcet(random, Features()));
    charts.emplace_back(
        "input \"a_b%c&d#e$f{g}h\\\\i^j~k<l>m|n\", \"--,,``''\", \"ŝ β 漢\"\ngraph G {\n initial "
        "1\n step 2\n"
        "1 -> 2 : \"a_b%c&d#e$f{g}h\\\\i^j~k<l>m|n\" . \"--,,``''\"\n2 -> 1 : /\"ŝ β 漢\"\n}\n");
    set_in_type(document_of_charts(charts));
}

TEST_CASE("TikZ: pdflatex sets schematics of every style, in both kinds of symbols, with values") {
    std::vector<std::vector<Sheet>> drawings;
    for (const char* name : {"single-sequence", "rule-5", "manipulator"}) {
        const auto grafcet = read_grafcet(example_text(std::string(name) + ".grafcet"));
        REQUIRE(grafcet);
        for (const StyleRow& row : style_table) {
            Diagnostics diagnostics;
            const auto netlist =
                netlist_from(*grafcet, equations_from(*grafcet, {row.default_cdx, true}), row.style,
                             diagnostics);
            if (!netlist && row.style == Style::handshake) continue;  // a source on a level
            REQUIRE(netlist);
            SchematicDrawing how;
            how.title = std::string(row.name);
            drawings.push_back(draw_schematic(*netlist, how));
            how.shapes = GateShapes::us;
            for (std::size_t net = 0; net < netlist->net_count(); ++net) {
                how.values.push_back(static_cast<Logic>(net % 3));
            }
            drawings.push_back(draw_schematic(*netlist, how));
        }
    }
    set_in_type(document_of(drawings));
}

}  // namespace grafwire::testing
