// Which memories a report lists, and which smaller forms it shows.
//
// An edge of the GRAFCET may have lost its use on the way: its transition condition was constantly
// 0, or it stands in an action that no write needs. So what the equations use is marked, from their
// parts down to the operands. Smaller forms are worth showing only where they have fewer operands
// than what was derived; operands are counted as often as they are written, which in a shared
// expression is more often than they are stored.

#include "equations/report/report_parts.h"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "equations/minimise.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

/// Marks expressions and all they are made of.
class Marks {
  public:
    explicit Marks(const Expressions& pool) : pool_(pool), marked_(pool.size(), false) {}

    void mark(ExprId id) {
        if (id != no_expr) marked_[static_cast<std::size_t>(id)] = true;
    }

    /// Operands have smaller ids, so one pass downwards reaches everything.
    void spread() {
        for (std::size_t i = marked_.size(); i-- > 0;) {
            if (!marked_[i]) continue;
            const auto id = static_cast<ExprId>(i);
            for (const ExprId operand : pool_.operands(id)) mark(operand);
            if (pool_.kind(id) == ExprKind::time_condition) {
                mark(pool_.time_condition_of(id).operand);
            }
        }
    }

    std::vector<ExprId> marked_among(const std::vector<ExprId>& ids, std::size_t count) const {
        std::vector<ExprId> result;
        for (std::size_t i = 0; i < count; ++i) {
            if (marked_[static_cast<std::size_t>(ids[i])]) result.push_back(ids[i]);
        }
        return result;
    }

  private:
    const Expressions& pool_;
    std::vector<bool> marked_;
};

}  // namespace

/// Only those of the GRAFCET, which come first: edges that triggers and links need are not listed.
UsedMemories used_memories(const Grafcet& grafcet, const Equations& equations) {
    Marks marks(equations.expressions);
    for (const StepEquation& step : equations.steps) {
        for (const ExprId part : {step.cax, step.cdx, step.link}) marks.mark(part);
    }
    for (const OutputEquation& output : equations.outputs) marks.mark(output.sum);
    for (const HeldEquation& held : equations.held) marks.mark(held.value);
    for (const StoredEquation& stored : equations.stored) {
        for (const StoredWrite& write : stored.writes) {
            marks.mark(write.trigger);
            marks.mark(write.value);
        }
    }
    marks.spread();
    const Expressions& pool = equations.expressions;
    const Expressions& source = grafcet.expressions;
    return {marks.marked_among(pool.edges(), source.edges().size()),
            marks.marked_among(pool.time_conditions(), source.time_conditions().size())};
}

ExprId condition_of(const Equations& equations, const Transition& transition) {
    return equations.from_grafcet[static_cast<std::size_t>(transition.condition)];
}

std::string shown_name(const Grafcet& grafcet, Variable variable) {
    return quoted_where_needed(variable_name(grafcet, variable));
}

std::string sum_text(const Grafcet& grafcet, const Sum& sum) {
    return sum_text(sum, [&](Variable counter) { return shown_name(grafcet, counter); });
}

std::string write_text(const Grafcet& grafcet, const Expressions& pool, Variable target,
                       const StoredWrite& write) {
    const std::string value = write.sum.empty() ? write_expression(grafcet, pool, write.value)
                                                : sum_text(grafcet, write.sum);
    return shown_name(grafcet, target) + " := " + value;
}

namespace {

/// The number of operands in an expression with few distinct atoms, each as often as it is written.
std::size_t literal_count(const Expressions& pool, ExprId root) {
    std::vector<ExprId> nodes{root};
    std::unordered_set<ExprId> seen{root};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const ExprKind kind = pool.kind(nodes[i]);
        if (kind == ExprKind::rise || kind == ExprKind::fall) continue;
        for (const ExprId operand : pool.operands(nodes[i])) {
            if (seen.insert(operand).second) nodes.push_back(operand);
        }
    }
    std::sort(nodes.begin(), nodes.end());
    std::unordered_map<ExprId, std::size_t> counts;
    for (const ExprId id : nodes) {
        const ExprKind kind = pool.kind(id);
        const bool is_atom =
            pool.operands(id).empty() || kind == ExprKind::rise || kind == ExprKind::fall;
        std::size_t count = is_atom && kind != ExprKind::constant ? 1 : 0;
        if (!is_atom) {
            for (const ExprId operand : pool.operands(id)) count += counts.at(operand);
        }
        counts[id] = count;
    }
    return counts.at(root);
}

ExprId smaller_form(Expressions& pool, ExprId id) {
    const ExprId candidate = minimised(pool, id);
    if (candidate == no_expr) return no_expr;
    return literal_count(pool, candidate) < literal_count(pool, id) ? candidate : no_expr;
}

}  // namespace

SmallerForms smaller_forms(Reported& reported, StepId step) {
    Expressions& pool = reported.pool;
    const TableConditions table = table_conditions(reported.equations, step, pool);
    return {smaller_form(pool, table.cax), smaller_form(pool, table.cdx),
            smaller_form(pool, step_expression(reported.equations, step, pool))};
}

}  // namespace grafwire
