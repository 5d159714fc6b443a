// grafwire draw: what it writes, the moment it shows, and what it refuses.

#include <doctest/doctest.h>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// What is said of a request that is refused; nothing is written.
std::string refused_drawing(const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"draw", sequence_chart};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ran ran = grafwire_with(arguments);
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    return ran.err;
}

}  // namespace

TEST_CASE("a chart is drawn as SVG, or as TikZ, alone or as a document") {
    const Ran svg = grafwire_with({"draw", sequence_chart});
    CHECK(svg.status == 0);
    CHECK(svg.err.empty());
    CHECK(svg.out.rfind("<svg ", 0) == 0);
    CHECK(contains(svg.out, "<title id=\"title\">Séquence unique</title>"));
    const Ran tikz = grafwire_with({"draw", sequence_chart, "--to", "tikz"});
    CHECK(contains(tikz.out, "\\begin{tikzpicture}"));
    CHECK(!contains(tikz.out, "\\documentclass"));
    const Ran document = grafwire_with({"draw", sequence_chart, "--to", "tikz", "--standalone"});
    CHECK(contains(document.out, "\\documentclass[a4paper]{article}"));
    const Ran french = grafwire_with({"draw", sequence_chart, "--lang", "fr"});
    CHECK(contains(french.out, "<title>étape 0</title>"));
}

TEST_CASE("NOT is a line over what it complements, or a stroke before it") {
    const std::string chart =
        "input a\ngraph G { initial 0\n step 1\n 0 -> 1 : /a\n 1 -> 0 : a }\n";
    CHECK(contains(grafwire_with({"draw", "-"}, chart).out, "<tspan class=\"over\">a</tspan>"));
    CHECK(contains(grafwire_with({"draw", "-", "--notation", "slash"}, chart).out, ">/a<"));
}

TEST_CASE("the situation of a moment: active steps, and what they enable") {
    const std::string chart =
        "input a\ngraph G { initial 0\n step 1\n 0 -> 1 : 2s/a\n 1 -> 0 : /a }\n";
    const ScratchFolder folder;
    const std::string stimuli = folder.file("a.stim", "1s : a=1\n5s : end\n");
    const auto drawn_at = [&](const std::string& at) {
        const Ran ran = grafwire_with({"draw", "-", stimuli, "--at", at}, chart);
        CHECK(ran.status == 0);
        return ran.out;
    };
    for (const std::string at : {"0", "1s", "2999ms"}) {
        CHECK(contains(drawn_at(at), "step initial active\" data-step=\"0\""));
        CHECK(contains(drawn_at(at), "transition enabled\" data-transition=\"(0)\""));
    }
    for (const std::string at : {"3s", "4s", "1h"}) {
        CHECK(contains(drawn_at(at), "step active\" data-step=\"1\""));
        CHECK(contains(drawn_at(at), "transition enabled\" data-transition=\"(1)\""));
    }
    CHECK(contains(drawn_at("1500ms"), "situation at 1.5s"));
}

TEST_CASE("a run, and a simulation, as a timing diagram") {
    const Ran svg = grafwire_with({"run", sequence_chart, sequence_stimuli, "--to", "svg"});
    CHECK(svg.status == 0);
    CHECK(contains(svg.out, "class=\"signal\" data-signal=\"X0\""));
    const std::vector<std::string> request{"simulate", sequence_chart, sequence_stimuli,
                                           "--style",  "nand",         "--to"};
    for (const std::string format : {"svg", "wavedrom"}) {
        std::vector<std::string> arguments = request;
        arguments.push_back(format);
        const Ran run = grafwire_with({"run", sequence_chart, sequence_stimuli, "--to", format});
        CHECK(grafwire_with(arguments).out == run.out);
    }
    const Ran refused = grafwire_with({"run", sequence_chart, sequence_stimuli, "--to", "png"});
    CHECK(refused.status == 2);
    CHECK(contains(refused.err, "there is no format 'png'; there are: csv, svg, wavedrom"));
}

TEST_CASE("a netlist is drawn as a schematic, with the values of a moment") {
    const auto drawn = [](const std::string& style, const std::vector<std::string>& options) {
        std::vector<std::string> arguments{"netlist", sequence_chart, "--style", style, "--to"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Ran ran = grafwire_with(arguments);
        CHECK(ran.status == 0);
        return ran.out;
    };
    CHECK(contains(drawn("nand", {"svg"}), "class=\"module step\" data-module=\"X0\""));
    CHECK(contains(drawn("nand", {"svg"}), ">&amp;</text>"));
    CHECK(!contains(drawn("nand", {"svg", "--symbols", "us"}), ">&amp;</text>"));
    CHECK(contains(drawn("gates", {"tikz", "--standalone"}), "\\documentclass"));
    // Step 1 is active at 350ms and not before; where there is a clock, the scans follow at once.
    for (const std::string style : {"gates", "nand", "clocked"}) {
        const auto at = [&](const std::string& moment) {
            return drawn(style, {"svg", "--stim", sequence_stimuli, "--at", moment});
        };
        CHECK(contains(at("250ms"), "<title>X1 = 0</title>"));
        CHECK(contains(at("350ms"), "<title>X1 = 1</title>"));
        CHECK(contains(at("350ms"), "class=\"net one\" data-net=\"X1\""));
        CHECK(contains(at("350ms"), "values at 350ms"));
    }
}

TEST_CASE("a moment without a stable situation, or that is none, is refused") {
    const std::string chart = "input a\ngraph G { initial 0\n step 1\n 0 -> 1 : a\n 1 -> 0 : a }\n";
    const ScratchFolder folder;
    const std::string stimuli = folder.file("a.stim", "0ms : a=0\n1s : a=1\n2s : end\n");
    const Ran ran = grafwire_with({"draw", "-", stimuli, "--at", "1s"}, chart);
    CHECK(ran.status == 2);
    CHECK(ran.out.empty());
    CHECK(contains(ran.err, "there is no stable situation at 1s"));
    CHECK(contains(refused_drawing({sequence_stimuli, "--at", "soon"}), "'soon' is no moment"));
    CHECK(contains(refused_drawing({sequence_stimuli}), "stimuli without --at change nothing"));
    CHECK(contains(refused_drawing({"--at", "1s"}), "it needs STIM"));
    CHECK(contains(refused_drawing({"--to", "pdf"}), "there is no format 'pdf'"));
}

}  // namespace grafwire::testing
