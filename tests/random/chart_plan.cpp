#include "random/chart_plan.h"

#include <algorithm>

#include "random/chart_names.h"

namespace grafwire::testing {

namespace {

class Planner {
  public:
    Planner(RandomSource& random, const Features& features)
        : random_(random), features_(features), steps_left_(features.steps) {}

    ChartPlan make() {
        plan_.graph_count = random_.between(1, features_.graphs);
        for (std::size_t graph = 0; graph < plan_.graph_count; ++graph) {
            PlannedBlock block;
            block.name = random_name(random_, features_, "G", next_++);
            block.graph = graph;
            plan_.blocks.push_back(std::move(block));
        }
        for (std::size_t graph = 0; graph < plan_.graph_count; ++graph) fill(graph, 0);
        if (features_.enclosures) choose_enclosures();
        return std::move(plan_);
    }

  private:
    void fill(std::size_t block, std::size_t depth);
    void add_macro(std::size_t block, std::size_t depth);
    void choose_enclosures();
    std::vector<PlannedNode*> steps_that_may_enclose(std::size_t before_graph);
    bool has_initial(std::size_t graph) const;

    RandomSource& random_;
    const Features& features_;
    std::size_t steps_left_;
    std::size_t next_ = 0;
    ChartPlan plan_;
};

void Planner::fill(std::size_t block, std::size_t depth) {
    const bool is_expansion = plan_.blocks[block].is_expansion;
    const std::size_t share =
        std::max<std::size_t>(1, features_.steps / (plan_.graph_count + depth));
    const std::size_t wanted =
        random_.between(is_expansion ? 0 : 1, std::max<std::size_t>(1, share));
    for (std::size_t i = 0; i < wanted && (i == 0 || steps_left_ != 0); ++i) {
        if (features_.macros && depth < 3 && steps_left_ > 2 && random_.one_in(5)) {
            add_macro(block, depth);
            continue;
        }
        PlannedNode node;
        node.name = random_step_name(random_, features_, next_++);
        const auto& nodes = plan_.blocks[block].nodes;
        node.initial = nodes.empty() && !is_expansion ? !random_.one_in(8) : random_.one_in(4);
        plan_.blocks[block].nodes.push_back(node);
        if (steps_left_ != 0) --steps_left_;
    }
}

void Planner::add_macro(std::size_t block, std::size_t depth) {
    PlannedBlock expansion;
    expansion.name = random_name(random_, features_, "expansion", next_++);
    expansion.graph = plan_.blocks[block].graph;
    expansion.is_expansion = true;
    for (const auto kind : {PlannedNode::Kind::entry, PlannedNode::Kind::exit}) {
        PlannedNode node;
        node.kind = kind;
        node.name = random_step_name(random_, features_, next_++);
        expansion.nodes.push_back(node);
        --steps_left_;
    }
    PlannedNode macro;
    macro.kind = PlannedNode::Kind::macro;
    macro.name = random_name(random_, features_, "M", next_++);
    macro.expansion = plan_.blocks.size();
    plan_.blocks[block].nodes.push_back(macro);
    plan_.blocks.push_back(std::move(expansion));
    fill(macro.expansion, depth + 1);
    // Entry and exit may stand anywhere in the expansion.
    std::vector<PlannedNode>& nodes = plan_.blocks[macro.expansion].nodes;
    nodes = random_.pick_some(nodes, nodes.size());
}

std::vector<PlannedNode*> Planner::steps_that_may_enclose(std::size_t before_graph) {
    std::vector<PlannedNode*> steps;
    for (PlannedBlock& block : plan_.blocks) {
        if (block.graph >= before_graph) continue;
        for (PlannedNode& node : block.nodes) {
            const bool is_free = node.kind == PlannedNode::Kind::step && node.encloses == nothing;
            if (is_free) steps.push_back(&node);
        }
    }
    return steps;
}

bool Planner::has_initial(std::size_t graph) const {
    for (const PlannedBlock& block : plan_.blocks) {
        if (block.graph != graph) continue;
        for (const PlannedNode& node : block.nodes) {
            if (node.initial) return true;
        }
    }
    return false;
}

/// An enclosed graph has initial steps if and only if the enclosing step is initial. Enclosing
/// steps stand in earlier graphs, whose initial steps are settled by then.
void Planner::choose_enclosures() {
    for (std::size_t graph = 1; graph < plan_.graph_count; ++graph) {
        const std::vector<PlannedNode*> candidates = steps_that_may_enclose(graph);
        if (candidates.empty() || !random_.one_in(3)) continue;
        PlannedNode& step = *random_.pick(candidates);
        if (step.initial && !has_initial(graph)) continue;
        step.encloses = graph;
        if (step.initial) continue;
        for (PlannedBlock& block : plan_.blocks) {
            if (block.graph != graph) continue;
            for (PlannedNode& node : block.nodes) node.initial = false;
        }
    }
}

}  // namespace

std::vector<std::string> ChartPlan::steps_of(std::size_t graph) const {
    std::vector<std::string> names;
    for (const PlannedBlock& block : blocks) {
        if (block.graph != graph) continue;
        for (const PlannedNode& node : block.nodes) {
            if (node.kind != PlannedNode::Kind::macro) names.push_back(node.name);
        }
    }
    return names;
}

ChartPlan random_plan(RandomSource& random, const Features& features) {
    return Planner(random, features).make();
}

}  // namespace grafwire::testing
