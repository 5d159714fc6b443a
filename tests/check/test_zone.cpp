#include <doctest/doctest.h>

#include <random>

#include "check/path.h"
#include "check/zone.h"
#include "grafcet/parse_grafcet.h"

namespace grafwire::testing {

namespace {

using Origin = Zone::Origin;

Origin begins(std::int64_t grains) {
    return {Origin::begins, grains};
}

/// Whether the delays can end in this way: per delay, at the moment or later.
bool can_end(Zone zone, const std::vector<bool>& ends) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (!(ends[i] ? zone.let_end(i) : zone.let_run_on(i))) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("of delays that begin together the shorter ends first") {
    const Zone zone = Zone().with({begins(10), begins(30)}).later();
    CHECK(can_end(zone, {false, false}));
    CHECK(can_end(zone, {true, false}));
    CHECK_FALSE(can_end(zone, {false, true}));
    CHECK_FALSE(can_end(zone, {true, true}));
}

TEST_CASE("of delays that begin one after the other either can end first, or both at once") {
    Zone zone = Zone().with({begins(30)}).later();
    REQUIRE(zone.let_run_on(0));
    zone = zone.with({{0, 0}, begins(10)}).later();
    CHECK(can_end(zone, {false, false}));
    CHECK(can_end(zone, {true, false}));
    CHECK(can_end(zone, {false, true}));
    CHECK(can_end(zone, {true, true}));
    // Not if they are as long as each other: some time has passed in between.
    Zone equal = Zone().with({begins(10)}).later();
    REQUIRE(equal.let_run_on(0));
    equal = equal.with({{0, 0}, begins(10)}).later();
    CHECK(can_end(equal, {true, false}));
    CHECK_FALSE(can_end(equal, {false, true}));
    CHECK_FALSE(can_end(equal, {true, true}));
}

TEST_CASE("how far a delay is when it is last seen does not matter") {
    const Zone begun = Zone().with({begins(10)}).later();
    Zone seen = begun;
    REQUIRE(seen.let_run_on(0));
    CHECK(seen.with({{0, 0}}).later() == begun);
}

TEST_CASE("a zone includes what is possible in a smaller one, and not the reverse") {
    const Zone together = Zone().with({begins(30), begins(10)}).later();
    Zone apart = Zone().with({begins(30)}).later();
    REQUIRE(apart.let_run_on(0));
    apart = apart.with({{0, 0}, begins(10)}).later();
    CHECK_FALSE(apart.includes(together));  // there the longer one has been running for a while
    CHECK_FALSE(together.includes(apart));
    CHECK(Zone::unbounded(2).includes(together));
    CHECK(Zone::unbounded(2).includes(apart));
    CHECK_FALSE(apart.includes(Zone::unbounded(2)));
    CHECK(can_end(Zone::unbounded(2), {false, true}));
    CHECK(can_end(Zone::unbounded(2), {true, true}));
}

// Zones against moments: a random run of delays that begin, end and are dropped is possible by
// zones exactly if difference constraints have a solution for it.
TEST_CASE("zones allow what has moments, and nothing else") {
    Diagnostics diagnostics;
    const auto grafcet =
        parse_grafcet({"no inputs", "graph G { initial 0 }"}, diagnostics).value_or(Grafcet());
    const Assumptions assumptions(grafcet);
    const PartialInputs none(grafcet.all_input_count(), PartialInput::zero);
    std::size_t possible = 0;
    std::size_t impossible = 0;
    for (std::uint32_t seed = 1; seed <= 3000; ++seed) {
        std::minstd_rand random(seed);
        const auto below = [&](std::uint32_t bound) {
            return static_cast<std::uint32_t>(random() % bound);
        };
        Zone zone;
        std::vector<RunningDelay> running;
        std::vector<PathStep> path;
        bool goes_on = true;
        for (std::size_t instant = 0; goes_on && instant < 8; ++instant) {
            std::vector<bool> ends(running.size());
            for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = below(3) == 0;
            PathStep step{none, none, {}, running};
            for (std::size_t i = 0; i < ends.size(); ++i) step.running[i].ends = ends[i];
            path.push_back(std::move(step));
            for (std::size_t i = 0; goes_on && i < ends.size(); ++i) {
                goes_on = ends[i] ? zone.let_end(i) : zone.let_run_on(i);
            }
            const bool has_moments =
                stimuli_for(grafcet, assumptions, path, gaps_for(path).back()).has_value();
            INFO("seed " << seed << ", instant " << instant);
            REQUIRE(goes_on == has_moments);
            ++(goes_on ? possible : impossible);
            if (!goes_on) break;

            std::vector<Origin> origins;
            std::vector<RunningDelay> next;
            for (std::uint32_t i = 0; i < running.size(); ++i) {
                if (ends[i] || below(5) == 0) continue;
                origins.push_back({i, 0});
                next.push_back(running[i]);
            }
            for (std::uint32_t more = below(3); more > 0 && next.size() < 5; --more) {
                const std::int64_t length = 1 + below(4);
                origins.push_back(begins(length));
                next.push_back({instant, length * second, false});
            }
            zone = zone.with(origins).later();
            running = std::move(next);
        }
    }
    CHECK(possible > 3000);
    CHECK(impossible > 500);
}

}  // namespace grafwire::testing
