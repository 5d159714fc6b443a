#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/path.h"
#include "check/reference_case.h"
#include "netlist/netlist.h"
#include "simulate/netlist_machine.h"
#include "simulate/simulator.h"

namespace grafwire {

/// What came of a case on the netlist's side.
struct NetlistOutcome {
    enum class Kind {
        agrees,
        open,        ///< depends on an input that is still open: see `split`
        differs,     ///< no open input is to blame
        broken_off,  ///< the time was up
    };
    Kind kind = Kind::agrees;
    /// open: the input to close, in the state left (`split_before`) or in the case.
    std::uint32_t split = 0;
    bool split_before = false;
    /// agrees: the state reached, with `due` as RunningDelays wants it.
    SimulatorState state;
    /// agrees: a memory is unknown that no open input explains. It has never been given a value,
    /// and nothing that is compared depends on it in this state.
    bool has_open_memory = false;
};

/// Takes a netlist through cases: restores the state left, applies the change, lets it settle (an
/// asynchronous netlist) or gives it a clock cycle (a clocked one), and compares with what the
/// reference did.
class NetlistCases {
  public:
    NetlistCases(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                 const KeepGoing& keep_going);
    NetlistCases(const NetlistCases&) = delete;
    NetlistCases& operator=(const NetlistCases&) = delete;

    /// `start` none: power-up and initialisation. `left` are the inputs with which the state
    /// `start` was saved; `step.before` may close some that are open there.
    NetlistOutcome run(const SimulatorState* start, const PartialInputs& left, const PathStep& step,
                       const ReferenceOutcome& expected);

    /// Per timer cell, in the order of Simulator::timers: the time condition it stands for, and
    /// whether an X or an output depends on it.
    std::vector<std::uint32_t> conditions_of_timers() const;
    std::vector<std::uint8_t> relevant_timers() const;

    /// Opens inputs in a state, if none of the nets on which the future depends comes to depend on
    /// them; nothing otherwise.
    std::optional<SimulatorState> forget(const SimulatorState& state,
                                         const std::vector<std::uint32_t>& inputs);

    /// Appends to a key what the netlist remembers in a state, as far as an X or an output can ever
    /// depend on it.
    void append_key(std::string& key, const SimulatorState& state) const;

  private:
    Settling start_up(const PathStep& step);
    void leave(const SimulatorState& start, const PartialInputs& left, const PathStep& step);
    void begin_instant(const PartialInputs& inputs);
    SimulatorState kept_state() const;
    NetlistOutcome look(const BitTable& situation, const OutputValues& outputs,
                        const PathStep& step) const;
    NetlistOutcome after_gates(const PathStep& step, const ReferenceOutcome& expected);
    NetlistOutcome clock(const PathStep& step, const ReferenceOutcome& expected);
    std::optional<NetlistOutcome> open_input_of_loops(const PathStep& step) const;
    NetlistOutcome not_settled(const Settling& settling, const PathStep& step) const;
    bool same(const BitTable& situation, const OutputValues& outputs) const;
    NetlistOutcome blame(const std::vector<NetId>& nets, const PathStep& step) const;
    bool open_input_behind(const std::vector<NetId>& nets, const PartialInputs& inputs,
                           std::uint32_t& input) const;
    void find_remembered_nets();

    const Netlist& netlist_;
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
