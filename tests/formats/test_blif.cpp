#include <doctest/doctest.h>

#include "formats/blif/read_blif.h"
#include "formats/shared/messages.h"

using namespace grafwire;

namespace {

/// The netlist as text, or what is wrong with the file.
std::string read_as_blif(const std::string& text) {
    const SourceFile source{"x.blif", text};
    Diagnostics diagnostics;
    const std::optional<Netlist> netlist = read_blif(source, diagnostics);
    CHECK(netlist.has_value() != diagnostics.has_errors());
    if (!netlist) {
        for (const Diagnostic& item : diagnostics.items()) {
            CHECK((item.code == code::bad_netlist || item.code == code::not_utf8));
        }
        return format_diagnostics(diagnostics, source);
    }
    CHECK(fault_of(*netlist) == "");
    return write_netlist_text(*netlist);
}

/// The cells for one cover over a, b, c.
std::string cells_of_cover(const std::string& names, const std::string& rows) {
    const std::string text = read_as_blif(".model m\n.inputs a b c\n.outputs y\n.names " + names +
                                          "\n" + rows + "\n.end\n");
    const std::string head = "netlist m\ninput a\ninput b\ninput c\noutput y = y\nmodule m\n";
    REQUIRE(text.starts_with(head));
    return text.substr(head.size());
}

std::string error_of(const std::string& line) {
    return read_as_blif(".model m\n.inputs a b clk\n.outputs y\n" + line + "\n.end\n");
}

}  // namespace

TEST_CASE("covers that are one gate") {
    CHECK(cells_of_cover("y", "") == "  y = low()\n");
    CHECK(cells_of_cover("y", "0") == "  y = low()\n");
    CHECK(cells_of_cover("y", "1") == "  y = high()\n");
    CHECK(cells_of_cover("a y", "1 1") == "  y = buf(a)\n");
    CHECK(cells_of_cover("a y", "0 1") == "  y = not(a)\n");
    CHECK(cells_of_cover("a y", "1 0") == "  y = not(a)\n");
    CHECK(cells_of_cover("a y", "0 0") == "  y = buf(a)\n");
    CHECK(cells_of_cover("a b y", "") == "  y = low()\n");
    CHECK(cells_of_cover("a b y", "-- 1") == "  y = high()\n");
    CHECK(cells_of_cover("a b y", "-- 0") == "  y = low()\n");
    CHECK(cells_of_cover("a b c y", "111 1") == "  y = and(a, b, c)\n");
    CHECK(cells_of_cover("a b c y", "111 0") == "  y = nand(a, b, c)\n");
    CHECK(cells_of_cover("a b c y", "000 1") == "  y = nor(a, b, c)\n");
    CHECK(cells_of_cover("a b c y", "000 0") == "  y = or(a, b, c)\n");
    CHECK(cells_of_cover("a b c y", "1-1 1") == "  y = and(a, c)\n");
    CHECK(cells_of_cover("a b c y", "-1- 1") == "  y = buf(b)\n");
    CHECK(cells_of_cover("a b c y", "1-- 1\n-1- 1\n--1 1") == "  y = or(a, b, c)\n");
    CHECK(cells_of_cover("a b c y", "0-- 1\n-0- 1\n--0 1") == "  y = nand(a, b, c)\n");
    CHECK(cells_of_cover("a b y", "1- 0\n-1 0") == "  y = nor(a, b)\n");
    CHECK(cells_of_cover("a b y", "0- 0\n-0 0") == "  y = and(a, b)\n");
    CHECK(cells_of_cover("a b y", "01 1\n10 1") == "  y = xor(a, b)\n");
    CHECK(cells_of_cover("a b y", "00 0\n11 0") == "  y = xor(a, b)\n");
    CHECK(cells_of_cover("a b c y", "001 1\n010 1\n100 1\n111 1") == "  y = xor(a, b, c)\n");
}

TEST_CASE("other covers") {
    CHECK(cells_of_cover("a b y", "10 1") == "  b$1 = not(b)\n  y = and(a, b$1)\n");
    CHECK(cells_of_cover("a b y", "1- 1\n-0 1") == "  b$1 = not(b)\n  y = or(a, b$1)\n");
    CHECK(cells_of_cover("a b y", "00 1\n11 1") == "  y$1 = xor(a, b)\n  y = not(y$1)\n");
    CHECK(cells_of_cover("a b c y", "1-0 1\n011 1") ==
          "  c$1 = not(c)\n  y$1 = and(a, c$1)\n  a$1 = not(a)\n  y$2 = and(a$1, b, c)\n"
          "  y = or(y$1, y$2)\n");
    CHECK(cells_of_cover("a b c y", "11- 0\n--1 0") == "  y$1 = and(a, b)\n  y = nor(y$1, c)\n");
}

