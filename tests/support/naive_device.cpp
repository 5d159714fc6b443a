#include "support/naive_device.h"

#include <cstring>

namespace grafwire::testing {

namespace {

std::vector<Logic> logic(const std::vector<bool>& bits) {
    std::vector<Logic> values;
    for (const bool bit : bits) values.push_back(bit ? Logic::one : Logic::zero);
    return values;
}

/// Every part of a state, its bits first.
template <typename State, typename Bits, typename Numbers>
void for_each_part(State& state, const Bits& bits, const Numbers& numbers) {
    bits(state.tp);
    bits(state.ts);
    bits(state.tfig);
    bits(state.edge_values);
    bits(state.edge_memories);
    bits(state.stored);
    bits(state.vars);
    bits(state.times);
    bits(state.waiting);
    numbers(state.counters);
    numbers(state.since);
}

bool same(const ScannedDevice::Outcome& a, const ScannedDevice::Outcome& b) {
    return a.memory == b.memory && a.steps == b.steps && a.outputs == b.outputs;
}

}  // namespace

std::string NaiveDevice::packed(const NaiveState& state, const std::string& extra) const {
    std::string memory;
    for_each_part(
        state,
        [&](const std::vector<bool>& bits) {
            for (const bool bit : bits) memory += bit ? '1' : '0';
        },
        [&](const std::vector<std::int64_t>& numbers) {
            for (const std::int64_t number : numbers) {
                memory.append(reinterpret_cast<const char*>(&number), sizeof(number));
            }
        });
    return memory + extra;
}

NaiveState NaiveDevice::unpacked(const std::string& memory, std::string& extra) const {
    NaiveState state = evolution_.start(InputValues(grafcet_.all_input_count(), 0));
    std::size_t at = 0;
    for_each_part(
        state,
        [&](std::vector<bool>& bits) {
            for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = memory[at++] == '1';
        },
        [&](std::vector<std::int64_t>& numbers) {
            for (std::int64_t& number : numbers) {
                std::memcpy(&number, memory.data() + at, sizeof(number));
                at += sizeof(number);
            }
        });
    extra = memory.substr(at);
    return state;
}

ScannedDevice::Outcome NaiveDevice::scan_assigned(const std::string& memory,
                                                  const InputValues& inputs, Time now) const {
    std::string extra;
    NaiveState state = memory.empty() ? evolution_.start(inputs) : unpacked(memory, extra);
    evolution_.scan(state, inputs, now);
    Outcome outcome;
    outcome.steps = logic(state.ts);
    outcome.outputs = logic(evolution_.outputs(state, inputs));
    if (fault_) fault_(state, inputs, outcome, extra);
    outcome.memory = packed(state, extra);
    return outcome;
}

ScannedDevice::Outcome NaiveDevice::scan(const std::string& memory, const PartialInputs& inputs,
                                         Time now) const {
    std::vector<std::uint32_t> unassigned;
    InputValues values(inputs.size());
    for (std::uint32_t i = 0; i < inputs.size(); ++i) {
        values[i] = inputs[i] == PartialInput::one ? 1 : 0;
        if (inputs[i] == PartialInput::unassigned) unassigned.push_back(i);
    }
    // Outcome by the number that the unassigned inputs spell, bit 0 first.
    std::vector<Outcome> outcomes;
    for (std::size_t number = 0; number < std::size_t{1} << unassigned.size(); ++number) {
        for (std::size_t bit = 0; bit < unassigned.size(); ++bit)
            values[unassigned[bit]] = number >> bit & 1U;
        outcomes.push_back(scan_assigned(memory, values, now));
        for (std::size_t bit = 0; bit < unassigned.size(); ++bit) {
            const std::size_t without = number & ~(std::size_t{1} << bit);
            if (same(outcomes[number], outcomes[without])) continue;
            Outcome outcome;
            outcome.needs = unassigned[bit];
            return outcome;
        }
    }
    return outcomes.front();
}

std::string NaiveDevice::key(const std::string& memory, Time now) const {
    std::string extra;
    NaiveState state = unpacked(memory, extra);
    for (std::size_t i = 0; i < state.since.size(); ++i) {
        state.since[i] = state.waiting[i] ? now - state.since[i] : 0;
    }
    return packed(state, extra);
}

}  // namespace grafwire::testing
