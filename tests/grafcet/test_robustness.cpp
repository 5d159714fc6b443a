// Inputs of extreme size, depth or disorder: the parser reports or accepts, and always comes back.

#include "grafcet/describe_grafcet.h"
#include "grafcet/messages.h"
#include "parsing.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::string repeated(std::string_view text, int count) {
    std::string result;
    for (int i = 0; i < count; ++i) result += text;
    return result;
}

std::string chart_with(const std::string& receptivity) {
    return "input a\ngraph G { initial 1 1 -> 1 : " + receptivity + " }\n";
}

}  // namespace

TEST_CASE("nesting is limited, chains are not") {
    CHECK(messages_of(chart_with(repeated("/", 499) + "a")).empty());
    CHECK(messages_of(chart_with(repeated("/", 500) + "a")) ==
          "2:530 error: this expression is nested more than 500 levels deep; give parts of it to "
          "vars of their own\n");
    CHECK(messages_of(chart_with(repeated("(", 499) + "a" + repeated(")", 499))).empty());
    CHECK(gives_only(chart_with(repeated("(", 100000)), code::nested_too_deep));
    CHECK(gives_only(chart_with(repeated("1s/", 100000)), code::nested_too_deep));
    CHECK(gives_only(chart_with(repeated("rise(", 100000)), code::nested_too_deep));
    const Grafcet grafcet = parsed(chart_with(repeated("a + ", 100000) + "a"));
    CHECK(grafcet.expressions.operands(grafcet.transitions.items()[0].condition).size() == 100001);
    const std::string written = write_grafcet(grafcet);
    CHECK(write_grafcet(parsed(written)) == written);
}

TEST_CASE("expansions may be nested as deep as the file is long") {
    constexpr int depth = 20000;
    std::string text = "input a\ngraph G { initial i macro M0 = e0 i -> M0 : a M0 -> i : a }\n";
    for (int i = 0; i < depth; ++i) {
        const std::string n = std::to_string(i);
        const std::string next = std::to_string(i + 1);
        text += "expansion e" + n + " { entry E" + n + " exit S" + n;
        if (i + 1 < depth)
            text += " macro M" + next + " = e" + next + " E" + n + " -> M" + next + " : a M" +
                    next + " -> S" + n + " : a }\n";
        else
            text += " E" + n + " -> S" + n + " : a }\n";
    }
    const Grafcet grafcet = parsed(text);
    CHECK(grafcet.steps.size() == 2 * depth + 1);
    CHECK(grafcet.macros.items()[0].steps.count == 2 * depth);
    CHECK(grafcet.steps.items()[2].name == "S0");
    CHECK(parsed(write_grafcet(grafcet)).steps.size() == grafcet.steps.size());
}

TEST_CASE("a long chain of forcing orders, and the circle that closes it") {
    constexpr int length = 20000;
    std::string text = "input a\n";
    for (int i = 0; i < length; ++i)
        text += "graph G" + std::to_string(i) + " { initial " + std::to_string(i) +
                (i + 1 < length ? " : G" + std::to_string(i + 1) + "{} " : " ") +
                std::to_string(i) + " -> " + std::to_string(i) + " : a }\n";
    const Grafcet grafcet = parsed(text);
    CHECK(describe_grafcet(grafcet, Language::english).size() < 200U * length);
    Diagnostics diagnostics;
    text += "graph G" + std::to_string(length) + " { initial x : G0{} x -> x : a }\n";
    text.replace(text.find("initial 19999 "), 14, "initial 19999 : G20000{} ");
    CHECK_FALSE(parse_grafcet({"test", text}, diagnostics).has_value());
    REQUIRE(diagnostics.items().size() == 1);
    CHECK(diagnostics.items()[0].code == code::forcing_circle);
    CHECK(diagnostics.items()[0].notes.size() == length);
}

TEST_CASE("many mistakes are all reported") {
    std::string text = "input a\ngraph G { initial 1\n";
    for (int i = 0; i < 20000; ++i) text += "1 -> 1 : unknown" + std::to_string(i) + "\n1 -> 1 a\n";
    Diagnostics diagnostics;
    CHECK_FALSE(parse_grafcet({"test", text + "}\n"}, diagnostics).has_value());
    CHECK(diagnostics.error_count() == 40000);
}

TEST_CASE("any bytes come back as a chart or as errors") {
    const std::string seed = R"(grafcet g "t"
input a, "b c" output l, m var v counter n : -3..9
assume /(a . "b c")
graph G { initial 1 encloses H{5} : l if 3s/a/2s, set m on ↑a step 2 : K{*}, K{7, 8}, n := n - 1
macro M = e
(t) 1 -> M, 2 : [n > 3] + (a ⊕ v) do set v, n := 0 M, 2 -> 1 :=1 }
graph H { initial 5 5 -> 5 : rise(a) } graph K { step 7 step 8 7 -> 8 : 1 -> 7 : /X5 8 -> : XG }
expansion e { entry E exit S E -> S : a and not v or a xor "b c" } # end
)";
    std::uint64_t state = 12345;
    const auto random = [&state](std::size_t limit) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<std::size_t>(state >> 33U) % (limit == 0 ? 1 : limit);
    };
    std::size_t accepted = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string text = seed;
        for (std::size_t edits = 1 + random(4); edits > 0; --edits) {
            const std::size_t at = random(text.size());
            switch (random(4)) {
                case 0:
                    text.erase(at, 1 + random(20));
                    break;
                case 1:
                    text.insert(at, 1, static_cast<char>(random(256)));
                    break;
                case 2:
                    text.insert(at, text.substr(random(text.size()), random(30)));
                    break;
                default:
                    text.resize(at + 1);
                    break;
            }
        }
        Diagnostics diagnostics;
        const SourceFile source{"test", text};
        const auto grafcet = parse_grafcet(source, diagnostics);
        REQUIRE(grafcet.has_value() != diagnostics.has_errors());
        format_diagnostics(diagnostics, source);
        if (!grafcet) continue;
        ++accepted;
        const std::string written = write_grafcet(*grafcet);
        REQUIRE(write_grafcet(parsed(written)) == written);
        CHECK_FALSE(describe_grafcet(*grafcet, Language::french).empty());
    }
    CHECK(accepted > 30);
}
