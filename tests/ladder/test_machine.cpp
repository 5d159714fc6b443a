// What a machine makes of contacts, coils and blocks.

#include <doctest/doctest.h>

#include "ladder/machine.h"

namespace grafwire::testing {

namespace {

using namespace ladder;

/// A diagram in the making, and its scans a millisecond apart.
struct Bench {
    ladder::Ladder diagram;

    VariableId bit(const char* name, Role role = Role::memory) {
        ladder::Variable variable;
        variable.name = name;
        variable.role = role;
        return diagram.add(variable);
    }
    VariableId integer(const char* name) {
        ladder::Variable variable;
        variable.name = name;
        variable.type = Type::integer;
        return diagram.add(variable);
    }
    VariableId instance(BlockType type) {
        ladder::Variable variable;
        variable.name = "block" + std::to_string(diagram.variables.size());
        variable.type = Type::block;
        variable.block = type;
        return diagram.add(variable);
    }
    void rung(Power power, std::vector<ladder::Block> blocks, std::vector<Coil> coils) {
        Rung rung;
        rung.power = std::move(power);
        rung.blocks = std::move(blocks);
        rung.coils = std::move(coils);
        diagram.rungs.push_back(std::move(rung));
    }
    /// The values of `output` while `input` takes those of a text, such as "0110x".
    std::string run(VariableId input, VariableId output, const std::string& values) const {
        const Machine machine(diagram);
        MachineState state = machine.start();
        std::string got;
        Time now = 0;
        for (const char value : values) {
            machine.set(state, input,
                        value == 'x'   ? Logic::unknown
                        : value == '1' ? Logic::one
                                       : Logic::zero);
            const auto outcome = machine.scan(state, now);
            now += millisecond;
            if (outcome.needs) {
                CHECK(*outcome.needs == input);
                return got + "?";
            }
            const Logic bit = state.cells[static_cast<std::size_t>(output)].bit.value;
            got += bit == Logic::unknown ? 'x' : bit == Logic::one ? '1' : '0';
        }
        return got;
    }
};

Operand number(std::int64_t value) {
    return {Operand::Kind::number, value, {}};
}
Operand variable(VariableId id) {
    return {Operand::Kind::variable, 0, id};
}
Operand time(Time value) {
    return {Operand::Kind::time, value, {}};
}

std::string with_block(BlockType type, std::vector<Operand> operands, const std::string& values) {
    Bench bench;
    const VariableId a = bench.bit("a", Role::input);
    const VariableId q = bench.bit("q");
    const VariableId instance = bench.instance(type);
    bench.rung(contact(a), {{type, instance, std::move(operands)}}, {{CoilKind::normal, q}});
    return bench.run(a, q, values);
}

std::string with_coil(CoilKind kind, const std::string& values) {
    Bench bench;
    const VariableId a = bench.bit("a", Role::input);
    const VariableId q = bench.bit("q");
    bench.rung(contact(a), {}, {{kind, q}});
    return bench.run(a, q, values);
}

std::string with_contact(ContactKind kind, const std::string& values) {
    Bench bench;
    const VariableId a = bench.bit("a", Role::input);
    const VariableId q = bench.bit("q");
    bench.rung(contact(a, kind), {}, {{CoilKind::normal, q}});
    return bench.run(a, q, values);
}

}  // namespace

TEST_CASE("coils and contacts") {
    CHECK(with_coil(CoilKind::normal, "0110x") == "0110x");
    CHECK(with_coil(CoilKind::negated, "0110x") == "1001x");
    CHECK(with_coil(CoilKind::set, "01000") == "01111");
    CHECK(with_coil(CoilKind::set, "0x010") == "0xx11");
    CHECK(with_coil(CoilKind::reset, "0100x") == "00000");
    CHECK(with_coil(CoilKind::rising, "1011x") == "10100");
    CHECK(with_coil(CoilKind::falling, "01100") == "00010");
    CHECK(with_contact(ContactKind::negated, "01x") == "10x");
    CHECK(with_contact(ContactKind::rising, "01101x") == "010010");
    CHECK(with_contact(ContactKind::falling, "001100x") == "0000100");
}

TEST_CASE("timers") {
    const std::vector<Operand> two{time(2 * millisecond)};
    CHECK(with_block(BlockType::on_delay, two, "0111101110") == "0001100010");
    CHECK(with_block(BlockType::on_delay, {time(0)}, "0101") == "0101");
    CHECK(with_block(BlockType::off_delay, two, "0010001001000") == "0011101111110");
    CHECK(with_block(BlockType::off_delay, {time(0)}, "0101") == "0101");
    CHECK(with_block(BlockType::on_delay, two, "01x") == "00?");
}

TEST_CASE("triggers, counters and flip-flops") {
    CHECK(with_block(BlockType::rise, {}, "0110x1") == "0100xx");
    CHECK(with_block(BlockType::fall, {}, "001101") == "000010");
    CHECK(with_block(BlockType::count_up, {number(0), number(2)}, "01101010") == "00001111");
    CHECK(with_block(BlockType::count_up, {number(1), number(2)}, "0101010") == "0000000");
    CHECK(with_block(BlockType::count_down, {number(0), number(2)}, "0101") == "1111");
    CHECK(with_block(BlockType::set_dominant, {number(1)}, "0100") == "0100");
    CHECK(with_block(BlockType::set_dominant, {number(0)}, "0100") == "0111");
    CHECK(with_block(BlockType::reset_dominant, {number(1)}, "0100") == "0000");
    CHECK(with_block(BlockType::reset_dominant, {number(0)}, "0100") == "0111");
}

TEST_CASE("arithmetic is done where there is power") {
    Bench bench;
    const VariableId a = bench.bit("a", Role::input);
    const VariableId q = bench.bit("q");
    const VariableId n = bench.integer("n");
    const VariableId sum = bench.integer("sum");
    bench.rung(contact(a),
               {{BlockType::add, sum, {variable(n), number(2)}},
                {BlockType::limit, n, {number(0), variable(sum), number(5)}}},
               {});
    Power comparison;
    comparison.kind = Power::Kind::comparison;
    comparison.relation = Relation::equal;
    comparison.left = variable(n);
    comparison.right = number(5);
    bench.rung(comparison, {}, {{CoilKind::normal, q}});
    CHECK(bench.run(a, q, "1011") == "0001");
    CHECK(bench.run(a, q, "x") == "?");
}

TEST_CASE("a branch is 1 whatever an open input in the other is") {
    Bench bench;
    const VariableId a = bench.bit("a", Role::input);
    const VariableId b = bench.bit("b", Role::input);
    const VariableId q = bench.bit("q");
    bench.rung(parallel({contact(a), contact(b)}), {}, {{CoilKind::normal, q}});
    const Machine machine(bench.diagram);
    MachineState state = machine.start();
    machine.set(state, a, Logic::one);
    machine.set(state, b, Logic::unknown);
    machine.scan(state, 0);
    CHECK(state.cells[static_cast<std::size_t>(q)].bit.value == Logic::one);
    machine.set(state, a, Logic::zero);
    const auto outcome = machine.scan(state, 1);
    const auto& bit = state.cells[static_cast<std::size_t>(q)].bit;
    CHECK(bit.value == Logic::unknown);
    CHECK(bit.cause == b);
    CHECK(outcome.writers[static_cast<std::size_t>(q)] == 0);
    CHECK(outcome.powers == std::vector{Logic::unknown});
    CHECK_FALSE(machine.open_memory(state));  // q is written before anybody reads it
}

TEST_CASE("what is remembered is saved, and states that behave alike have one key") {
    Bench bench;
    const VariableId a = bench.bit("a", Role::input);
    const VariableId q = bench.bit("q");
    const VariableId timer = bench.instance(BlockType::on_delay);
    bench.rung(contact(a), {{BlockType::on_delay, timer, {time(3 * millisecond)}}},
               {{CoilKind::set, q}});
    const Machine machine(bench.diagram);
    CHECK(machine.delays() == std::vector<Time>{3 * millisecond});
    MachineState state = machine.start();
    std::vector<std::string> keys;
    for (Time now = 0; now <= 5 * millisecond; now += millisecond) {
        state = machine.load(machine.save(state));
        machine.set(state, a, Logic::one);
        machine.scan(state, now);
        keys.push_back(machine.key(state, now));
    }
    CHECK(state.cells[static_cast<std::size_t>(q)].bit.value == Logic::one);
    CHECK(keys[0] != keys[1]);
    CHECK(keys[1] != keys[2]);
    CHECK(keys[4] == keys[5]);
}

}  // namespace grafwire::testing
