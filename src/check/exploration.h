#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/check_result.h"
#include "check/path.h"
#include "check/reference_case.h"
#include "check/running_delays.h"
#include "grafcet/grafcet.h"
#include "simulate/simulator.h"
#include "text/keep_going.h"

namespace grafwire {

/// Why a value that counts is unknown in a netlist.
struct UnknownCause {
    enum class Kind : std::uint8_t {
        unassigned_input,   ///< `input` is unassigned in the case: a case split decides
        unassigned_before,  ///< it is unassigned in the state left, likewise
        undetermined,       ///< the gates leave it open under every input: a memory that was never
                            ///< given a value, a race
    };
    Kind kind = Kind::undetermined;
    std::uint32_t input = 0;  ///< of the first two, as numbered in PartialInputs

    bool is_of_an_input() const { return kind != Kind::undetermined; }
};

/// One thing that a netlist can do in a case.
struct NetlistOutcome {
    enum class Kind : std::uint8_t {
        agrees,        ///< what is compared is as it should be
        differs,       ///< it is not, or is unknown, or never comes to rest
        unassigned,    ///< it depends on the input that `unknown` names
        not_explored,  ///< there is more that it can do than can be gone through
        broken_off,    ///< the check is to stop
    };
    Kind kind = Kind::agrees;
    /// unassigned: the input. differs: what is compared is unknown. agrees: a memory is unknown,
    /// and nothing that is compared depends on it in this state.
    std::optional<UnknownCause> unknown;
    /// agrees: the state reached, with `due` as RunningDelays wants it.
    SimulatorState state;
    /// Of the first outcome of a case: how many states of gates it took to find all.
    std::uint64_t gate_states = 0;
};

/// All that a netlist can do in a case, never empty. With fixed delays of gates there is exactly
/// one outcome; where delays are not known exactly there may be more.
using NetlistOutcomes = std::vector<NetlistOutcome>;

/// A netlist as the exploration sees it: something whose states are values and which goes from one
/// to others, case by case.
class ExploredNetlist {
  public:
    virtual ~ExploredNetlist() = default;

    /// Whether it goes from scan to scan, or from instant to instant.
    virtual bool is_clocked() const = 0;
    /// Whether it has Init, AUdur and AUdoux; where not, they stay 0.
    virtual bool has_modes() const = 0;

    /// Per timer (in the order of SimulatorState::due): the time condition it stands for, and
    /// whether an X or an output depends on it.
    virtual std::vector<std::uint32_t> conditions_of_timers() const = 0;
    virtual std::vector<std::uint8_t> relevant_timers() const = 0;
    /// The lengths of all timers.
    virtual std::vector<Time> delays() const = 0;

    /// Whether a case takes long enough for several to share the work.
    virtual bool is_worth_sharing() const { return false; }

    /// What it does in a step from `start` (none: power-up and initialisation), compared with what
    /// the reference does. `left` are the inputs with which the state `start` was saved;
    /// `step.before` may assign some that are unassigned there.
    virtual NetlistOutcomes run(const SimulatorState* start, const PartialInputs& left,
                                const PathStep& step, const ReferenceOutcome& expected) = 0;
    /// The state with some inputs made don't-cares, if none of what it remembers comes to depend on
    /// them; nothing otherwise.
    virtual std::optional<SimulatorState> abstracted(const SimulatorState& state,
                                                     const std::vector<std::uint32_t>& inputs) = 0;
    /// Appends to an encoding what is remembered in a state, as far as an X or an output can ever
    /// depend on it.
    virtual void encode(std::string& encoding, const SimulatorState& state) const = 0;

    /// Runs it and the reference over stimuli, from power-up, and reports a difference; nothing
    /// where none shows. `period`: of scans; 0 for instants.
    virtual std::optional<Witness> replay(const Stimuli& stimuli, Time period) const = 0;
};

/// What an exploration goes through.
struct ExplorationPlan {
    Changes changes = Changes::one;  ///< of asynchronous netlists
    Passing passing = Passing::free;
    Time period = 0;  ///< of Passing::by_a_period
};

struct ExplorationResult {
    CheckResult result;
    /// Ended without a verdict, because the lengths of delays were ignored and matter.
    bool needs_lengths = false;
};

/// Makes the netlist once more, for somebody else to work with at the same time; within a case it
/// asks whether to go on.
using ExploredNetlistMaker =
    std::function<std::unique_ptr<ExploredNetlist>(const KeepGoing& keep_going)>;

class PulseSearch;

/// Goes through every case that can be reached, asynchronous netlists instant by instant, clocked
/// ones scan by scan, within the bounds of `options`. What comes of it does not depend on how many
/// share the work, as long as nothing but its cases ends it.
///
/// `pulses`, if given, looks at each case in which the netlist is right, one after the other. Then
/// no witness is sought of a difference, what comes after it is left out, and the exploration is
/// not complete.
ExplorationResult explore(const Grafcet& grafcet, const ExploredNetlistMaker& make_netlist,
                          const CheckOptions& options, const ExplorationPlan& plan,
                          PulseSearch* pulses = nullptr);

}  // namespace grafwire
