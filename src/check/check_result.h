#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "netlist/delay_model.h"
#include "text/keep_going.h"
#include "text/workers.h"
#include "trace/stimuli.h"

namespace grafwire {

/// What a check ends with. Undecided where a bound ended it, or for the reasons that CheckResult
/// names.
enum class Verdict { equivalent, different, undecided };

/// Which inputs of an asynchronous netlist may change in one instant. (A clocked netlist and a
/// program sample their inputs, and any of them change between two scans.)
enum class Changes {
    one,   ///< one, or delays end, and the netlist settles before the next: fundamental mode
    many,  ///< any, and delays end in the same instant
};

/// How much of the exploration is done.
struct Coverage {
    std::uint64_t situations = 0;  ///< distinct situations reached
    std::uint64_t cases = 0;       ///< changes of the inputs, or scans, that were compared
    std::uint64_t unstable = 0;    ///< cases in which the reference finds no stable situation
    std::uint64_t waiting = 0;     ///< states reached but not yet expanded
    /// Where delays are open: the states of gates gone through, between the change of an input and
    /// rest.
    std::uint64_t gate_states = 0;
};

/// The parts of a GRAFCET that no case of an exploration exercised, each in table order. What a
/// verdict says of them is little.
struct NeverExercised {
    std::vector<StepId> steps;              ///< never active
    std::vector<TransitionId> transitions;  ///< never cleared
    std::vector<std::uint32_t> inputs;      ///< never both 0 and 1; numbered as in Stimuli
    std::vector<OutputId> outputs;          ///< never 1
    bool none() const { return *this == NeverExercised(); }
    bool operator==(const NeverExercised&) const = default;
};

/// What is asked of a check.
struct CheckOptions {
    Changes changes = Changes::one;
    /// Asynchronous netlists, where they are equivalent under Changes::one: whether to look at
    /// Changes::many as well.
    bool looks_at_many = true;
    /// Asynchronous netlists: whether to look for X and outputs that change too often.
    bool looks_for_pulses = false;
    /// Netlists: how long the gates take.
    DelayModel delays{};
    /// Clocked netlists: the only time from one scan to the next for which the verdict is to hold;
    /// none: it holds for every one.
    std::optional<Time> scan_period;
    std::uint64_t max_cases = 0;  ///< stop undecided after this many; 0: no bound
    /// Called many times a second with how far the present exploration is; a check may take
    /// several. None by default.
    std::function<void(const Coverage&)> progress;
    /// Asked as often, also within a case, and by all workers at the same time; the check stops
    /// undecided once it says no. That is how a caller bounds time and memory, and cancels.
    KeepGoing keep_going;
    /// Who shares the exploration; nullptr: nobody does. They must outlive the check.
    Workers* workers = nullptr;
};

/// What becomes of a netlist that is equivalent under Changes::one under Changes::many.
struct Together {
    Verdict verdict = Verdict::undecided;
    /// different: the shortest way to it, and what must not change within the settling time there.
    std::optional<Witness> witness;
    std::vector<std::uint32_t> inputs;  ///< as numbered in Stimuli
    bool with_delay = false;            ///< they, and the end of a delay
    /// An assumption under which it is equivalent all the same and everything is still exercised,
    /// as the language writes it; empty where none was found.
    std::string assumption;
};

/// An X or output that can change more often within an instant than the reference changes it there,
/// its transient situations included: a hazard.
struct Pulse {
    std::string name;  ///< `X1`, or the output
    NetId net = no_net;
    Stimuli stimuli;        ///< among the shortest that show it; they end with the instant
    unsigned expected = 0;  ///< changes of the reference in it
    unsigned got = 0;       ///< of the netlist, with these delays
    DelaySchedule delays;   ///< those that it takes; the others are nominal
};

/// What was found of such changes.
struct Pulses {
    std::vector<Pulse> found;  ///< one of each X and output at most: X first, in table order
    /// X and outputs of which that could not be told in some cases, and in how many.
    struct Open {
        std::string name;
        std::uint64_t cases = 0;
    };
    std::vector<Open> open;
    std::uint64_t cases = 0;  ///< that were looked at, without power-up
    bool complete = false;    ///< every case that can be reached
};

/// How much the delays of gates may differ. Ratios of the longest to the shortest are in tenths and
/// have two digits: 1.0 to 9.9, then 10 to 99.
struct Tolerance {
    /// The greatest for which the netlist is proven equivalent; 0: it is so for none.
    int holds = 0;
    bool is_unlimited = false;  ///< it is so for all
    /// The smallest for which a difference was found, and that; 0: none was.
    int fails = 0;
    std::optional<Witness> witness;
};
inline constexpr int least_ratio = 10;
inline constexpr int greatest_ratio = 990;
/// Of `holds`: the ratio after it.
constexpr int next_ratio(int ratio) {
    if (ratio < least_ratio) return least_ratio;
    return ratio < 100 ? ratio + 1 : ratio + 10;
}

/// What came of a check.
struct CheckResult {
    Verdict verdict = Verdict::undecided;
    Coverage coverage;
    bool complete = false;  ///< every reachable case was explored
    std::optional<Witness> witness;
    /// A case in which the reference itself is unstable: the stimuli that lead there, and what
    /// keeps changing.
    struct Unstable {
        Stimuli stimuli;
        std::vector<std::string> changing;
    };
    std::optional<Unstable> first_unstable;
    /// What no case exercised.
    NeverExercised never;
    std::optional<Together> together;
    std::optional<Tolerance> tolerance;  ///< if it was asked for
    std::optional<Pulses> pulses;        ///< likewise; no part of the verdict
    /// undecided though complete: differences were found for which no scan period was.
    bool depends_on_period = false;
    /// undecided though complete: a difference in three values was found that no run shows.
    bool is_unexplained = false;
    /// undecided: there is a case in which gates can change in more orders than were gone through.
    bool has_unexplored_orders = false;
    /// Some state was reached in which a memory has never been given a value. Every X and output is
    /// right all the same; whether everything comes to rest three values cannot tell.
    bool has_uninitialised_memory = false;
};

/// Sets what follows from how an exploration ended: verdict, completeness, states left waiting.
inline void conclude(CheckResult& result, bool is_complete, std::size_t waiting) {
    result.complete = is_complete;
    result.coverage.waiting = waiting;
    if (result.witness) {
        result.verdict = Verdict::different;
    } else if (is_complete && result.coverage.cases != 0) {
        result.verdict = Verdict::equivalent;
    }
}

}  // namespace grafwire
