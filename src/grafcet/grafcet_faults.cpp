// Ids are checked before what they lead to is looked at, so that any contents can be examined. The
// order of steps and transitions is checked by walking the chart as grafcet.h describes it and
// counting: each walk must meet the numbers 0, 1, 2 … in turn. Lists that belong to steps and
// transitions (actions, links, …) lie one behind the other without a gap.

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/grafcet_builder.h"

namespace grafwire {

namespace {

/// The first fault, in the order of the model: each check may rely on what those before it have
/// found sound.
class FaultSearch {
  public:
    explicit FaultSearch(const Grafcet& grafcet) : g_(grafcet) {}

    std::string search() {
        const bool is_sound = sums_and_expressions() && declarations() && blocks() && steps() &&
                              macros() && graphs() && walk_of_steps() && enclosures() &&
                              actions() && orders() && transitions() && walk_of_transitions() &&
                              stored_outputs();
        return is_sound ? "" : fault_;
    }

  private:
    template <typename... Args>
    /// Notes the fault where `holds` is false.
    bool require(bool holds, fmt::format_string<Args...> what, Args&&... args) {
        if (!holds) fault_ = fmt::format(what, std::forward<Args>(args)...);
        return holds;
    }

    template <typename Id, typename Item>
    static bool is_in(Id id, const Table<Id, Item>& table) {
        return index_of(id) < table.size();
    }
    template <typename Id>
    static std::uint32_t end_of(Range<Id> range) {
        return range.first + range.count;
    }
    static bool is_in(Range<> range, std::size_t size) {
        return std::size_t{range.first} + range.count <= size;
    }
    bool is_step(StepId id) const { return is_in(id, g_.steps); }
    bool is_expression(ExprId id) const { return index_of(id) < g_.expressions.size(); }

    /// Whether there is such a variable.
    bool is_variable(Variable variable) const {
        const std::size_t sizes[variable_kind_count] = {
            g_.inputs.size(),   control_input_count, g_.outputs.size(), g_.vars.size(),
            g_.counters.size(), g_.steps.size(),     g_.macros.size(),  g_.graphs.size()};
        return variable.index < sizes[static_cast<std::size_t>(variable.kind)];
    }

    /// A sum has terms, and a minus is the sign of a term, never of its number.
    bool is_sum(const Sum& sum) const {
        return !sum.empty() && std::all_of(sum.begin(), sum.end(), [this](const SumTerm& term) {
            return term.value >= 0 &&
                   (term.counter == SumTerm::no_counter || term.counter < g_.counters.size());
        });
    }

    /// Expressions read variables that there are; counters occur in comparisons only.
    bool sums_and_expressions() {
        for (const Sum& sum : g_.sums) {
            if (!require(is_sum(sum), "a sum has no terms, a negative number or no such counter")) {
                return false;
            }
        }
        const Expressions& pool = g_.expressions;
        for (std::size_t i = 0; i < pool.size(); ++i) {
            const auto id = static_cast<ExprId>(i);
            bool is_sound = true;
            if (pool.kind(id) == ExprKind::variable) {
                const Variable variable = pool.variable_of(id);
                is_sound = is_variable(variable) && variable.kind != VariableKind::counter;
            } else if (pool.kind(id) == ExprKind::comparison) {
                const Comparison& comparison = pool.comparison_of(id);
                is_sound = is_sum(comparison.left) && is_sum(comparison.right);
            }
            if (!require(is_sound, "expression {} reads what there is not", i)) return false;
        }
        return true;
    }

    /// Ranges are not empty, and assumptions are over inputs.
    bool declarations() {
        for (const Counter& counter : g_.counters) {
            if (!require(counter.low <= counter.high, "the range of counter {} is empty",
                         counter.name)) {
                return false;
            }
        }
        for (const Var& var : g_.vars) {
            if (!require(!var.is_held() || is_expression(var.held), "var {} stands for nothing",
                         var.name)) {
                return false;
            }
        }
        for (const Assumption& assumption : g_.assumptions) {
            if (!require(is_of_plant(assumption.expression), "an assumption is not over inputs")) {
                return false;
            }
        }
        return true;
    }

