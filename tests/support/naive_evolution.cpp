#include "support/naive_evolution.h"

#include <algorithm>
#include <set>

namespace grafwire::testing {

bool NaiveEvolution::value(ExprId id, const NaiveState& s, const InputValues& in) const {
    const Expressions& e = g_.expressions;
    std::vector<bool> v;
    for (const ExprId operand : e.operands(id)) v.push_back(value(operand, s, in));
    const auto ones = std::count(v.begin(), v.end(), true);
    switch (e.kind(id)) {
        case ExprKind::constant:
            return e.constant_value(id);
        case ExprKind::negation:
            return ones == 0;
        case ExprKind::conjunction:
            return ones == static_cast<long>(v.size());
        case ExprKind::disjunction:
            return ones > 0;
        case ExprKind::exclusive_or:
            return ones % 2 == 1;
        case ExprKind::rise:
        case ExprKind::fall:
            return s.edge_values[e.ordinal(id)];
        case ExprKind::time_condition:
            return s.times[e.ordinal(id)];
        case ExprKind::comparison: {
            const Comparison& c = e.comparison_of(id);
            const std::int64_t l = sum(c.left, s);
            const std::int64_t r = sum(c.right, s);
            return (c.relation == Relation::equal && l == r) ||
                   (c.relation == Relation::not_equal && l != r) ||
                   (c.relation == Relation::less && l < r) ||
                   (c.relation == Relation::less_equal && l <= r) ||
                   (c.relation == Relation::greater && l > r) ||
                   (c.relation == Relation::greater_equal && l >= r);
        }
        case ExprKind::variable:
            break;
    }
    const Variable x = e.variable_of(id);
    if (x.kind == VariableKind::input) return in[x.index] != 0;
    if (x.kind == VariableKind::control) return in[g_.inputs.size() + x.index] != 0;
    if (x.kind == VariableKind::output) return s.stored[x.index];
    if (x.kind == VariableKind::var) return s.vars[x.index];
    if (x.kind == VariableKind::step) return s.ts[x.index];
    for (std::size_t i = 0; i < g_.steps.size(); ++i) {
        if (!s.ts[i]) continue;
        const Macro* macro = x.kind == VariableKind::macro ? &g_.macros[MacroId{x.index}] : nullptr;
        const bool belongs =
            macro != nullptr
                ? macro->steps.contains(StepId{static_cast<std::uint32_t>(i)})
                : index_of(g_.steps[StepId{static_cast<std::uint32_t>(i)}].graph) == x.index;
        if (belongs) return true;
    }
    return false;
}

std::int64_t NaiveEvolution::sum(const Sum& terms, const NaiveState& s) const {
    std::int64_t total = 0;
    for (const SumTerm& t : terms) {
        const std::int64_t v = t.counter == SumTerm::no_counter ? t.value : s.counters[t.counter];
        total += t.negative ? -v : v;
    }
    return total;
}

NaiveState NaiveEvolution::start(const InputValues& in) const {
    NaiveState s;
    for (const Step& step : g_.steps) s.ts.push_back(step.initial);
    s.tp = s.ts;
    s.tfig.assign(g_.graphs.size(), true);
    s.stored.assign(g_.outputs.size(), false);
    s.vars.assign(g_.vars.size(), false);
    for (const Counter& counter : g_.counters) s.counters.push_back(counter.low);
    const std::size_t time_count = g_.expressions.time_conditions().size();
    s.times.assign(time_count, false);
    s.waiting.assign(time_count, false);
    s.since.assign(time_count, 0);
    const std::size_t edge_count = g_.expressions.edges().size();
    s.edge_values.assign(edge_count, false);
    s.edge_memories.assign(edge_count, false);
    for (std::size_t i = 0; i < edge_count; ++i) {
        const ExprId edge = g_.expressions.edges()[i];
        s.edge_memories[i] = value(g_.expressions.operands(edge)[0], s, in);
    }
    return s;
}

void NaiveEvolution::edges(NaiveState& s, const InputValues& in) const {
    for (std::size_t i = 0; i < s.edge_values.size(); ++i) {
        const ExprId edge = g_.expressions.edges()[i];
        const bool now = value(g_.expressions.operands(edge)[0], s, in);
        const bool before = s.edge_memories[i];
        s.edge_values[i] =
            g_.expressions.kind(edge) == ExprKind::rise ? now && !before : !now && before;
        s.edge_memories[i] = now;
    }
}

std::vector<bool> NaiveEvolution::cleared_now(const NaiveState& s, const InputValues& in) const {
    std::vector<bool> tt;
    for (const Transition& t : g_.transitions) {
        tt.push_back(value(t.condition, s, in) && s.tfig[index_of(t.graph)]);
    }
    std::vector<bool> cleared;
    for (std::size_t i = 0; i < tt.size(); ++i) {
        bool enabled = true;
        for (const StepId p : g_.preceding(g_.transitions.items()[i])) {
            enabled = enabled && s.ts[index_of(p)];
        }
        cleared.push_back(enabled && tt[i]);
    }
    if (in[g_.inputs.size()] != 0) cleared.assign(cleared.size(), false);
    return cleared;
}

std::vector<bool> NaiveEvolution::cleared(NaiveState s, const InputValues& in) const {
    edges(s, in);
    return cleared_now(s, in);
}

void NaiveEvolution::forcing(NaiveState& s) const {
    std::vector<bool> tf0(s.ts.size()), tf1(s.ts.size());
    for (const Order& order : g_.orders) {
        if (!s.ts[index_of(order.step)] || order.kind == OrderKind::freeze) continue;
        for (std::size_t i = 0; i < s.ts.size(); ++i) {
            const Step& step = g_.steps.items()[i];
            if (step.graph != order.graph) continue;
            tf0[i] = true;
            const bool listed = std::count(order.steps.begin(), order.steps.end(),
                                           StepId{static_cast<std::uint32_t>(i)}) != 0;
            if (order.kind == OrderKind::listed && listed) tf1[i] = true;
            if (order.kind == OrderKind::initial && step.initial) tf1[i] = true;
        }
    }
    for (std::size_t i = 0; i < s.ts.size(); ++i) s.ts[i] = (s.ts[i] && !tf0[i]) || tf1[i];
}

void NaiveEvolution::enclosures(NaiveState& s, const std::vector<bool>& after_4, bool init) const {
    // From the outermost inwards: as long as there is one whose surroundings are done.
    std::set<std::size_t> left;
    for (std::size_t e = 0; e < g_.enclosures.size(); ++e) left.insert(e);
    const auto is_outermost = [&](std::size_t e) {
        for (const std::size_t other : left) {
            if (g_.enclosures.items()[other].graph == g_.steps[g_.enclosures.items()[e].step].graph)
                return false;
        }
        return true;
    };
    while (!left.empty()) {
        const std::size_t e = *std::find_if(left.begin(), left.end(), is_outermost);
        left.erase(e);
        const Enclosure& enclosure = g_.enclosures.items()[e];
        const std::size_t outer = index_of(enclosure.step);
        bool ordered = false;
        for (const Order& order : g_.orders) {
            if (after_4[index_of(order.step)] && order.graph == enclosure.graph) ordered = true;
        }
        if (!s.ts[outer]) {
            for (std::size_t i = 0; i < s.ts.size(); ++i) {
                if (g_.steps.items()[i].graph == enclosure.graph) s.ts[i] = false;
            }
        } else if (!s.tp[outer] && !init && !ordered) {
            for (const StepId link : enclosure.links) s.ts[index_of(link)] = true;
        }
    }
}

void NaiveEvolution::actions(NaiveState& s, const InputValues& in,
                             const std::vector<bool>& cleared) const {
    NaiveState next = s;
    const auto write = [&](const Write& w) {
        if (w.target.kind == VariableKind::counter) {
            const Counter& counter = g_.counters.items()[w.target.index];
            next.counters[w.target.index] =
                std::clamp(sum(g_.sums[w.sum], s), counter.low, counter.high);
            return;
        }
        bool bit = w.operation == WriteOperation::set;
        if (w.operation == WriteOperation::assign) bit = value(w.value, s, in);
        (w.target.kind == VariableKind::var ? next.vars : next.stored)[w.target.index] = bit;
    };
    const auto of_steps = [&](Trigger trigger) {
        for (const Action& a : g_.actions) {
            if (a.kind != ActionKind::stored || a.trigger != trigger) continue;
            const bool now = s.ts[index_of(a.step)];
            const bool before = s.tp[index_of(a.step)];
            if (trigger == Trigger::activation && now && !before) write(a.write);
            if (trigger == Trigger::deactivation && !now && before) write(a.write);
            if (trigger == Trigger::event && now && value(a.expression, s, in)) write(a.write);
        }
    };
    of_steps(Trigger::deactivation);
    for (const ClearingAction& a : g_.clearing_actions) {
        if (cleared[index_of(a.transition)]) write(a.write);
    }
    of_steps(Trigger::activation);
    of_steps(Trigger::event);
    s = next;
}

void NaiveEvolution::times(NaiveState& s, const InputValues& in, Time now) const {
    for (std::size_t i = 0; i < s.times.size(); ++i) {
        const TimeCondition& c =
            g_.expressions.time_condition_of(g_.expressions.time_conditions()[i]);
        const bool operand = value(c.operand, s, in);
        if (operand != s.times[i]) {
            if (!s.waiting[i]) s.since[i] = now;
            s.waiting[i] = true;
            if (now - s.since[i] >= (operand ? c.on_delay : c.off_delay)) s.times[i] = operand;
        }
        if (operand == s.times[i]) {
            s.waiting[i] = false;
            s.since[i] = 0;
        }
    }
}

void NaiveEvolution::end_delays(NaiveState& s, const InputValues& in, Time now) const {
    for (std::size_t i = 0; i < s.times.size(); ++i) {
        const TimeCondition& c =
            g_.expressions.time_condition_of(g_.expressions.time_conditions()[i]);
        if (!s.waiting[i] || now - s.since[i] < (s.times[i] ? c.off_delay : c.on_delay)) continue;
        if (value(c.operand, s, in) == s.times[i]) continue;  // it no longer asks for it
        s.times[i] = !s.times[i];
        s.waiting[i] = false;
        s.since[i] = 0;
    }
}

void NaiveEvolution::scan(NaiveState& s, const InputValues& in, Time now) const {
    s.tp = s.ts;
    edges(s, in);
    const bool init = in[g_.inputs.size()] != 0;
    const std::vector<bool> cleared = cleared_now(s, in);
    std::vector<bool> ta(s.ts.size()), td(s.ts.size());
    for (std::size_t t = 0; t < cleared.size(); ++t) {
        if (!cleared[t]) continue;
        for (const StepId p : g_.preceding(g_.transitions.items()[t])) td[index_of(p)] = true;
        for (const StepId f : g_.following(g_.transitions.items()[t])) ta[index_of(f)] = true;
    }
    for (std::size_t i = 0; i < s.ts.size(); ++i) s.ts[i] = (s.tp[i] && !td[i]) || ta[i];
    if (init) {
        for (std::size_t i = 0; i < s.ts.size(); ++i) s.ts[i] = g_.steps.items()[i].initial;
    }
    const std::vector<bool> after_4 = s.ts;
    forcing(s);
    enclosures(s, after_4, init);
    if (in[g_.inputs.size() + 1] != 0) s.ts.assign(s.ts.size(), false);
    actions(s, in, cleared);
    times(s, in, now);
    s.tfig.assign(s.tfig.size(), true);
    for (const Order& order : g_.orders) {
        if (order.kind == OrderKind::freeze && s.ts[index_of(order.step)]) {
            s.tfig[index_of(order.graph)] = false;
        }
    }
}

std::vector<bool> NaiveEvolution::outputs(const NaiveState& s, const InputValues& in) const {
    std::vector<bool> result(g_.outputs.size(), false);
    for (const Action& a : g_.actions) {
        if (a.kind == ActionKind::continuous && s.ts[index_of(a.step)] &&
            (a.expression == no_expr || value(a.expression, s, in))) {
            result[index_of(a.output)] = true;
        }
    }
    if (in[g_.inputs.size() + 2] != 0) result.assign(result.size(), false);
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (g_.outputs.items()[i].stored) result[i] = s.stored[i];
    }
    return result;
}

