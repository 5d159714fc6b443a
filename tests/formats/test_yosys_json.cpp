#include <doctest/doctest.h>

#include "formats/yosys/read_yosys_json.h"

using namespace grafwire;

namespace {

/// The netlist as text, or the first message.
std::string read_as_json(const std::string& text) {
    const SourceFile source{"x.json", text};
    Diagnostics diagnostics;
    const std::optional<Netlist> netlist = read_yosys_json(source, diagnostics);
    CHECK(netlist.has_value() != diagnostics.has_errors());
    for (const Diagnostic& item : diagnostics.items()) CHECK(item.where.is_known());
    if (!netlist) return diagnostics.items().front().message.english + '\n';
    CHECK(fault_of(*netlist) == "");
    return write_netlist_text(*netlist);
}

/// All that is said of a file, with its places.
std::string shown(const std::string& text) {
    const SourceFile source{"x.json", text};
    Diagnostics diagnostics;
    CHECK_FALSE(read_yosys_json(source, diagnostics).has_value());
    return format_diagnostics(diagnostics, source);
}

constexpr std::string_view ports = R"("ports": {
  "a": {"direction": "input", "bits": [2]}, "b": {"direction": "input", "bits": [3]},
  "c": {"direction": "input", "bits": [4]}, "d": {"direction": "input", "bits": [5]},
  "y": {"direction": "output", "bits": [6]}})";

std::string module_with(const std::string& cells, const std::string& net_names = "") {
    return R"({"modules": {"m": {)" + std::string(ports) + R"(, "cells": {)" + cells +
           R"(}, "netnames": {)" + net_names + "}}}}";
}

std::string cell(const std::string& type, const std::string& connections,
                 const std::string& parameters = "") {
    return R"("g": {"type": ")" + type + R"(", "parameters": {)" + parameters +
           R"(}, "connections": {)" + connections + "}}";
}

/// The cells that a Yosys cell becomes; a to d are bits 2 to 5, y is bit 6.
std::string cells_of_cell(const std::string& type, const std::string& connections,
                          const std::string& parameters = "") {
    const std::string text = read_as_json(module_with(cell(type, connections, parameters)));
    const std::string head =
        "netlist m\ninput a\ninput b\ninput c\ninput d\noutput y = y\nmodule m\n";
    if (!text.starts_with(head)) return text;
    return text.substr(head.size());
}

const std::string ab = R"("A": [2], "B": [3], "Y": [6])";
const std::string abcd = R"("A": [2], "B": [3], "C": [4], "D": [5], "Y": [6])";

}  // namespace

TEST_CASE("every cell knows the line at which it begins") {
    const std::string two = cell("$_ANDNOT_", ab) + ",\n\n" +
                            R"("h": {"type": "$_OR_", "connections": )"
                            "\n"
                            R"({"A": [2], "B": [3], "Y": [7]}})";
    const SourceFile source{"x.json", module_with(two)};
    Diagnostics diagnostics;
    const std::optional<Netlist> netlist = read_yosys_json(source, diagnostics);
    REQUIRE(netlist);
    // The ports take four lines before.
    for (const Cell& cell : netlist->cells) {
        CHECK(netlist->origin_of(cell).where.line == (cell.type == CellType::or_gate ? 6 : 4));
    }
    CHECK(netlist->cells.size() == 3);
}

TEST_CASE("gates") {
    CHECK(cells_of_cell("$_BUF_", R"("A": [2], "Y": [6])") == "  y = buf(a)\n");
    CHECK(cells_of_cell("$_NOT_", R"("A": [2], "Y": [6])") == "  y = not(a)\n");
    CHECK(cells_of_cell("$_AND_", ab) == "  y = and(a, b)\n");
    CHECK(cells_of_cell("$_NAND_", ab) == "  y = nand(a, b)\n");
    CHECK(cells_of_cell("$_OR_", ab) == "  y = or(a, b)\n");
    CHECK(cells_of_cell("$_NOR_", ab) == "  y = nor(a, b)\n");
    CHECK(cells_of_cell("$_XOR_", ab) == "  y = xor(a, b)\n");
    CHECK(cells_of_cell("$_XNOR_", ab) == "  y$1 = xor(a, b)\n  y = not(y$1)\n");
    CHECK(cells_of_cell("$_ANDNOT_", ab) == "  b$1 = not(b)\n  y = and(a, b$1)\n");
    CHECK(cells_of_cell("$_ORNOT_", ab) == "  b$1 = not(b)\n  y = or(a, b$1)\n");
    CHECK(cells_of_cell("$_MUX_", R"("A": [2], "B": [3], "S": [4], "Y": [6])") ==
          "  c$1 = not(c)\n  y$1 = and(a, c$1)\n  y$2 = and(b, c)\n  y = or(y$1, y$2)\n");
    CHECK(cells_of_cell("$_NMUX_", R"("A": [2], "B": [3], "S": [4], "Y": [6])") ==
          "  c$1 = not(c)\n  y$1 = and(a, c$1)\n  y$2 = and(b, c)\n  y = nor(y$1, y$2)\n");
    CHECK(cells_of_cell("$_AOI3_", abcd) == "  y$1 = and(a, b)\n  y = nor(y$1, c)\n");
    CHECK(cells_of_cell("$_OAI3_", abcd) == "  y$1 = or(a, b)\n  y = nand(y$1, c)\n");
    CHECK(cells_of_cell("$_AOI4_", abcd) ==
          "  y$1 = and(a, b)\n  y$2 = and(c, d)\n  y = nor(y$1, y$2)\n");
    CHECK(cells_of_cell("$_OAI4_", abcd) ==
          "  y$1 = or(a, b)\n  y$2 = or(c, d)\n  y = nand(y$1, y$2)\n");
}

