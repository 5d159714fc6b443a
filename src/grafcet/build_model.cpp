// The model of a file without errors. Steps are numbered by walking each graph as written and
// stepping into an expansion where its macro-step stands; transitions by taking those of a block,
// then those of the expansions in it. Both walks keep their own stack: expansions may be nested as
// deep as the file is long.

#include <fmt/format.h>

#include <cassert>
#include <functional>

#include "grafcet/checking.h"

namespace grafwire {

namespace {

/// The terms of a sum; all counters are known by now.
Sum sum_of(const Draft& draft, Range<> range) {
    Sum sum;
    for (const std::uint32_t i : range) {
        const DraftTerm& term = draft.terms[i];
        sum.push_back({term.negative, term.counter, term.value});
    }
    return sum;
}

/// The variable of a node: steps, macro-steps and graphs have their final numbers only here.
Variable variable_of(const ExpressionNode& node, const std::vector<std::uint32_t>& node_ids,
                     const std::vector<std::uint32_t>& graph_ids) {
    switch (node.variable) {
        case VariableKind::step:
        case VariableKind::macro:
            return {node.variable, node_ids[node.value]};
        case VariableKind::graph:
            return {node.variable, graph_ids[node.value]};
        default:
            return {node.variable, node.value};
    }
}

/// Replaces the topmost operands by the n-ary node over them.
void reduce(std::vector<ExprId>& stack, const ExpressionNode& node, Expressions& expressions) {
    assert(stack.size() >= node.value);
    const std::span<const ExprId> operands(stack.data() + stack.size() - node.value, node.value);
    ExprId id = no_expr;
    switch (node.kind) {
        case ExprKind::negation:
            id = expressions.negation(operands[0]);
            break;
        case ExprKind::rise:
            id = expressions.rise(operands[0]);
            break;
        case ExprKind::fall:
            id = expressions.fall(operands[0]);
            break;
        case ExprKind::conjunction:
            id = expressions.conjunction(operands);
            break;
        case ExprKind::disjunction:
            id = expressions.disjunction(operands);
            break;
        default:
            id = expressions.exclusive_or(operands);
            break;
    }
    stack.resize(stack.size() - node.value);
    stack.push_back(id);
}

/// Moves a draft into a model. What refers to steps waits until all have their numbers:
/// assumptions, actions and transitions come after the steps of all graphs.
class ModelBuilder {
  public:
    explicit ModelBuilder(const Draft& draft)
        : draft_(draft),
          node_ids_(draft.nodes.size(), none),
          graph_ids_(draft.blocks.size(), none) {}

    Grafcet build() {
        if (draft_.has_name) {
            grafcet_.name = draft_.text(draft_.name);
            grafcet_.title = draft_.text(draft_.title);
        }
        add_declarations();
        reserve();
        add_blocks();
        for (std::uint32_t block = 0; block < draft_.blocks.size(); ++block) {
            if (!draft_.blocks[block].is_expansion) add_steps(block);
        }
        definition_ids_.assign(draft_.definitions.size(), no_expr);
        for (const DraftAssumption& assumption : draft_.assumptions) {
            grafcet_.assumptions.push_back({build(assumption.expression), assumption.where});
        }
        for (std::uint32_t index = 0; index < grafcet_.steps.size(); ++index) add_actions(index);
        for (std::uint32_t block = 0; block < draft_.blocks.size(); ++block) {
            if (!draft_.blocks[block].is_expansion) add_transitions(block);
        }
        finish_held_vars();
        mark_stored_outputs();
        return std::move(grafcet_);
    }

  private:
    std::string string_of(const Word& word) const { return std::string(draft_.text(word)); }
    ExprId build(const DraftExpression& expression) {
        const auto value_of = [this](std::uint32_t index) { return definition(index); };
        return build_expression(draft_, expression, node_ids_, graph_ids_, value_of,
                                grafcet_.expressions);
    }

    /// What a name stands for, which is built where it is first read, as if it stood there. Names
    /// read names no deeper than expressions are nested.
    ExprId definition(std::uint32_t index) {
        if (definition_ids_[index] == no_expr) {
            const DraftDefinition& item = draft_.definitions[index];
            const ExprId value = item.is_held ? held(item) : build(item.expression);
            definition_ids_[index] = value;
        }
        return definition_ids_[index];
    }

    void finish_held_vars() {
        std::uint32_t var = 0;
        for (const DraftDeclaration& item : draft_.declarations) {
            if (item.kind != VariableKind::var) continue;
            if (item.held != none) grafcet_.vars[VarId{var}].held = definition(item.held);
            ++var;
        }
    }

