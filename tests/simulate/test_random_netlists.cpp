#include <doctest/doctest.h>

#include <optional>
#include <random>

#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

// Random netlists of gates and latches against an oracle that knows nothing of events: every
// nanosecond it evaluates every cell from its pins, and all outputs change together.

namespace {

using Values = std::vector<Logic>;

Logic naive_gate(const Netlist& netlist, const Cell& cell, const Values& values) {
    bool all = true;
    bool any = false;
    bool odd = false;
    bool doubt = false;
    for (const NetId pin : netlist.pins_of(cell)) {
        const Logic value = values[index_of(pin)];
        if (value == unknown) doubt = true;
        if (value == zero) all = false;
        if (value == one) any = true;
        if (value == one) odd = !odd;
    }
    const auto inverted = [](Logic value) {
        return value == unknown ? unknown : value == one ? zero : one;
    };
    const Logic conjunction = !all ? zero : doubt ? unknown : one;
    const Logic disjunction = any ? one : doubt ? unknown : zero;
    switch (cell.type) {
        case CellType::and_gate:
            return conjunction;
        case CellType::nand_gate:
            return inverted(conjunction);
        case CellType::nor_gate:
        case CellType::inverter:
            return inverted(disjunction);
        case CellType::high:
            return one;
        case CellType::xor_gate:
            return doubt ? unknown : odd ? one : zero;
        default:
            return disjunction;
    }
}

/// The latch as its definition says, by trying both values for what is unknown.
Logic naive_latch(Logic set, Logic reset, Logic held) {
    std::optional<bool> agreed;
    for (unsigned fill = 0; fill < 8; ++fill) {
        const bool s = (fill & 1U) != 0;
        const bool r = (fill & 2U) != 0;
        const bool h = (fill & 4U) != 0;
        const auto fits = [](Logic value, bool bit) {
            return value == unknown || (value == one) == bit;
        };
        if (!fits(set, s) || !fits(reset, r) || !fits(held, h)) continue;
        const bool result = s || (!r && h);
        if (agreed && *agreed != result) return unknown;
        agreed = result;
    }
    return *agreed ? one : zero;
}

Values next_values(const Netlist& netlist, const Values& values) {
    Values next = values;
    for (const Cell& cell : netlist.cells) {
        const auto pins = netlist.pins_of(cell);
        next[index_of(cell.output)] =
            cell.type == CellType::latch
                ? naive_latch(values[index_of(pins[0])], values[index_of(pins[1])],
                              values[index_of(cell.output)])
                : naive_gate(netlist, cell, values);
    }
    return next;
}

SmallNetlist random_netlist(std::mt19937& random, std::size_t inputs, std::size_t cells) {
    SmallNetlist small;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < inputs; ++i) {
        names.push_back("i" + std::to_string(i));
        small.input(names.back());
    }
    for (std::size_t i = 0; i < cells; ++i) names.push_back("g" + std::to_string(i));
    constexpr CellType types[] = {CellType::buffer,   CellType::inverter,  CellType::and_gate,
                                  CellType::or_gate,  CellType::nand_gate, CellType::nor_gate,
                                  CellType::xor_gate, CellType::latch};
    for (std::size_t i = 0; i < cells; ++i) {
        const CellType type = types[random() % std::size(types)];
        const std::size_t wanted = 1 + random() % 4;
        const std::size_t count = std::min<std::size_t>(
            std::max<std::size_t>(wanted, row_of(type).min_pins), row_of(type).max_pins);
        std::vector<std::string> pins;
        for (std::size_t pin = 0; pin < count; ++pin) {
            // Mostly forward, so that many netlists settle; sometimes any net at all.
            const std::size_t reach = random() % 8 == 0 ? names.size() : inputs + i;
            pins.push_back(names[random() % reach]);
        }
        small.cell(type, names[inputs + i], pins, random() % 2 == 0 ? zero : one);
    }
    return small;
}

}  // namespace

TEST_CASE("random netlists do nanosecond by nanosecond what the naive simulation does") {
    std::mt19937 random(20260);
    std::size_t oscillations = 0;
    std::size_t settled = 0;
    for (int round = 0; round < 600; ++round) {
        CAPTURE(round);
        SmallNetlist small = random_netlist(random, 1 + random() % 4, 1 + random() % 24);
        const Netlist& netlist = small.netlist;
        CellDelays delays = cell_delays(netlist, {});
        if (round % 2 == 1) {
            // An idle cell of another delay: the same events by way of the wheel.
            small.cell(CellType::high, "idle", {});
            delays.rise.push_back(500);
            delays.fall.push_back(500);
        }
        Simulator simulator(netlist, delays);
        Values values(netlist.net_count());
        for (std::size_t net = 0; net < values.size(); ++net) {
            values[net] = simulator.value(static_cast<NetId>(net));
        }
        std::optional<Preparation> idle;
        Time start = 0;
        std::vector<Values> history;
        simulator.observe([&](Time at, NetId net, Logic value) {
            const auto moment = static_cast<std::size_t>((at - start) / nanosecond);
            while (history.size() <= moment) history.push_back(history.back());
            history[moment][index_of(net)] = value;
        });
        for (int instant = 0; instant < 6; ++instant) {
            start = simulator.now() + 50 * nanosecond;
            simulator.begin_instant(start);
            history.assign(1, values);
            for (const Port& input : netlist.inputs) {
                const Logic value = all_values[random() % 8 == 0 ? 2 : random() % 2];
                simulator.set_input(input.net, value);
                values[index_of(input.net)] = value;
            }
            if (round % 2 == 1) {
                values.back() = one;
                if (instant == 0) idle.emplace(simulator).hold(small.net("idle"), one);
            }
            const Settling settling = simulator.settle();
            std::size_t moment = 0;
            for (; moment < history.size(); ++moment) {
                REQUIRE(history[moment] == values);
                values = next_values(netlist, values);
            }
            if (settling.settled) {
                REQUIRE(history.back() == values);
                ++settled;
                continue;
            }
            // The oracle must come back to where it is, and change just these nets on the way.
            ++oscillations;
            values = history.back();
            const Values first = values;
            std::vector<bool> changes(values.size(), false);
            std::size_t period = 0;
            do {
                const Values next = next_values(netlist, values);
                for (std::size_t net = 0; net < next.size(); ++net) {
                    if (next[net] != values[net]) changes[net] = true;
                }
                values = next;
                REQUIRE(++period <= history.size());
            } while (values != first);
            std::vector<NetId> changing;
            for (std::size_t net = 0; net < changes.size(); ++net) {
                if (changes[net]) changing.push_back(static_cast<NetId>(net));
            }
            REQUIRE(settling.oscillating == changing);
            break;
        }
    }
    CHECK(oscillations > 30);
    CHECK(settled > 1000);
}
