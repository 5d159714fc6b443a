// The pool of a GRAFCET holds expressions as they were written. Here they are rebuilt, operands
// before what uses them, with the operators of logic.h and with the variables of macro-steps and
// graphs written out.
//
// Evolution, netlist and check speak of the same time condition by its ordinal, so rebuilding must
// neither drop one nor make two into one. Two can come to coincide (`↑XM` beside `↑(X20 + X21)`, or
// `3s/(a + 0)` beside `3s/a`); since a pool holds equal expressions once, the later one is then
// given an operand that is equal but not the same: `↑(e.e)`, the next `↑(e.(e.e))`.

#include <cassert>
#include <map>
#include <utility>

#include "equations/derivation.h"

namespace grafwire {

namespace {

class Normaliser {
  public:
    Normaliser(const Grafcet& grafcet, Expressions& pool, std::vector<ExprId>& normal)
        : grafcet_(grafcet), source_(grafcet.expressions), pool_(pool), normal_(normal) {}

    void run() {
        normal_.reserve(source_.size());
        for (std::size_t i = 0; i < source_.size(); ++i) {
            normal_.push_back(rebuilt(static_cast<ExprId>(i)));
        }
        assert(pool_.edges().size() == source_.edges().size());
        assert(pool_.time_conditions().size() == source_.time_conditions().size());
    }

  private:
    ExprId rebuilt(ExprId id) {
        switch (source_.kind(id)) {
            case ExprKind::constant:
                return pool_.constant(source_.constant_value(id));
            case ExprKind::variable:
                return variable(source_.variable_of(id));
            case ExprKind::negation:
                return not_of(pool_, normal(source_.operands(id).front()));
            case ExprKind::conjunction:
                return and_of(pool_, normal_operands(id));
            case ExprKind::disjunction:
                return or_of(pool_, normal_operands(id));
            case ExprKind::exclusive_or:
                return xor_of(pool_, normal_operands(id));
            case ExprKind::rise:
            case ExprKind::fall:
                return edge(id);
            case ExprKind::time_condition:
                return time_condition(id);
            case ExprKind::comparison:
                return pool_.comparison(source_.comparison_of(id));
        }
        return no_expr;
    }

    ExprId normal(ExprId id) const { return normal_[static_cast<std::size_t>(id)]; }

    const std::vector<ExprId>& normal_operands(ExprId id) {
        operands_.clear();
        for (const ExprId operand : source_.operands(id)) operands_.push_back(normal(operand));
        return operands_;
    }

    ExprId variable(Variable variable) {
        if (variable.kind == VariableKind::macro) {
            const Macro& macro = grafcet_.macros[static_cast<MacroId>(variable.index)];
            return any_step(macro.steps);
        }
        if (variable.kind == VariableKind::graph) {
            const Graph& graph = grafcet_.graphs[static_cast<GraphId>(variable.index)];
            return any_step(graph.steps);
        }
        return pool_.variable(variable);
    }

    ExprId any_step(Range<StepId> steps) {
        std::vector<ExprId> variables;
        variables.reserve(steps.count);
        for (const StepId step : steps) {
            variables.push_back(
                pool_.variable({VariableKind::step, static_cast<std::uint32_t>(step)}));
        }
        return or_of(pool_, variables);
    }

    ExprId edge(ExprId id) {
        const ExprKind kind = source_.kind(id);
        const ExprId operand = normal(source_.operands(id).front());
        const std::size_t before = pool_.edges().size();
        ExprId result = make_edge(kind, operand);
        if (pool_.edges().size() == before) {
            result = make_edge(kind, equal_but_not_same(kind, {0, operand, 0}));
        }
        assert(pool_.ordinal(result) == source_.ordinal(id));
        // What never changes has no edge.
        return pool_.kind(operand) == ExprKind::constant ? pool_.constant(false) : result;
    }

    ExprId make_edge(ExprKind kind, ExprId operand) {
        return kind == ExprKind::rise ? pool_.rise(operand) : pool_.fall(operand);
    }

    ExprId time_condition(ExprId id) {
        TimeCondition condition = source_.time_condition_of(id);
        condition.operand = normal(condition.operand);
        const bool never_one = is_constant(pool_, condition.operand, false);
        const std::size_t before = pool_.time_conditions().size();
        ExprId result = pool_.time_condition(condition);
        if (pool_.time_conditions().size() == before) {
            condition.operand = equal_but_not_same(ExprKind::time_condition, condition);
            result = pool_.time_condition(condition);
        }
        assert(pool_.ordinal(result) == source_.ordinal(id));
        // With the operand 1 it is not constant: it is 0 until the delay has passed.
        return never_one ? pool_.constant(false) : result;
    }

    ExprId equal_but_not_same(ExprKind kind, const TimeCondition& key) {
        const auto [place, is_new] = last_operand_.try_emplace({kind, key}, key.operand);
        const ExprId pair[] = {key.operand, place->second};
        return place->second = pool_.conjunction(pair);
    }

    const Grafcet& grafcet_;
    const Expressions& source_;
    Expressions& pool_;
    std::vector<ExprId>& normal_;
    std::vector<ExprId> operands_;
    std::map<std::pair<ExprKind, TimeCondition>, ExprId> last_operand_;
};

}  // namespace

void normalise_expressions(const Grafcet& grafcet, Equations& equations) {
    Normaliser(grafcet, equations.expressions, equations.from_grafcet).run();
}

}  // namespace grafwire