    /// The OR, over the steps that hold a var, of their conditions.
    ExprId held(const DraftDefinition& item) {
        std::vector<ExprId> alternatives;
        for (const std::uint32_t i : item.actions) {
            const DraftAction& action = draft_.actions[i];
            const ExprId step =
                grafcet_.expressions.variable({VariableKind::step, node_ids_[action.node]});
            if (action.expression.empty()) {
                alternatives.push_back(step);
            } else {
                const ExprId both[] = {step, build(action.expression)};
                alternatives.push_back(grafcet_.expressions.conjunction(both));
            }
        }
        return alternatives.size() == 1 ? alternatives.front()
                                        : grafcet_.expressions.disjunction(alternatives);
    }

    void add_declarations() {
        for (const DraftDeclaration& item : draft_.declarations) {
            const Location where = item.name.where;
            switch (item.kind) {
                case VariableKind::output:
                    grafcet_.outputs.add({string_of(item.name), false, where});
                    break;
                case VariableKind::var:
                    grafcet_.vars.add({string_of(item.name), where, no_expr});
                    break;
                case VariableKind::counter:
                    grafcet_.counters.add({string_of(item.name), item.low, item.high, where});
                    break;
                default:
                    grafcet_.inputs.add({string_of(item.name), where});
                    break;
            }
        }
    }

    void reserve() {
        step_nodes_.reserve(draft_.nodes.size());
        grafcet_.steps.items().reserve(draft_.nodes.size());
        grafcet_.transitions.items().reserve(draft_.transitions.size());
        grafcet_.links.reserve(draft_.words.size());
        grafcet_.actions.reserve(draft_.actions.size());
    }

    /// Blocks in the order of the text; the graph of an expansion is that of the block at its root.
    void add_blocks() {
        for (std::uint32_t i = 0; i < draft_.blocks.size(); ++i) {
            const DraftBlock& item = draft_.blocks[i];
            Block block;
            block.name = draft_.text(item.name);
            block.is_expansion = item.is_expansion;
            block.nodes.reserve(draft_.nodes_of_block.of(i).size());
            block.transitions.reserve(draft_.transitions_of_block.of(i).size());
            block.where = item.name.where;
            const BlockId id = grafcet_.blocks.add(std::move(block));
            if (item.is_expansion) continue;
            Graph graph;
            graph.name = draft_.text(item.name);
            graph.block = id;
            graph_ids_[i] = static_cast<std::uint32_t>(grafcet_.graphs.add(std::move(graph)));
        }
        for (std::uint32_t i = 0; i < draft_.blocks.size(); ++i) {
            grafcet_.blocks[BlockId{i}].graph = GraphId{graph_ids_[draft_.blocks[i].root]};
        }
    }

    /// Numbers the steps of a graph: `1 M 5`, where M is expanded to `10 11`, gives 1 10 11 5, so
    /// that the steps of a graph, and those of a macro-step, are an unbroken range.
    void add_steps(std::uint32_t graph_block) {
        Graph& graph = grafcet_.graphs[GraphId{graph_ids_[graph_block]}];
        graph.steps.first = step_count();
        struct Place {
            std::uint32_t block;
            std::uint32_t next;
        };
        std::vector<Place> open = {{graph_block, 0}};
        while (!open.empty()) {
            Place& place = open.back();
            const auto nodes = draft_.nodes_of_block.of(place.block);
            if (place.next == nodes.size()) {
                close_expansion(place.block);
                open.pop_back();
                continue;
            }
            const std::uint32_t node = nodes[place.next++];
            if (draft_.nodes[node].is_macro) {
                add_macro(node);
                open.push_back({draft_.nodes[node].resolved, 0});
            } else {
                add_step(node);
            }
        }
        graph.steps.count = step_count() - graph.steps.first;
    }

    void add_macro(std::uint32_t node) {
        const DraftNode& item = draft_.nodes[node];
        Macro macro;
        macro.name = draft_.text(item.name);
        macro.block = BlockId{item.block};
        macro.graph = grafcet_.blocks[macro.block].graph;
        macro.expansion = BlockId{item.resolved};
        macro.steps.first = step_count();
        macro.where = item.name.where;
        node_ids_[node] = static_cast<std::uint32_t>(grafcet_.macros.add(std::move(macro)));
        grafcet_.blocks[BlockId{item.block}].nodes.push_back({true, node_ids_[node]});
    }

