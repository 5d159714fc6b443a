#include <doctest/doctest.h>

#include "all_orders.h"
#include "random_gates.h"
#include "settling/ternary.h"

using namespace grafwire;
using namespace grafwire::testing;

TEST_CASE("ternary: what is known at rest is so in every order, on random netlists") {
    std::mt19937 random(3);
    int known = 0;
    int partly = 0;
    for (int number = 0; number < 800; ++number) {
        CAPTURE(number);
        const Netlist netlist = random_gates(random, 2 + random() % 5);
        const Bits start = random_bits(random, netlist);
        const Circuit circuit(netlist, all_nets(netlist));
        const CircuitState rest = ternary_rest(circuit, state_of(start));
        const Outcomes outcomes = outcomes_by_definition(netlist, start);
        for (const Bits& bits : outcomes.rests) {
            for (std::size_t net = 0; net < bits.size(); ++net) {
                const bool allows = rest.values[net] == Logic::unknown ||
                                    rest.values[net] == static_cast<Logic>(bits[net]);
                CHECK(allows);
            }
        }
        if (!is_known(circuit, rest)) {
            ++partly;
            continue;
        }
        ++known;
        CHECK(outcomes.rests == std::set<Bits>{bits_of(rest)});
        CHECK(!outcomes.can_go_on_for_ever);
    }
    CHECK(known > 100);
    CHECK(partly > 100);
}
