// Pairs are compared by their whole state, never by a digest: a collision would be a wrong verdict.

#include "check/pair_state.h"

#include <algorithm>

namespace grafwire {

namespace {

/// Four values to a byte.
void append_logic(std::string& key, const std::vector<Logic>& values) {
    for (std::size_t i = 0; i < values.size(); i += 4) {
        unsigned packed = 0;
        for (std::size_t j = i; j < std::min(i + 4, values.size()); ++j) {
            packed = packed * 4 + static_cast<unsigned>(values[j]);
        }
        key += static_cast<char>(packed);
    }
}

}  // namespace

void append_key(std::string& key, const BitTable& bits) {
    const auto& words = bits.words();
    key.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0]));
}

std::string key_of(const PairState& pair) {
    std::string key;
    const EvolutionState& state = pair.reference;
    for (const BitTable* bits : {&state.situation, &state.may_evolve, &state.stored_outputs,
                                 &state.vars, &state.edge_memory, &state.time_values}) {
        append_key(key, *bits);
    }
    key.append(reinterpret_cast<const char*>(state.counters.data()),
               state.counters.size() * sizeof(std::int64_t));
    pair.delays.append_key(key);
    append_logic(key, pair.inputs);
    append_logic(key, pair.netlist.values);
    return key;
}

}  // namespace grafwire