    /// Whether an expression is over inputs alone, as assumptions are.
    bool is_of_plant(ExprId id) const {
        if (!is_expression(id)) return false;
        switch (g_.expressions.kind(id)) {
            case ExprKind::rise:
            case ExprKind::fall:
            case ExprKind::time_condition:
            case ExprKind::comparison:
                return false;
            case ExprKind::variable: {
                const VariableKind kind = g_.expressions.variable_of(id).kind;
                return kind == VariableKind::input || kind == VariableKind::control;
            }
            default: {
                const auto operands = g_.expressions.operands(id);
                return std::all_of(operands.begin(), operands.end(),
                                   [this](ExprId operand) { return is_of_plant(operand); });
            }
        }
    }

    /// Blocks list steps, macro-steps and transitions that there are; the walks look at their
    /// order.
    bool blocks() {
        for (const Block& block : g_.blocks) {
            bool is_sound = is_in(block.graph, g_.graphs);
            for (const Block::Node& node : block.nodes) {
                is_sound =
                    is_sound && node.index < (node.is_macro ? g_.macros.size() : g_.steps.size());
            }
            for (const TransitionId id : block.transitions) {
                is_sound = is_sound && is_in(id, g_.transitions);
            }
            if (!require(is_sound, "block {} lists what there is not", block.name)) return false;
        }
        return true;
    }

    /// Each step has its place, and its actions follow those of the step before.
    bool steps() {
        std::uint32_t next_action = 0;
        for (const Step& step : g_.steps) {
            const bool has_place = is_in(step.block, g_.blocks) &&
                                   step.graph == g_.blocks[step.block].graph &&
                                   is_in(step.graph, g_.graphs);
            if (!require(has_place, "step {} is in no graph or no block of it", step.name) ||
                !require(step.role == StepRole::ordinary || g_.blocks[step.block].is_expansion,
                         "step {} is the entry or exit of a graph", step.name) ||
                !require(
                    step.role == StepRole::ordinary || (!step.initial && step.enclosure == none),
                    "step {} is an entry or exit, and is initial or encloses", step.name) ||
                !require(step.enclosure == none || is_in(step.enclosure, g_.enclosures),
                         "step {} has no such enclosure", step.name) ||
                !require(
                    step.actions.first == next_action && is_in(step.actions, g_.actions.size()),
                    "the actions of step {} are out of order", step.name)) {
                return false;
            }
            next_action += step.actions.count;
        }
        return require(next_action == g_.actions.size(), "an action belongs to no step");
    }

    /// Each macro-step has an expansion of its own, and each expansion a macro-step.
    bool macros() {
        std::vector<bool> is_used(g_.blocks.size(), false);
        for (const Macro& macro : g_.macros) {
            const bool has_place = is_in(macro.block, g_.blocks) &&
                                   is_in(macro.expansion, g_.blocks) &&
                                   macro.graph == g_.blocks[macro.block].graph &&
                                   macro.graph == g_.blocks[macro.expansion].graph;
            if (!require(has_place && g_.blocks[macro.expansion].is_expansion,
                         "macro-step {} has no place or no expansion", macro.name) ||
                !require(!is_used[index_of(macro.expansion)],
                         "two macro-steps have one expansion") ||
                !require(is_end(macro, macro.entry, StepRole::entry) &&
                             is_end(macro, macro.exit, StepRole::exit),
                         "macro-step {} has no entry or exit step", macro.name)) {
                return false;
            }
            is_used[index_of(macro.expansion)] = true;
        }
        for (std::size_t i = 0; i < g_.blocks.size(); ++i) {
            const Block& block = g_.blocks.items()[i];
            if (!require(!block.is_expansion || is_used[i], "no macro-step uses expansion {}",
                         block.name)) {
                return false;
            }
        }
        return true;
    }

    /// Whether a step is the entry or exit of the expansion of a macro-step.
    bool is_end(const Macro& macro, StepId id, StepRole role) const {
        return is_step(id) && g_.steps[id].block == macro.expansion && g_.steps[id].role == role;
    }