    void close_expansion(std::uint32_t block) {
        const DraftBlock& item = draft_.blocks[block];
        if (!item.is_expansion) return;
        Macro& macro = grafcet_.macros[MacroId{node_ids_[item.macro]}];
        macro.steps.count = step_count() - macro.steps.first;
        macro.entry = StepId{node_ids_[item.entry]};
        macro.exit = StepId{node_ids_[item.exit]};
    }

    void add_step(std::uint32_t node) {
        const DraftNode& item = draft_.nodes[node];
        Step step;
        step.name = draft_.text(item.name);
        step.block = BlockId{item.block};
        step.graph = grafcet_.blocks[step.block].graph;
        step.role = item.role;
        step.initial = item.initial;
        step.where = item.name.where;
        node_ids_[node] = static_cast<std::uint32_t>(grafcet_.steps.add(std::move(step)));
        step_nodes_.push_back(node);
        grafcet_.blocks[BlockId{item.block}].nodes.push_back({false, node_ids_[node]});
    }

    /// Actions of a step lie side by side, and so do those of all steps in their order.
    void add_actions(std::uint32_t index) {
        const DraftNode& item = draft_.nodes[step_nodes_[index]];
        Step& step = grafcet_.steps[StepId{index}];
        if (item.extra != none) {
            const DraftEnclosure& enclosure = draft_.enclosures[item.extra];
            const GraphId graph{graph_ids_[enclosure.resolved]};
            step.enclosure = grafcet_.enclosures.add(
                {StepId{index}, graph, steps_of(enclosure.links), enclosure.graph.where});
            grafcet_.graphs[graph].enclosed_by = step.enclosure;
        }
        step.actions.first = static_cast<std::uint32_t>(grafcet_.actions.size());
        const auto actions = draft_.actions_of_node.of(step_nodes_[index]);
        step.actions.count = static_cast<std::uint32_t>(actions.size());
        for (const std::uint32_t action : actions) {
            add_action(StepId{index}, draft_.actions[action]);
        }
    }

    void add_action(StepId step, const DraftAction& item) {
        Action action;
        action.kind = item.kind;
        action.trigger = item.trigger;
        action.step = step;
        action.where = item.where;
        if (item.held != none) {
            action.kind = ActionKind::held;
            action.var = VarId{item.resolved};
        } else if (item.kind == ActionKind::continuous) {
            action.output = OutputId{item.resolved};
        }
        if (item.kind == ActionKind::stored) action.write = write_of(draft_.writes[item.write]);
        if (!item.expression.empty()) action.expression = build(item.expression);
        if (item.kind == ActionKind::order) {
            action.order = grafcet_.orders.add({step, GraphId{graph_ids_[item.resolved]},
                                                item.order, steps_of(item.steps), item.where});
        }
        grafcet_.actions.push_back(action);
    }

    Write write_of(const DraftWrite& item) {
        Write write;
        write.target = item.resolved;
        write.operation = item.operation;
        if (item.operation != WriteOperation::assign) return write;
        if (item.sum.empty()) {
            write.value = build(item.value);
            return write;
        }
        write.sum = grafcet_.sums.add(sum_of(draft_, item.sum));
        return write;
    }

    std::vector<StepId> steps_of(Range<> list) const {
        std::vector<StepId> steps;
        for (const std::uint32_t i : list) {
            steps.push_back(StepId{node_ids_[draft_.word_nodes[i]]});
        }
        return steps;
    }

    /// Numbers the transitions of a graph: those of a block, then those of its expansions.
    void add_transitions(std::uint32_t graph_block) {
        Graph& graph = grafcet_.graphs[GraphId{graph_ids_[graph_block]}];
        graph.transitions.first = static_cast<std::uint32_t>(grafcet_.transitions.size());
        std::vector<std::uint32_t> open = {graph_block};
        while (!open.empty()) {
            const std::uint32_t block = open.back();
            open.pop_back();
            for (const std::uint32_t rank : draft_.transitions_of_block.of(block)) {
                add_transition(block, rank);
            }
            const auto nodes = draft_.nodes_of_block.of(block);
            for (std::size_t i = nodes.size(); i-- > 0;) {
                const DraftNode& node = draft_.nodes[nodes[i]];
                if (node.is_macro) open.push_back(node.resolved);
            }
        }
        graph.transitions.count =
            static_cast<std::uint32_t>(grafcet_.transitions.size()) - graph.transitions.first;
    }

