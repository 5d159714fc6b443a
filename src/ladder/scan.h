#pragma once

#include "ladder/machine.h"

namespace grafwire::ladder {

/// One scan of a machine, in the making.
class Scan {
  public:
    Scan(const Machine& machine, MachineState& state, Time now)
        : machine_(machine), ladder_(machine.ladder_), state_(state), now_(now) {}

    Machine::Outcome run();

  private:
    MachineState::Cell& cell(VariableId id) { return state_.cells[static_cast<std::size_t>(id)]; }
    Signal bit(const Operand& operand);
    std::int64_t number(const Operand& operand);
    /// Every contact is looked at, for those of edges remember what they saw.
    Signal flow(const Power& power);
    Signal contact(const Power& power);
    bool compare(const Power& power);
    Signal execute(const Block& block, Signal power);
    Signal execute_function(const Block& block, Signal power);
    void execute_counter(const Block& block, bool counts);
    void execute(const Coil& coil, Signal power);
    /// 1 where the operand was 0 at the last time and is 1 (rising), or the reverse.
    Signal edge(Signal operand, bool rising);
    void write(VariableId id, Signal value);
    /// Whether a signal is 1; the scan ends here where that is unknown.
    bool decided(Signal signal);

    const Machine& machine_;
    const Ladder& ladder_;
    MachineState& state_;
    Time now_;
    Machine::Outcome outcome_;
    std::uint32_t rung_ = 0;
    std::size_t next_edge_ = 0;
};

}  // namespace grafwire::ladder
