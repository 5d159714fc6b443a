// What a listing cannot hold is an error that says which limit and what to do.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include "s7/made_listing.h"

namespace grafwire::testing {

namespace {

std::string refused_size(const std::string& chart, const std::string& io = {},
                         std::optional<s7::Cpu> cpu = {}) {
    s7::ListingOptions options;
    options.cpu = cpu;
    const MadeListing result = make_listing(chart, io, options);
    CHECK_FALSE(result.made);
    return result.messages;
}

/// A ring of so many steps.
std::string ring(int steps) {
    std::string chart = "input a\ngraph G0 {\n  initial 0\n";
    for (int s = 1; s < steps; ++s) chart += fmt::format("  step {}\n", s);
    for (int s = 0; s < steps; ++s) chart += fmt::format("  {} -> {} : a\n", s, (s + 1) % steps);
    return chart + "}\n";
}

/// A chart with so many time conditions of that text.
std::string delays(const std::vector<std::string>& texts) {
    std::string chart = "input a\ngraph G0 {\n  initial 0\n";
    for (const std::string& text : texts) chart += "  0 -> 0 : " + text + "\n";
    return chart + "}\n";
}

/// A chart with so many inputs.
std::string inputs(int count) {
    std::string names = "i0";
    for (int i = 1; i < count; ++i) names += fmt::format(", i{}", i);
    return "input " + names + "\ngraph G0 { initial 0 }\n";
}

}  // namespace

TEST_CASE("tables") {
    CHECK(make_listing(ring(80)).made);
    CHECK(
        refused_size(ring(81)) ==
        R"(the chart has 81 steps, and the tables of the method hold 80: wide tables (--tables wide) hold them all
)");
}

TEST_CASE("the process images") {
    CHECK(make_listing(inputs(64)).made);
    CHECK(
        refused_size(inputs(66)) ==
        R"(1:317: input 'i64' finds no room: an S7-200 has 64 inputs, E0.0 … E7.7; give some of them addresses in M or V with an assignment (--io) and carry them over to another controller
1:322: input 'i65' finds no room: an S7-200 has 64 inputs, E0.0 … E7.7; give some of them addresses in M or V with an assignment (--io) and carry them over to another controller
)");
    // An address in V or M helps.
    CHECK(make_listing(inputs(65), "M0.0 = i64").made);
}

TEST_CASE("timers") {
    // 4 of 10 ms, those of 1 ms after them; 8 and 2 on a CPU 214.
    std::vector<std::string> fine;
    for (int i = 1; i <= 5; ++i) fine.push_back(fmt::format("{}ms/a", 10 * i));
    s7::ListingOptions of_212;
    of_212.cpu = s7::Cpu::cpu_212;
    CHECK(make_listing(delays(fine), {}, of_212).made);
    fine.push_back("60ms/a");
    CHECK(
        refused_size(delays(fine), {}, s7::Cpu::cpu_212) ==
        R"(no timer of 10ms or finer is left on a CPU 212 for 60ms of '60ms/a'; round delays to 100 ms, of which there are most timers, or take a CPU 214, which has twice as many
)");
    // Without a controller in mind it is a CPU 214, and the head says so.
    const MadeListing of_214 = make_listing(delays(fine));
    REQUIRE(of_214.made);
    const std::vector<std::string>& head = of_214.made->listing.head;
    CHECK(head.at(5) == "CPU 212, 1024 bytes of program, 1024 of V memory: does not fit.");
    CHECK(head.at(6) == "CPU 214, 4096 bytes of program, 4096 of V memory: fits.");
    CHECK(
        refused_size(delays({"1ms/a", "2ms/a/3ms"})) ==
        R"(no timer of 1ms is left on a CPU 214 for 3ms of '2ms/a/3ms'; round delays to 100 ms, of which there are most timers
)");
    CHECK(
        refused_size(delays({"1.5ms/a", "2h/a", "33.001s/a"})) ==
        R"(no timer of an S7-200 counts 1.5ms of '1.5ms/a': the timers count up to 32767 times 1 ms, 10 ms or 100 ms; choose a delay that is a multiple of one of these, or divide a long one between two steps
no timer of an S7-200 counts 2h of '2h/a': the timers count up to 32767 times 1 ms, 10 ms or 100 ms; choose a delay that is a multiple of one of these, or divide a long one between two steps
no timer of an S7-200 counts 33.001s of '33.001s/a': the timers count up to 32767 times 1 ms, 10 ms or 100 ms; choose a delay that is a multiple of one of these, or divide a long one between two steps
)");
    CHECK(make_listing(delays({"33s/a", "3276.7s/a", "32.767s/a"})).made);
}

TEST_CASE("integers") {
    CHECK(
        refused_size(R"(
        input a
        counter n : 2147483000..2147483640
        graph G0 { initial 0 : n := n + n on ↑a })") ==
        R"(4:32: a sum in 'n on an event in step 0' can reach beyond the 32 bits that an S7-200 counts with; narrow the ranges of the counters
)");
    CHECK(
        refused_size(R"(
        input a
        counter n : 0..40000
        graph G0 { initial 0 : n := n + 1 on ↑a })",
                     "VW100 = n\n") ==
        R"(3:17: counter 'n' needs a double word in the assignment (VD instead of VW): a counter or sum of this chart needs more than 16 bits, or another counter has a double word
)");
}

TEST_CASE("memory") {
    s7::ListingOptions of_212;
    of_212.cpu = s7::Cpu::cpu_212;
    CHECK(make_listing(ring(16), {}, of_212).made);
    CHECK(
        refused_size(ring(40), {}, s7::Cpu::cpu_212) ==
        R"(the program takes 1512 bytes, and the program memory of a CPU 212 holds 1024: take a CPU 214
)");
    s7::ListingOptions options;
    options.cpu = s7::Cpu::cpu_214;
    CHECK(make_listing(ring(80), {}, options).made);
    options.wide_tables = true;
    for (const bool modes : {false, true}) {
        const MadeListing wide = make_listing(ring(200), {}, options, modes);
        CHECK_FALSE(wide.made);
        const std::string remedy = modes ? "leave out the modes (--modes off), or " : "";
        CHECK(wide.messages ==
              fmt::format("the program takes {} bytes, and the program memory of a CPU 214 holds "
                          "4096: {}divide the chart between two controllers\n",
                          modes ? 6331 : 6304, remedy));
    }
    const MadeListing huge = [] {
        s7::ListingOptions wide_only;
        wide_only.wide_tables = true;
        return make_listing(ring(5000), {}, wide_only);
    }();
    CHECK_FALSE(huge.made);
    CHECK(
        huge.messages ==
        R"(the program needs 5034 bytes of V memory, and a CPU 214 has 4096: divide the chart between two controllers
)");
}

}  // namespace grafwire::testing
