// Ladder diagrams of other tools: what is read, and what is refused.

#include <doctest/doctest.h>

#include "ladder/draw/write_drawings.h"
#include "ladder/ladder_from.h"
#include "plcopen/messages.h"
#include "plcopen/read_ladder.h"
#include "plcopen/write_project.h"
#include "random/random_source.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

/// A project with one program; `variables` are `name:type` or `name:type=initial`.
std::string project(const std::vector<std::string>& variables, const std::string& body) {
    std::string text =
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\">\n"
        "<types><pous><pou name=\"main\" pouType=\"program\">\n<interface><localVars>\n";
    for (const std::string& variable : variables) {
        const std::size_t colon = variable.find(':');
        const std::size_t equals = variable.find('=');
        const std::string type = variable.substr(colon + 1, equals - colon - 1);
        const bool is_plain = type == "BOOL" || type == "INT" || type == "TIME" || type == "REAL";
        text += "<variable name=\"" + variable.substr(0, colon) + "\"><type>" +
                (is_plain ? "<" + type + "/>" : "<derived name=\"" + type + "\"/>") + "</type>";
        if (equals != std::string::npos) {
            text += "<initialValue><simpleValue value=\"" + variable.substr(equals + 1) +
                    "\"/></initialValue>";
        }
        text += "</variable>\n";
    }
    return text + "</localVars></interface>\n<body><LD>\n" + body +
           "</LD></body>\n</pou></pous></types>\n</project>\n";
}

std::string place(int x, int y) {
    return "<position x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\"/>";
}

/// `1,2:Q` becomes connections to elements 1 and 2, the latter's output Q.
std::string inlet(const std::string& sources) {
    std::string text = "<connectionPointIn>";
    for (std::size_t at = 0; at < sources.size();) {
        const std::size_t end = std::min(sources.find(',', at), sources.size());
        const std::string source = sources.substr(at, end - at);
        const std::size_t colon = source.find(':');
        text += "<connection refLocalId=\"" + source.substr(0, colon) + "\"";
        if (colon != std::string::npos) {
            text += " formalParameter=\"" + source.substr(colon + 1) + "\"";
        }
        text += "/>";
        at = end + 1;
    }
    return text + "</connectionPointIn>";
}

std::string rail() {
    return "<leftPowerRail localId=\"1\">" + place(0, 0) + "</leftPowerRail>\n";
}

std::string element(const char* kind, int id, int x, int y, const std::string& sources,
                    const std::string& variable, const std::string& attributes = "") {
    return std::string("<") + kind + " localId=\"" + std::to_string(id) + "\" " + attributes + ">" +
           place(x, y) + inlet(sources) + "<variable>" + variable + "</variable></" + kind + ">\n";
}

std::string value(int id, const std::string& expression) {
    return "<inVariable localId=\"" + std::to_string(id) + "\">" + place(0, 0) + "<expression>" +
           expression + "</expression></inVariable>\n";
}

/// `inputs`: pairs of a parameter and its sources.
std::string block(int id, int y, const std::string& type, const std::string& instance,
                  const std::vector<std::pair<std::string, std::string>>& inputs) {
    std::string text = "<block localId=\"" + std::to_string(id) + "\" typeName=\"" + type +
                       "\" instanceName=\"" + instance + "\">" + place(100, y) + "<inputVariables>";
    for (const auto& [name, sources] : inputs) {
        text += "<variable formalParameter=\"" + name + "\">" + inlet(sources) + "</variable>";
    }
    return text + "</inputVariables><inOutVariables/><outputVariables/></block>\n";
}

/// The rungs as drawn, or the messages.
std::string read(const std::string& text) {
    const SourceFile source{"main.xml", text};
    Diagnostics diagnostics;
    const auto ladder = plcopen::read_ladder(source, diagnostics);
    if (!ladder) {
        CHECK(diagnostics.has_errors());
        std::string messages;
        for (const Diagnostic& item : diagnostics.items()) {
            CHECK(item.code == code::bad_ladder);
            messages += std::to_string(item.where.line) + ":" + std::to_string(item.where.column) +
                        ": " + item.message.english + "\n";
        }
        return messages;
    }
    std::string drawn;
    for (const ladder::Rung& rung : ladder->rungs) {
        drawn += std::to_string(rung.number) + " line " + std::to_string(rung.origin.line) + "\n" +
                 write_rung(*ladder, rung, 50);
    }
    return drawn;
}

}  // namespace

