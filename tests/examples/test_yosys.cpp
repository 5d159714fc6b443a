// Yosys reads what is written for it, and finds nothing wrong with clocked netlists.

#include <doctest/doctest.h>

#include <algorithm>

#include "examples/example.h"
#include "formats/netlist_formats.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

/// Yosys reads no table of more than 12 inputs in a BLIF file.
bool has_wide_gate(const Netlist& netlist) {
    return std::any_of(netlist.cells.begin(), netlist.cells.end(),
                       [](const Cell& cell) { return cell.pin_count > 12; });
}

/// All examples in a style, each read by the commands that `script` gives for its file.
template <typename Script>
void read_all(const StyleRow& row, std::string_view format, Script script) {
    const NetlistFormat* written = netlist_format_named(format);
    REQUIRE(written != nullptr);
    const ScratchFolder folder;
    std::string commands;
    std::size_t count = 0;
    for (const Example& example : examples()) {
        const auto netlist = netlist_of(example.grafcet, row);
        if (!netlist || (format == "blif" && has_wide_gate(*netlist))) continue;
        const std::string text = write_netlist(*written, *netlist);
        const std::string file = example.name + std::string(written->extension);
        commands += "log ### " + file + "\n" + script(folder.file(file, text)) + "tee -a " +
                    folder.path("log") + " log read\ndesign -reset\n";
        ++count;
    }
    CHECK(count >= (row.style == Style::handshake ? 6 : 10));
    const Ran ran = run_program({"yosys", "-Q", "-T", "-s", folder.file("script", commands)});
    const std::size_t last = ran.out.rfind("###");
    INFO("Yosys stopped at: " << (last == std::string::npos ? ran.out : ran.out.substr(last)));
    INFO("standard error: " << ran.err);
    CHECK(ran.status == 0);
    // Nothing was skipped.
    std::size_t read = 0;
    const std::string log = text_of(folder.path("log"));
    for (std::size_t at = 0; (at = log.find("read", at)) != std::string::npos; ++at) ++read;
    CHECK(read == count);
}

}  // namespace

TEST_CASE("Yosys reads the Verilog of every example in every style") {
    for (const StyleRow& row : style_table) {
        INFO("style: " << row.name);
        read_all(row, "verilog", [](const std::string& file) {
            return "read_verilog " + file + "\nhierarchy -check -auto-top\nproc\nopt\n";
        });
    }
}

TEST_CASE("Yosys finds no loop, no conflict and no open net in clocked netlists") {
    read_all(style_table[static_cast<std::size_t>(Style::clocked)], "verilog",
             [](const std::string& file) {
                 return "read_verilog " + file +
                        "\nhierarchy -check -auto-top\nproc\nflatten\nopt\ncheck -assert\n";
             });
}

TEST_CASE("Yosys reads BLIF and JSON of every example in every style") {
    for (const StyleRow& row : style_table) {
        INFO("style: " << row.name);
        read_all(row, "blif",
                 [](const std::string& file) { return "read_blif " + file + "\nstat\n"; });
        read_all(row, "json",
                 [](const std::string& file) { return "read_json " + file + "\nstat\n"; });
    }
}

}  // namespace grafwire::testing
