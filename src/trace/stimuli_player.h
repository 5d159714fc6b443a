#pragma once

#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

/// Plays stimuli into the inputs, forwards in time. Before the first change all inputs are 0.
class StimuliPlayer {
  public:
    /// `input_count`: Grafcet::all_input_count(). The stimuli must outlive it.
    StimuliPlayer(const Stimuli& stimuli, std::size_t input_count)
        : stimuli_(stimuli), inputs_(input_count, 0) {}

    /// Applies the changes after the last call up to and including `now`; false where there are
    /// none.
    bool advance(Time now);

    /// As the last call of advance() has left them.
    const InputValues& inputs() const { return inputs_; }
    /// The time of the next change; `never` after the last.
    Time next_change() const;

  private:
    const Stimuli& stimuli_;
    InputValues inputs_;
    std::size_t next_ = 0;  ///< the first change not yet applied
};

}  // namespace grafwire
