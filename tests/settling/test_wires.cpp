// Gates and wires of any delay: what telling_wires and AnyWire claim, by the definition, on small
// random netlists.

#include <doctest/doctest.h>

#include <algorithm>

#include "all_orders.h"
#include "netlist/passes/wire_delays.h"
#include "random_gates.h"
#include "settling/any_wire.h"
#include "settling/late_orders.h"
#include "settling/ternary.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

std::vector<Wire> all_wires(const Netlist& netlist) {
    std::vector<Wire> wires;
    for (std::size_t i = 0; i < netlist.cells.size(); ++i) {
        for (const NetId net : netlist.pins_of(netlist.cells.items()[i])) {
            const Wire wire{net, netlist.cells.id_at(i)};
            if (std::find(wires.begin(), wires.end(), wire) == wires.end()) wires.push_back(wire);
        }
    }
    return wires;
}

/// A wire shows its net, as it did before an input changed; `before` are the bits then.
Bits with_wires(const Bits& bits, const Bits& before, const std::vector<Wire>& wires) {
    Bits all = bits;
    for (const Wire& wire : wires) all.push_back(before[index_of(wire.net)]);
    return all;
}

/// Of the nets that there are without wires.
Outcomes without_wires(const Outcomes& outcomes, std::size_t nets) {
    Outcomes seen{{}, outcomes.can_go_on_for_ever};
    for (Bits bits : outcomes.rests) {
        bits.resize(nets);
        seen.rests.insert(bits);
    }
    return seen;
}

/// A small netlist in some state, in which inputs have just changed.
struct Moment {
    Netlist netlist;
    Bits before;
    Bits bits;
};

Moment random_moment(std::mt19937& random, std::size_t most_wires) {
    for (;;) {
        Moment moment;
        const std::size_t gates = 2 + random() % 2;
        moment.netlist = random_gates(random, gates);
        moment.netlist.modules.push_back({"all", "", 0, static_cast<std::uint32_t>(gates)});
        if (all_wires(moment.netlist).size() > most_wires) continue;
        moment.before = random_bits(random, moment.netlist);
        moment.bits = moment.before;
        for (const Port& input : moment.netlist.inputs) {
            moment.bits[index_of(input.net)] = static_cast<std::uint8_t>(random() % 2);
        }
        return moment;
    }
}

/// Whether three values say all that can be said of its output: not where inputs are tied together
/// (a XOR a is 0), or where an unknown output may be what holds it (a latch).
bool is_exact(const Netlist& netlist, const Cell& cell) {
    const std::span<const NetId> pins = netlist.pins_of(cell);
    const std::set<NetId> nets(pins.begin(), pins.end());
    return cell.type != CellType::latch && nets.size() == pins.size();
}

/// The same from rest, of such cells alone.
Moment random_start(std::mt19937& random, std::size_t most_wires) {
    for (;;) {
        Moment moment = random_moment(random, most_wires);
        const bool are_exact =
            std::all_of(moment.netlist.cells.begin(), moment.netlist.cells.end(),
                        [&](const Cell& cell) { return is_exact(moment.netlist, cell); });
        if (!are_exact) continue;
        const Outcomes outcomes = outcomes_by_definition(moment.netlist, moment.before);
        if (outcomes.rests.empty()) continue;
        moment.before = *outcomes.rests.begin();
        for (std::size_t net = 0; net < moment.before.size(); ++net) {
            const auto is_it = [&](const Port& port) { return index_of(port.net) == net; };
            const bool is_input =
                std::any_of(moment.netlist.inputs.begin(), moment.netlist.inputs.end(), is_it);
            if (!is_input) moment.bits[net] = moment.before[net];
        }
        return moment;
    }
}

}  // namespace

TEST_CASE("wires: those that are left out make no difference") {
    std::mt19937 random(29);
    int left_out = 0;
    for (int number = 0; number < 250; ++number) {
        CAPTURE(number);
        const Moment moment = random_moment(random, 5);
        const std::vector<Wire> all = all_wires(moment.netlist);
        const std::vector<Wire> telling = telling_wires(moment.netlist);
        if (telling.size() < all.size()) ++left_out;
        const auto outcomes = [&](const std::vector<Wire>& wires) {
            return without_wires(
                outcomes_by_definition(with_wire_delays(moment.netlist, wires),
                                       with_wires(moment.bits, moment.before, wires)),
                moment.netlist.net_count());
        };
        const Outcomes with_all = outcomes(all);
        const Outcomes with_telling = outcomes(telling);
        CHECK(with_telling.rests == with_all.rests);
        CHECK(with_telling.can_go_on_for_ever == with_all.can_go_on_for_ever);
    }
    CHECK(left_out > 50);
}

TEST_CASE("wires: what ternary simulation leaves unknown does depend on delays") {
    std::mt19937 random(31);
    int unknown = 0;
    for (int number = 0; number < 250; ++number) {
        CAPTURE(number);
        const Moment moment = random_start(random, 6);
        const std::vector<Wire> wires = telling_wires(moment.netlist);
        const Netlist wired = with_wire_delays(moment.netlist, wires);
        const Bits start = with_wires(moment.bits, moment.before, wires);
        const Circuit circuit(wired, all_nets(wired));
        const CircuitState rest = ternary_rest(circuit, state_of(start));
        const Outcomes outcomes = outcomes_by_definition(wired, start);
        for (std::size_t net = 0; net < start.size(); ++net) {
            if (rest.values[net] != Logic::unknown) continue;
            ++unknown;
            std::set<std::uint8_t> ends;
            for (const Bits& bits : outcomes.rests) ends.insert(bits[net]);
            const bool is_open = ends.size() == 2 || outcomes.can_go_on_for_ever;
            CHECK(is_open);
        }
    }
    CHECK(unknown > 100);
}

TEST_CASE("wires: the model finds every rest, or leaves open what it does not find") {
    std::mt19937 random(37);
    for (int number = 0; number < 150; ++number) {
        CAPTURE(number);
        const Moment moment = random_moment(random, 5);
        const std::vector<Wire> wires = telling_wires(moment.netlist);
        const Netlist wired = with_wire_delays(moment.netlist, wires);
        const Bits start = with_wires(moment.bits, moment.before, wires);
        const Circuit circuit(wired, all_nets(wired));
        const Outcomes outcomes = outcomes_by_definition(wired, start);
        AnyWire model(circuit, {});
        std::set<Bits> found;
        for (const Rest& rest : model.settle(state_of(start), false, enough).rests) {
            if (rest.kind == Rest::Kind::settles) found.insert(bits_of(rest.state));
        }
        CHECK(found == outcomes.rests);
        // Orders with one late gate are some of them.
        for (const Rest& rest : rests_of_late_gates(circuit, state_of(start), {}).rests) {
            CHECK(outcomes.rests.contains(bits_of(rest.state)));
        }
    }
}
