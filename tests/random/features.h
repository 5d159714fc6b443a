#pragma once

#include <cstddef>

namespace grafwire::testing {

/// What a random GRAFCET may contain. The defaults are the whole language.
struct Features {
    std::size_t steps = 12;  ///< at most about so many
    std::size_t graphs = 4;  ///< at most
    std::size_t inputs = 4;
    std::size_t outputs = 4;
    std::size_t vars = 2;
    std::size_t counters = 2;
    std::size_t time_conditions = 4;  ///< at most so many are written
    std::size_t edges = 100;          ///< likewise
    std::size_t expression_depth = 3;
    bool macros = true;
    bool orders = true;
    bool enclosures = true;
    bool stored = true;    ///< stored actions
    bool clearing = true;  ///< those on clearing of transitions
    bool nested_times = true;
    bool off_delays = true;
    bool sources_and_sinks = true;
    bool assumptions = true;
    bool reads_controls = true;  ///< expressions read Init, AUdur, AUdoux
    bool odd_names = true;       ///< quoted and Unicode ones
    bool named_parts = true;  ///< names for conditions and durations, vars that steps hold, French
    /// One graph of one token (but for simultaneous sequences): sequences, selections with
    /// conditions that exclude each other, levels of inputs only. Most of the rest does not apply.
    bool plain = false;

    static Features plain_chart() {
        Features features;
        features.plain = true;
        features.odd_names = false;
        return features;
    }
    /// Small enough for every reachable case to be looked at.
    static Features small() {
        Features features;
        features.steps = 4;
        features.graphs = 2;
        features.inputs = 2;
        features.outputs = 2;
        features.vars = 1;
        features.counters = 1;
        features.time_conditions = 1;
        features.edges = 2;
        features.expression_depth = 2;
        return features;
    }
};

}  // namespace grafwire::testing
