#include "random_gates.h"

#include "support/small_netlist.h"

namespace grafwire::testing {

namespace {

constexpr CellType types[] = {CellType::nand_gate, CellType::nand_gate, CellType::nor_gate,
                              CellType::and_gate,  CellType::or_gate,   CellType::inverter,
                              CellType::xor_gate,  CellType::latch};

std::string name_of(std::size_t gate) {
    return "g" + std::to_string(gate);
}

}  // namespace

Netlist random_gates(std::mt19937& random, std::size_t gates) {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    for (std::size_t gate = 0; gate < gates; ++gate) {
        const CellType type = types[random() % std::size(types)];
        std::size_t pins = 2 + random() % 2;
        if (type == CellType::inverter) pins = 1;
        if (type == CellType::latch) pins = 2;
        std::vector<std::string> names;
        while (names.size() < pins) {
            const std::size_t source = random() % (gates + 2);
            names.push_back(source < gates ? name_of(source) : source == gates ? "a" : "b");
        }
        small.cell(type, name_of(gate), names);
    }
    return small.netlist;
}

Bits random_bits(std::mt19937& random, const Netlist& netlist) {
    Bits bits(netlist.net_count());
    for (std::uint8_t& bit : bits) bit = static_cast<std::uint8_t>(random() % 2);
    return bits;
}

CircuitState state_of(const Bits& bits) {
    CircuitState state;
    for (const std::uint8_t bit : bits) state.values.push_back(static_cast<Logic>(bit));
    return state;
}

Bits bits_of(const CircuitState& state) {
    Bits bits;
    for (const Logic value : state.values) bits.push_back(static_cast<std::uint8_t>(value));
    return bits;
}

}  // namespace grafwire::testing
