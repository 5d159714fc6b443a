#include <doctest/doctest.h>

#include "iec/identifiers.h"
#include "iec/literals.h"

namespace grafwire::testing {

using namespace iec;

TEST_CASE("names become identifiers, one-to-one") {
    Identifiers identifiers;
    CHECK(identifiers.add({"V+", "V_plus", "v_PLUS", "↑dcy", "5s/X13", "Marche Moteur", "été",
                           "STEP", "a__b", "日本", "a", "A"}) ==
          std::vector<std::string>{"V_plus_2", "V_plus", "v_PLUS_3", "rise_dcy", "n5s_X13",
                                   "Marche_Moteur", "ete", "STEP_2", "a_b", "u65E5u672C", "a",
                                   "A_2"});
    CHECK(identifiers.add({"a", "b"}) == std::vector<std::string>{"a_3", "b"});
}

TEST_CASE("identifiers") {
    for (const char* name : {"a", "_x1", "X13", "Tempo_2", "S1", "Q"}) CHECK(is_identifier(name));
    for (const char* name : {"s1", "clk", "ld"}) CHECK(is_il_keyword(name));
    CHECK_FALSE(is_il_keyword("q"));
    for (const char* name : {"", "1a", "a_", "a__b", "a b", "é", "TON", "and"}) {
        CHECK_FALSE(is_identifier(name));
    }
}

TEST_CASE("literals of IEC 61131-3") {
    CHECK(time_literal(0) == "T#0s");
    CHECK(time_literal(5 * minute) == "T#5m");
    CHECK(time_literal(90 * second + 500 * millisecond) == "T#90.5s");
    CHECK(time_literal(250 * microsecond) == "T#0.25ms");
    CHECK(time_literal(nanosecond) == "T#0.000001ms");
    for (const Time time : {Time{0}, 90 * second, 3 * hour + millisecond, 250 * microsecond}) {
        CHECK(parse_time_literal(time_literal(time)) == time);
    }
    CHECK(parse_time_literal("time#1_000.5ms") == 1000 * millisecond + 500 * microsecond);
    CHECK(parse_time_literal("T#1d2h") == 26 * hour);
    for (const char* text : {"", "T#", "5s", "T#5", "T#-5s", "T#5s x", "X#5s"}) {
        CHECK_FALSE(parse_time_literal(text));
    }
    CHECK(parse_number_literal("-12") == -12);
    CHECK(parse_number_literal("INT#16#fF") == 255);
    CHECK(parse_number_literal("2#1010_1010") == 170);
    CHECK(parse_number_literal("true") == 1);
    CHECK(parse_number_literal("BOOL#FALSE") == 0);
    for (const char* text : {"", "a", "1.5", "7#1", "99999999999999999999"}) {
        CHECK_FALSE(parse_number_literal(text));
    }
}

}  // namespace grafwire::testing
