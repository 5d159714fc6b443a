#include "orders/tell_orders.h"

#include "grafcet/shown_transition.h"
#include "grafcet/write_grafcet.h"
#include "orders/messages.h"
#include "text/joined.h"

namespace grafwire {

namespace {

namespace say = messages::orders;

/// `{2, 12}`, as an order names a situation.
std::string told_situation(const Grafcet& grafcet, const BitTable& situation) {
    std::vector<std::string> names;
    for_each_bit(situation, [&](std::size_t step) {
        names.push_back(grafcet.steps[grafcet.steps.id_at(step)].name);
    });
    return "{" + joined(names, ", ") + "}";
}

}  // namespace

Localized told_race(const Grafcet& grafcet, const OrderRace& race) {
    const std::string other = shown_transition(grafcet, race.second);
    const bool by_time = race.first == none;
    const std::string first = by_time ? std::string() : shown_transition(grafcet, race.first);
    switch (race.kind) {
        case RaceKind::withdrawn:
            return by_time ? say::withdrawn_by_time(other) : say::withdrawn(first, other);
        case RaceKind::arrival:
            return race.first == race.second ? say::arrival_at_itself(first)
                                             : say::arrival(first, other);
        case RaceKind::difference:
            return by_time ? say::difference_by_time(other) : say::difference(first, other);
        case RaceKind::unrest:
            break;
    }
    return by_time ? say::unrest_by_time(other) : say::unrest(first, other);
}

Localized told_ends(const Grafcet& grafcet, const OrderRace& race) {
    const std::string together = told_situation(grafcet, race.together);
    if (!race.apart) return say::no_end(together);
    if (race.together == *race.apart) return say::ends_alike(together);
    return say::ends(together, told_situation(grafcet, *race.apart));
}

Location place_of(const Grafcet& grafcet, const OrderRace& race) {
    return grafcet.transitions[race.first == none ? race.second : race.first].where;
}

Localized told_interlock(const InterlockedChart& chart, const Interlock& interlock) {
    const Grafcet& grafcet = chart.grafcet;
    return say::interlock(shown_transition(grafcet, interlock.waiting),
                          shown_transition(grafcet, interlock.awaited),
                          write_expression(grafcet, grafcet.expressions,
                                           grafcet.transitions[interlock.waiting].condition));
}

Localized told_interlocks(const InterlockedChart& chart) {
    Localized text;
    for (const Interlock& interlock : chart.interlocks) {
        const Localized told = told_interlock(chart, interlock);
        const std::string_view line_end = text.english.empty() ? "" : "\n";
        text.english += std::string(line_end) + "  " + told.english;
        text.french += std::string(line_end) + "  " + told.french;
    }
    return text;
}

}  // namespace grafwire
