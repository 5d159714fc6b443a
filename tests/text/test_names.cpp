#include <doctest/doctest.h>

#include "text/diagnostics.h"
#include "text/nearest_name.h"

using namespace grafwire;

TEST_CASE("the nearest name is the one with the fewest changes") {
    CHECK(nearest_name("strat", {"stop", "start", "stat"}) == "start");
    CHECK(nearest_name("lampe", {"pump", "lamp"}) == "lamp");
    CHECK(nearest_name("dcx", {"au", "dcy"}) == "dcy");
    CHECK(nearest_name("h2", {"v0", "h0", "h1"}) == "h0");
    CHECK(nearest_name("étape", {"etape", "XX"}) == "etape");
    CHECK(nearest_name("AUdux", {"AUdur", "AUdoux"}) == "AUdur");
}

TEST_CASE("a name that is not near is not suggested") {
    CHECK(nearest_name("pump", {"lamp", "start"}).empty());
    CHECK(nearest_name("a", {"b", "c"}).empty());
    CHECK(nearest_name("abcdef", {"abcxyz"}).empty());
    CHECK(nearest_name("abcdef", {"abcdxy"}) == "abcdxy");
    CHECK(nearest_name("x", {}).empty());
}
