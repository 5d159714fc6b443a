#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evolution/evolution.h"
#include "referee/gate_simulator.h"
#include "support/naive_evolution.h"

namespace grafwire::testing {

/// The reference, as the product has it or once more written plainly.
class ReferenceRun {
  public:
    ReferenceRun(const Grafcet& grafcet, bool is_plain)
        : grafcet_(grafcet), is_plain_(is_plain), evolution_(grafcet), plain_(grafcet) {}

    void start(const InputValues& inputs);
    /// False where there is no stable situation.
    bool instant(Time now, const InputValues& inputs);
    void scan(Time now, const InputValues& inputs);
    Time next_end() const;
    /// X of every step, then the outputs.
    std::vector<bool> shown(const InputValues& inputs) const;

  private:
    const Grafcet& grafcet_;
    bool is_plain_;
    Evolution evolution_;
    EvolutionState state_;
    NaiveEvolution plain_;
    NaiveState plain_state_;
};

/// In words where two lists of X and outputs differ: " X1 is 0, not 1".
std::string differences(const Grafcet& grafcet, const std::vector<bool>& expected,
                        const std::vector<bool>& got);

/// How reference and netlist compare at the end of an instant or scan.
enum class Comparison { alike, differ, unsettled, unstable };

/// A reference and a netlist side by side, from power-up on.
class PairRun {
  public:
    PairRun(const Grafcet& grafcet, const Netlist& netlist, bool is_plain)
        : grafcet_(grafcet),
          is_clocked_(netlist.is_clocked()),
          reference_(grafcet, is_plain),
          gates_(grafcet, netlist) {}

    /// Before instant 0, or before the first scan, with these inputs; false where the netlist does
    /// not settle.
    bool start(const InputValues& inputs, const std::vector<bool>& power_up);
    /// unstable: the reference finds no stable situation, and the run ends.
    Comparison instant(Time now, const InputValues& inputs);
    Comparison scan(Time now, const InputValues& inputs);
    Time next_end() const { return std::min(reference_.next_end(), gates_.next_end()); }
    /// After `differ`: what differs, in words.
    std::string difference(const InputValues& inputs) const;

  private:
    Comparison compared(const InputValues& inputs) const;

    const Grafcet& grafcet_;
    bool is_clocked_;
    ReferenceRun reference_;
    GateSimulator gates_;
};

/// Runs stimuli from power-up; `scan_period`: as for a witness, 0 for a run until stable. The first
/// difference in words, or nothing.
std::optional<std::string> replayed(const Grafcet& grafcet, const Netlist& netlist,
                                    const Stimuli& stimuli, Time scan_period, bool is_plain,
                                    const std::vector<bool>& power_up);

}  // namespace grafwire::testing
