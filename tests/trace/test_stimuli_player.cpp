#include <doctest/doctest.h>

#include "trace/input_values.h"

using namespace grafwire;

TEST_CASE("stimuli are played up to and including a time") {
    Stimuli stimuli;
    stimuli.changes.push_back({0, {{1, true}}, {}});
    stimuli.changes.push_back({5, {}, {}});
    stimuli.changes.push_back({10, {{0, true}, {1, false}}, {}});
    stimuli.changes.push_back({20, {{2, true}, {2, false}, {0, false}}, {}});
    stimuli.end = 30;
    StimuliPlayer player(stimuli, 3);
    CHECK(player.inputs() == InputValues{0, 0, 0});
    CHECK(player.next_change() == 0);
    CHECK(player.advance(0));
    CHECK(player.inputs() == InputValues{0, 1, 0});
    CHECK(player.next_change() == 5);
    CHECK_FALSE(player.advance(4));
    CHECK(player.advance(5));  // a line that changes nothing is a change as well
    CHECK(player.inputs() == InputValues{0, 1, 0});
    CHECK_FALSE(player.advance(9));
    CHECK(player.advance(25));  // two lines at once, the later one on top
    CHECK(player.inputs() == InputValues{0, 0, 0});
    CHECK(player.next_change() == never);
    CHECK_FALSE(player.advance(never));
}

TEST_CASE("inputs in three values are all known") {
    CHECK(known_inputs({0, 1}) == std::vector{Logic::zero, Logic::one});
    CHECK(known_inputs({}).empty());
}
