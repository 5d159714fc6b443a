#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "check/exercised.h"
#include "check/witness.h"
#include "evolution/bit_table.h"
#include "trace/stimuli.h"

namespace grafwire {

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
    std::uint64_t waiting = 0;     ///< states reached but not yet left
};

struct CheckOptions {
    Changes changes = Changes::one;
    /// Asynchronous netlists, where they are equivalent under Changes::one: whether to look at
    /// Changes::many as well.
    bool looks_at_many = true;
    /// Clocked netlists: the only time from one scan to the next for which the verdict is to hold;
    /// none: it holds for every one.
    std::optional<Time> scan_period;
    std::uint64_t max_cases = 0;  ///< stop undecided after so many; 0: no bound
    /// Asked many times a second; the exploration stops undecided when it says no.
    std::function<bool(const Coverage&)> keep_going;
};

/// What `many` inputs at once make of a netlist that is equivalent when `one` changes at a time.
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
    /// undecided though complete: differences were found for which no scan period was.
    bool depends_on_period = false;
    /// undecided though complete: a difference in three values was found that no run shows.
    bool is_unexplained = false;
    /// Some state was reached in which a memory has never been given a value. Every X and output is
    /// right all the same; whether everything comes to rest three values cannot tell.
    bool has_open_memory = false;
};

/// Counts the cases of an exploration and keeps it within its bounds.
class CaseCounter {
  public:
    CaseCounter(const CheckOptions& options, Coverage& coverage)
        : options_(options), coverage_(coverage) {}

    /// One more case; false where the exploration has to end with it.
    bool count(bool is_stable, std::size_t waiting);
    /// Whether there is time left; for work within a case.
    bool goes_on() const { return !options_.keep_going || options_.keep_going(coverage_); }
    /// The situation of a state that was reached.
    void note(const BitTable& situation);

  private:
    const CheckOptions& options_;
    Coverage& coverage_;
    std::unordered_set<std::string> situations_;
};

/// Sets what follows from how an exploration ended: verdict, completeness, states left waiting.
void conclude(CheckResult& result, bool is_complete, std::size_t waiting);

}  // namespace grafwire
