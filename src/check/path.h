#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "check/partial_inputs.h"
#include "grafcet/grafcet.h"
#include "text/time.h"
#include "trace/input_values.h"
#include "trace/stimuli.h"

namespace grafwire {

/// The delays that fall due at one instant, or by one scan.
struct EndedDelays {
    std::vector<std::uint32_t> conditions;  ///< of the reference: numbers of time conditions
    std::vector<std::uint32_t> timers;      ///< of the netlist: numbers of timer cells
    bool none() const { return conditions.empty() && timers.empty(); }
};

/// A delay that is running when an instant comes.
struct RunningDelay {
    std::size_t begun = 0;  ///< the instant at which it began
    Time length = 0;
    bool ends = false;  ///< at this instant, or by this scan; or it goes on beyond it
};

/// One step of a path through the product states: inputs that change and delays that end, all at
/// one instant or scan.
struct PathStep {
    PartialInputs before;  ///< what the inputs were in the state left (unassigned: any)
    PartialInputs inputs;  ///< what they become
    EndedDelays ended;
    std::vector<RunningDelay> running;  ///< the delays of both sides when the instant comes
};

/// What leads from some values of the inputs to others.
std::vector<Stimuli::Assignment> differences(const InputValues& from, const InputValues& to);

/// Finds times and full input values for a path, so that exactly the delays that are to end do so,
/// and instants are at least `gap` apart; nothing where that cannot be. Instants are numbered from
/// 0 in the order of the path.
std::optional<Stimuli> stimuli_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                   const std::vector<PathStep>& path, Time gap);

/// The gaps worth trying, from one that is easy to read to the smallest that can be needed: if a
/// path is possible at all, it is so with the last.
std::vector<Time> gaps_for(const std::vector<PathStep>& path);

/// The stimuli with the first of these gaps with which there are some.
std::optional<Stimuli> first_stimuli_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                         const std::vector<PathStep>& path);

/// The path with all inputs assigned and at most one of them changing at an instant, as far as the
/// assumptions allow that; what changes without an effect gets instants of its own. Nothing where
/// the assumptions allow no values.
std::optional<std::vector<PathStep>> one_by_one(const Assumptions& assumptions,
                                                const std::vector<PathStep>& path,
                                                std::size_t input_count);

/// Stimuli for a run scan by scan, and its period.
struct ScanStimuli {
    Stimuli stimuli;
    Time period = 0;
};

/// Finds a period and full input values for a path whose steps are scans, so that exactly the
/// delays that are to fall due by a scan do so; nothing where there is none. `period`, if not 0, is
/// the only one.
std::optional<ScanStimuli> scans_for(const Grafcet& grafcet, const Assumptions& assumptions,
                                     const std::vector<PathStep>& path, Time period);

}  // namespace grafwire