TEST_CASE("word-level cells of one bit") {
    CHECK(cells_of_cell("$not", R"("A": [2], "Y": [6])") == "  y = not(a)\n");
    CHECK(cells_of_cell("$and", ab) == "  y = and(a, b)\n");
    CHECK(cells_of_cell("$or", ab) == "  y = or(a, b)\n");
    CHECK(cells_of_cell("$xor", ab) == "  y = xor(a, b)\n");
    for (const char* type : {"$buf", "$pos"}) {
        CHECK(cells_of_cell(type, R"("A": [2], "Y": [6])") == "  y = buf(a)\n");
    }
    CHECK(cells_of_cell("$reduce_xnor", R"("A": [2, 3, 4], "Y": [6])") ==
          "  y$1 = xor(a, b, c)\n  y = not(y$1)\n");
    // Of these each bit would have a gate of its own.
    for (const char* type : {"$buf", "$pos", "$not", "$and", "$or", "$xor", "$xnor"}) {
        CHECK(cells_of_cell(type, R"("A": [2, 3], "B": [4], "Y": [6])")
                  .starts_with("cell 'g' of type "));
    }
    CHECK(cells_of_cell("$xnor", ab) == "  y$1 = xor(a, b)\n  y = not(y$1)\n");
    CHECK(cells_of_cell("$reduce_and", R"("A": [2, 3, 4], "Y": [6])") == "  y = and(a, b, c)\n");
    CHECK(cells_of_cell("$reduce_or", R"("A": [2, 3, 4], "Y": [6])") == "  y = or(a, b, c)\n");
    CHECK(cells_of_cell("$reduce_bool", R"("A": [2, 3, 4], "Y": [6])") == "  y = or(a, b, c)\n");
    CHECK(cells_of_cell("$reduce_xor", R"("A": [2, 3, 4], "Y": [6])") == "  y = xor(a, b, c)\n");
    CHECK(cells_of_cell("$logic_not", R"("A": [2, 3, 4], "Y": [6])") == "  y = nor(a, b, c)\n");
    CHECK(cells_of_cell("$logic_or", R"("A": [2, 3], "B": [4], "Y": [6])") ==
          "  y = or(a, b, c)\n");
    CHECK(cells_of_cell("$logic_and", R"("A": [2, 3], "B": [4], "Y": [6])") ==
          "  y$1 = or(a, b)\n  y = and(y$1, c)\n");
    CHECK(cells_of_cell("$ne", ab) == "  y = xor(a, b)\n");
    CHECK(cells_of_cell("$eq", ab) == "  y$1 = xor(a, b)\n  y = not(y$1)\n");
    CHECK(cells_of_cell("$ne", R"("A": [2, 3], "B": ["1", "1"], "Y": [6])") ==
          "  y = nand(a, b)\n");
    CHECK(cells_of_cell("$eq", R"("A": ["0", 3], "B": [2, "1"], "Y": [6])") ==
          "  a$1 = not(a)\n  y = and(a$1, b)\n");
    CHECK(cells_of_cell("$eq", R"("A": ["0", "1"], "B": ["1", 2], "Y": [6])") ==
          "  net$1 = high()\n  net$2 = low()\n  y = and(net$2, a)\n");
    CHECK(cells_of_cell("$eq", R"("A": [2, 3], "B": [4, 5], "Y": [6])") ==
          "  y$1 = xor(a, c)\n  y$1$1 = not(y$1)\n  y$2 = xor(b, d)\n  y$2$1 = not(y$2)\n"
          "  y = and(y$1$1, y$2$1)\n");
}

