// An option that has no effect with what was asked for is refused, with what it is for: every
// option of every command, in every context in which it is idle; and in the others it is not.

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "command/charts.h"
#include "support/run_program.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

/// A request, and the options that change nothing in it.
struct Context {
    std::vector<std::string> request;
    std::set<std::string> idle;
};

/// The options of a command as its help lists them, but for help itself.
std::set<std::string> options_of(const std::vector<std::string>& command) {
    std::vector<std::string> arguments = command;
    arguments.push_back("--help");
    std::istringstream help(grafwire_with(arguments).out);
    std::set<std::string> options;
    for (std::string line; std::getline(help, line);) {
        if (line.rfind("  -", 0) != 0) continue;
        std::string option = line.substr(2, line.find(' ', 2) - 2);
        option = option.substr(option.rfind(',') + 1);
        if (option != "--help" && option != "--lang") options.insert(option);
    }
    return options;
}

/// The files that the contexts need.
class Files {
  public:
    Files() {
        const std::string text =
            grafwire_with({"netlist", sequence_chart, "--style", "nand", "--to", "blif"}).out;
        folder_.file("init.blif", text);
        folder_.file(
            "clocked.blif",
            grafwire_with({"netlist", sequence_chart, "--style", "clocked", "--to", "blif"}).out);
        folder_.file("bare.blif",
                     ".model bare\n.inputs m a b\n.outputs X0 X1 X2\n"
                     ".names X2 b X1 X0 X0\n11-- 1\n--01 1\n"
                     ".names X0 m X2 X1 X1\n11-- 1\n--01 1\n"
                     ".names X1 a X0 X2 X2\n11-- 1\n--01 1\n.end\n");
        folder_.file("ladder.xml", grafwire_with({"plc", sequence_chart, "--to", "plcopen"}).out);
        const Ran listing = grafwire_with({"plc", sequence_chart, "--to", "s7-200", "--addresses",
                                           folder_.path("a.io"), "-o", folder_.path("a.awl")});
        CHECK(listing.status == 0);
        folder_.file("init.delays", "* 2\n");
        folder_.file("by-address.stim", "0ms : E0.0=1\n+1ms : end\n");
    }
    std::string path(const std::string& name) const { return folder_.path(name); }

  private:
    ScratchFolder folder_;
};

/// A value that can be written after each option; flags have none.
using Values = std::map<std::string, std::vector<std::string>>;

/// Under the sanitizers every third context is tried: whether an option is idle is looked up in the
/// same tables in all of them, and the other builds try each.
constexpr std::size_t every_so_many = is_slow_build ? 3 : 1;

/// Every option of the command, in every context.
void try_all(const std::vector<std::string>& command, const Values& values,
             const std::vector<Context>& contexts) {
    const std::set<std::string> options = options_of(command);
    std::set<std::string> known;
    for (const auto& [option, value] : values) known.insert(option);
    // An option that this table does not know shows here.
    CHECK(options == known);
    for (std::size_t i = 0; i < contexts.size(); i += every_so_many) {
        const Context& context = contexts[i];
        std::vector<std::string> request = command;
        request.insert(request.end(), context.request.begin(), context.request.end());
        std::ostringstream shown;
        for (const std::string& word : request) shown << ' ' << word;
        INFO("request: " << shown.str());
        for (const auto& [name, value] : values) {
            const std::string option(name);  // a binding cannot be captured by INFO
            if (std::count(request.begin(), request.end(), option) != 0) continue;
            INFO("option: " << option);
            std::vector<std::string> arguments = request;
            arguments.push_back(option);
            arguments.insert(arguments.end(), value.begin(), value.end());
            const Ran ran = grafwire_with(arguments);
            const bool is_refused = contains(ran.err, option + " has no effect here: ") ||
                                    contains(ran.err, " has no " + option + "; it is for ");
            CHECK(is_refused == (context.idle.count(option) != 0));
            if (is_refused) {
                CHECK(ran.status == 2);
                CHECK(ran.out.empty());
            }
        }
    }
}

}  // namespace