    /// The steps and transitions of the graphs follow each other without a gap.
    bool graphs() {
        std::uint32_t next_step = 0;
        std::uint32_t next_transition = 0;
        std::size_t graph_blocks = 0;
        for (const Block& block : g_.blocks) graph_blocks += block.is_expansion ? 0U : 1U;
        if (!require(graph_blocks == g_.graphs.size(), "graphs and their blocks are not as many")) {
            return false;
        }
        for (std::size_t i = 0; i < g_.graphs.size(); ++i) {
            const Graph& graph = g_.graphs.items()[i];
            const bool has_block = is_in(graph.block, g_.blocks) &&
                                   !g_.blocks[graph.block].is_expansion &&
                                   index_of(g_.blocks[graph.block].graph) == i;
            if (!require(has_block, "graph {} has no block", graph.name) ||
                !require(graph.steps.first == next_step, "the steps of graph {} are out of order",
                         graph.name) ||
                !require(graph.transitions.first == next_transition,
                         "the transitions of graph {} are out of order", graph.name) ||
                !require(graph.enclosed_by == none || is_in(graph.enclosed_by, g_.enclosures),
                         "graph {} is enclosed by what there is not", graph.name)) {
                return false;
            }
            next_step += graph.steps.count;
            next_transition += graph.transitions.count;
        }
        return require(next_step == g_.steps.size(), "a step is in no graph") &&
               require(next_transition == g_.transitions.size(), "a transition is in no graph");
    }

    /// Graph by graph as written, into each expansion where its macro-step stands.
    bool walk_of_steps() {
        std::uint32_t next_step = 0;
        std::uint32_t next_macro = 0;
        struct Place {
            BlockId block{};
            std::size_t next = 0;
            const Macro* macro = nullptr;
        };
        for (const Graph& graph : g_.graphs) {
            std::vector<Place> open{{graph.block, 0, nullptr}};
            while (!open.empty()) {
                Place& place = open.back();
                const Block& block = g_.blocks[place.block];
                if (place.next == block.nodes.size()) {
                    if (place.macro != nullptr &&
                        !require(end_of(place.macro->steps) == next_step,
                                 "macro-step {} has not the steps of its expansion",
                                 place.macro->name)) {
                        return false;
                    }
                    open.pop_back();
                    continue;
                }
                const Block::Node node = block.nodes[place.next++];
                std::uint32_t& next = node.is_macro ? next_macro : next_step;
                const BlockId own = node.is_macro ? g_.macros.items()[node.index].block
                                                  : g_.steps.items()[node.index].block;
                if (!require(node.index == next && own == place.block,
                             "the steps of block {} are out of order", block.name)) {
                    return false;
                }
                ++next;
                if (!node.is_macro) continue;
                const Macro& macro = g_.macros.items()[node.index];
                if (!require(macro.steps.first == next_step,
                             "macro-step {} has not the steps of its expansion", macro.name)) {
                    return false;
                }
                open.push_back({macro.expansion, 0, &macro});
            }
            if (!require(next_step == end_of(graph.steps),
                         "graph {} has not the steps of its block", graph.name)) {
                return false;
            }
        }
        return require(next_macro == g_.macros.size(), "a macro-step is in no block");
    }

    /// Whether all of them are steps of the graph, those of its expansions included.
    bool are_steps_of(GraphId graph, const std::vector<StepId>& steps) const {
        return std::all_of(steps.begin(), steps.end(),
                           [&](StepId id) { return is_step(id) && g_.steps[id].graph == graph; });
    }

    /// An enclosure, its step and its graph name each other.
    bool enclosures() {
        for (std::size_t i = 0; i < g_.enclosures.size(); ++i) {
            const EnclosureId id = g_.enclosures.id_at(i);
            const Enclosure& enclosure = g_.enclosures[id];
            const bool is_sound = is_step(enclosure.step) && is_in(enclosure.graph, g_.graphs) &&
                                  g_.steps[enclosure.step].enclosure == id &&
                                  g_.graphs[enclosure.graph].enclosed_by == id;
            const bool is_in_order = i == 0 || g_.enclosures.items()[i - 1].step < enclosure.step;
            if (!require(is_sound, "enclosure {} is not that of its step and graph", i) ||
                !require(is_in_order, "enclosure {} is out of order", i) ||
                !require(!enclosure.links.empty() && are_steps_of(enclosure.graph, enclosure.links),
                         "enclosure {} links to no step of its graph", i)) {
                return false;
            }
        }
        const auto known = [](EnclosureId id) { return id != none; };
        const auto enclosing = std::count_if(g_.steps.begin(), g_.steps.end(),
                                             [&](const Step& s) { return known(s.enclosure); });
        const auto enclosed = std::count_if(g_.graphs.begin(), g_.graphs.end(),
                                            [&](const Graph& g) { return known(g.enclosed_by); });
        const auto count = static_cast<std::ptrdiff_t>(g_.enclosures.size());
        return require(enclosing == count && enclosed == count,
                       "a step or graph has the enclosure of another");
    }