TEST_CASE("a row that stands twice makes no exclusive or") {
    CHECK(cells_of_cover("a b y", "01 1\n01 1") ==
          "  a$1 = not(a)\n  y$1 = and(a$1, b)\n  y$2 = and(a$1, b)\n  y = or(y$1, y$2)\n");
    CHECK(cells_of_cover("a b c y", "001 1\n010 1\n100 1\n100 1").find("xor") == std::string::npos);
}

TEST_CASE("the value of a parameter stands between two quotes or none") {
    const auto timer = [](const std::string& value) {
        return read_as_blif(
            ".model m\n.inputs a\n.outputs t\n.subckt grafwire_timer a=a q=t\n.param RISE " +
            value + "\n.end\n");
    };
    for (const char* good : {"2s", "\"2s\""}) CHECK(timer(good).find("2s") != std::string::npos);
    for (const char* bad : {"\"2s", "2s\"", "\"", "\"\""}) {
        CHECK(timer(bad).starts_with("x.blif:5:1: error: the value of RISE does not fit"));
    }
}

TEST_CASE("inner nets stay clear of the names in the file") {
    CHECK(read_as_blif(
              ".model m\n.inputs a b b$1\n.outputs y y$1\n.names a b y\n10 1\n.names b$1 y$1\n1 "
              "1\n.end") ==
          "netlist m\ninput a\ninput b\ninput b$1\noutput y = y\noutput y$1 = y$1\nmodule m\n"
          "  b$2 = not(b)\n  y = and(a, b$2)\n  y$1 = buf(b$1)\n");
}

TEST_CASE("latches of all forms that can be used") {
    CHECK(
        read_as_blif(
            ".model m\n.inputs d e clk\n.outputs q r s t\n.latch d q re clk 1\n.latch d r re clk\n"
            ".latch d s ah e 0\n.latch d t 2\n.end\n") ==
        "netlist m\ninput d\ninput e\ninput clk\noutput q = q\noutput r = r\noutput s = s\n"
        "output t = t\nmodule m\n  q = dff(d, clk) initially 1\n  r = dff(d, clk)\n"
        "  s = hold(d, e) initially 0\n  t = dff(d, clk)\n");
    // What ABC writes: no clock at all.
    CHECK(read_as_blif(".model m\n.inputs d\n.outputs q\n.latch d q 0\n.end\n") ==
          "netlist m\ninput d\ninput clk\noutput q = q\nmodule m\n  q = dff(d, clk) initially 0\n");
    CHECK(
        read_as_blif(".model m\n.inputs d\n.clock clk\n.outputs q\n.latch d q re clk 0\n.end\n") ==
        "netlist m\ninput d\ninput clk\noutput q = q\nmodule m\n  q = dff(d, clk) initially 0\n");
}

TEST_CASE("comments, joined lines and carriage returns") {
    CHECK(read_as_blif(
              "# a comment \\\n.model m # and one here\r\n.inputs a \\\n  b\n\n.outputs \\ \n y\n"
              ".names a \\\n b y\n11 1 # the row\n.end\nwhat comes after .end is of no interest") ==
          "x.blif:12:1: error: 'what' is not a BLIF command\n"
          "what comes after .end is of no interest\n^\n");
    CHECK(read_as_blif(
              "# a comment \\\n.model m # and one here\r\n.inputs a \\\n  b\n\n.outputs \\ \n y\n"
              ".names a \\\n b y\n11 1 # the row\n.end") ==
          "netlist m\ninput a\ninput b\noutput y = y\nmodule m\n  y = and(a, b)\n");
}