TEST_CASE("options of equations and of run") {
    const Files files;
    std::vector<Context> contexts;
    for (const std::string form : {"text", "markdown", "json"}) {
        contexts.push_back({{sequence_chart, "--to", form}, {"--standalone"}});
    }
    contexts.push_back({{sequence_chart, "--to", "latex"}, {}});
    contexts.push_back({{sequence_chart, "--to", "csv"}, {"--karnaugh", "--standalone"}});
    try_all({"equations"},
            {{"--cdx", {"transition"}},
             {"--modes", {"off"}},
             {"--to", {"text"}},
             {"--karnaugh", {}},
             {"--standalone", {}},
             {"--strict", {}},
             {"-o", {files.path("out")}}},
            contexts);
    try_all({"run"},
            {{"--scan", {"10ms"}},
             {"--explain", {}},
             {"--to", {"svg"}},
             {"--strict", {}},
             {"--vcd", {files.path("vcd")}},
             {"-o", {files.path("out")}}},
            {{{sequence_chart, sequence_stimuli}, {}},
             {{sequence_chart}, {"--explain", "--to", "--vcd", "-o"}}});
    try_all({"info"}, {{"--to", {"sarif"}}, {"--strict", {}}, {"-o", {files.path("out")}}},
            {{{sequence_chart}, {}}, {{sequence_chart, "--to", "sarif"}, {}}});
}

TEST_CASE("options of draw") {
    const Files files;
    try_all({"draw"},
            {{"--at", {"0"}},
             {"--to", {"svg"}},
             {"--notation", {"slash"}},
             {"--paper", {"a3"}},
             {"--standalone", {}},
             {"--strict", {}},
             {"-o", {files.path("out")}}},
            {{{sequence_chart}, {"--at", "--standalone"}},
             {{sequence_chart, sequence_stimuli, "--at", "0"}, {"--standalone"}},
             {{sequence_chart, "--to", "tikz"}, {"--at"}}});
}

TEST_CASE("options of netlist") {
    const Files files;
    std::vector<Context> contexts;
    for (const std::string style : {"gates", "nand", "nor"}) {
        for (const std::string format : {"blif", "json", "dot", "stats", "text"}) {
            contexts.push_back({{sequence_chart, "--style", style, "--to", format},
                                {"--scan", "--stim", "--bench"}});
        }
        contexts.push_back({{sequence_chart, "--style", style, "--to", "verilog"},
                            {"--scan", "--stim", "--bench"}});
        contexts.push_back(
            {{sequence_chart, "--style", style, "--to", "spice"}, {"--scan", "--bench"}});
    }
    contexts.push_back(
        {{sequence_chart, "--style", "clocked", "--to", "blif"}, {"--scan", "--stim", "--bench"}});
    contexts.push_back(
        {{sequence_chart, "--style", "clocked", "--to", "verilog"}, {"--stim", "--bench"}});
    contexts.push_back({{sequence_chart, "--style", "clocked", "--to", "spice"}, {"--bench"}});
    // A bench needs stimuli and a file to stand beside; a deck is its own.
    const std::string out = files.path("n.v");
    contexts.push_back(
        {{sequence_chart, "--style", "nand", "--to", "verilog", "--stim", sequence_stimuli},
         {"--scan", "--bench"}});
    contexts.push_back({{sequence_chart, "--style", "nand", "--to", "verilog", "--stim",
                         sequence_stimuli, "--bench", "-o", out},
                        {"--scan"}});
    contexts.push_back({{sequence_chart, "--style", "clocked", "--to", "verilog", "--stim",
                         sequence_stimuli, "--bench", "-o", out},
                        {}});
    contexts.push_back(
        {{sequence_chart, "--style", "nand", "--to", "spice", "--stim", sequence_stimuli},
         {"--scan"}});
    // What drawings heed, texts do not.
    for (Context& context : contexts) {
        context.idle.insert({"--at", "--symbols", "--paper", "--standalone"});
    }
    contexts.push_back({{sequence_chart, "--style", "nand", "--to", "svg"},
                        {"--scan", "--stim", "--bench", "--at", "--standalone"}});
    contexts.push_back({{sequence_chart, "--style", "clocked", "--to", "tikz"},
                        {"--scan", "--stim", "--bench", "--at"}});
    contexts.push_back({{sequence_chart, "--style", "clocked", "--to", "svg", "--stim",
                         sequence_stimuli, "--at", "0"},
                        {"--scan", "--bench", "--standalone"}});
    // Only one style depends on the order of clearing.
    for (Context& context : contexts) context.idle.insert("--interlock");
    contexts.push_back(
        {{sequence_chart, "--style", "handshake", "--to", "blif"},
         {"--scan", "--stim", "--bench", "--at", "--symbols", "--paper", "--standalone"}});
    try_all({"netlist"},
            {{"--style", {"nand"}},
             {"--cdx", {"transition"}},
             {"--modes", {"off"}},
             {"--interlock", {}},
             {"--to", {"blif"}},
             {"--stim", {sequence_stimuli}},
             {"--bench", {}},
             {"--scan", {"10ms"}},
             {"--at", {"0"}},
             {"--symbols", {"us"}},
             {"--paper", {"a3"}},
             {"--standalone", {}},
             {"--strict", {}},
             {"-o", {files.path("out")}}},
            contexts);
}