TEST_CASE("look-up tables") {
    const std::string pins = R"("A": [2, 3], "Y": [6])";
    CHECK(cells_of_cell("$lut", pins, R"("LUT": "1000")") == "  y = and(a, b)\n");
    CHECK(cells_of_cell("$lut", pins, R"("LUT": "0111")") == "  y = nand(a, b)\n");
    CHECK(cells_of_cell("$lut", pins, R"("LUT": "1110")") == "  y = or(a, b)\n");
    CHECK(cells_of_cell("$lut", pins, R"("LUT": "0001")") == "  y = nor(a, b)\n");
    CHECK(cells_of_cell("$lut", pins, R"("LUT": "0110")") == "  y = xor(a, b)\n");
    CHECK(cells_of_cell("$lut", pins, R"("LUT": "0010")") == "  b$1 = not(b)\n  y = and(a, b$1)\n");
    CHECK(cells_of_cell("$lut", R"("A": [2], "Y": [6])", R"("LUT": "01")") == "  y = not(a)\n");
    CHECK(cells_of_cell("$lut", pins, R"("LUT": "01")") ==
          "cell 'g' of type $lut: its table does not fit its inputs\n");
    CHECK(cells_of_cell("$lut", R"("Y": [6])", R"("LUT": "1")") ==
          "cell 'g' of type $lut: its port A is not connected\n");
}

TEST_CASE("constants") {
    // Both in one module, each made once.
    CHECK(
        cells_of_cell("$_AOI4_", R"("A": ["1"], "B": ["0"], "C": ["1"], "D": ["0"], "Y": [6])") ==
        "  net$1 = high()\n  net$2 = low()\n  y$1 = and(net$1, net$2)\n  y$2 = and(net$1, net$2)\n"
        "  y = nor(y$1, y$2)\n");
    CHECK(cells_of_cell("$_BUF_", R"("A": ["1"], "Y": [6])") == "  y = high()\n");
    CHECK(cells_of_cell("$_AND_", R"("A": [2], "B": ["0"], "Y": [6])") ==
          "  net$1 = low()\n  y = and(a, net$1)\n");
    for (const char* type : {"$_AND_", "$_BUF_", "$eq"}) {
        CHECK(cells_of_cell(type, R"("A": [2], "B": [3], "Y": ["1"])") ==
              "cell 'g' of type " + std::string(type) +
                  ": its output Y is connected to a constant\n");
    }
    CHECK(cells_of_cell("$_AND_", R"("A": [2], "B": ["x"], "Y": [6])") ==
          "cell 'g' of type $_AND_: port B is connected to 'x'\n");
    CHECK(read_as_json(
              R"({"modules": {"m": {"ports": {"y": {"direction": "output", "bits": ["1"]}}}}})") ==
          "netlist m\noutput y = y\nmodule m\n  y = high()\n");
}

