#include <doctest/doctest.h>

#include <functional>

#include "support/small_netlist.h"

using namespace grafwire;
using namespace grafwire::testing;

namespace {

/// What a gate of known inputs gives, said in the plainest way.
bool plain_value(CellType type, const std::vector<bool>& inputs) {
    bool all = true;
    bool any = false;
    bool odd = false;
    for (const bool input : inputs) {
        all = all && input;
        any = any || input;
        odd = odd != input;
    }
    switch (type) {
        case CellType::high:
            return true;
        case CellType::buffer:
        case CellType::or_gate:
            return any;
        case CellType::and_gate:
            return all;
        case CellType::inverter:
        case CellType::nor_gate:
            return !any;
        case CellType::nand_gate:
            return !all;
        case CellType::xor_gate:
            return odd;
        default:
            return false;
    }
}

/// Kleene: known if all ways to fill in the unknown inputs agree.
Logic agreed_value(const std::vector<Logic>& inputs,
                   const std::function<bool(const std::vector<bool>&)>& plain) {
    bool can_be_0 = false;
    bool can_be_1 = false;
    for (unsigned fill = 0; fill < 1U << inputs.size(); ++fill) {
        std::vector<bool> bits;
        bool fits = true;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const bool bit = (fill >> i & 1U) != 0;
            bits.push_back(bit);
            fits = fits && (inputs[i] == unknown || inputs[i] == (bit ? one : zero));
        }
        if (!fits) continue;
        (plain(bits) ? can_be_1 : can_be_0) = true;
    }
    if (can_be_0 && can_be_1) return unknown;
    return can_be_1 ? one : zero;
}

void check_gate(CellType type, std::size_t pin_count) {
    SmallNetlist small;
    std::vector<std::string> pins;
    for (std::size_t i = 0; i < pin_count; ++i) {
        pins.push_back("i" + std::to_string(i));
        small.input(pins.back());
    }
    small.cell(type, "y", pins);
    std::size_t combinations = 1;
    for (std::size_t i = 0; i < pin_count; ++i) combinations *= 3;
    // From power-up, and from every combination to every other.
    Bench bench(small);
    for (std::size_t from = 0; from < combinations; ++from) {
        for (std::size_t to = 0; to < combinations; ++to) {
            for (const std::size_t combination : {from, to}) {
                std::vector<Logic> inputs;
                std::size_t rest = combination;
                for (std::size_t i = 0; i < pin_count; ++i, rest /= 3) {
                    inputs.push_back(all_values[rest % 3]);
                    bench.set(pins[i], inputs.back());
                }
                REQUIRE(bench.simulator.settle().settled);
                REQUIRE(bench.get("y") == agreed_value(inputs, [&](const std::vector<bool>& bits) {
                            return plain_value(type, bits);
                        }));
            }
        }
    }
}

}  // namespace

TEST_CASE("every gate gives what its possible inputs agree on") {
    for (const CellType type : {CellType::buffer, CellType::inverter}) check_gate(type, 1);
    for (const CellType type : {CellType::low, CellType::high}) check_gate(type, 0);
    for (const CellType type : {CellType::and_gate, CellType::or_gate, CellType::nand_gate,
                                CellType::nor_gate, CellType::xor_gate}) {
        for (std::size_t pins = 1; pins <= 4; ++pins) {
            CAPTURE(row_of(type).name);
            CAPTURE(pins);
            check_gate(type, pins);
        }
    }
}

TEST_CASE("a gate may have very many pins, and read a net more than once") {
    SmallNetlist small;
    std::vector<std::string> pins;
    for (int i = 0; i < 70'000; ++i) {
        pins.push_back("i" + std::to_string(i));
        small.input(pins.back());
    }
    small.cell(CellType::and_gate, "and", pins);
    small.cell(CellType::nor_gate, "nor", pins);
    small.cell(CellType::and_gate, "twice", {"i0", "i0", "i1"});
    small.cell(CellType::xor_gate, "cancelled", {"i0", "i1", "i0"});
    Bench bench(small);
    for (const std::string& pin : pins) bench.set(pin, one);
    bench.simulator.settle();
    CHECK(bench.get("and") == one);
    CHECK(bench.get("nor") == zero);
    CHECK(bench.get("twice") == one);
    CHECK(bench.get("cancelled") == one);
    bench.step("i69999", unknown);
    CHECK(bench.get("and") == unknown);
    CHECK(bench.get("nor") == zero);
    bench.step("i0", zero);
    CHECK(bench.get("and") == zero);
    CHECK(bench.get("twice") == zero);
    CHECK(bench.get("cancelled") == one);
    for (const std::string& pin : pins) bench.set(pin, zero);
    bench.simulator.settle();
    CHECK(bench.get("nor") == one);
}

TEST_CASE(
    "at power-up all is unknown but what has an initial value, and constants come by themselves") {
    SmallNetlist small;
    small.input("a");
    small.cell(CellType::high, "h", {});
    small.cell(CellType::inverter, "n", {"a"});
    small.cell(CellType::flip_flop, "q", {"a", "c"}, one);
    small.input("c");
    small.cell(CellType::buffer, "b", {"n"});
    small.starts_at("b", false);
    Bench bench(small);
    bench.simulator.power_up();
    bench.set("c", zero);
    CHECK(bench.get("a") == unknown);
    CHECK(bench.get("h") == unknown);
    CHECK(bench.get("n") == unknown);
    CHECK(bench.get("q") == one);
    CHECK(bench.get("b") == zero);
    CHECK(bench.simulator.settle().settled);
    CHECK(bench.get("h") == one);
    CHECK(bench.get("q") == one);
    CHECK(bench.get("b") == unknown);
    CHECK(bench.simulator.now() == nanosecond);
}

TEST_CASE("a net that is held keeps its value until it is released") {
    SmallNetlist small;
    small.input("a");
    small.cell(CellType::buffer, "y", {"a"});
    small.cell(CellType::inverter, "z", {"y"});
    small.cell(CellType::xor_gate, "w", {"a", "a"});
    Bench bench(small);
    bench.step("a", one);
    Preparation preparation(bench.simulator);
    preparation.hold(small.net("y"), zero);
    preparation.hold(small.net("w"), one);
    bench.simulator.settle();
    CHECK(bench.get("z") == one);
    bench.step("a", zero);
    bench.step("a", one);
    CHECK(bench.get("y") == zero);
    CHECK(bench.get("w") == one);
    preparation.release();
    CHECK(bench.get("y") == zero);
    bench.simulator.settle();
    CHECK(bench.get("y") == one);
    CHECK(bench.get("z") == zero);
    CHECK(bench.get("w") == zero);
    preparation.hold(small.net("y"), zero);
    bench.simulator.power_up();
    bench.step("a", one);
    CHECK(bench.get("y") == one);
}