TEST_CASE("options of simulate") {
    const Files files;
    std::vector<Context> contexts{
        {{sequence_chart, sequence_stimuli}, {"--power-up", "--scan", "--zoom"}},
        {{sequence_chart, sequence_stimuli, "--against", files.path("init.blif")},
         {"--style", "--cdx", "--modes", "--power-up", "--scan", "--zoom"}},
        {{sequence_chart, sequence_stimuli, "--against", files.path("bare.blif")},
         {"--style", "--cdx", "--modes", "--scan", "--zoom"}},
        {{sequence_chart, sequence_stimuli, "--against", files.path("clocked.blif")},
         {"--style", "--cdx", "--modes", "--power-up", "--delays", "--zoom"}},
        {{sequence_chart, sequence_stimuli, "--style", "clocked"},
         {"--power-up", "--delays", "--zoom"}},
        {{sequence_chart, sequence_stimuli, "--to", "svg"}, {"--power-up", "--scan"}},
        {{sequence_chart, sequence_stimuli, "--to", "wavedrom"}, {"--power-up", "--scan"}}};
    for (Context& context : contexts) context.idle.insert("--interlock");
    contexts.push_back({{sequence_chart, sequence_stimuli, "--style", "handshake"},
                        {"--power-up", "--scan", "--zoom"}});
    try_all({"simulate"},
            {{"--style", {"nand"}},
             {"--cdx", {"transition"}},
             {"--modes", {"off"}},
             {"--interlock", {}},
             {"--against", {files.path("init.blif")}},
             {"--power-up", {"initial"}},
             {"--delay", {"unit"}},
             {"--delays", {files.path("init.delays")}},
             {"--scan", {"10ms"}},
             {"--explain", {}},
             {"--zoom", {"0"}},
             {"--strict", {}},
             {"--to", {"svg"}},
             {"--vcd", {files.path("vcd")}},
             {"-o", {files.path("out")}}},
            contexts);
}