TEST_CASE("names written with percent signs") {
    CHECK(
        read_as_blif(".model a%20b\n.inputs %25 %3D%23%5C%41\n.outputs y%20\n.names % %3D%23%5C%41 "
                     "y%20\n11 1\n"
                     ".names %\n1\n.end\n") ==
        "x.blif:6:1: error: net '%' has a second driver\n.names %\n^\n"
        "x.blif:2:9: note: the first one is here\n.inputs %25 %3D%23%5C%41\n        ^\n");
    CHECK(read_as_blif(
              ".model a%20b\n.inputs %25 %3D%23%5C%41\n.outputs y%20\n.names %25 %3D%23%5C%41 "
              "y%20\n11 1\n"
              ".end\n") ==
          "netlist a b\ninput %\ninput =#\\%41\noutput y  = y \nmodule a b\n  y  = and(%, "
          "=#\\%41)\n");
}

TEST_CASE("black boxes and what is said about them") {
    CHECK(
        read_as_blif(
            ".model m\n.inputs a s r\n.outputs q p t\n.subckt grafwire_latch r=r q=q s=s\n.attr "
            "INIT 1\n"
            ".cname whatever\n.attr src \"x.v:1\"\n.subckt grafwire_rise_pulse a=a q=p\n"
            ".param FALL \"3us\"\n.subckt grafwire__timer a=a q=t\n.attr RISE \"5s\"\n.attr FALL "
            "\"0s\"\n"
            ".attr ORDINAL \"2\"\n.end\n.model grafwire_latch\n.inputs s r\n.outputs "
            "q\n.blackbox\n.end\n") ==
        "netlist m\ninput a\ninput s\ninput r\noutput q = q\noutput p = p\noutput t = t\nmodule m\n"
        "  q = latch(s, r) initially 1\n  p = rise_pulse(a) rise 0s fall 3us\n"
        "  t = timer(a) rise 5s fall 0s\n");
}

TEST_CASE("initial values of nets") {
    CHECK(read_as_blif(".model m\n.inputs a\n.outputs X1\n#@initially X1 1\n#@initially a 2\n"
                       "#@something else\n.names a X1\n1 1\n.end\n") ==
          "netlist m\ninput a\noutput X1 = X1\nmodule m\n  X1 = buf(a)\ninitially X1 = 1\n");
}

TEST_CASE("the steps of a netlist come first") {
    Diagnostics diagnostics;
    const std::string text =
        ".model m\n.inputs Init a\n.outputs X1 X2 lamp\n.names a X1\n1 1\n.names a X2\n1 1\n"
        ".names a lamp\n1 1\n.end\n";
    const std::optional<Netlist> netlist = read_blif({"x", text}, diagnostics);
    REQUIRE(netlist.has_value());
    CHECK(netlist->step_count == 2);
    CHECK(netlist->has_modes);
    CHECK_FALSE(netlist->is_clocked());
}

TEST_CASE("every cell knows its line") {
    const SourceFile source{"x.blif",
                            ".model m\n.inputs a b c\n.outputs y z\n"
                            ".names a b c y\n11- 1\n0-1 1\n# and\n.latch a z re b 0\n.end\n"};
    Diagnostics diagnostics;
    const std::optional<Netlist> netlist = read_blif(source, diagnostics);
    REQUIRE(netlist);
    CHECK(fault_of(*netlist) == "");
    REQUIRE(netlist->cells.size() > 3);
    for (const Cell& cell : netlist->cells) {
        const Origin& origin = netlist->origin_of(cell);
        CHECK(origin.kind == Origin::Kind::other);
        CHECK(origin.where.line == (cell.type == CellType::flip_flop ? 8 : 4));
    }
}

