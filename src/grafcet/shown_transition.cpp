#include "grafcet/shown_transition.h"

#include <fmt/format.h>

#include <span>
#include <string_view>
#include <vector>

#include "text/joined.h"

namespace grafwire {

std::string shown_transition(const Grafcet& grafcet, TransitionId id) {
    const Transition& transition = grafcet.transitions[id];
    const auto names = [&](std::span<const StepId> steps) {
        std::vector<std::string_view> list;
        for (const StepId step : steps) list.push_back(grafcet.steps[step].name);
        return joined(list, ", ");
    };
    const std::string before = names(grafcet.preceding(transition));
    const std::string after = names(grafcet.following(transition));
    return fmt::format("({}) {}{}->{}{}", transition.name, before, before.empty() ? "" : " ",
                       after.empty() ? "" : " ", after);
}

}  // namespace grafwire
