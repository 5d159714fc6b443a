// Interlocks: extra conditions under which the order of clearing makes no difference.
//
// The usual race is a step that is passed through while another graph reads it: the reader sees it
// or does not. Let the transition that leaves it wait until the reader has been cleared or cannot
// be, and both orders come to what the reference comes to. The same condition orders any two
// transitions, so for each race both ways round are tried: the one that goes first to ill effect
// waits, or the other.
//
// Nothing is assumed of an interlock. The chart with it is searched for races like the chart
// without (find_races.cpp), with the original along: it is taken if the race is gone and the two
// charts come to the same in every case. Of two that do, the one that leaves fewer races; then the
// first. Nothing taken is given up again, so the search ends.

#include "orders/interlock.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace grafwire {

namespace {

constexpr std::size_t most_interlocks = 40;

/// The receptivity and a further condition.
ExprId both(Expressions& pool, ExprId receptivity, ExprId condition) {
    if (pool.kind(receptivity) == ExprKind::constant && pool.constant_value(receptivity)) {
        return condition;
    }
    std::vector<ExprId> operands;
    for (const ExprId id : {receptivity, condition}) {
        if (pool.kind(id) != ExprKind::conjunction) {
            operands.push_back(id);
            continue;
        }
        const auto inner = pool.operands(id);
        operands.insert(operands.end(), inner.begin(), inner.end());
    }
    return pool.conjunction(operands);
}

bool has_race(const RaceReport& report, const OrderRace& race) {
    return std::any_of(report.races.begin(), report.races.end(), [&](const FoundRace& found) {
        return found.race.kind == race.kind && found.race.first == race.first &&
               found.race.second == race.second;
    });
}

/// The chart with one more interlock; empty where there is no such condition.
std::optional<InterlockedChart> with_one_more(const InterlockedChart& chart, TransitionId waiting,
                                              TransitionId awaited) {
    InterlockedChart more{chart.grafcet, chart.interlocks, {}};
    const ExprId condition = waiting_condition(more.grafcet, waiting, awaited);
    if (condition == no_expr) return std::nullopt;
    Transition& transition = more.grafcet.transitions[waiting];
    transition.condition = both(more.grafcet.expressions, transition.condition, condition);
    more.interlocks.push_back({waiting, awaited, condition});
    return more;
}

/// The chart with an interlock that cures a race; empty where there is none.
/// `cases`: those looked at are added to it.
std::optional<InterlockedChart> cured(const InterlockedChart& chart, const OrderRace& race,
                                      const RaceOptions& options, std::uint64_t& cases) {
    std::optional<InterlockedChart> best;
    if (race.first == none) return best;
    for (const auto& [waiting, awaited] :
         {std::pair(race.first, race.second), std::pair(race.second, race.first)}) {
        auto trial = with_one_more(chart, waiting, awaited);
        if (!trial) continue;
        trial->left = find_races(trial->grafcet, options);
        cases += trial->left.cases;
        if (trial->left.unlike || has_race(trial->left, race)) continue;
        if (!best || trial->left.races.size() < best->left.races.size()) best = std::move(trial);
        if (best->left.races.empty()) break;
    }
    return best;
}

}  // namespace

InterlockedChart with_interlocks(const Grafcet& grafcet, RaceReport races,
                                 const RaceOptions& options, std::uint64_t max_cases_in_all) {
    RaceOptions compared = options;
    compared.like = &grafcet;
    InterlockedChart chart{grafcet, {}, std::move(races)};
    std::uint64_t cases = 0;
    bool goes_on = true;
    while (goes_on && chart.interlocks.size() < most_interlocks) {
        goes_on = false;
        const std::vector<FoundRace> left = chart.left.races;
        for (const FoundRace& found : left) {
            if (max_cases_in_all != 0 && cases >= max_cases_in_all) return chart;
            auto better = cured(chart, found.race, compared, cases);
            if (!better) continue;
            chart = std::move(*better);
            goes_on = true;
            break;
        }
    }
    return chart;
}

}  // namespace grafwire