TEST_CASE("elements in any order, one rail for all networks, wires that branch") {
    const std::string text = project(
        {"a:BOOL", "b:BOOL", "c:BOOL", "d:BOOL", "q:BOOL", "r:BOOL"},
        element("coil", 9, 400, 50, "5,6", "q", "storage=\"set\"") +
            element("contact", 5, 200, 50, "3,4", "c", "edge=\"rising\"") +
            element("contact", 6, 200, 70, "3,4", "D", "negated=\"true\"") +
            element("contact", 3, 100, 50, "1", "a") + element("contact", 4, 100, 70, "1", "b") +
            rail() + element("coil", 20, 400, 10, "1", "r", "negated=\"true\""));
    CHECK(read(text) == R"(1 line 18
│                                           r    │
├──────────────────────────────────────────(/)───┤
2 line 12
│     a        c                            q    │
├─┬──┤ ├──┬┬──┤P├──┬───────────────────────(S)───┤
│ │   b   ││   d   │                             │
│ └──┤ ├──┘└──┤/├──┘                             │
)");
}

TEST_CASE("a bridge is written out") {
    // a to c and d, b to d only.
    const std::string text = project(
        {"a:BOOL", "b:BOOL", "c:BOOL", "d:BOOL", "q:BOOL"},
        rail() + element("contact", 2, 100, 10, "1", "a") +
            element("contact", 3, 100, 30, "1", "b") + element("contact", 4, 200, 10, "2", "c") +
            element("contact", 5, 200, 30, "2,3", "d") + element("coil", 6, 300, 10, "4,5", "q"));
    CHECK(read(text) == R"(1 line 16
│     a      c                              q    │
├─┬──┤ ├────┤ ├────┬───────────────────────( )───┤
│ │    a       d   │                             │
│ └┬──┤ ├──┬──┤ ├──┘                             │
│  │   b   │                                     │
│  └──┤ ├──┘                                     │
)");
}

TEST_CASE("blocks of functions blocks, with what hangs on them") {
    const std::string text =
        project({"a:BOOL", "b:BOOL", "q:BOOL", "r:BOOL", "T1:TON", "F1:R_TRIG", "C1:CTU",
                 "delay:TIME=T#2s", "n:INT=5"},
                rail() + element("contact", 2, 50, 10, "1", "a") + value(3, "delay") +
                    block(4, 10, "TON", "T1", {{"IN", "2"}, {"PT", "3"}}) +
                    block(5, 10, "R_TRIG", "F1", {{"CLK", "4:Q"}}) +
                    element("coil", 6, 300, 10, "5:Q", "q", "storage=\"set\"") +
                    element("contact", 7, 50, 100, "1", "T1.Q") + value(8, "n") +
                    element("contact", 9, 50, 140, "1", "b") +
                    block(10, 100, "CTU", "C1", {{"CU", "7"}, {"R", "9"}, {"PV", "8"}}) +
                    element("coil", 11, 300, 100, "10:Q", "r"));
    CHECK(read(text) == R"(1 line 18
│             T1           F1                    │
│    a    ┌─TON─────┐  ┌─R_TRIG─┐           q    │
├───┤ ├───┤ IN    Q ├──┤ CLK  Q ├──────────(S)───┤
│         │ PT T#2s │  └────────┘                │
│         └─────────┘                            │
2 line 24
│    b                                    R_10   │
├───┤ ├────────────────────────────────────( )───┤
2 line 24
│             C1                                 │
│   T1    ┌─CTU────┐                        r    │
├───┤ ├───┤ CU   Q ├───────────────────────( )───┤
│         │ R R_10 │                             │
│         │ PV n   │                             │
│         └────────┘                             │
)");
}

TEST_CASE("numbers go through functions, comparisons let power through") {
    const std::string text = project(
        {"a:BOOL", "q:BOOL", "n:INT"},
        rail() + element("contact", 2, 50, 10, "1", "a") + value(3, "n") + value(4, "1") +
            block(5, 10, "ADD", "", {{"EN", "2"}, {"IN1", "3"}, {"IN2", "4"}}) + value(6, "9") +
            block(7, 10, "LIMIT", "",
                  {{"EN", "5:ENO"}, {"MN", "4"}, {"IN", "5:OUT"}, {"MX", "6"}}) +
            "<outVariable localId=\"8\">" + place(300, 10) + inlet("7:OUT") +
            "<expression>n</expression></outVariable>\n" +
            block(9, 100, "GE", "", {{"EN", "1"}, {"IN1", "3"}, {"IN2", "6"}}) +
            element("coil", 10, 300, 100, "9", "q"));
    CHECK(read(text) == R"(1 line 13
│                                                │
│    a    ┌─ADD────────────┐                     │
├───┤ ├───┤ EN         ENO ├───▶1                │
│         │ OUT_5 := n + 1 │                     │
│         └────────────────┘                     │
│                                                │
│      ┌─LIMIT──────────────┐                    │
│ 1▶───┤ EN             ENO ├────────────────────┤
│      │ n := OUT_5, 1 .. 9 │                    │
│      └────────────────────┘                    │
2 line 18
│                                           q    │
├──┤ n >= 9 ├──────────────────────────────( )───┤
)");
}

