#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "trace/input_values.h"

namespace grafwire::testing {

/// The method once more, written as slowly and plainly as it can be: every table in full, every
/// expression in every scan, one byte per bit. For comparison.
struct NaiveState {
    std::vector<bool> tp, ts;
    std::vector<bool> tfig;
    std::vector<bool> edge_values, edge_memories;
    std::vector<bool> stored;
    std::vector<bool> vars;
    std::vector<std::int64_t> counters;
    std::vector<bool> times;
    std::vector<bool> waiting;
    std::vector<Time> since;  ///< while waiting: when the operand was first seen to differ

    bool operator==(const NaiveState&) const = default;
};

class NaiveEvolution {
  public:
    explicit NaiveEvolution(const Grafcet& grafcet) : g_(grafcet) {}

    NaiveState start(const InputValues& inputs) const;
    void scan(NaiveState& state, const InputValues& inputs, Time now) const;
    std::vector<bool> outputs(const NaiveState& state, const InputValues& inputs) const;
    /// Of each var that steps hold; 0 for the others.
    std::vector<bool> held_vars(const NaiveState& state, const InputValues& inputs) const;
    std::vector<bool> cleared(NaiveState state, const InputValues& inputs) const;
    void end_delays(NaiveState& state, const InputValues& inputs, Time now) const;
    /// False where there is no stable situation; `changing` is filled then.
    bool settle(NaiveState& state, const InputValues& inputs, Time now,
                std::vector<std::string>& changing) const;

  private:
    bool value(ExprId id, const NaiveState& state, const InputValues& inputs) const;
    std::int64_t sum(const Sum& terms, const NaiveState& state) const;
    void edges(NaiveState& state, const InputValues& inputs) const;
    std::vector<bool> cleared_now(const NaiveState& state, const InputValues& inputs) const;
    void forcing(NaiveState& state) const;
    void enclosures(NaiveState& state, const std::vector<bool>& after_4, bool init) const;
    void actions(NaiveState& state, const InputValues& inputs,
                 const std::vector<bool>& cleared) const;
    void times(NaiveState& state, const InputValues& inputs, Time now) const;

    const Grafcet& g_;
};

}  // namespace grafwire::testing
