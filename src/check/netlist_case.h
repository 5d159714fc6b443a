#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/exploration.h"
#include "check/path.h"
#include "check/reference_case.h"
#include "netlist/netlist.h"
#include "simulate/netlist_machine.h"
#include "simulate/simulator.h"
#include "text/keep_going.h"

namespace grafwire {

/// Per net, 1 where one of the `roots` can ever depend on it.
std::vector<std::uint8_t> cone_of_influence(const Netlist& netlist,
                                            const std::vector<NetId>& roots);

/// The lengths of the timers of a netlist, of both their edges.
std::vector<Time> timer_lengths(const Netlist& netlist);

/// A netlist with fixed delays, case by case: restores the state left, applies the change, lets it
/// settle (an asynchronous netlist) or gives it a clock cycle (a clocked one), and compares with
/// what the reference did. What it is made of must outlive it.
class NetlistCases : public ExploredNetlist {
  public:
    NetlistCases(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                 const KeepGoing& keep_going);
    NetlistCases(const NetlistCases&) = delete;
    NetlistCases& operator=(const NetlistCases&) = delete;

    bool is_clocked() const override { return netlist_.is_clocked(); }
    bool has_modes() const override { return netlist_.has_modes; }
    std::vector<std::uint32_t> conditions_of_timers() const override;
    std::vector<std::uint8_t> relevant_timers() const override;
    std::vector<Time> delays() const override { return timer_lengths(netlist_); }
    NetlistOutcomes run(const SimulatorState* start, const PartialInputs& left,
                        const PathStep& step, const ReferenceOutcome& expected) override;
    std::optional<SimulatorState> abstracted(const SimulatorState& state,
                                             const std::vector<std::uint32_t>& inputs) override;
    void encode(std::string& encoding, const SimulatorState& state) const override;
    std::optional<Witness> replay(const Stimuli& stimuli, Time period) const override;

  protected:
    const Grafcet& grafcet() const { return grafcet_; }
    const Netlist& netlist() const { return netlist_; }
    Simulator& simulator() { return simulator_; }
    const PortMap& ports() const { return ports_; }
    const CellDelays& delays_of_gates() const { return delays_; }
    const std::vector<std::uint8_t>& relevant_nets() const { return is_relevant_; }
    const std::vector<NetId>& remembered_nets() const { return remembered_; }
    Time instant() const { return instant_; }

    /// Everything of a case but what the gates do in it: from `start`, or from power-up, to the
    /// moment at which the inputs have changed and delays that are due have ended. Not settled:
    /// power-up does not come to rest. `values_left`, if given, are the values before that change.
    Settling begin(const SimulatorState* start, const PartialInputs& left, const PathStep& step,
                   std::vector<Logic>* values_left = nullptr);
    /// What is to be compared, and kept, once the gates have come to rest.
    NetlistOutcome after_gates(const PathStep& step, const ReferenceOutcome& expected);
    /// The gates come to rest, under fixed delays.
    Settling settle() { return machine_.settle(); }
    /// X of every step, then the outputs.
    const std::vector<NetId>& compared_nets() const { return compared_; }
    /// The input that a net carries, or `none`.
    std::uint32_t input_of(NetId net) const { return input_of_net_[index_of(net)]; }
    /// What it means that some nets are not known, or never come to rest.
    NetlistOutcome undetermined(const std::vector<NetId>& nets, const PathStep& step) const;
    NetlistOutcome not_settled(const Settling& settling, const PathStep& step) const;

  private:
    NetlistOutcome outcome_of(const SimulatorState* start, const PartialInputs& left,
                              const PathStep& step, const ReferenceOutcome& expected);
    void prepare(const SimulatorState& start, const PartialInputs& left, const PathStep& step);
    void begin_instant(const std::vector<Logic>& inputs);
    SimulatorState kept_state() const;
    NetlistOutcome compare(const BitTable& situation, const OutputValues& outputs,
                           const PathStep& step) const;
    NetlistOutcome clock(const PathStep& step, const ReferenceOutcome& expected);
    std::optional<NetlistOutcome> unassigned_input_of_loops(const PathStep& step) const;
    bool same(const BitTable& situation, const OutputValues& outputs) const;
    UnknownCause cause_of(const std::vector<NetId>& nets, const PathStep& step) const;
    std::optional<std::uint32_t> unassigned_input_behind(const std::vector<NetId>& nets,
                                                         const PartialInputs& inputs) const;
    void find_remembered_nets();

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& delays_;
    NetlistMachine machine_;
    Simulator& simulator_;
    const PortMap& ports_;
    Time instant_ = 0;  ///< of the case, on the clock of the simulation
    Table<NetId, CellId> drivers_;
    std::vector<std::uint32_t> input_of_net_;  ///< per net: the input it carries, or none
    std::vector<std::uint8_t> is_relevant_;    ///< per net: an X or an output depends on it
    std::vector<NetId> compared_;              ///< X of every step, then the outputs
    /// What the future depends on, besides the inputs: memories, loops of gates, operands of
    /// timers; as far as they are relevant.
    std::vector<NetId> remembered_;
    std::vector<NetId> on_loops_;  ///< those of remembered_ that lie on loops of gates
};

}  // namespace grafwire
