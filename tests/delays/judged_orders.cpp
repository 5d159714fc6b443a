#include "delays/judged_orders.h"

#include <deque>
#include <set>

#include "orders/tell_orders.h"

namespace grafwire::testing {

bool JudgedOrders::depends_on_order(const ChartCase& item) {
    EvolutionState start = item.state;
    if (!item.event.is_input) start.due[item.event.index] = 0;
    for (Time& due : start.due) due = due <= second ? 0 : due;  // as ChartOrders counts
    product_.evolution().end_delays(start, {item.after}, 0);
    const OrderOutcome outcome = product_.outcome(start, item.after);
    if (outcome.kind == OrderOutcome::Kind::too_large) return true;
    const bool depends = outcome.kind == OrderOutcome::Kind::dependent;
    if (depends) ++dependent_;
    const bool expected = exhaustive_.depends_on_order(item);
    const bool is_of_edges = expected && !grafcet_.expressions.edges().empty();
    const bool has_rest =
        depends && product_.evolution().cleared_by_scan(outcome.state, {item.after}, 0).empty();
    const bool is_not_asked = depends && (outcome.race->kind == RaceKind::unrest ||
                                          outcome.race->first == none || !has_rest);
    if (depends != expected && !is_of_edges && !is_not_asked && first_disagreement_.empty()) {
        first_disagreement_ = depends ? told_race(grafcet_, *outcome.race).english + ", in {"
                                      : "only by ChartOrders in {";
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            if (!item.state.situation.test(i)) continue;
            first_disagreement_ += " " + grafcet_.steps[grafcet_.steps.id_at(i)].name;
        }
        first_disagreement_ += " } under";
        for (std::size_t i = 0; i < item.after.size(); ++i) {
            if (item.after[i] == 0) continue;
            first_disagreement_ += " " + std::string(input_name(grafcet_, i));
        }
    }
    return depends;
}

namespace {

struct Reached {
    EvolutionState state;
    InputValues inputs;
};

std::vector<DelayEvent> events_of(const Reached& reached) {
    std::vector<DelayEvent> events;
    for (std::size_t i = 0; i < reached.inputs.size(); ++i) events.push_back({true, i});
    for (std::size_t i = 0; i < reached.state.due.size(); ++i) {
        if (reached.state.due[i] != never) events.push_back({false, i});
    }
    return events;
}

}  // namespace

bool for_each_chart_case(const Grafcet& grafcet, std::size_t most,
                         const std::function<void(const ChartCase&)>& visit) {
    const Evolution evolution(grafcet);
    InputValues inputs(grafcet.all_input_count(), 0);
    inputs[grafcet.inputs.size()] = 1;  // Init
    Reached first{evolution.start({inputs}), inputs};
    if (!reference_after(evolution, first.state, inputs, {})) return true;
    std::deque<Reached> open{first};
    std::set<std::string> seen;
    for (std::size_t cases = 0; !open.empty();) {
        const Reached reached = std::move(open.front());
        open.pop_front();
        for (const DelayEvent& event : events_of(reached)) {
            Reached next = reached;
            if (event.is_input) next.inputs[event.index] ^= 1U;
            if (broken_assumption(grafcet, next.inputs) != grafcet.assumptions.size()) continue;
            if (!reference_after(evolution, next.state, next.inputs, event)) continue;
            if (++cases > most) return false;
            visit({reached.state, reached.inputs, next.inputs, event});
            std::string key(next.inputs.begin(), next.inputs.end());
            if (seen.insert(key + key_of(next.state)).second) open.push_back(std::move(next));
        }
    }
    return true;
}

}  // namespace grafwire::testing
