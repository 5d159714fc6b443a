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
