#include <doctest/doctest.h>

#include "text/time.h"

using namespace grafwire;

TEST_CASE("durations are read in every unit") {
    CHECK(parse_duration("1ps") == 1);
    CHECK(parse_duration("3ns") == 3 * nanosecond);
    CHECK(parse_duration("20us") == 20 * microsecond);
    CHECK(parse_duration("7ms") == 7 * millisecond);
    CHECK(parse_duration("5s") == 5 * second);
    CHECK(parse_duration("2min") == 120 * second);
    CHECK(parse_duration("1h") == 3600 * second);
    CHECK(parse_duration("0s") == 0);
    CHECK(parse_duration("007s") == 7 * second);
}

TEST_CASE("fractions are exact") {
    CHECK(parse_duration("1.5s") == 1500 * millisecond);
    CHECK(parse_duration("0.1h") == 6 * minute);
    CHECK(parse_duration("0.000000000001s") == 1);
    CHECK(parse_duration("0.0000000000010000000000000000s") == 1);
    CHECK(parse_duration("0.0000152587890625h") == 54'931'640'625);
    CHECK_FALSE(parse_duration("0.0000000000005s").has_value());
    CHECK_FALSE(parse_duration("0.5ps").has_value());
    CHECK_FALSE(parse_duration("0.3333333333333333333s").has_value());
}

TEST_CASE("what is no duration, or out of range, is refused") {
    for (const char* text : {"", "s", "5", "5 s", " 5s", "5s ", "5sec", ".5s", "5.s", "-5s", "5S",
                             "1e3s", "5.5.5s", "5m"})
        CHECK_MESSAGE(!parse_duration(text).has_value(), text);
    CHECK(parse_duration("2562h") == 2562 * hour);
    CHECK_FALSE(parse_duration("2563h").has_value());
    CHECK_FALSE(parse_duration("99999999999999999999999999s").has_value());
    CHECK(parse_duration("9223372036854775806ps") == never - 1);
    CHECK_FALSE(parse_duration("9223372036854775807ps").has_value());
    CHECK_FALSE(parse_duration("9223372036854775.807ns").has_value());
}

TEST_CASE("durations are written in the largest unit that stays short") {
    CHECK(format_duration(0) == "0s");
    CHECK(format_duration(5 * second) == "5s");
    CHECK(format_duration(90 * second) == "90s");
    CHECK(format_duration(1500 * millisecond) == "1.5s");
    CHECK(format_duration(20 * millisecond) == "20ms");
    CHECK(format_duration(120 * second) == "2min");
    CHECK(format_duration(7200 * second) == "2h");
    CHECK(format_duration(90 * minute) == "90min");
    CHECK(format_duration(1) == "0.000001us");
    CHECK(format_duration(2500 * nanosecond) == "2.5us");
}

TEST_CASE("a written duration reads back as itself") {
    for (Time time = 1; time < never / 7; time = time * 7 + 3) {
        const auto back = parse_duration(format_duration(time));
        REQUIRE(back.has_value());
        CHECK(*back == time);
    }
    CHECK(parse_duration(format_duration(never - 1)) == never - 1);
}

TEST_CASE("moments are written in milliseconds") {
    CHECK(format_milliseconds(0) == "0");
    CHECK(format_milliseconds(100 * millisecond) == "100");
    CHECK(format_milliseconds(500 * microsecond) == "0.5");
    CHECK(format_milliseconds(1500 * millisecond) == "1500");
    CHECK(format_milliseconds(1) == "0.000000001");
}

TEST_CASE("times are written in nanoseconds") {
    CHECK(format_nanoseconds(nanosecond) == "1");
    CHECK(format_nanoseconds(2500) == "2.5");
    CHECK(format_nanoseconds(millisecond) == "1000000");
}

TEST_CASE("adding times stops at never") {
    CHECK(add_times(2, 3) == 5);
    CHECK(add_times(never - 1, 2) == never);
    CHECK(add_times(never, 0) == never);
}