TEST_CASE("refusals name the place and the cause") {
    CHECK(error_of(".names a b y\n111 1") ==
          "x.blif:5:1: error: expected a row of 2 characters 0, 1 or - and a 0 or 1\n111 1\n^\n");
    CHECK(error_of(".names a b y\n1x 1") ==
          "x.blif:5:1: error: expected a row of 2 characters 0, 1 or - and a 0 or 1\n1x 1\n^\n");
    CHECK(error_of(".names a b y\n11 1\n00 0") ==
          "x.blif:6:4: error: the rows of one .names must end alike, all 0 or all 1\n00 0\n   ^\n");
    CHECK(error_of(".names") == "x.blif:4:1: error: .names without an output\n.names\n^\n");
    CHECK(error_of(".names a z y\n11 1") ==
          "x.blif:4:10: error: net 'z' has no driver: it is neither an input nor the output of a "
          "cell\n"
          ".names a z y\n         ^\n");
    CHECK(error_of(".names a y\n1 1\n.names b y\n1 1") ==
          "x.blif:6:1: error: net 'y' has a second driver\n.names b y\n^\n"
          "x.blif:4:1: note: the first one is here\n.names a y\n^\n");
    CHECK(error_of(".latch a y fe clk 0\n.names a y\n1 1") ==
          "x.blif:4:12: error: latch type 'fe': only re (rising edge) and ah (transparent while "
          "high) are "
          "supported\n.latch a y fe clk 0\n           ^\n");
    CHECK(error_of(".latch a y re clk 7\n.names a y\n1 1") ==
          "x.blif:4:19: error: the initial value of a latch is 0, 1, 2 or 3\n.latch a y re clk 7\n"
          "                  ^\n");
    CHECK(error_of(".latch a\n.names a y\n1 1") ==
          "x.blif:4:1: error: expected .latch input output [type control] [initial value]\n.latch "
          "a\n^\n");
    CHECK(error_of(".names a n\n1 1\n.latch b y re n 0") ==
          "x.blif:6:1: error: the clock 'n' of D flip-flop 'y' is not an input\n.latch b y re n "
          "0\n^\n");
    CHECK(error_of(".latch b y re clk 0\n.latch b z re a 0") ==
          "x.blif:5:1: error: D flip-flop 'z' has the clock 'a', others have 'clk': one clock is "
          "supported\n.latch b z re a 0\n^\n");
    CHECK(error_of(".gate nand2 A=a B=b O=y\n.names a y\n1 1") ==
          "x.blif:4:1: error: library cell 'nand2': its function is not in the file; write the "
          "netlist "
          "with .names instead\n.gate nand2 A=a B=b O=y\n^\n");
    CHECK(error_of(".subckt\n.names a y\n1 1").find("error: .subckt without a model") !=
          std::string::npos);
    CHECK(error_of(".subckt adder a=a\n.names a y\n1 1") ==
          "x.blif:4:9: error: subcircuit 'adder' is not known; flatten the netlist first\n"
          ".subckt adder a=a\n        ^\n");
    CHECK(error_of(".subckt grafwire_latch s=a q=y\n.names a y\n1 1") ==
          "x.blif:4:1: error: a connection of this set-priority latch is missing\n"
          ".subckt grafwire_latch s=a q=y\n^\n");
    CHECK(error_of(".subckt grafwire_latch s=a r=b q=y z=a\n.names a y\n1 1") ==
          "x.blif:4:36: error: 'z=a' is not a connection of a set-priority latch\n"
          ".subckt grafwire_latch s=a r=b q=y z=a\n                                   ^\n");
    CHECK(error_of(".subckt grafwire_timer a=a q=y\n.attr RISE \"soon\"") ==
          "x.blif:5:1: error: the value of RISE does not fit; INIT is 0 or 1, RISE and FALL are "
          "durations, "
          "ORDINAL is a number\n.attr RISE \"soon\"\n^\n");
    CHECK(error_of(".subckt grafwire_rise_pulse a=a q=y") ==
          "x.blif:4:1: error: the pulse of rising-edge pulse cell 'y' has no width\n"
          ".subckt grafwire_rise_pulse a=a q=y\n^\n");
    CHECK(error_of(".exdc\n.names a y\n1 1") ==
          "x.blif:4:1: error: '.exdc' is not supported\n.exdc\n^\n");
    CHECK(error_of(".names a y\n1 1\n.outputs y") ==
          "x.blif:6:10: error: output 'y' is listed twice\n.outputs y\n         ^\n");
    CHECK(error_of("hello") == "x.blif:4:1: error: 'hello' is not a BLIF command\nhello\n^\n");
    CHECK(read_as_blif("") == "x.blif: error: there is no .model in the file\n");
    CHECK(read_as_blif("module m; endmodule") ==
          "x.blif:1:1: error: expected .model at the start of the netlist\nmodule m; endmodule\n^\n"
          "x.blif: error: there is no .model in the file\n");
    CHECK(read_as_blif(".model m\n.end\n.model n\n.names a\n1\n.names b\n.end\n") ==
          "x.blif:4:1: error: a second model with cells of its own; flatten the netlist "
          "first\n.names a\n^\n");
    CHECK(read_as_blif(".model m\n.inputs \xff\n.end\n").find("x.blif:2:9: error: ") == 0);
}