std::vector<bool> NaiveEvolution::held_vars(const NaiveState& s, const InputValues& in) const {
    std::vector<bool> result(g_.vars.size(), false);
    for (const Action& a : g_.actions) {
        if (a.kind == ActionKind::held && s.ts[index_of(a.step)] &&
            (a.expression == no_expr || value(a.expression, s, in))) {
            result[index_of(a.var)] = true;
        }
    }
    return result;
}

bool NaiveEvolution::settle(NaiveState& s, const InputValues& in, Time now,
                            std::vector<std::string>& changing) const {
    std::vector<NaiveState> seen = {s};
    for (;;) {
        scan(s, in, now);
        const NaiveState& before = seen.back();
        const bool any_edge = std::count(s.edge_values.begin(), s.edge_values.end(), true) != 0;
        if (!any_edge && before.ts == s.ts && before.tfig == s.tfig && before.times == s.times &&
            before.vars == s.vars && before.counters == s.counters && before.stored == s.stored) {
            return true;
        }
        const auto again = std::find(seen.begin(), seen.end(), s);
        if (again == seen.end()) {
            seen.push_back(s);
            continue;
        }
        const auto add = [&](std::string name, auto&& part) {
            const bool changes = std::any_of(
                again, seen.end(), [&](const NaiveState& other) { return part(other) != part(s); });
            if (changes) changing.push_back(std::move(name));
        };
        for (std::size_t i = 0; i < s.ts.size(); ++i) {
            add("X" + g_.steps.items()[i].name, [i](const NaiveState& o) { return bool(o.ts[i]); });
        }
        for (std::size_t i = 0; i < s.stored.size(); ++i) {
            add(g_.outputs.items()[i].name, [i](const NaiveState& o) { return bool(o.stored[i]); });
        }
        for (std::size_t i = 0; i < s.vars.size(); ++i) {
            add(g_.vars.items()[i].name, [i](const NaiveState& o) { return bool(o.vars[i]); });
        }
        for (std::size_t i = 0; i < s.counters.size(); ++i) {
            add(g_.counters.items()[i].name, [i](const NaiveState& o) { return o.counters[i]; });
        }
        return false;
    }
}

}  // namespace grafwire::testing
