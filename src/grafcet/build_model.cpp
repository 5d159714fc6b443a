// The model of a file without errors. Steps are numbered by walking each graph as written and
// stepping into an expansion where its macro-step stands; transitions by taking those of a block,
// then those of the expansions in it. Both walks keep their own stack: expansions may be nested as
// deep as the file is long.

#include <fmt/format.h>

#include "grafcet/names.h"

namespace grafwire {

namespace {

class ModelBuilder {
  public:
    explicit ModelBuilder(const Syntax& syntax)
        : syntax_(syntax),
          node_ids_(syntax.nodes.size(), none),
          graph_ids_(syntax.blocks.size(), none) {}

    Grafcet build() {
        if (syntax_.has_name) {
            grafcet_.name = syntax_.text(syntax_.name);
            grafcet_.title = syntax_.text(syntax_.title);
        }
        add_declarations();
        reserve();
        add_blocks();
        for (std::uint32_t block = 0; block < syntax_.blocks.size(); ++block)
            if (!syntax_.blocks[block].is_expansion) add_steps(block);
        for (const ExpressionSyntax& assumption : syntax_.assumptions)
            grafcet_.assumptions.push_back({build(assumption), assumption.where});
        for (std::uint32_t index = 0; index < grafcet_.steps.size(); ++index) add_actions(index);
        for (std::uint32_t block = 0; block < syntax_.blocks.size(); ++block)
            if (!syntax_.blocks[block].is_expansion) add_transitions(block);
        mark_stored_outputs();
        return std::move(grafcet_);
    }

  private:
    std::string string_of(const Word& word) const { return std::string(syntax_.text(word)); }
    ExprId build(const ExpressionSyntax& expression) {
        return build_expression(syntax_, expression, node_ids_, graph_ids_, grafcet_.expressions);
    }

    void add_declarations() {
        for (const DeclarationSyntax& item : syntax_.declarations) {
            const Location where = item.name.where;
            switch (item.kind) {
                case VariableKind::output:
                    grafcet_.outputs.add({string_of(item.name), false, where});
                    break;
                case VariableKind::var:
                    grafcet_.vars.add({string_of(item.name), where});
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
        step_nodes_.reserve(syntax_.nodes.size());
        grafcet_.steps.items().reserve(syntax_.nodes.size());
        grafcet_.transitions.items().reserve(syntax_.transitions.size());
        grafcet_.links.reserve(syntax_.words.size());
        grafcet_.actions.reserve(syntax_.actions.size());
    }

    void add_blocks() {
        for (std::uint32_t i = 0; i < syntax_.blocks.size(); ++i) {
            const BlockSyntax& item = syntax_.blocks[i];
            Block block;
            block.name = syntax_.text(item.name);
            block.is_expansion = item.is_expansion;
            block.nodes.reserve(item.nodes.count);
            block.transitions.reserve(item.transitions.count);
            block.where = item.name.where;
            const BlockId id = grafcet_.blocks.add(std::move(block));
            if (item.is_expansion) continue;
            Graph graph;
            graph.name = syntax_.text(item.name);
            graph.block = id;
            graph_ids_[i] = static_cast<std::uint32_t>(grafcet_.graphs.add(std::move(graph)));
        }
        for (std::uint32_t i = 0; i < syntax_.blocks.size(); ++i)
            grafcet_.blocks[BlockId{i}].graph = GraphId{graph_ids_[syntax_.blocks[i].root]};
    }

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
            const Range<> nodes = syntax_.blocks[place.block].nodes;
            if (place.next == nodes.count) {
                close_expansion(place.block);
                open.pop_back();
                continue;
            }
            const std::uint32_t node = nodes.first + place.next++;
            if (syntax_.nodes[node].kind == NodeKind::macro) {
                add_macro(node);
                open.push_back({syntax_.nodes[node].resolved, 0});
            } else {
                add_step(node);
            }
        }
        graph.steps.count = step_count() - graph.steps.first;
    }

    void add_macro(std::uint32_t node) {
        const NodeSyntax& item = syntax_.nodes[node];
        Macro macro;
        macro.name = syntax_.text(item.name);
        macro.block = BlockId{item.block};
        macro.graph = grafcet_.blocks[macro.block].graph;
        macro.expansion = BlockId{item.resolved};
        macro.steps.first = step_count();
        macro.where = item.name.where;
        node_ids_[node] = static_cast<std::uint32_t>(grafcet_.macros.add(std::move(macro)));
        grafcet_.blocks[BlockId{item.block}].nodes.push_back({true, node_ids_[node]});
    }

    void close_expansion(std::uint32_t block) {
        const BlockSyntax& item = syntax_.blocks[block];
        if (!item.is_expansion) return;
        Macro& macro = grafcet_.macros[MacroId{node_ids_[item.macro]}];
        macro.steps.count = step_count() - macro.steps.first;
        macro.entry = StepId{node_ids_[item.entry]};
        macro.exit = StepId{node_ids_[item.exit]};
    }

    void add_step(std::uint32_t node) {
        const NodeSyntax& item = syntax_.nodes[node];
        Step step;
        step.name = syntax_.text(item.name);
        step.block = BlockId{item.block};
        step.graph = grafcet_.blocks[step.block].graph;
        step.role = item.kind == NodeKind::entry  ? StepRole::entry
                    : item.kind == NodeKind::exit ? StepRole::exit
                                                  : StepRole::ordinary;
        step.initial = item.initial;
        step.where = item.name.where;
        node_ids_[node] = static_cast<std::uint32_t>(grafcet_.steps.add(std::move(step)));
        step_nodes_.push_back(node);
        grafcet_.blocks[BlockId{item.block}].nodes.push_back({false, node_ids_[node]});
    }

