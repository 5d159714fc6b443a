// What is told to GrafcetBuilder is copied here into a few vectors: names into one text, lists into
// ranges, expressions in their postfix order. The memory of a chart as a draft grows with its text,
// not with the number of its parts, and is given back in one go.

#include "grafcet/draft.h"

#include <cassert>
#include <limits>

namespace grafwire {

namespace {

/// Read from its end a postfix list has every operator before its operands: each node hands down to
/// as many as it has whether they are inside a time condition.
void mark_inside_time(std::span<ExpressionNode> nodes) {
    std::vector<bool> to_come{false};
    for (std::size_t i = nodes.size(); i-- > 0;) {
        ExpressionNode& node = nodes[i];
        node.inside_time = to_come.back();
        to_come.pop_back();
        const bool is_time = node.kind == ExprKind::time_condition;
        to_come.insert(to_come.end(), operand_count(node), node.inside_time || is_time);
    }
}

}  // namespace

std::uint32_t operand_count(const ExpressionNode& node) {
    switch (node.kind) {
        case ExprKind::constant:
        case ExprKind::variable:
        case ExprKind::comparison:
            return 0;
        case ExprKind::time_condition:
            return 1;
        default:
            return node.value;
    }
}

/// What belongs to a block or a step, side by side.
void Draft::arrange() {
    nodes_of_block.collect(nodes, &DraftNode::block, blocks.size());
    transitions_of_block.collect(transitions, &DraftTransition::block, blocks.size());
    actions_of_node.collect(actions, &DraftAction::node, nodes.size());
    word_nodes.assign(words.size(), none);
}

Word Draft::add(Name added) {
    assert(added.text.size() <= std::numeric_limits<std::uint32_t>::max() - names.size());
    const Word word{size_of(names), size_of(added.text), added.where};
    names += added.text;
    return word;
}

Range<> Draft::add(std::span<const Name> list) {
    const Range<> range{size_of(words), size_of(list)};
    for (const Name& added : list) words.push_back(add(added));
    return range;
}

/// A negative number becomes a negative term of a positive one.
Range<> Draft::add(const NamedSum& sum) {
    const Range<> range{size_of(terms), size_of(sum)};
    for (const NamedTerm& term : sum) {
        DraftTerm added;
        added.is_name = term.counter.has_value();
        added.negative = term.negative != (!added.is_name && term.number < 0);
        added.value = term.number < 0 ? -term.number : term.number;
        added.word = add(term.counter.value_or(Name{{}, term.where}));
        terms.push_back(added);
    }
    return range;
}

/// The places of times and comparisons move by what is there already.
DraftExpression Draft::add(const NamedExpression& expression) {
    assert(expression.is_empty() || expression.is_whole());
    const DraftExpression range{size_of(expression_nodes), size_of(expression.nodes())};
    for (const NamedExpression::Node& node : expression.nodes()) {
        ExpressionNode added;
        added.kind = node.kind;
        added.value = node.value;
        if (node.kind == ExprKind::time_condition) added.value += size_of(times);
        if (node.kind == ExprKind::comparison) added.value += size_of(comparisons);
        added.word = add(node.name);
        expression_nodes.push_back(added);
    }
    for (const NamedExpression::NamedTimeCondition& time : expression.times()) {
        const Word on_name = add(time.on_delay.name.value_or(Name{}));
        const Word off_name = add(time.off_delay.name.value_or(Name{}));
        DraftTime added;
        added.on_delay = time.on_delay.time;
        added.off_delay = time.off_delay.time;
        added.on_name = on_name;
        added.off_name = off_name;
        times.push_back(added);
    }
    for (const NamedExpression::NamedComparison& comparison : expression.comparisons()) {
        const Range<> left = add(comparison.left);
        comparisons.push_back({left, add(comparison.right), comparison.relation});
    }
    if (!expression.times().empty()) {
        mark_inside_time(std::span(expression_nodes).subspan(range.first));
    }
    return range;
}

DraftWrite Draft::add(const NamedWrite& write) {
    DraftWrite added;
    added.operation = write.operation;
    added.target = add(write.target);
    added.value = add(write.value);
    added.sum = add(write.sum);
    added.where = write.where;
    return added;
}

}  // namespace grafwire
