#include <doctest/doctest.h>

#include "text/wrapped.h"

using namespace grafwire;

TEST_CASE("lines that fit stay as they are") {
    CHECK(wrapped("", 10).empty());
    CHECK(wrapped("\n\n", 10) == "\n\n");
    CHECK(wrapped("0123456789\n  ab cd", 10) == "0123456789\n  ab cd");
    CHECK(wrapped("éèàùçéèàùç\n", 10) == "éèàùçéèàùç\n");
}

TEST_CASE("what is broken off goes on below, further in than the line") {
    CHECK(wrapped("aaa bbb ccc ddd eee\nf\n", 12) == "aaa bbb ccc\n    ddd eee\nf\n");
    CHECK(wrapped("  aaa bbb ccc ddd\n", 12) == "  aaa bbb\n      ccc\n      ddd\n");
}

TEST_CASE("lines without a blank in the right place, and no-break blanks") {
    CHECK(wrapped("0123456789ab cd", 10) == "0123456789ab cd");
    CHECK(wrapped("ab 0123456789ab cd", 10) == "ab\n    0123456789ab cd");
    CHECK(wrapped("abc 10\u00a0ms\u00a0: cd", 10) == "abc\n    10\u00a0ms\u00a0: cd");
}

TEST_CASE("formulas are broken behind operators, the outermost first") {
    CHECK(wrapped_formulas("  X1 = a.b + c.d", 20) == "  X1 = a.b + c.d");
    CHECK(wrapped_formulas("  X1 = (a + b + c)./Init + d.(e + f)", 30) ==
          "  X1 = (a + b + c)./Init +\n      d.(e + f)");
    // The sum fits, and what it is multiplied with goes on below.
    CHECK(wrapped_formulas("  X1 = (a.b + /X2.X1 + Init)./AUdur", 30) ==
          "  X1 = (a.b + /X2.X1 + Init).\n      /AUdur");
    CHECK(wrapped_formulas("  X1 = (a.b + /X2.X1 + Init)./AUdur", 24) ==
          "  X1 = (a.b + /X2.X1 +\n      Init)./AUdur");
    // A line that begins within parentheses.
    CHECK(wrapped_formulas("  X1 = ((abc + def + ghi).jkl + m)./AUdur", 22) ==
          "  X1 = ((abc + def +\n      ghi).jkl + m).\n      /AUdur");
}

TEST_CASE("formulas: names in quotation marks, comparisons, numbers, and the left side") {
    CHECK(wrapped_formulas("X1 = \"a + b.c\".d", 15) == "X1 = \"a + b.c\".\n    d");
    CHECK(wrapped_formulas("X1 = a.[pieces < 4]", 16) == "X1 = a.\n    [pieces < 4]");
    CHECK(wrapped_formulas("X1 = 12.5s/X3.a", 13) == "X1 = 12.5s/X3.a");
    CHECK(wrapped_formulas("Xlong = abcdefgh", 10) == "Xlong = abcdefgh");
}