    void add_actions(std::uint32_t index) {
        const NodeSyntax& item = syntax_.nodes[step_nodes_[index]];
        Step& step = grafcet_.steps[StepId{index}];
        if (item.extra != none) {
            const EnclosureSyntax& enclosure = syntax_.enclosures[item.extra];
            const GraphId graph{graph_ids_[enclosure.resolved]};
            step.enclosure = grafcet_.enclosures.add(
                {StepId{index}, graph, steps_of(enclosure.links), enclosure.graph.where});
            grafcet_.graphs[graph].enclosed_by = step.enclosure;
        }
        step.actions.first = static_cast<std::uint32_t>(grafcet_.actions.size());
        step.actions.count = item.actions.count;
        for (std::uint32_t i = 0; i < item.actions.count; ++i)
            add_action(StepId{index}, syntax_.actions[item.actions.first + i]);
    }

    void add_action(StepId step, const ActionSyntax& item) {
        Action action;
        action.kind = item.kind;
        action.trigger = item.trigger;
        action.step = step;
        action.where = item.where;
        if (item.kind == ActionKind::continuous) action.output = OutputId{item.resolved};
        if (item.kind == ActionKind::stored) action.write = write_of(syntax_.writes[item.write]);
        if (item.expression.is_present()) action.expression = build(item.expression);
        if (item.kind == ActionKind::order) {
            action.order = grafcet_.orders.add({step, GraphId{graph_ids_[item.resolved]},
                                                item.order, steps_of(item.steps), item.where});
        }
        grafcet_.actions.push_back(action);
    }

    Write write_of(const WriteSyntax& item) {
        Write write;
        write.target = item.resolved;
        write.operation = item.operation;
        if (item.operation != WriteOperation::assign) return write;
        if (!item.is_sum) {
            write.value = build(item.value);
            return write;
        }
        Sum sum;
        for (std::uint32_t i = item.sum.first; i < item.sum.first + item.sum.count; ++i) {
            const TermSyntax& term = syntax_.terms[i];
            sum.push_back({term.negative, term.counter, term.value});
        }
        write.sum = grafcet_.sums.add(std::move(sum));
        return write;
    }

    std::vector<StepId> steps_of(Range<> list) const {
        std::vector<StepId> steps;
        for (std::uint32_t i = list.first; i < list.first + list.count; ++i)
            steps.push_back(StepId{node_ids_[syntax_.word_nodes[i]]});
        return steps;
    }

    void add_transitions(std::uint32_t graph_block) {
        Graph& graph = grafcet_.graphs[GraphId{graph_ids_[graph_block]}];
        graph.transitions.first = static_cast<std::uint32_t>(grafcet_.transitions.size());
        std::vector<std::uint32_t> open = {graph_block};
        while (!open.empty()) {
            const std::uint32_t block = open.back();
            open.pop_back();
            const BlockSyntax& item = syntax_.blocks[block];
            for (std::uint32_t i = 0; i < item.transitions.count; ++i)
                add_transition(block, item.transitions.first + i);
            for (std::uint32_t i = item.nodes.count; i-- > 0;) {
                const NodeSyntax& node = syntax_.nodes[item.nodes.first + i];
                if (node.kind == NodeKind::macro) open.push_back(node.resolved);
            }
        }
        graph.transitions.count =
            static_cast<std::uint32_t>(grafcet_.transitions.size()) - graph.transitions.first;
    }

    void add_transition(std::uint32_t block, std::uint32_t rank) {
        const TransitionSyntax& item = syntax_.transitions[rank];
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
        for (std::uint32_t i = 0; i < item.writes.count; ++i) {
            const WriteSyntax& write = syntax_.writes[item.writes.first + i];
            grafcet_.clearing_actions.push_back({id, write_of(write), write.where});
        }
        grafcet_.blocks[BlockId{block}].transitions.push_back(id);
    }

    void add_links(Range<> list, bool is_preceding) {
        for (std::uint32_t i = list.first; i < list.first + list.count; ++i) {
            const std::uint32_t node = syntax_.word_nodes[i];
            StepId step{node_ids_[node]};
            if (syntax_.nodes[node].kind == NodeKind::macro) {
                const Macro& macro = grafcet_.macros[MacroId{node_ids_[node]}];
                step = is_preceding ? macro.exit : macro.entry;
            }
            grafcet_.links.push_back(step);
        }
    }

    void mark_stored_outputs() {
        const auto mark = [this](const Write& write) {
            if (write.target.kind == VariableKind::output)
                grafcet_.outputs[OutputId{write.target.index}].stored = true;
        };
        for (const Action& action : grafcet_.actions)
            if (action.kind == ActionKind::stored) mark(action.write);
        for (const ClearingAction& action : grafcet_.clearing_actions) mark(action.write);
    }

    std::uint32_t step_count() const { return static_cast<std::uint32_t>(grafcet_.steps.size()); }

    const Syntax& syntax_;
    std::vector<std::uint32_t> node_ids_;    // the StepId or MacroId of each of Syntax::nodes
    std::vector<std::uint32_t> graph_ids_;   // the GraphId of each block that is a graph
    std::vector<std::uint32_t> step_nodes_;  // the node of each step
    Grafcet grafcet_;
};

}  // namespace

Grafcet build_model(const Syntax& syntax) {
    return ModelBuilder(syntax).build();
}

}  // namespace grafwire
