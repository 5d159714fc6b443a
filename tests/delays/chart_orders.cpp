#include "delays/chart_orders.h"

#include <algorithm>
#include <deque>
#include <set>
#include <string>

namespace grafwire::testing {

/// The chart with all other receptivities at 0.
struct ChartOrders::Subset {
    Grafcet grafcet;
    std::unique_ptr<Evolution> evolution;
};

namespace {

/// The operands of OR at the top, and the choices of an OR within an AND, one level deep: which is
/// how receptivities are written.
std::vector<ExprId> summands(Expressions& pool, ExprId id) {
    if (pool.kind(id) == ExprKind::disjunction) {
        std::vector<ExprId> result;
        const auto operands = pool.operands(id);
        for (const ExprId operand : std::vector<ExprId>(operands.begin(), operands.end())) {
            for (const ExprId part : summands(pool, operand)) result.push_back(part);
        }
        return result;
    }
    return {id};
}

}  // namespace

ChartOrders::ChartOrders(const Grafcet& grafcet) : grafcet_(grafcet), evolution_(grafcet) {
    Expressions pool = grafcet.expressions;
    for (const Transition& transition : grafcet.transitions) {
        products_.push_back(summands(pool, transition.condition));
    }
}

ChartOrders::~ChartOrders() = default;

const Evolution& ChartOrders::with_only(const std::vector<TransitionId>& transitions) {
    std::unique_ptr<Subset>& subset = subsets_[transitions];
    if (subset == nullptr) {
        subset = std::make_unique<Subset>();
        subset->grafcet = grafcet_;
        const ExprId never_true = subset->grafcet.expressions.constant(false);
        for (std::size_t i = 0; i < grafcet_.transitions.size(); ++i) {
            const TransitionId id = grafcet_.transitions.id_at(i);
            if (std::find(transitions.begin(), transitions.end(), id) == transitions.end()) {
                subset->grafcet.transitions[id].condition = never_true;
            }
        }
        subset->evolution = std::make_unique<Evolution>(subset->grafcet);
    }
    return *subset->evolution;
}

/// Whether an order bears on the graph: what it stops need not go on.
bool ChartOrders::is_overruled(const EvolutionState& state, GraphId graph) const {
    const EnclosureId enclosure = grafcet_.graphs[graph].enclosed_by;
    if (enclosure != none && !state.situation.test(index_of(grafcet_.enclosures[enclosure].step))) {
        return true;
    }
    return std::any_of(grafcet_.orders.begin(), grafcet_.orders.end(), [&](const Order& order) {
        return order.graph == graph && order.kind != OrderKind::freeze &&
               state.situation.test(index_of(order.step));
    });
}

/// Whether the step that overrules a graph is gone again when all is over: the moment in which it
/// stops what is in motion is then seen by nobody.
bool ChartOrders::is_passing(const EvolutionState& state, GraphId graph,
                             const BitTable& expected) const {
    const auto is_gone = [&](StepId step) { return !expected.test(index_of(step)); };
    return std::any_of(grafcet_.orders.begin(), grafcet_.orders.end(), [&](const Order& order) {
        return order.graph == graph && order.kind != OrderKind::freeze &&
               state.situation.test(index_of(order.step)) && is_gone(order.step);
    });
}

bool ChartOrders::is_withdrawn(const EvolutionState& before, const EvolutionState& after,
                               const InputValues& inputs, TransitionId id,
                               const BitTable& expected) const {
    const Transition& transition = grafcet_.transitions[id];
    if (is_overruled(after, transition.graph)) return is_passing(after, transition.graph, expected);
    for (const StepId step : grafcet_.preceding(transition)) {
        if (!after.situation.test(index_of(step))) return true;
    }
    if (!after.may_evolve.test(index_of(transition.graph))) return true;
    const auto& products = products_[index_of(id)];
    return std::any_of(products.begin(), products.end(), [&](ExprId product) {
        return evolution_.value(product, before, {inputs}) &&
               !evolution_.value(product, after, {inputs});
    });
}

bool ChartOrders::arrives_where_one_leaves(const EvolutionState& state,
                                           const std::vector<TransitionId>& clearable,
                                           const std::vector<TransitionId>& cleared) const {
    const auto leaves = [&](StepId step) {
        return std::any_of(clearable.begin(), clearable.end(), [&](TransitionId id) {
            const auto steps = grafcet_.preceding(grafcet_.transitions[id]);
            return std::find(steps.begin(), steps.end(), step) != steps.end();
        });
    };
    for (const TransitionId id : cleared) {
        for (const StepId step : grafcet_.following(grafcet_.transitions[id])) {
            if (state.situation.test(index_of(step)) && leaves(step)) return true;
        }
    }
    return false;
}

bool ChartOrders::depends_on_order(const ChartCase& item) {
    const Time now = second;
    EvolutionState start = item.state;
    if (!item.event.is_input) start.due[item.event.index] = now;
    evolution_.end_delays(start, {item.after}, now);
    EvolutionState expected = start;
    if (!evolution_.settle(expected, {item.after}, now).stable) return false;
    const auto normal = [](EvolutionState state) {
        for (Time& due : state.due) due = due == never ? never : far_away;
        return key_of(state);
    };

    std::deque<EvolutionState> open{start};
    std::set<std::string> seen{normal(start)};
    while (!open.empty()) {
        const EvolutionState state = std::move(open.front());
        open.pop_front();
        const auto clearable = evolution_.cleared_by_scan(state, {item.after}, now);
        if (clearable.size() > 10 || seen.size() > 3000) return true;
        const std::size_t first = clearable.empty() ? 0 : 1;
        for (std::size_t bits = first; bits < std::size_t{1} << clearable.size(); ++bits) {
            std::vector<TransitionId> chosen;
            for (std::size_t i = 0; i < clearable.size(); ++i) {
                if ((bits >> i & 1) != 0) chosen.push_back(clearable[i]);
            }
            if (arrives_where_one_leaves(state, clearable, chosen)) return true;
            EvolutionState next = state;
            with_only(chosen).scan(next, {item.after}, now);
            for (const TransitionId id : clearable) {
                const bool is_cleared = std::count(chosen.begin(), chosen.end(), id) != 0;
                if (!is_cleared && is_withdrawn(state, next, item.after, id, expected.situation))
                    return true;
            }
            if (clearable.empty() && Evolution::is_settled(state, next)) {
                if (normal(next) != normal(expected)) return true;
                continue;
            }
            if (seen.insert(normal(next)).second) open.push_back(std::move(next));
        }
    }
    return false;
}

}  // namespace grafwire::testing
