// Stored outputs, vars and counters of the clocked style: registers, and what is written to them.

#include <cstdlib>

#include "netlist/styles/clocked_build.h"

namespace grafwire {

NetId ClockedBuild::trigger(const StoredWrite& write) {
    const std::size_t step = index_of(write.step);
    const std::string role = "when" + next_role();
    switch (write.cause) {
        case StoredWrite::Cause::deactivation:
            return gate(CellType::and_gate,
                        {now_.steps[step], builder_.inverted(writing_.steps[step])}, role);
        case StoredWrite::Cause::activation:
            return gate(CellType::and_gate,
                        {builder_.inverted(now_.steps[step]), writing_.steps[step]}, role);
        case StoredWrite::Cause::clearing:
            return clearing_[index_of(write.transition)];
        case StoredWrite::Cause::event: {
            const NetId event = net(writing_, write.event);
            return gate(CellType::and_gate, {writing_.steps[step], event}, role);
        }
    }
    return builder_.low();
}

/// The writes in the order of their execution, each choosing between its value and what was there:
/// the last one wins.
void ClockedBuild::write_bit(const StoredEquation& stored) {
    const bool is_output = stored.target.kind == VariableKind::output;
    const std::uint32_t index = stored.target.index;
    const NetId held = (is_output ? now_.outputs : now_.vars)[index];
    Arithmetic arithmetic(builder_, owner_ + "$next");
    NetId next = held;
    for (const StoredWrite& write : stored.writes) {
        const NetId value = net(writing_, write.value);
        const NetId when = trigger(write);
        next = arithmetic.choose(when, value, next);
    }
    (is_output ? after_.outputs : after_.vars)[index] = next;
    flip_flop(held, next, false);
}

void ClockedBuild::write_counter(const StoredEquation& stored) {
    const std::uint32_t index = stored.target.index;
    const Counter& counter = grafcet_.counters[CounterId{index}];
    const std::vector<NetId>& bits = builder_.netlist().counters[index].bits;
    Arithmetic arithmetic(builder_, owner_ + "$next");
    // All words hold the position above the low end.
    Word next = bits;
    next.push_back(builder_.low());
    for (const StoredWrite& write : stored.writes) {
        const NetId when = trigger(write);
        const Word low = arithmetic.constant(counter.low, 65);
        Word position = arithmetic.subtract(arithmetic.sum(*write.sum, writing_.counters), low);
        const NetId below = arithmetic.is_negative(position);
        const Word top = arithmetic.constant(counter.high - counter.low, bits.size() + 1);
        const NetId above = arithmetic.compare(position, Relation::greater, top);
        position.resize(bits.size() + 1);
        position = arithmetic.choose(above, top, position);
        position = arithmetic.choose(below, arithmetic.constant(0, bits.size() + 1), position);
        next = arithmetic.choose(when, position, next);
    }
    for (std::size_t bit = 0; bit < bits.size(); ++bit) flip_flop(bits[bit], next[bit], false);
    next.resize(bits.size());
    next.push_back(builder_.low());
    const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)}, {false, 0, 0}};
    after_.counters[index] = arithmetic.sum(offset, {next});
}

void ClockedBuild::make_stored() {
    std::vector<std::uint8_t> written(grafcet_.counters.size());
    for (const StoredEquation& stored : equations_.stored) {
        const std::uint32_t index = stored.target.index;
        role_ = 0;
        switch (stored.target.kind) {
            case VariableKind::output: {
                const Output& output = grafcet_.outputs[OutputId{index}];
                work_on(output.name,
                        builder_.add_origin(Origin::Kind::output, output.name, output.where));
                write_bit(stored);
                break;
            }
            case VariableKind::var: {
                const Var& var = grafcet_.vars[VarId{index}];
                work_on(var.name, builder_.add_origin(Origin::Kind::var, var.name, var.where));
                write_bit(stored);
                break;
            }
            default: {
                const Counter& counter = grafcet_.counters[CounterId{index}];
                work_on(counter.name,
                        builder_.add_origin(Origin::Kind::counter, counter.name, counter.where));
                written[index] = 1;
                write_counter(stored);
                break;
            }
        }
    }
    for (std::size_t i = 0; i < written.size(); ++i) {
        if (written[i] != 0) continue;
        const Counter& counter = grafcet_.counters[grafcet_.counters.id_at(i)];
        work_on(counter.name,
                builder_.add_origin(Origin::Kind::counter, counter.name, counter.where));
        for (const NetId bit : builder_.netlist().counters[i].bits) {
            builder_.add_cell(CellType::low, bit, {});
        }
    }
}

}  // namespace grafwire
