#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "check/witness.h"
#include "evolution/bit_table.h"
#include "trace/stimuli.h"

namespace grafwire {

enum class Verdict { equivalent, different, undecided };

/// How much of the exploration is done.
struct Coverage {
    std::uint64_t situations = 0;  ///< distinct stable situations reached
    std::uint64_t cases = 0;       ///< changes of the inputs that were compared
    std::uint64_t unstable = 0;    ///< cases in which the reference finds no stable situation
    std::uint64_t waiting = 0;     ///< states reached but not yet left
};

struct CheckOptions {
    std::uint64_t max_cases = 0;  ///< stop undecided after so many; 0: no bound
    /// Asked now and then; the exploration stops undecided when it says no.
    std::function<bool(const Coverage&)> keep_going;
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
};

/// Counts the cases of an exploration and keeps it within its bounds.
class CaseCounter {
  public:
    CaseCounter(const CheckOptions& options, Coverage& coverage)
        : options_(options), coverage_(coverage) {}

    /// One more case; false where the exploration has to end with it.
    bool count(bool is_stable, std::size_t waiting);
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