TEST_CASE("memories") {
    const std::string pins = R"("D": [2], "C": [3], "Q": [6])";
    CHECK(cells_of_cell("$_DFF_P_", pins) == "  y = dff(a, b)\n");
    CHECK(cells_of_cell("$dff", R"("D": [2], "CLK": [3], "Q": [6])",
                        R"("CLK_POLARITY": 1, "WIDTH": 1)") == "  y = dff(a, b)\n");
    CHECK(cells_of_cell("$_DFFE_PN_", R"("D": [2], "C": [3], "E": [4], "Q": [6])") ==
          "  c$1 = not(c)\n  y$1 = and(a, c$1)\n  y$2 = and(y, c)\n  y$3 = or(y$1, y$2)\n"
          "  y = dff(y$3, b)\n");
    CHECK(cells_of_cell("$_SDFF_PP1_", R"("D": [2], "C": [3], "R": [4], "Q": [6])") ==
          "  y$1 = or(a, c)\n  y = dff(y$1, b)\n");
    CHECK(cells_of_cell("$_SDFF_PN0_", R"("D": [2], "C": [3], "R": [4], "Q": [6])") ==
          "  c$1 = not(c)\n  y$1 = and(a, c)\n  y = dff(y$1, b)\n");
    // With an enable: does the reset act without it?
    const std::string all = R"("D": [2], "C": [3], "R": [4], "E": [5], "Q": [6])";
    CHECK(cells_of_cell("$_SDFFE_PP0P_", all) ==
          "  y$1 = and(a, d)\n  d$1 = not(d)\n  y$2 = and(y, d$1)\n  y$3 = or(y$1, y$2)\n"
          "  c$1 = not(c)\n  y$4 = and(y$3, c$1)\n  y = dff(y$4, b)\n");
    CHECK(cells_of_cell("$_SDFFCE_PP0P_", all) ==
          "  c$1 = not(c)\n  y$1 = and(a, c$1)\n  y$2 = and(y$1, d)\n  d$1 = not(d)\n"
          "  y$3 = and(y, d$1)\n  y$4 = or(y$2, y$3)\n  y = dff(y$4, b)\n");
    CHECK(cells_of_cell("$_DLATCH_P_", R"("D": [2], "E": [3], "Q": [6])") == "  y = hold(a, b)\n");
    CHECK(cells_of_cell("$_DLATCH_N_", R"("D": [2], "E": [3], "Q": [6])") ==
          "  b$1 = not(b)\n  y = hold(a, b$1)\n");
    // The reset of Yosys's latches wins.
    CHECK(cells_of_cell("$_SR_PP_", R"("S": [2], "R": [3], "Q": [6])") ==
          "  b$1 = not(b)\n  y$1 = and(a, b$1)\n  y = latch(y$1, b)\n");
    CHECK(cells_of_cell("$_DFF_N_", pins) ==
          "cell 'g' of type $_DFF_N_: flip-flops on the falling edge are not "
          "supported\n");
    CHECK(cells_of_cell("$_DFF_PP0_", R"("D": [2], "C": [3], "R": [4], "Q": [6])") ==
          "cell 'g' of type $_DFF_PP0_: flip-flops with asynchronous set or reset "
          "are not "
          "supported\n");
    CHECK(cells_of_cell("$_DLATCH_PP0_", pins) ==
          "cell 'g' of type $_DLATCH_PP0_: latches with set or reset are not "
          "supported\n");
}

TEST_CASE("initial values belong to memories, else to nets") {
    const std::string flip_flop = cell("$_DFF_P_", R"("D": [2], "C": [3], "Q": [6])");
    const std::string names = R"("q": {"bits": [6], "attributes": {"init": "1"}})";
    CHECK(read_as_json(module_with(flip_flop, names)).ends_with("  y = dff(a, b) initially 1\n"));
    CHECK(read_as_json(module_with(cell("$_AND_", ab), names))
              .ends_with("  y = and(a, b)\ninitially y = 1\n"));
    // Of a word the last digit is that of bit 0.
    const std::string memories = R"("g": {"type": "$_DFF_P_",
        "connections": {"D": [2], "C": [3], "Q": [6]}}, "h": {"type": "$_DFF_P_",
        "connections": {"D": [6], "C": [3], "Q": [7]}})";
    // Digits beyond the bits of the net mean nothing.
    const std::string longer = R"("q": {"bits": [6], "attributes": {"init": "0001"}})";
    CHECK(read_as_json(module_with(flip_flop, longer)).ends_with("  y = dff(a, b) initially 1\n"));
    const std::string word = R"("q": {"bits": [6, 7], "attributes": {"init": "01"}})";
    CHECK(read_as_json(module_with(memories, word))
              .ends_with("  y = dff(a, b) initially 1\n  q[1] = dff(y, b) initially 0\n"));
}

TEST_CASE("black boxes") {
    CHECK(cells_of_cell("grafwire_timer", R"("a": [2], "q": [6])",
                        R"("RISE": "5s", "FALL": "20ms", "INIT": "0",
                      "ORDINAL": "00000000000000000000000000000011")") ==
          "  y = timer(a) rise 5s fall 20ms initially 0\n");
    CHECK(cells_of_cell("grafwire_latch", R"("s": [2], "r": [3], "q": [6])") ==
          "  y = latch(a, b)\n");
    CHECK(cells_of_cell("grafwire_timer", R"("a": [2], "q": [6])", R"("RISE": "5 s")") ==
          "cell 'g' of type grafwire_timer: its RISE is not valid: '5 s'\n");
}

