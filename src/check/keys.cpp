#include "check/keys.h"

namespace grafwire {

void append_key(std::string& key, const BitTable& bits) {
    const auto& words = bits.words();
    key.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0]));
}

void append_key(std::string& key, const EvolutionState& state) {
    for (const BitTable* bits : {&state.situation, &state.may_evolve, &state.stored_outputs,
                                 &state.vars, &state.edge_memory, &state.time_values}) {
        append_key(key, *bits);
    }
    key.append(reinterpret_cast<const char*>(state.counters.data()),
               state.counters.size() * sizeof(std::int64_t));
}

}  // namespace grafwire
