// A random GRAFCET is made in two passes: first its bones (chart_plan.h), because actions, forcing
// orders and expressions speak of steps and graphs anywhere in the file, then the text.

#include "random/random_grafcet.h"

#include <algorithm>

#include "random/chart_plan.h"
#include "random/named_parts.h"
#include "random/plain_chart.h"
#include "random/random_expression.h"

namespace grafwire::testing {

namespace {

std::string joined(const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : ", ") + item;
    return text;
}

class ChartWriter {
  public:
    ChartWriter(RandomSource& random, const Features& features)
        : random_(random), features_(features), plan_(random_plan(random, features)) {
        choose_names();
        mandatory_ = names_.stored_outputs;
    }

    std::string write() {
        ExpressionWriter expressions(random_, features_, names_);
        expressions_ = &expressions;
        std::string text = declarations();
        std::vector<std::size_t> order(plan_.blocks.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        // Blocks may stand in any order in the file.
        if (random_.flip()) order = random_.pick_some(order, order.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            text += block(plan_.blocks[order[i]], i + 1 == order.size());
        }
        return text;
    }

  private:
    void choose_names();
    std::string declarations();
    std::string block(const PlannedBlock& block, bool is_last);
    std::string node(const PlannedNode& node, std::size_t graph);
    std::vector<std::string> actions(std::size_t graph);
    std::string action(std::size_t graph);
    std::string order(std::size_t graph);
    std::string transition(const PlannedBlock& block, std::size_t from, std::size_t to);
    std::string side(const PlannedBlock& block, std::size_t first);

    RandomSource& random_;
    const Features& features_;
    ChartPlan plan_;
    ChartNames names_;
    ExpressionWriter* expressions_ = nullptr;
    std::vector<std::string> mandatory_;  ///< stored outputs that nothing writes yet
    std::size_t next_label_ = 1000;
};

void ChartWriter::choose_names() {
    std::size_t next = 100;
    const auto make = [&](std::size_t count, const char* stem, std::vector<std::string>& names) {
        for (; count != 0; --count) {
            names.push_back(random_name(random_, features_, stem, next++));
        }
    };
    make(std::max<std::size_t>(1, features_.inputs), "i", names_.inputs);
    const std::size_t stored = features_.stored ? random_.between(0, features_.outputs) : 0;
    make(features_.outputs - stored, "o", names_.continuous_outputs);
    make(stored, "m", names_.stored_outputs);
    if (features_.stored) make(random_.between(0, features_.vars), "v", names_.vars);
    if (features_.stored) make(random_.between(0, features_.counters), "c", names_.counters);
    for (const PlannedBlock& block : plan_.blocks) {
        if (!block.is_expansion) names_.x_variables.push_back(x_variable(block.name));
        for (const PlannedNode& node : block.nodes) {
            names_.x_variables.push_back(x_variable(node.name));
        }
    }
}

std::string ChartWriter::declarations() {
    std::string text = random_.flip() ? "grafcet chart \"a title, éà\"\n" : "";
    for (const std::string& input : names_.inputs) text += "input " + input + "\n";
    std::vector<std::string> outputs = names_.continuous_outputs;
    outputs.insert(outputs.end(), names_.stored_outputs.begin(), names_.stored_outputs.end());
    for (const std::string& output : random_.pick_some(outputs, outputs.size())) {
        text += "output " + output + "\n";
    }
    for (const std::string& var : names_.vars) text += "var " + var + "\n";
    for (const std::string& counter : names_.counters) {
        const std::size_t high = random_.below(5);
        const std::size_t below = random_.below(4);
        const std::string low = random_.flip() ? "0" : "-" + std::to_string(below);
        text += "counter " + counter + " : " + low + ".." + std::to_string(high) + "\n";
    }
    if (features_.assumptions && random_.one_in(3)) {
        // With an input of its own among the terms, so that it can always be satisfied.
        const std::string a = expressions_->plant_expression(1);
        text += "assume " + a + " + " + expressions_->plant_expression(0) + "\n";
    }
    return text;
}

std::string ChartWriter::block(const PlannedBlock& block, bool is_last) {
    std::string text = (block.is_expansion ? "expansion " : "graph ") + block.name + " {\n";
    for (const PlannedNode& item : block.nodes) text += "  " + node(item, block.graph);
    const std::size_t count = block.nodes.size();
    // A cycle through the nodes, now and then broken, so that tokens get about; then anything.
    if (count > 1) {
        for (std::size_t i = 0; i < count; ++i) {
            if (!random_.one_in(6)) text += "  " + transition(block, i, (i + 1) % count);
        }
    }
    for (std::size_t more = random_.below(count + 1); more != 0; --more) {
        const std::size_t from = random_.below(count);
        text += "  " + transition(block, from, random_.below(count));
    }
    if (is_last && !mandatory_.empty()) {
        const std::string& step = block.nodes[0].name;
        const std::string when = expressions_->receptivity();
        std::vector<std::string> writes;
        for (const std::string& target : mandatory_) writes.push_back(expressions_->write(target));
        if (features_.clearing) {
            text += "  " + step + " -> " + step + " : " + when + " do " + joined(writes) + "\n";
        } else {
            const std::string extra = std::to_string(next_label_++);
            text += "  step " + extra + " : " + joined(writes) + "\n  " + step + " -> " + extra +
                    " : " + when + "\n  " + extra + " -> " + step + " : 1\n";
        }
    }
    return text + "}\n";
}

std::string ChartWriter::node(const PlannedNode& node, std::size_t graph) {
    if (node.kind == PlannedNode::Kind::macro) {
        return "macro " + node.name + " = " + plan_.blocks[node.expansion].name + "\n";
    }
    std::string text = node.kind == PlannedNode::Kind::entry  ? "entry "
                       : node.kind == PlannedNode::Kind::exit ? "exit "
                       : !node.initial                        ? "step "
                       : random_.flip()                       ? "initial "
                                                              : "initial step ";
    text += node.name;
    if (node.encloses != nothing) {
        const auto links = random_.pick_some(plan_.steps_of(node.encloses), random_.between(1, 2));
        text += " encloses " + plan_.blocks[node.encloses].name + "{" + joined(links) + "}";
    }
    const std::vector<std::string> list = actions(graph);
    return text + (list.empty() ? "\n" : " : " + joined(list) + "\n");
}

std::vector<std::string> ChartWriter::actions(std::size_t graph) {
    std::vector<std::string> list;
    for (std::size_t count = random_.below(3); count != 0; --count) {
        const std::string text = action(graph);
        if (!text.empty()) list.push_back(text);
    }
    return list;
}

std::string ChartWriter::order(std::size_t graph) {
    const std::size_t target = random_.between(graph + 1, plan_.graph_count - 1);
    const std::string& name = plan_.blocks[target].name;
    switch (random_.below(4)) {
        case 0:
            return name + "{}";
        case 1:
            return name + "{INIT}";
        case 2:
            return name + "{*}";
        default:
            return name + "{" +
                   joined(random_.pick_some(plan_.steps_of(target), random_.between(1, 2))) + "}";
    }
}

std::string ChartWriter::action(std::size_t graph) {
    if (features_.orders && graph + 1 < plan_.graph_count && random_.one_in(3)) return order(graph);
    const bool can_store = features_.stored && expressions_->has_targets();
    if (!names_.continuous_outputs.empty() && (!can_store || random_.flip())) {
        const std::string output = random_.pick(names_.continuous_outputs);
        return random_.one_in(3) ? output + " if " + expressions_->condition() : output;
    }
    if (!can_store) return {};
    std::string text;
    if (!mandatory_.empty()) {
        text = expressions_->write(mandatory_.back());
        mandatory_.pop_back();
    } else {
        text = expressions_->write();
    }
    switch (random_.below(5)) {
        case 0:
            return text + " on deactivation";
        case 1:
            return text + " on activation";
        case 2:
            return text + " on " + expressions_->expression();
        default:
            return text;
    }
}

/// One side of a transition: mostly one node, sometimes two (AND).
std::string ChartWriter::side(const PlannedBlock& block, std::size_t first) {
    std::vector<std::string> names{block.nodes[first].name};
    const std::size_t second = random_.below(block.nodes.size());
    if (second != first && random_.one_in(8)) names.push_back(block.nodes[second].name);
    return joined(names);
}

std::string ChartWriter::transition(const PlannedBlock& block, std::size_t from, std::size_t to) {
    std::string text;
    if (random_.one_in(3)) {
        text = "(" +
               (random_.flip() ? std::to_string(next_label_)
                               : random_name(random_, features_, "t", next_label_)) +
               ") ";
        ++next_label_;
    }
    const bool is_source = features_.sources_and_sinks && random_.one_in(12);
    const bool is_sink = features_.sources_and_sinks && !is_source && random_.one_in(12);
    if (!is_source) text += side(block, from) + " ";
    text += "->";
    if (!is_sink) text += " " + side(block, to);
    text += random_.one_in(12) ? " := 1" : " : " + expressions_->receptivity();
    if (features_.clearing && features_.stored && expressions_->has_targets() &&
        random_.one_in(4)) {
        text += " do " + expressions_->write();
        if (random_.one_in(3)) text += ", " + expressions_->write();
    }
    return text + "\n";
}

}  // namespace

std::string random_grafcet(RandomSource& random, const Features& features) {
    const std::string chart =
        features.plain ? plain_chart(random, features) : ChartWriter(random, features).write();
    if (!features.named_parts) return chart;
    return with_named_parts(chart, !features.plain && features.vars != 0);
}

}  // namespace grafwire::testing
