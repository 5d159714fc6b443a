#include "properties/same_model.h"

#include <algorithm>

namespace grafwire::testing {

namespace {

constexpr auto by_name = [](const auto& x, const auto& y) { return x.name == y.name; };

class ModelComparison {
  public:
    ModelComparison(const Grafcet& a, const Grafcet& b) : a_(a), b_(b) {}

    std::string difference() {
        if (a_.name != b_.name || a_.title != b_.title) return "name or title";
        if (!all(a_.inputs, b_.inputs, by_name)) return "inputs";
        if (!all(a_.vars, b_.vars, [this](const Var& x, const Var& y) {
                return x.name == y.name && x.is_held() == y.is_held() &&
                       (!x.is_held() || same(x.held, y.held));
            })) {
            return "vars";
        }
        if (!all(a_.outputs, b_.outputs, [](const Output& x, const Output& y) {
                return x.name == y.name && x.stored == y.stored;
            })) {
            return "outputs";
        }
        if (!all(a_.counters, b_.counters, [](const Counter& x, const Counter& y) {
                return x.name == y.name && x.low == y.low && x.high == y.high;
            })) {
            return "counters";
        }
        if (!all(a_.assumptions, b_.assumptions, [this](const Assumption& x, const Assumption& y) {
                return same(x.expression, y.expression);
            })) {
            return "assumptions";
        }
        if (a_.sums != b_.sums) return "sums";
        if (a_.links != b_.links) return "links";
        return structure();
    }

  private:
    std::string structure() {
        if (!all(a_.graphs, b_.graphs, [](const Graph& x, const Graph& y) {
                return x.name == y.name && x.block == y.block && x.steps.first == y.steps.first &&
                       x.steps.count == y.steps.count &&
                       x.transitions.first == y.transitions.first &&
                       x.transitions.count == y.transitions.count && x.enclosed_by == y.enclosed_by;
            })) {
            return "graphs";
        }
        if (!all(a_.blocks, b_.blocks, [](const Block& x, const Block& y) {
                return x.name == y.name && x.is_expansion == y.is_expansion && x.graph == y.graph &&
                       x.nodes == y.nodes && x.transitions == y.transitions;
            })) {
            return "blocks";
        }
        if (!all(a_.macros, b_.macros, [](const Macro& x, const Macro& y) {
                return x.name == y.name && x.graph == y.graph && x.block == y.block &&
                       x.expansion == y.expansion && x.entry == y.entry && x.exit == y.exit &&
                       x.steps.first == y.steps.first && x.steps.count == y.steps.count;
            })) {
            return "macro-steps";
        }
        if (!all(a_.steps, b_.steps, [](const Step& x, const Step& y) {
                return x.name == y.name && x.graph == y.graph && x.block == y.block &&
                       x.role == y.role && x.initial == y.initial && x.enclosure == y.enclosure &&
                       x.actions.first == y.actions.first && x.actions.count == y.actions.count;
            })) {
            return "steps";
        }
        if (!all(a_.enclosures, b_.enclosures, [](const Enclosure& x, const Enclosure& y) {
                return x.step == y.step && x.graph == y.graph && x.links == y.links;
            })) {
            return "enclosures";
        }
        if (!all(a_.orders, b_.orders, [](const Order& x, const Order& y) {
                return x.step == y.step && x.graph == y.graph && x.kind == y.kind &&
                       x.steps == y.steps;
            })) {
            return "orders";
        }
        return behaviour();
    }

    std::string behaviour() {
        if (!all(a_.transitions, b_.transitions, [this](const Transition& x, const Transition& y) {
                return x.name == y.name && x.labelled == y.labelled && x.graph == y.graph &&
                       x.block == y.block && same(x.condition, y.condition) &&
                       x.preceding.first == y.preceding.first &&
                       x.preceding.count == y.preceding.count &&
                       x.following.first == y.following.first &&
                       x.following.count == y.following.count &&
                       x.clearing.first == y.clearing.first && x.clearing.count == y.clearing.count;
            })) {
            return "transitions";
        }
        if (!all(a_.clearing_actions, b_.clearing_actions,
                 [this](const ClearingAction& x, const ClearingAction& y) {
                     return x.transition == y.transition && same(x.write, y.write);
                 })) {
            return "actions on clearing";
        }
        if (!all(a_.actions, b_.actions, [this](const Action& x, const Action& y) {
                const bool is_stored = x.kind == ActionKind::stored;
                return x.kind == y.kind && x.trigger == y.trigger && x.step == y.step &&
                       x.output == y.output && same(x.expression, y.expression) &&
                       x.order == y.order && (!is_stored || same(x.write, y.write));
            })) {
            return "actions";
        }
        return {};
    }

    template <typename Items, typename Same>
    static bool all(const Items& x, const Items& y, const Same& same_items) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end(), same_items);
    }

    bool same(const Write& x, const Write& y) const {
        return x.target == y.target && x.operation == y.operation && same(x.value, y.value) &&
               x.sum == y.sum;
    }
    bool same(ExprId x, ExprId y) const {
        if (x == no_expr || y == no_expr) return x == y;
        const Expressions& p = a_.expressions;
        const Expressions& q = b_.expressions;
        if (p.kind(x) != q.kind(y)) return false;
        switch (p.kind(x)) {
            case ExprKind::constant:
                return p.constant_value(x) == q.constant_value(y);
            case ExprKind::variable:
                return p.variable_of(x) == q.variable_of(y);
            case ExprKind::comparison:
                return p.comparison_of(x) == q.comparison_of(y);
            case ExprKind::time_condition: {
                const TimeCondition& s = p.time_condition_of(x);
                const TimeCondition& t = q.time_condition_of(y);
                return s.on_delay == t.on_delay && s.off_delay == t.off_delay &&
                       p.ordinal(x) == q.ordinal(y) && same(s.operand, t.operand);
            }
            default: {
                const auto s = p.operands(x);
                const auto t = q.operands(y);
                return std::equal(s.begin(), s.end(), t.begin(), t.end(),
                                  [this](ExprId i, ExprId j) { return same(i, j); });
            }
        }
    }

    const Grafcet& a_;
    const Grafcet& b_;
};

}  // namespace

std::string model_difference(const Grafcet& a, const Grafcet& b) {
    return ModelComparison(a, b).difference();
}

}  // namespace grafwire::testing
