// Stored outputs, vars and counters of the clocked style: registers, and what is written to them.
// The writes stand in the order of their execution, each choosing between its value and what was
// there: the last one wins.

#include <cstdlib>

#include "netlist/styles/clocked.h"

namespace grafwire {

namespace {

/// The net that is 1 when a write happens.
NetId trigger_of(ClockedBuild& build, const StoredWrite& write, NumberedGates& at) {
    const GateMaker& gates = at.gates;
    const std::size_t step = index_of(write.step);
    const std::string role = "when" + at.next_role();
    switch (write.cause) {
        case StoredWrite::Cause::deactivation:
            return gates.gate(CellType::and_gate,
                              {build.now.steps[step], gates.inverted(build.writing.steps[step])},
                              role);
        case StoredWrite::Cause::activation:
            return gates.gate(CellType::and_gate,
                              {gates.inverted(build.now.steps[step]), build.writing.steps[step]},
                              role);
        case StoredWrite::Cause::clearing:
            return build.clearing[index_of(write.transition)];
        case StoredWrite::Cause::event: {
            const NetId event = build.net(build.writing, write.event, at);
            return gates.gate(CellType::and_gate, {build.writing.steps[step], event}, role);
        }
    }
    return gates.low();
}

/// `held`: what the register holds; returns what it will hold.
NetId make_bit(ClockedBuild& build, const StoredEquation& stored, NetId held, NumberedGates at) {
    Arithmetic arithmetic(at.gates.named(at.gates.owner() + "$next"));
    NetId next = held;
    for (const StoredWrite& write : stored.writes) {
        const NetId value = build.net(build.writing, write.value, at);
        const NetId when = trigger_of(build, write, at);
        next = arithmetic.choose(when, value, next);
    }
    build.add_flip_flop(held, next, false, at.gates);
    return next;
}

/// Likewise for the register of a counter; returns the value it will have.
Word make_counter(ClockedBuild& build, const StoredEquation& stored, const Counter& counter,
                  const std::vector<NetId>& bits, NumberedGates at) {
    Arithmetic arithmetic(at.gates.named(at.gates.owner() + "$next"));
    // All words hold the position above the low end.
    Word next = bits;
    next.push_back(at.gates.low());
    for (const StoredWrite& write : stored.writes) {
        const NetId when = trigger_of(build, write, at);
        const Word low = arithmetic.constant(counter.low, 65);
        Word position = arithmetic.subtract(arithmetic.sum(write.sum, build.writing.counters), low);
        const NetId below = arithmetic.is_negative(position);
        const Word top = arithmetic.constant(counter.high - counter.low, bits.size() + 1);
        const NetId above = arithmetic.compare(position, Relation::greater, top);
        position.resize(bits.size() + 1);
        position = arithmetic.choose(above, top, position);
        position = arithmetic.choose(below, arithmetic.constant(0, bits.size() + 1), position);
        next = arithmetic.choose(when, position, next);
    }
    for (std::size_t bit = 0; bit < bits.size(); ++bit) {
        build.add_flip_flop(bits[bit], next[bit], false, at.gates);
    }
    next.resize(bits.size());
    next.push_back(at.gates.low());
    const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)}, {false, 0, 0}};
    return arithmetic.sum(offset, {next});
}

}  // namespace

void make_registers(ClockedBuild& build) {
    const Grafcet& grafcet = build.grafcet;
    const std::vector<Observed>& registers = build.chart.builder().netlist().counters;
    std::vector<std::uint8_t> written(grafcet.counters.size());
    for (const StoredEquation& stored : build.equations.stored) {
        const std::uint32_t index = stored.target.index;
        if (stored.target.kind == VariableKind::output) {
            const OutputId id{index};
            build.after.outputs[index] =
                make_bit(build, stored, build.now.outputs[index],
                         build.add_module(grafcet.outputs[id].name, build.chart.origin_of(id)));
        } else if (stored.target.kind == VariableKind::var) {
            const VarId id{index};
            build.after.vars[index] =
                make_bit(build, stored, build.now.vars[index],
                         build.add_module(grafcet.vars[id].name, build.chart.origin_of(id)));
        } else {
            const CounterId id{index};
            const Counter& counter = grafcet.counters[id];
            written[index] = 1;
            build.after.counters[index] =
                make_counter(build, stored, counter, registers[index].bits,
                             build.add_module(counter.name, build.chart.origin_of(id)));
        }
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written[i] != 0) continue;
        const CounterId id = grafcet.counters.id_at(i);
        const GateMaker gates =
            build.chart.add_module(grafcet.counters[id].name, build.chart.origin_of(id));
        for (const NetId bit : registers[i].bits) gates.add_cell(CellType::low, bit, {});
    }
}

}  // namespace grafwire