TEST_CASE("options of check") {
    const Files files;
    const std::set<std::string> of_programs{"--style",   "--cdx",      "--modes",     "--delay",
                                            "--changes", "--power-up", "--tolerance", "--pulses"};
    const auto with = [](std::set<std::string> some, const std::set<std::string>& more) {
        some.insert(more.begin(), more.end());
        return some;
    };
    const std::set<std::string> of_netlists{"--program", "--io", "--cpu"};
    const std::set<std::string> of_elsewhere = with(of_netlists, {"--style", "--cdx", "--modes"});
    std::vector<Context> contexts{
        {{sequence_chart}, with(of_netlists, {"--power-up", "--scan"})},
        {{sequence_chart, "--style", "clocked"},
         with(of_netlists, {"--power-up", "--changes", "--delay", "--tolerance", "--pulses"})},
        {{sequence_chart, "--against", files.path("init.blif")},
         with(of_elsewhere, {"--power-up", "--scan"})},
        {{sequence_chart, "--against", files.path("bare.blif")}, with(of_elsewhere, {"--scan"})},
        {{sequence_chart, "--against", files.path("clocked.blif")},
         with(of_elsewhere, {"--power-up", "--changes", "--delay", "--tolerance", "--pulses"})},
        {{sequence_chart, "--against", files.path("ladder.xml")},
         with(of_programs, {"--io", "--cpu"})},
        {{sequence_chart, "--against", files.path("a.awl"), "--io", files.path("a.io")},
         with(of_programs, {"--program"})}};
    for (const std::string style : {"gates", "nor"}) {
        contexts.push_back(
            {{sequence_chart, "--style", style}, with(of_netlists, {"--power-up", "--scan"})});
    }
    // What any of several checks heeds has an effect.
    contexts.push_back(
        {{sequence_chart, "--style", "nand,clocked"}, with(of_netlists, {"--power-up"})});
    for (Context& context : contexts) context.idle.insert("--interlock");
    contexts.push_back(
        {{sequence_chart, "--style", "handshake"}, with(of_netlists, {"--power-up", "--scan"})});
    try_all({"check"},
            {{"--style", {"nand"}},
             {"--cdx", {"transition"}},
             {"--modes", {"off"}},
             {"--interlock", {}},
             {"--delay", {"unit"}},
             {"--against", {files.path("init.blif")}},
             {"--program", {"p"}},
             {"--io", {files.path("a.io")}},
             {"--changes", {"many"}},
             {"--power-up", {"initial"}},
             {"--scan", {"10ms"}},
             {"--cpu", {"212"}},
             {"--to", {"json"}},
             {"-o", {files.path("out")}},
             {"--witness", {files.path("w")}},
             {"--tolerance", {}},
             {"--pulses", {}},
             {"--assume", {"m + /m"}},
             {"--max-cases", {"5"}},
             {"--max-seconds", {"1"}},
             {"--max-memory", {"1G"}},
             {"--shard", {"1/2"}},
             {"--strict", {}},
             {"-j", {"2"}}},
            contexts);
}

TEST_CASE("options of plc and of s7 run") {
    const Files files;
    const std::set<std::string> of_listings{"--io",      "--addresses", "--mnemonics",
                                            "--offsets", "--tables",    "--cpu"};
    std::vector<Context> contexts{{{sequence_chart, "--to", "s7-200"}, {"--pull-up"}},
                                  {{sequence_chart, "--to", "stl"},
                                   {"--addresses", "--offsets", "--tables", "--cpu", "--pull-up"}},
                                  {{sequence_chart, "--to", "arduino"}, of_listings}};
    std::set<std::string> all = of_listings;
    all.insert("--pull-up");
    for (const std::string format : {"text", "il", "ladder", "ladder-svg", "pl7-2", "plcopen",
                                     "sfc", "st", "c", "pascal", "python"}) {
        contexts.push_back({{sequence_chart, "--to", format}, all});
    }
    try_all({"plc"},
            {{"--to", {"c"}},
             {"--modes", {"off"}},
             {"--io", {files.path("a.io")}},
             {"--addresses", {files.path("addresses")}},
             {"--mnemonics", {"iec"}},
             {"--offsets", {"off"}},
             {"--tables", {"wide"}},
             {"--cpu", {"212"}},
             {"--pull-up", {}},
             {"--strict", {}},
             {"-o", {files.path("out")}}},
            contexts);
    try_all(
        {"s7", "run"},
        {{"--stim", {files.path("by-address.stim")}},
         {"--scan", {"10ms"}},
         {"--io", {files.path("a.io")}},
         {"--cpu", {"212"}},
         {"--grafcet", {sequence_chart}},
         {"--vcd", {files.path("vcd")}},
         {"-o", {files.path("out")}}},
        {{{files.path("a.awl"), "--stim", files.path("by-address.stim"), "--scan", "10ms"}, {}}});
}

TEST_CASE("the refusal says what the option is for, and is in the JUnit report") {
    CHECK(grafwire_with({"check", sequence_chart, "--cpu", "212"}).err ==
          "grafwire: error: --cpu has no effect here: it is for an S7-200 listing given with "
          "--against\n");
    CHECK(grafwire_with(
              {"netlist", sequence_chart, "--style", "clocked", "--to", "blif", "--scan", "1h"})
              .err == "grafwire: error: blif has no --scan; it is for verilog, spice\n");
    const Ran ran = grafwire_with({"check", sequence_chart, "--scan", "1h", "--to", "junit"});
    CHECK(ran.status == 2);
    CHECK(contains(ran.out, "--scan has no effect here: nothing is scanned"));
}

}  // namespace grafwire::testing
