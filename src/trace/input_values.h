#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "grafcet/grafcet.h"
#include "logic/logic.h"
#include "text/time.h"
#include "trace/stimuli.h"

namespace grafwire {

/// The inputs at a moment: one value each, 0 or 1, declared inputs first, then Init, AUdur, AUdoux
/// (as input_name() numbers them).
using InputValues = std::vector<std::uint8_t>;

/// The same in three values, all known.
std::vector<Logic> known_inputs(const InputValues& values);

/// Whether one assumption of the GRAFCET, given by its index, is 1 under these inputs.
bool assumption_holds(const Grafcet& grafcet, std::size_t assumption, const InputValues& inputs);

/// The index of the first assumption that is 0 under these inputs; assumptions.size() where all
/// hold.
std::size_t broken_assumption(const Grafcet& grafcet, const InputValues& inputs);

/// Plays stimuli into the inputs, forwards in time. Before the first change all inputs are 0.
///
///     StimuliPlayer player(stimuli, grafcet.all_input_count());
///     player.advance(120 * millisecond);  // then inputs() are those of 120 ms
class StimuliPlayer {
  public:
    /// `input_count`: Grafcet::all_input_count(). The stimuli must outlive it.
    StimuliPlayer(const Stimuli& stimuli, std::size_t input_count)
        : stimuli_(stimuli), inputs_(input_count, 0) {}

    /// Applies the changes after the last call up to and including `now`, which is not before that
    /// of the last call; false where there are none.
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