    /// A transition without a label is called by its rank in the file, as the messages about it
    /// are.
    void add_transition(std::uint32_t block, std::uint32_t rank) {
        const DraftTransition& item = draft_.transitions[rank];
        Transition transition;
        transition.labelled = item.labelled;
        transition.name = item.labelled ? string_of(item.label) : std::to_string(rank);
        transition.block = BlockId{block};
        transition.graph = grafcet_.blocks[transition.block].graph;
        transition.condition = build(item.condition);
        transition.preceding.first = static_cast<std::uint32_t>(grafcet_.links.size());
        transition.preceding.count = item.preceding.count;
        add_links(item.preceding, true);
        transition.following.first = static_cast<std::uint32_t>(grafcet_.links.size());
        transition.following.count = item.following.count;
        add_links(item.following, false);
        transition.clearing.first = static_cast<std::uint32_t>(grafcet_.clearing_actions.size());
        transition.clearing.count = item.writes.count;
        transition.where = item.where;
        const TransitionId id = grafcet_.transitions.add(std::move(transition));
        for (const std::uint32_t i : item.writes) {
            const DraftWrite& write = draft_.writes[i];
            grafcet_.clearing_actions.push_back({id, write_of(write), write.where});
        }
        grafcet_.blocks[BlockId{block}].transitions.push_back(id);
    }

    /// A macro-step before a transition stands for its exit step, one behind it for its entry step.
    void add_links(Range<> list, bool is_preceding) {
        for (const std::uint32_t i : list) {
            const std::uint32_t node = draft_.word_nodes[i];
            StepId step{node_ids_[node]};
            if (draft_.nodes[node].is_macro) {
                const Macro& macro = grafcet_.macros[MacroId{node_ids_[node]}];
                step = is_preceding ? macro.exit : macro.entry;
            }
            grafcet_.links.push_back(step);
        }
    }

    /// An output is stored where anything writes it; one that nothing drives counts as continuous.
    void mark_stored_outputs() {
        const auto mark = [this](const Write& write) {
            if (write.target.kind == VariableKind::output) {
                grafcet_.outputs[OutputId{write.target.index}].stored = true;
            }
        };
        for (const Action& action : grafcet_.actions) {
            if (action.kind == ActionKind::stored) mark(action.write);
        }
        for (const ClearingAction& action : grafcet_.clearing_actions) mark(action.write);
    }

    std::uint32_t step_count() const { return static_cast<std::uint32_t>(grafcet_.steps.size()); }

    const Draft& draft_;
    std::vector<std::uint32_t> node_ids_;    ///< the StepId or MacroId of each of Draft::nodes
    std::vector<std::uint32_t> graph_ids_;   ///< the GraphId of each block that is a graph
    std::vector<std::uint32_t> step_nodes_;  ///< the node of each step
    std::vector<ExprId> definition_ids_;     ///< what each of Draft::definitions stands for
    Grafcet grafcet_;
};

}  // namespace

ExprId build_expression(const Draft& draft, const DraftExpression& expression,
                        const std::vector<std::uint32_t>& node_ids,
                        const std::vector<std::uint32_t>& graph_ids,
                        const std::function<ExprId(std::uint32_t)>& definition,
                        Expressions& expressions) {
    std::vector<ExprId> stack;
    for (const std::uint32_t i : expression) {
        const ExpressionNode& node = draft.expression_nodes[i];
        switch (node.kind) {
            case ExprKind::constant:
                stack.push_back(expressions.constant(node.value != 0));
                break;
            case ExprKind::variable:
                if (node.definition != none) {
                    stack.push_back(definition(node.definition));
                    break;
                }
                stack.push_back(expressions.variable(variable_of(node, node_ids, graph_ids)));
                break;
            case ExprKind::time_condition: {
                const DraftTime& time = draft.times[node.value];
                stack.back() =
                    expressions.time_condition({time.on_delay, stack.back(), time.off_delay});
                break;
            }
            case ExprKind::comparison: {
                const DraftComparison& item = draft.comparisons[node.value];
                stack.push_back(expressions.comparison(
                    {sum_of(draft, item.left), item.relation, sum_of(draft, item.right)}));
                break;
            }
            default:
                reduce(stack, node, expressions);
                break;
        }
    }
    assert(stack.size() == 1);
    return stack.back();
}

Grafcet build_model(const Draft& draft) {
    return ModelBuilder(draft).build();
}

}  // namespace grafwire
