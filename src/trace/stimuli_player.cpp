#include "trace/stimuli_player.h"

namespace grafwire {

bool StimuliPlayer::advance(Time now) {
    const std::size_t first = next_;
    for (; next_change() <= now && next_ < stimuli_.changes.size(); ++next_) {
        for (const Stimuli::Assignment& set : stimuli_.changes[next_].assignments) {
            inputs_[set.input] = set.value ? 1 : 0;
        }
    }
    return next_ != first;
}

Time StimuliPlayer::next_change() const {
    return next_ < stimuli_.changes.size() ? stimuli_.changes[next_].at : never;
}

}  // namespace grafwire