TEST_CASE("what is not understood is refused, with its place") {
    CHECK(read("<project>").find("this is no XML") != std::string::npos);
    CHECK(read("<a/>") ==
          "1:1: this is no PLCopen project: its outermost element is not <project>\n");
    CHECK(read("<project/>") == "1:1: the project holds no program in ladder diagram (LD)\n");
    const auto refusal = [](const std::string& body) {
        return read(project({"q:BOOL", "x:REAL", "n:INT", "T1:TON"}, rail() + body));
    };
    CHECK(refusal(element("coil", 2, 9, 9, "1", "p")) ==
          "11:1: the program declares no variable 'p'\n");
    CHECK(refusal(element("coil", 2, 9, 9, "1", "n")) == "11:1: 'n' is no bit\n");
    CHECK(refusal(element("contact", 2, 9, 9, "1", "x") + element("coil", 3, 9, 9, "2", "q")) ==
          "11:1: 'x' is of type REAL; only BOOL, integers and the blocks of IEC 61131-3 are "
          "understood here\n");
    CHECK(refusal(element("coil", 2, 9, 9, "7", "q")) ==
          "11:62: there is no element with localId 7\n");
    CHECK(refusal(element("coil", 2, 9, 9, "", "q")) ==
          "11:1: this element is not connected to anything on its left\n");
    CHECK(refusal(element("coil", 1, 9, 9, "1", "q")) ==
          "11:1: an element needs a localId of its own\n");
    CHECK(refusal("<jump localId=\"2\" label=\"here\"/>") ==
          "11:1: <jump> is not understood in a ladder diagram\n");
    CHECK(refusal(element("contact", 2, 9, 9, "3", "q") + element("contact", 3, 9, 9, "2", "q") +
                  element("coil", 4, 9, 9, "3", "q")) ==
          "12:1: this element feeds itself in a circle of wires\n");
    CHECK(refusal(block(2, 9, "TP", "T1", {{"IN", "1"}})) ==
          "11:1: a block of type 'TP' is not understood\n");
    CHECK(refusal(block(2, 9, "TON", "T1", {{"IN", "1"}})) ==
          "11:1: input PT of this block is not connected\n");
    CHECK(refusal(value(3, "n") + block(2, 9, "TON", "T1", {{"IN", "1"}, {"PT", "3"}})) ==
          "11:1: 'n' is no time that is known beforehand: write one as T#1.5s\n");
    CHECK(refusal(block(2, 9, "TOF", "T1", {{"IN", "1"}, {"PT", "1"}})) ==
          "11:234: input PT of this block is fed by no number\n");
    CHECK(refusal(element("coil", 2, 9, 9, "1", "q", "negated=\"true\" storage=\"set\"")) ==
          "11:1: a coil can be negated, set, reset or of an edge, only one of them\n");
}

TEST_CASE("damaged projects are refused or read, never worse") {
    const auto grafcet = read_grafcet(R"(
        input a, b
        output "V+"
        counter n : 0..9
        graph G {
          initial 0
          step 1 : "V+" if 2s/a/3s
          0 -> 1 : ↑a . (b + [n > 3]) do n := n + 1
          1 -> 0 : b ⊕ a
        })");
    Diagnostics none;
    const ScanProgram program = program_from(*grafcet, {});
    const std::string whole =
        plcopen::write_ladder_project(ladder::ladder_from(*grafcet, program, none));
    RandomSource random(970'000);
    std::size_t refused = 0;
    for (std::size_t i = 0; i < 600; ++i) {
        std::string text = whole;
        for (std::size_t damage = random.between(1, 4); damage > 0; --damage) {
            const std::size_t at = random.below(text.size());
            switch (random.below(4)) {
                case 0:
                    text.erase(at, random.below(200));
                    break;
                case 1:
                    text[at] = static_cast<char>(random.below(256));
                    break;
                case 2: {
                    const std::size_t from = random.below(text.size());
                    text.insert(at, text.substr(from, random.below(300)));
                    break;
                }
                default: {
                    // Another number in place of one.
                    const std::size_t digit = text.find_first_of("0123456789", at);
                    if (digit != std::string::npos) {
                        text[digit] = static_cast<char>('0' + random.below(10));
                    }
                }
            }
        }
        const SourceFile source{"main.xml", text};
        Diagnostics diagnostics;
        const auto read = plcopen::read_ladder(source, diagnostics, grafcet->name);
        CHECK(read.has_value() != diagnostics.has_errors());
        if (!read) ++refused;
    }
    CHECK(refused > 100);
    CHECK(refused < 600);
}

}  // namespace grafwire::testing
