// Further conditions of receptivities in the text of a chart.

#include <doctest/doctest.h>

#include "grafcet/add_conditions.h"
#include "grafcet/parse_grafcet.h"
#include "grafcet/write_grafcet.h"

namespace grafwire::testing {

namespace {

Grafcet read(const SourceFile& source) {
    Diagnostics diagnostics;
    auto grafcet = parse_grafcet(source, diagnostics);
    REQUIRE(grafcet);
    return std::move(*grafcet);
}

/// The line of transition `1 -> 2` once these have been added; all else is as it was.
std::string with_added(const std::string& line, const std::vector<AddedCondition>& conditions) {
    const std::string before =
        "input a, b, \"c d\"\ndefine both = a . b\nvar v\ngraph G {\n  initial 1\n  step 2\n  ";
    const std::string after = "\n  2 -> 1 : b # as a + b\n}\n";
    const SourceFile source{"chart", before + line + after};
    const std::string text = with_added_conditions(source, read(source), conditions);
    read({"chart", text});
    REQUIRE(text.size() > before.size() + after.size());
    CHECK(text.substr(0, before.size()) == before);
    CHECK(text.substr(text.size() - after.size()) == after);
    return text.substr(before.size(), text.size() - before.size() - after.size());
}

const std::vector<AddedCondition> one{{TransitionId{0}, "/X2", true}};
const std::vector<AddedCondition> sum{{TransitionId{0}, "/X2 + /b", false}};

}  // namespace

TEST_CASE("a condition is added behind what is written") {
    CHECK(with_added("1 -> 2 : a", one) == "1 -> 2 : a . /X2");
    CHECK(with_added("1 -> 2 : a . b", sum) == "1 -> 2 : a . b . (/X2 + /b)");
    CHECK(with_added("(5) 1 -> 2 := a   # why", one) == "(5) 1 -> 2 := a . /X2   # why");
    CHECK(with_added("1 -> 2 : =a do set v, v := a + b", one) ==
          "1 -> 2 : =a . /X2 do set v, v := a + b");
    CHECK(with_added("1 -> 2 : a faire set v", one) == "1 -> 2 : a . /X2 faire set v");
    CHECK(with_added("1 -> 2 : \"c d\"", one) == "1 -> 2 : \"c d\" . /X2");
}

TEST_CASE("a sum gets parentheses, a name that stands for one needs none") {
    CHECK(with_added("1 -> 2 : a + b", one) == "1 -> 2 : (a + b) . /X2");
    CHECK(with_added("1 -> 2 : a ou b  # x\n    + 2s/X1", sum) ==
          "1 -> 2 : (a ou b  # x\n    + 2s/X1) . (/X2 + /b)");
    CHECK(with_added("1 -> 2 : a xor b", one) == "1 -> 2 : (a xor b) . /X2");
    CHECK(with_added("1 -> 2 : both", one) == "1 -> 2 : both . /X2");
}

TEST_CASE("a 1 that says nothing goes") {
    CHECK(with_added("1 -> 2 : 1", one) == "1 -> 2 : /X2");
    CHECK(with_added("1 -> 2 : =1", sum) == "1 -> 2 : =/X2 + /b");
    const std::vector<AddedCondition> two{{TransitionId{0}, "/X2 + /b", false},
                                          {TransitionId{0}, "a", true}};
    CHECK(with_added("1 -> 2 : 1", two) == "1 -> 2 : (/X2 + /b) . a");
}

TEST_CASE("nothing to add changes nothing") {
    CHECK(with_added("1 -> 2 : a  .  b", {}) == "1 -> 2 : a  .  b");
}

}  // namespace grafwire::testing