    /// Counters take sums, outputs and vars expressions; `set` and `reset` take nothing.
    bool is_write(const Write& write) const {
        const bool is_counter = write.target.kind == VariableKind::counter;
        const bool is_target = is_counter || write.target.kind == VariableKind::output ||
                               write.target.kind == VariableKind::var;
        if (!is_target || !is_variable(write.target)) return false;
        if (write.operation != WriteOperation::assign) {
            return !is_counter && write.value == no_expr && write.sum == none;
        }
        return is_counter ? is_in(write.sum, g_.sums) && write.value == no_expr
                          : is_expression(write.value) && write.sum == none;
    }

    /// Actions belong to the step that lists them; orders stand in the order of their actions.
    bool actions() {
        std::uint32_t next_order = 0;
        for (std::size_t s = 0; s < g_.steps.size(); ++s) {
            const Step& step = g_.steps.items()[s];
            for (const Action& action : g_.actions_of(step)) {
                if (!require(index_of(action.step) == s, "an action of step {} is another's",
                             step.name) ||
                    !require(is_action(action), "an action of step {} is not of its kind",
                             step.name)) {
                    return false;
                }
                if (action.kind != ActionKind::order) continue;
                if (!require(index_of(action.order) == next_order,
                             "the orders of step {} are out of order", step.name)) {
                    return false;
                }
                ++next_order;
            }
        }
        return require(next_order == g_.orders.size(), "an order belongs to no step");
    }

    /// Whether an action has what its kind asks for, and nothing else.
    bool is_action(const Action& action) const {
        switch (action.kind) {
            case ActionKind::continuous:
                return is_in(action.output, g_.outputs) && action.order == none &&
                       (action.expression == no_expr || is_expression(action.expression));
            case ActionKind::held:
                return is_in(action.var, g_.vars) && g_.vars[action.var].is_held() &&
                       action.order == none &&
                       (action.expression == no_expr || is_expression(action.expression));
            case ActionKind::stored:
                return is_write(action.write) && action.order == none &&
                       (action.trigger == Trigger::event ? is_expression(action.expression)
                                                         : action.expression == no_expr);
            case ActionKind::order:
                return is_in(action.order, g_.orders) && action.expression == no_expr &&
                       g_.orders[action.order].step == action.step;
        }
        return false;
    }

    /// A list of steps where the order asks for one, and only of the graph that is forced.
    bool orders() {
        for (const Order& order : g_.orders) {
            const std::string& step = g_.steps[order.step].name;
            const bool is_listed = order.kind == OrderKind::listed;
            if (!require(is_in(order.graph, g_.graphs), "an order of step {} is to no graph",
                         step) ||
                !require(is_listed != order.steps.empty() && are_steps_of(order.graph, order.steps),
                         "an order of step {} lists what it cannot force", step)) {
                return false;
            }
        }
        return true;
    }

