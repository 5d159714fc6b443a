#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evolution/bit_table.h"
#include "grafcet/grafcet.h"
#include "text/keep_going.h"
#include "text/time.h"
#include "trace/input_values.h"

namespace grafwire {

/// Everything that one scan hands to the next. Two states that compare equal evolve alike (the
/// running delays are compared by their remaining time only through `due`).
struct EvolutionState {
    BitTable situation;       ///< Ts, one bit per step
    BitTable previous;        ///< Tp of the last scan; what `situation` was when it began
    BitTable may_evolve;      ///< Tfig, one bit per graph: 0 frozen
    BitTable stored_outputs;  ///< one bit per output (0 for continuous ones)
    BitTable vars;
    std::vector<std::int64_t> counters;
    BitTable edge_memory;  ///< per edge (Expressions::edges): its operand at the last evaluation
    BitTable edges;        ///< per edge: its value in the last scan
    BitTable time_values;  ///< per time condition (Expressions::time_conditions): its value
    /// Per time condition: the time at which its value changes if its operand stays as it is;
    /// `never` where no delay is running.
    std::vector<Time> due;

    bool operator==(const EvolutionState&) const = default;
};

/// The inputs a scan reads, and where to note which of them it looked at.
struct EvolutionInputs {
    const InputValues& values;
    /// If not null, one byte per input, set to 1 when the value of that input was consulted. An
    /// input that was not consulted cannot have influenced the scan. Never cleared here.
    std::vector<std::uint8_t>* consulted = nullptr;
    /// If not null, one byte per transition, set to 1 when it is cleared. Never cleared here.
    std::vector<std::uint8_t>* cleared = nullptr;
    /// If not null, one byte per transition: one with a 0 is not cleared, whatever its receptivity.
    /// That is how a chart is run in another order than its own.
    const std::vector<std::uint8_t>* may_clear = nullptr;
};

/// What one scan did, part by part, for telling it in words. The scan itself keeps it.
struct ScanRecord {
    std::vector<TransitionId> cleared;  ///< in table order
    BitTable after_clearing;            ///< Ts after SBR 4
    std::vector<OrderId> orders;        ///< those of the steps in `after_clearing`, in table order
    BitTable after_forcing;             ///< Ts after the orders, before the enclosures
    /// Enclosures whose activation links were activated.
    std::vector<EnclosureId> opened;
    /// A stored action that was run.
    struct StoredWrite {
        bool on_clearing = false;
        std::size_t action = 0;  ///< of Grafcet::actions; of clearing_actions where on_clearing
        std::int64_t value = 0;  ///< what was written
    };
    std::vector<StoredWrite> writes;  ///< in the order of writing
};

/// Continuous and stored outputs together, one bit per output.
using OutputValues = BitTable;

struct SettleResult {
    bool stable = true;
    /// Broken off: what is stable is not known, and the state is one on the way.
    bool broken_off = false;
    std::uint32_t repetitions = 0;
    /// Not stable: what keeps changing, by name (`X5`, vars, counters, stored outputs), in the
    /// order of steps, outputs, vars, counters.
    std::vector<std::string> changing;
};

/// The reference evolution: the table method of Cordier, "Méthode d'implémentation du GRAFCET"
/// (1998), on bit tables of any size. One object serves any number of states, and holds none.
/// The GRAFCET must outlive it.
class Evolution {
  public:
    explicit Evolution(const Grafcet& grafcet);
    ~Evolution();
    Evolution(Evolution&&) noexcept;
    Evolution& operator=(Evolution&&) noexcept;

    /// SBR 0: the state before the first scan, which is about to read these inputs.
    EvolutionState start(const EvolutionInputs& inputs) const;

    /// SBR 1 to SBR 8 (without the continuous outputs): one scan at time `now`. Delays that have
    /// fallen due by then take effect in SBR 6. `record`: where to note what it did; nullptr where
    /// nobody asks.
    void scan(EvolutionState& state, const EvolutionInputs& inputs, Time now,
              ScanRecord* record = nullptr) const;

    /// The beginning of an instant of the until-stable run, once its inputs have changed: the
    /// running delays that end at or before `now` take effect, from the inside outwards, except
    /// those whose operand, read under these inputs, no longer asks for it. SBR 6 settles what
    /// becomes of the latter, as it does in a run scan by scan.
    void end_delays(EvolutionState& state, const EvolutionInputs& inputs, Time now) const;

    static bool is_running(const EvolutionState& state, std::size_t time_condition) {
        return state.due[time_condition] != never;
    }

    /// Repeats scans with the inputs and the clock held until one in which no edge is 1 leaves
    /// everything as it was, or until a state comes back (not stable).
    SettleResult settle(EvolutionState& state, const EvolutionInputs& inputs, Time now,
                        const KeepGoing& keep_going = {}) const;

    /// Whether the scan that led from `before` to `after` was the last of an instant: no edge is 1
    /// in it, and situation, freeze bits, time conditions, vars, counters and stored outputs are as
    /// before.
    static bool is_settled(const EvolutionState& before, const EvolutionState& after);

    /// SBR 8: the outputs in a state under these inputs.
    OutputValues outputs(const EvolutionState& state, const EvolutionInputs& inputs) const;
    /// The value of a var: its bit, or where steps hold it that of the present situation and
    /// inputs, as outputs have theirs.
    bool var(VarId var, const EvolutionState& state, const EvolutionInputs& inputs) const;

    /// The value of an expression, with edges and time conditions as the state holds them.
    bool value(ExprId expression, const EvolutionState& state, const EvolutionInputs& inputs) const;

    /// The transitions cleared by a scan of this state under these inputs, in table order; the
    /// state itself is left alone. For telling in words what happened.
    std::vector<TransitionId> cleared_by_scan(const EvolutionState& state,
                                              const EvolutionInputs& inputs, Time now) const;

    const Grafcet& grafcet() const { return *grafcet_; }

  private:
    struct Tables;
    const Grafcet* grafcet_;
    std::unique_ptr<Tables> tables_;
};

}  // namespace grafwire
