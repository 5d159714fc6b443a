#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ladder/ladder.h"
#include "logic/logic.h"

namespace grafwire::ladder {

// Executes ladder diagrams, a scan at a time. Bits have three values, so that a check can leave
// inputs open. Integers have 64 bits and wrap around; the rest is IEC 61131-3,
// with two things that it leaves open: a change is seen against 0 in the first scan (an input that
// is 1 from the beginning has a rising edge then, one that is 0 has no falling edge), and a
// comparison in a branch without power lets no power through.

/// A bit, and where it is unknown, one of the open inputs that it depends on.
using Signal = grafwire::Signal<VariableId>;

/// What a program remembers from one scan to the next; inputs included.
struct MachineState {
    struct Cell {
        Signal bit;               ///< of an instance: its Q
        Signal last;              ///< of an instance: its power input at the last execution
        std::int64_t number = 0;  ///< of an integer; of a counter instance its CV
        Time since = 0;           ///< of a timer that runs
        bool runs = false;
    };
    std::vector<Cell> cells;    ///< per variable
    std::vector<Signal> edges;  ///< per edge contact and edge coil: its last operand
};

class Machine {
  public:
    explicit Machine(const Ladder& ladder);

    /// Before the first scan.
    MachineState start() const;
    /// Sets a bit from outside; Logic::unknown leaves it open.
    void set(MachineState& state, VariableId variable, Logic value) const;

    struct Outcome {
        /// An open input that must be known to go on: blocks that keep time or count, and
        /// functions, do not run on an unknown power. The state is then unfinished and to be thrown
        /// away.
        std::optional<VariableId> needs;
        /// Per variable: the rung that wrote it last in this scan, an index into Ladder::rungs (a
        /// set or reset coil without power writes nothing).
        std::vector<std::uint32_t> writers;
        /// Per rung: the power that reached its coils.
        std::vector<Logic> powers;
    };
    static constexpr std::uint32_t nobody = 0xffffffffU;
    Outcome scan(MachineState& state, Time now) const;

    /// An open input on which something remembered depends; none where all of it is known.
    std::optional<VariableId> open_memory(const MachineState& state) const;
    /// The part of a state on which the future depends, times relative to `now`: two states of one
    /// key behave alike.
    std::string key(const MachineState& state, Time now) const;
    /// What is remembered, as bytes, and back. Bits in them must be known; the others are 0 in the
    /// state that comes back.
    std::string save(const MachineState& state) const;
    MachineState load(const std::string& memory) const;

    /// The presets of its timers.
    std::vector<Time> delays() const;

  private:
    friend class Scan;
    void find_memory();

    const Ladder& ladder_;
    std::size_t edge_count_ = 0;
    std::vector<std::size_t> first_edge_;  ///< per rung, into MachineState::edges
    std::vector<bool> remembered_;         ///< per variable: may be read before it is written
    std::vector<Time> longest_;            ///< per instance of a timer: its preset
};

}  // namespace grafwire::ladder