TEST_CASE("what cannot be used is refused by name") {
    CHECK(cells_of_cell("$add", ab) ==
          "cell 'g' of type $add: cells of this type are not supported (Yosys: "
          "techmap; "
          "opt)\n");
    CHECK(cells_of_cell("adder", ab)
              .starts_with("cell 'g' of type adder: it is a module of its own; "
                           "flatten the netlist first\n"));
    CHECK(cells_of_cell("$and", R"("A": [2, 3], "B": [4, 5], "Y": [6])")
              .starts_with("cell 'g' of type $and: its port A has 2 bits; split "
                           "words into bits first (Yosys: "
                           "simplemap)\n"));
    CHECK(cells_of_cell("$_AND_", R"("A": [2], "Y": [6])")
              .starts_with("cell 'g' of type $_AND_: its port B is not connected\n"));
    CHECK(cells_of_cell("$_AND_", R"("A": [2], "B": [9], "Y": [6])") ==
          "net 'net$1' has no driver: it is neither an input nor the output of a "
          "cell\n");
    CHECK(read_as_json(
              R"({"modules": {"m": {"ports": {"a": {"direction": "input", "bits": [2, 3]}}}}})") ==
          "port 'a' has 2 bits; ports of one bit are supported\n");
    CHECK(read_as_json(
              R"({"modules": {"m": {"ports": {"a": {"direction": "inout", "bits": [2]}}}}})") ==
          "port 'a' is neither an input nor an output\n");
    CHECK(read_as_json(R"({"modules": {}})") == "there is no module in the file\n");
    CHECK(read_as_json(R"({"modules": {"m": {}, "n": {}}})") ==
          "there are several modules and none is marked as the top; flatten the "
          "netlist "
          "first (Yosys: hierarchy -auto-top; flatten)\n");
    CHECK(read_as_json(R"({"modules": {"m": {}, "n": {"attributes": {"top": "01"}}}})") ==
          "netlist n\n");
    CHECK(read_as_json("[]") == "not a Yosys netlist: there is no \"modules\"\n");
}

TEST_CASE("messages show the place of the cell or port") {
    CHECK(shown(module_with("\n  " + cell("$add", ab))) ==
          "x.json:5:8: error: cell 'g' of type $add: cells of this type are not supported (Yosys: "
          "techmap; opt)\n"
          R"(  "g": {"type": "$add", "parameters": {}, "connections": {"A": [2],…)"
          "\n       ^\n");
    CHECK(shown("{\"modules\": {\"m\": {\n\"ports\": {\"é\": {\"direction\": \"inout\"}}}}}") ==
          "x.json:2:16: error: port 'é' is neither an input nor an output\n"
          "\"ports\": {\"é\": {\"direction\": \"inout\"}}}}}\n               ^\n");
}

TEST_CASE("everything that cannot be used is told, and once") {
    CHECK(shown("{\"modules\": {\"m\": {\"cells\": {\n\"g\": {},\n\"h\": {}}}}}") ==
          "x.json:2:6: error: cell 'g' has no connections\n\"g\": {},\n     ^\n"
          "x.json:3:6: error: cell 'h' has no connections\n\"h\": {}}}}}\n     ^\n");
    const std::string both =
        shown("{\"modules\": {\"m\": {\"ports\": {\n\"a\": {},\n\"b\": {}}}}}");
    CHECK(both ==
          "x.json:2:6: error: port 'a' is neither an input nor an output\n\"a\": {},\n     ^\n"
          "x.json:3:6: error: port 'b' is neither an input nor an output\n\"b\": {}}}}}\n     ^\n");
}

TEST_CASE("texts that are not JSON are refused with the place") {
    CHECK(shown("{\n  \"é\": 1,\n  \"modules\" {}\n}") ==
          "x.json:3:13: error: not JSON: the JSON reader says \"syntax error while parsing object "
          "separator - unexpected '{'; expected ':'\"\n  \"modules\" {}\n            ^\n");
    CHECK(shown("").starts_with("x.json:1:1: error: not JSON: the JSON reader says \""));
    CHECK(shown(std::string(100000, '['))
              .starts_with(
                  "x.json:1:21: error: values are nested more than 20 deep: not a netlist\n"));
    CHECK(shown(std::string(5000, '[') + std::string(5000, ']'))
              .starts_with(
                  "x.json:1:21: error: values are nested more than 20 deep: not a netlist\n"));
    CHECK(shown(std::string(20, '[') + std::string(20, ']')).find("nested") == std::string::npos);
    CHECK(shown("{\"modules\": 1").starts_with("x.json:1:"));
    CHECK(shown("\"\xff\"").starts_with("x.json:1:2: error: "));
}

TEST_CASE("words in names, and nets without one") {
    CHECK(read_as_json(module_with(R"("g": {"type": "$_NOT_", "connections": {"A": [2], "Y": [7]}},
                              "h": {"type": "$_NOT_", "connections": {"A": [7], "Y": [8]}},
                              "i": {"type": "$_NOT_", "connections": {"A": [8], "Y": [6]}})",
                                   R"("w": {"bits": [2, 8, 9], "attributes": {}})"))
              .ends_with("module m\n  net$1 = not(a)\n  w[1] = not(net$1)\n  y = not(w[1])\n"));
}
