#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evolution/evolution.h"
#include "evolution/run.h"
#include "grafcet/grafcet.h"
#include "text/time.h"
#include "trace/input_values.h"
#include "trace/stimuli.h"

namespace grafwire {

// What the reference does, as values that say why: which transitions were enabled and with which
// values their conditions were read, what was activated by which rule. write_story.h puts it into
// words.

/// What a condition reads, and its value there: `start=1`, `2s/X3=0`, `pieces=3`.
struct OperandValue {
    std::string name;
    std::int64_t value = 0;
    Time due = never;  ///< of a time condition whose delay is running: when it ends
};

/// A transition whose preceding steps are all active.
struct EnabledTransition {
    TransitionId transition{};
    bool condition = false;  ///< its value
    bool is_frozen = false;  ///< its graph may not evolve
    std::vector<OperandValue> operands;
};

/// What became of a time condition.
struct TimeConditionChange {
    ExprId condition = no_expr;
    enum class Kind { becomes_1, becomes_0, delay_begins, delay_is_dropped } kind{};
    Time due = never;  ///< delay_begins: when it ends
};

/// One scan: what was enabled, what it did, and what came of it.
struct ScanStory {
    BitTable before;                         ///< the situation it began with
    std::vector<EnabledTransition> enabled;  ///< cleared or not (record.cleared), in table order
    bool init = false;
    bool au_dur = false;
    ScanRecord record;
    /// Active steps that cleared transitions deactivate and activate at once (rule 5).
    std::vector<StepId> kept;
    std::vector<TimeConditionChange> times;
    BitTable situation;    ///< after it
    bool changes = false;  ///< whether anything is other than before, or was cleared or written
};

/// An instant of a run until stable, or a scan of a run scan by scan.
struct InstantStory {
    Time at = 0;
    bool is_first = false;  ///< rule 1: it begins in the initial situation
    bool by_scans = false;
    std::vector<Stimuli::Assignment> inputs;  ///< that change; at the first instant, those at 1
    std::vector<TimeConditionChange> ended;   ///< delays that end as the instant begins
    std::vector<ScanStory> scans;             ///< those that change something, the first of many
    std::size_t untold = 0;                   ///< scans that are not in `scans` for there are many
    bool is_stable = true;
    std::vector<std::string> changing;  ///< not stable: what keeps changing, by name

    // How it ends, where it is stable.
    BitTable situation;
    OutputValues outputs;
    BitTable vars;
    std::vector<std::int64_t> counters;
    bool init = false;
    bool au_doux = false;
    std::vector<EnabledTransition> enabled;  ///< with no edge at 1
    std::vector<OrderId> orders;             ///< of the active steps

    /// Scans like this one that follow it, none of which changes anything either, and the time of
    /// the last.
    std::size_t repeated = 0;
    Time last = 0;

    /// Nothing has changed, inputs and outputs included.
    bool is_quiet = false;
};

/// A run of the reference under way.
struct EvolutionUnderWay {
    std::optional<EvolutionState> state;  ///< none before the first instant
    InputValues inputs;                   ///< of the last instant
    OutputValues outputs;                 ///< likewise
    Time now = 0;                         ///< its time

    /// The end of the delay that ends next; `never` where none is running.
    Time next_delay_end() const;
};

/// Lets the run have one more instant, at a time not before its last one, with these inputs: a scan
/// where `by_scans`, else scans until the situation is stable. Where none is, the run cannot go on.
InstantStory tell_instant(const Evolution& evolution, EvolutionUnderWay& run,
                          const InputValues& inputs, Time at, bool by_scans);

/// Adds a story to those before it. Scans that change nothing are one story together.
void add_story(std::vector<InstantStory>& stories, InstantStory story);

/// A run of the reference, and what happened at each of its instants.
struct ToldRun {
    RunResult result;
    std::vector<InstantStory> stories;  ///< an instant without a stable situation is the last
};
/// A whole run: scan by scan with that period, or until stable (none).
ToldRun tell_run(const Grafcet& grafcet, const Stimuli& stimuli, std::optional<Time> period);

}  // namespace grafwire
