// Names that stand for conditions: those of `define`, and vars that steps hold by continuous
// actions, which stand for the OR over their steps. Whoever reads such a name reads the condition
// in its place, so the model knows no definitions; what has to be known here is what a name comes
// to when it is written out. Some rules ask whether an edge is in it, or anything but inputs; and
// names that stand for names can grow without bound (each twice the one before), or stand for
// themselves.
//
// The names are sorted so that each comes behind those that it reads (depth first, with a stack of
// its own, since a file may chain them as long as it likes); then one pass over them answers all of
// this.

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/checking.h"
#include "grafcet/messages.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// Of what a name stands for, written out.
constexpr std::uint32_t most_parts = 10'000;

class Definitions {
  public:
    explicit Definitions(const Checking& checking)
        : checking_(checking), draft_(checking.draft), reads_(draft_.definitions.size()) {}

    void resolve() {
        for (std::uint32_t i = 0; i < draft_.definitions.size(); ++i) link(i);
        sort();
        for (const std::uint32_t i : draft_.definitions_inwards) sum_up(i);
        for (const DraftDefinition& definition : draft_.definitions) {
            resolve_expression(checking_, definition.expression, ExpressionUse::value);
        }
        for (DraftDefinition& definition : draft_.definitions) definition.is_read = false;
        for (DraftDuration& duration : draft_.durations) duration.is_read = false;
    }

  private:
    /// Calls `visit` with each node of what a name stands for.
    template <typename Visit>
    void for_each_node(const DraftDefinition& definition, const Visit& visit) {
        for (const std::uint32_t i : definition.expression) visit(draft_.expression_nodes[i]);
        for (const std::uint32_t action : definition.actions) {
            for (const std::uint32_t i : draft_.actions[action].expression) {
                visit(draft_.expression_nodes[i]);
            }
        }
    }

    /// Finds the names in it that stand for something in their turn.
    void link(std::uint32_t definition) {
        for_each_node(draft_.definitions[definition], [&](ExpressionNode& node) {
            if (node.kind != ExprKind::variable) return;
            const auto* found = checking_.names.variables.find(draft_.text(node.word));
            if (found == nullptr || found->definition == none) return;
            node.definition = found->definition;
            reads_[definition].push_back(found->definition);
        });
    }

    void sort() {
        enum class State : std::uint8_t { untouched, open, done };
        std::vector<State> states(draft_.definitions.size(), State::untouched);
        struct Place {
            std::uint32_t definition;
            std::size_t next;
        };
        std::vector<Place> open;
        for (std::uint32_t root = 0; root < draft_.definitions.size(); ++root) {
            if (states[root] == State::untouched) open.push_back({root, 0});
            while (!open.empty()) {
                Place& place = open.back();
                const std::uint32_t here = place.definition;
                states[here] = State::open;
                if (place.next == reads_[here].size()) {
                    states[here] = State::done;
                    draft_.definitions_inwards.push_back(here);
                    open.pop_back();
                    continue;
                }
                const std::uint32_t read = reads_[here][place.next++];
                if (states[read] == State::untouched) open.push_back({read, 0});
                if (states[read] != State::open || &place != &open.back()) continue;
                std::vector<std::uint32_t> circle;
                for (const Place& on_way : open) circle.push_back(on_way.definition);
                circle.erase(circle.begin(), std::find(circle.begin(), circle.end(), read));
                report_circle(circle);
            }
        }
    }

    void report_circle(const std::vector<std::uint32_t>& circle) {
        std::string names;
        for (const std::uint32_t i : circle) {
            names += std::string(draft_.text(draft_.definitions[i].name)) + " → ";
        }
        names += draft_.text(draft_.definitions[circle.front()].name);
        checking_.error(code::circle_of_definitions, draft_.definitions[circle.front()].name.where,
                        say::circle_of_definitions(quoted(names)));
    }

    /// What it comes to, from what the names in it come to.
    void sum_up(std::uint32_t index) {
        DraftDefinition& definition = draft_.definitions[index];
        std::uint64_t size = 1;
        std::uint32_t levels = 1;
        if (definition.is_held) definition.is_of_plant = false;
        for_each_node(definition, [&](const ExpressionNode& node) {
            const DraftDefinition* read =
                node.definition == none ? nullptr : &draft_.definitions[node.definition];
            size += read == nullptr ? 1 : read->size;
            levels = std::max(levels, read == nullptr ? 1 : read->levels + 1);
            const bool is_edge = node.kind == ExprKind::rise || node.kind == ExprKind::fall;
            const bool has_edge = is_edge || (read != nullptr && read->has_edge);
            if (has_edge && !node.inside_time) definition.has_edge = true;
            if (!is_of_plant(node, read)) definition.is_of_plant = false;
        });
        // A bound on the nesting, not its measure: no expression is deeper than it has nodes.
        levels += draft_.definitions[index].expression.count;
        definition.size = static_cast<std::uint32_t>(std::min<std::uint64_t>(size, most_parts + 1));
        definition.levels = std::min<std::uint32_t>(levels, most_parts);
        if (size > most_parts) {
            checking_.error(
                code::nested_too_deep, definition.name.where,
                say::definition_too_large(checking_.shown(definition.name), most_parts));
        }
    }

    bool is_of_plant(const ExpressionNode& node, const DraftDefinition* read) const {
        switch (node.kind) {
            case ExprKind::rise:
            case ExprKind::fall:
            case ExprKind::time_condition:
            case ExprKind::comparison:
                return false;
            case ExprKind::variable:
                break;
            default:
                return true;
        }
        if (read != nullptr) return read->is_of_plant;
        const auto* found = checking_.names.variables.find(draft_.text(node.word));
        return found != nullptr && (found->variable.kind == VariableKind::input ||
                                    found->variable.kind == VariableKind::control);
    }

    const Checking& checking_;
    Draft& draft_;
    std::vector<std::vector<std::uint32_t>> reads_;
};

}  // namespace

void resolve_definitions(const Checking& checking) {
    if (!checking.draft.definitions.empty()) Definitions(checking).resolve();
}

/// A name is read if something that is no definition reads it, or a definition that is read.
void warn_unread(const Checking& checking) {
    Draft& draft = checking.draft;
    const auto mark = [&draft](const DraftExpression& expression) {
        for (const std::uint32_t i : expression) {
            const ExpressionNode& node = draft.expression_nodes[i];
            if (node.definition != none) draft.definitions[node.definition].is_read = true;
            if (node.kind != ExprKind::time_condition) continue;
            for (const std::uint32_t duration :
                 {draft.times[node.value].on_duration, draft.times[node.value].off_duration}) {
                if (duration != none) draft.durations[duration].is_read = true;
            }
        }
    };
    for (auto i = draft.definitions_inwards.rbegin(); i != draft.definitions_inwards.rend(); ++i) {
        const DraftDefinition& definition = draft.definitions[*i];
        if (definition.is_read) mark(definition.expression);
    }
    for (const DraftDefinition& definition : draft.definitions) {
        if (definition.is_held || definition.is_read) continue;
        checking.diagnostics.warning(code::unused_name, definition.name.where,
                                     say::definition_unused(checking.shown(definition.name)));
    }
    for (const DraftDuration& duration : draft.durations) {
        if (duration.is_read) continue;
        checking.diagnostics.warning(code::unused_name, duration.name.where,
                                     say::duration_unused(checking.shown(duration.name)));
    }
}

}  // namespace grafwire
