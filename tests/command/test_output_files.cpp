// An output file appears whole or not at all.

#include <doctest/doctest.h>

#include <filesystem>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("-o holds what would go to standard output, and - is standard output") {
    const std::vector<std::vector<std::string>> requests{
        {"equations", rule_5_chart, "--to", "csv"},
        {"run", rule_5_chart, rule_5_stimuli},
        {"netlist", rule_5_chart, "--style", "nand", "--to", "verilog"},
        {"simulate", rule_5_chart, rule_5_stimuli, "--style", "nand"},
        {"check", rule_5_chart, "--style", "nand", "--to", "json"},
    };
    for (const std::vector<std::string>& request : requests) {
        INFO("command: " << request.front());
        const Ran shown = grafwire_with(request);
        CHECK(shown.status == 0);
        CHECK(!shown.out.empty());
        const ScratchFolder folder;
        std::vector<std::string> with_file = request;
        with_file.insert(with_file.end(), {"-o", folder.path("out")});
        const Ran written = grafwire_with(with_file);
        CHECK(written.status == 0);
        CHECK(written.out.empty());
        CHECK(folder.names() == Names{"out"});
        CHECK(text_of(folder.path("out")) == shown.out);
        with_file.back() = "-";
        CHECK(grafwire_with(with_file).out == shown.out);
    }
}

TEST_CASE("an existing file is replaced, and a link to it stays a link") {
    const ScratchFolder folder;
    const std::string file = folder.file("trace.csv", "something else, and longer than the trace");
    std::filesystem::create_symlink(file, folder.path("link"));
    const std::string trace = grafwire_with({"run", rule_5_chart, rule_5_stimuli}).out;
    CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", folder.path("link")}).status ==
          0);
    CHECK(text_of(file) == trace);
    CHECK(std::filesystem::is_symlink(folder.path("link")));
    CHECK(folder.names() == Names{"link", "trace.csv"});
}

TEST_CASE("a device is written to, never replaced") {
    const ScratchFolder folder;
    const std::string pipe = folder.path("pipe");
    const std::string copy = folder.path("copy");
    const Ran ran = run_program({"sh", "-c",
                                 "mkfifo " + pipe + " && { cat " + pipe + " >" + copy +
                                     " & } && '" + GRAFWIRE_PROGRAM + "' run " + rule_5_chart +
                                     " " + rule_5_stimuli + " -o " + pipe + " && wait"});
    CHECK(ran.status == 0);
    CHECK(std::filesystem::is_fifo(pipe));
    CHECK(text_of(copy) == grafwire_with({"run", rule_5_chart, rule_5_stimuli}).out);
}

TEST_CASE("an error leaves existing files as they were") {
    const ScratchFolder folder;
    const std::string bad = folder.file("bad.grafcet", "graph G { initial 0\n 0 -> 1 : 1 }\n");
    const std::string out = folder.file("out", "kept");
    const std::string vcd = folder.file("vcd", "kept too");
    for (const std::vector<std::string>& request : std::vector<std::vector<std::string>>{
             {"equations", bad, "-o", out},
             {"run", bad, rule_5_stimuli, "-o", out, "--vcd", vcd},
             {"run", rule_5_chart, bad, "-o", out, "--vcd", vcd},
             {"netlist", bad, "--style", "nand", "--to", "blif", "-o", out},
             {"simulate", bad, rule_5_stimuli, "--style", "nand", "-o", out, "--vcd", vcd},
             {"check", bad, "--style", "nand", "-o", out}}) {
        INFO("command: " << request.front());
        CHECK(grafwire_with(request).status == 2);
        CHECK(text_of(out) == "kept");
        CHECK(text_of(vcd) == "kept too");
    }
    CHECK(folder.names() == Names{"bad.grafcet", "out", "vcd"});
}

TEST_CASE("a place that cannot be written to") {
    const ScratchFolder folder;
    const std::string no_folder = folder.path("none/out");
    const std::string in_a_file = folder.file("file", "text") + "/out";
    for (const std::string& place : {no_folder, in_a_file}) {
        for (const std::vector<std::string>& request : std::vector<std::vector<std::string>>{
                 {"equations", rule_5_chart, "-o", place},
                 {"run", rule_5_chart, rule_5_stimuli, "-o", place},
                 {"netlist", rule_5_chart, "--style", "nand", "--to", "blif", "-o", place},
                 {"simulate", rule_5_chart, rule_5_stimuli, "--style", "nand", "-o", place},
                 {"check", rule_5_chart, "--style", "nand", "-o", place}}) {
            INFO("command: " << request.front());
            const Ran ran = grafwire_with(request);
            CHECK(ran.status == 2);
            CHECK(ran.out.empty());
            CHECK(contains(ran.err, "cannot write " + place));
        }
    }
    CHECK(folder.names() == Names{"file"});
    CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "-o", "/dev/full"}).status == 2);
    const Ran to_full = run_program({"sh", "-c",
                                     "'" + std::string(GRAFWIRE_PROGRAM) + "' run " + rule_5_chart +
                                         " " + rule_5_stimuli + " >/dev/full"});
    CHECK(to_full.status == 2);
    CHECK(contains(to_full.err, "standard output"));
}

TEST_CASE("of several outputs none appears where one cannot be written") {
    const ScratchFolder folder;
    const std::string csv = folder.path("trace.csv");
    std::filesystem::create_directory(folder.path("folder"));
    for (const std::string& vcd : {folder.path("none/out.vcd"), folder.path("folder"), csv}) {
        INFO("waveform: " << vcd);
        for (const std::vector<std::string>& request : std::vector<std::vector<std::string>>{
                 {"run", rule_5_chart, rule_5_stimuli, "-o", csv, "--vcd", vcd},
                 {"run", rule_5_chart, rule_5_stimuli, "-o", vcd, "--vcd", csv},
                 {"simulate", rule_5_chart, rule_5_stimuli, "--style", "nand", "-o", csv, "--vcd",
                  vcd}}) {
            const Ran ran = grafwire_with(request);
            CHECK(ran.status == 2);
            CHECK(contains(ran.err, "cannot write " + vcd));
            CHECK(folder.names() == Names{"folder"});
        }
        // Nor does anything go to standard output.
        if (vcd != csv)
            CHECK(grafwire_with({"run", rule_5_chart, rule_5_stimuli, "--vcd", vcd}).out.empty());
    }
}

TEST_CASE("a witness that cannot be written is no answer") {
    const ScratchFolder folder;
    const std::string place = folder.file("file", "text") + "/witness";
    const Ran ran = grafwire_with({"check", rule_5_chart, "--style", "nor", "--witness", place,
                                   "--to", "json", "-o", folder.path("report.json")});
    CHECK(ran.status == 2);
    CHECK(contains(ran.err, "cannot write " + place));
    CHECK(folder.names() == Names{"file"});
}

}  // namespace grafwire::testing