    /// Each transition has its place, its condition and its steps; links and clearing actions
    /// follow those of the transition before.
    bool transitions() {
        std::uint32_t next_link = 0;
        std::uint32_t next_clearing = 0;
        for (std::size_t t = 0; t < g_.transitions.size(); ++t) {
            const Transition& transition = g_.transitions.items()[t];
            const std::string& name = transition.name;
            const bool has_place = is_in(transition.block, g_.blocks) &&
                                   transition.graph == g_.blocks[transition.block].graph;
            if (!require(has_place, "transition {} is in no block or another graph", name) ||
                !require(is_expression(transition.condition), "transition {} has no condition",
                         name) ||
                !require(transition.preceding.first == next_link &&
                             transition.following.first == end_of(transition.preceding) &&
                             is_in(transition.following, g_.links.size()),
                         "the links of transition {} are out of order", name) ||
                !require(transition.preceding.count + transition.following.count != 0,
                         "transition {} has no steps", name) ||
                !require(is_linked(transition), "transition {} links a step of another block",
                         name) ||
                !require(transition.clearing.first == next_clearing &&
                             is_in(transition.clearing, g_.clearing_actions.size()),
                         "the actions of transition {} are out of order", name)) {
                return false;
            }
            next_link = end_of(transition.following);
            next_clearing = end_of(transition.clearing);
            for (const ClearingAction& action : g_.clearing_actions_of(transition)) {
                if (!require(index_of(action.transition) == t && is_write(action.write),
                             "an action of transition {} is another's or no write", name)) {
                    return false;
                }
            }
        }
        return require(next_link == g_.links.size(), "a link belongs to no transition") &&
               require(next_clearing == g_.clearing_actions.size(),
                       "an action on clearing belongs to no transition");
    }

    /// A macro-step of the block is left by its exit and entered by its entry.
    bool is_linked(const Transition& transition) const {
        const auto is_near = [&](StepId id, StepRole role) {
            if (!is_step(id)) return false;
            const Step& step = g_.steps[id];
            if (step.block == transition.block) return true;
            return step.role == role &&
                   std::any_of(g_.macros.begin(), g_.macros.end(), [&](const Macro& macro) {
                       return macro.block == transition.block && macro.expansion == step.block;
                   });
        };
        const auto before = g_.preceding(transition);
        const auto after = g_.following(transition);
        return std::all_of(before.begin(), before.end(),
                           [&](StepId id) { return is_near(id, StepRole::exit); }) &&
               std::all_of(after.begin(), after.end(),
                           [&](StepId id) { return is_near(id, StepRole::entry); });
    }

    /// Those of a block, then those of the expansions in it.
    bool walk_of_transitions() {
        std::uint32_t next = 0;
        for (const Graph& graph : g_.graphs) {
            std::vector<BlockId> open{graph.block};
            while (!open.empty()) {
                const BlockId id = open.back();
                open.pop_back();
                const Block& block = g_.blocks[id];
                for (const TransitionId transition : block.transitions) {
                    if (!require(
                            index_of(transition) == next && g_.transitions[transition].block == id,
                            "the transitions of block {} are out of order", block.name)) {
                        return false;
                    }
                    ++next;
                }
                for (std::size_t i = block.nodes.size(); i-- > 0;) {
                    const Block::Node node = block.nodes[i];
                    if (node.is_macro) open.push_back(g_.macros.items()[node.index].expansion);
                }
            }
            if (!require(next == end_of(graph.transitions),
                         "graph {} has not the transitions of its block", graph.name)) {
                return false;
            }
        }
        return true;
    }

    /// An output is stored exactly where something writes it, and then nothing else drives it.
    bool stored_outputs() {
        Table<OutputId, bool> is_written(g_.outputs.size(), false);
        Table<OutputId, bool> is_driven(g_.outputs.size(), false);
        const auto note = [&is_written](const Write& write) {
            if (write.target.kind == VariableKind::output) {
                is_written[OutputId{write.target.index}] = true;
            }
        };
        for (const Action& action : g_.actions) {
            if (action.kind == ActionKind::stored) note(action.write);
            if (action.kind == ActionKind::continuous) is_driven[action.output] = true;
        }
        for (const ClearingAction& action : g_.clearing_actions) note(action.write);
        for (std::size_t i = 0; i < g_.outputs.size(); ++i) {
            const OutputId id = g_.outputs.id_at(i);
            const Output& output = g_.outputs[id];
            if (!require(output.stored == is_written[id], "output {} is stored, or is not",
                         output.name) ||
                !require(!is_written[id] || !is_driven[id],
                         "output {} is driven by both kinds of action", output.name)) {
                return false;
            }
        }
        return true;
    }

    const Grafcet& g_;
    std::string fault_;
};

}  // namespace

std::string fault_of(const Grafcet& grafcet) {
    return FaultSearch(grafcet).search();
}

}  // namespace grafwire
