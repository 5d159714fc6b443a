#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "story/instant_story.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

/// A run of the reference that somebody takes on, instant by instant, and back. Every step that is
/// taken leaves the moment before it behind, whole, so that going back cannot go wrong. The GRAFCET
/// must outlive it.
class SteppedRun {
  public:
    /// By scans with that period, or until stable (none).
    SteppedRun(const Grafcet& grafcet, std::optional<Time> period);

    const std::optional<Time>& period() const { return period_; }
    bool has_begun() const { return moment_.run.state.has_value(); }
    Time now() const { return moment_.now; }  ///< not before the last instant
    /// The inputs as they are now; by scans, for the next scan to read.
    const InputValues& inputs() const { return moment_.inputs; }
    bool has_unread_inputs() const { return moment_.inputs != moment_.run.inputs; }
    const EvolutionUnderWay& run() const { return moment_.run; }
    const std::optional<InstantStory>& last() const { return moment_.last; }
    /// No situation was stable at the last instant: there is no way but back.
    bool is_stuck() const { return moment_.last && !moment_.last->is_stable; }

    /// When the next scan is.
    Time next_scan() const { return has_begun() ? moment_.run.now + *period_ : 0; }
    /// When the next instant comes by itself: a scan, the end of a delay, the first instant; or
    /// `never`.
    Time next_instant() const;

    /// Takes a step: lets time pass up to a moment, with all instants on the way, and then changes
    /// inputs. `has_instant`: at the end of the way there is an instant in any case. `tell` is
    /// given every instant. False where the way was so long that it was left in between, and no
    /// input has changed.
    bool advance(Time to, const std::vector<Stimuli::Assignment>& assignments, bool has_instant,
                 const std::function<void(InstantStory)>& tell);
    bool can_go_back() const { return !past_.empty(); }
    /// Takes back the last step.
    void go_back();
    std::size_t step_count() const { return past_.size(); }

    /// All that was applied. By scans, inputs that no scan has read yet are left to the next one.
    Stimuli stimuli() const;

    /// The assumptions that the inputs break, as they are now.
    std::vector<std::size_t> broken_assumptions() const;

  private:
    /// Where the run stands; what is come back to.
    struct Moment {
        EvolutionUnderWay run;
        InputValues inputs;
        Time now = 0;
        std::size_t change_count = 0;  ///< of changes_
        std::optional<InstantStory> last;
    };

    InstantStory do_instant(Time at, bool is_asked);

    const Grafcet& grafcet_;
    Evolution evolution_;
    std::optional<Time> period_;
    Moment moment_;
    std::vector<Moment> past_;
    std::vector<Stimuli::Change> changes_;  ///< all that has been applied, in the order of time
};

}  // namespace grafwire
