// Sentences are those of the catalogue; here is which of them are said, and in which order: that of
// the scan itself. What goes without saying is left out: values of a condition that is one operand,
// an order that changes nothing, and, in the middle of an instant, transitions that wait at its end
// as well.

#include "story/write_story.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "grafcet/shown_transition.h"
#include "grafcet/write_grafcet.h"
#include "story/messages.h"
#include "text/joined.h"

namespace grafwire {

namespace {

namespace words = messages::story;

class StoryWriter {
  public:
    StoryWriter(const Grafcet& grafcet, Language language)
        : grafcet_(grafcet), language_(language) {}

    void tell(const InstantStory& story);
    void tell_outcome(const InstantStory& story);
    std::string take() { return std::move(text_); }

  private:
    // An instant.
    void tell_beginning(const InstantStory& story);
    void tell_end(const InstantStory& story);
    void tell_waiting(const EnabledTransition& enabled, const InstantStory& story);
    void tell_values(const InstantStory& story);

    // A scan.
    void tell_scan(const ScanStory& scan, const InstantStory& story);
    void tell_clearing(const ScanStory& scan, const InstantStory& story);
    void tell_orders(const ScanStory& scan);
    void tell_enclosures(const ScanStory& scan);
    void tell_writes(const ScanStory& scan);
    void tell_times(const ScanStory& scan);

    // Names.
    std::string step(StepId id) const { return "X" + grafcet_.steps[id].name; }
    std::string graph(GraphId id) const { return grafcet_.graphs[id].name; }
    std::string expression(ExprId id) const {
        return write_expression(grafcet_, grafcet_.expressions, id);
    }
    std::string transition(TransitionId id) const { return shown_transition(grafcet_, id); }
    std::string condition(const EnabledTransition& enabled) const;
    /// ` (start=1 top=1)`; nothing where the condition is a single operand.
    std::string values(const EnabledTransition& enabled) const;
    std::string situation(const BitTable& table) const;
    /// Which steps change, of all or of those of one graph.
    std::string changed_steps(const BitTable& before, const BitTable& after) const {
        return changed_steps(before, after, {0, static_cast<std::uint32_t>(grafcet_.steps.size())});
    }
    std::string changed_steps(const BitTable& before, const BitTable& after,
                              Range<StepId> among) const;
    static std::string list(const std::vector<std::string>& names) { return joined(names, ", "); }

    template <class... Arguments>
    void say(const Message<Arguments...>& message,
             const std::type_identity_t<Arguments>&... arguments) {
        text_.append(indent_, ' ') += message.in(language_, arguments...);
    }
    template <class... Arguments>
    std::string word(const Message<Arguments...>& message,
                     const std::type_identity_t<Arguments>&... arguments) const {
        return message.in(language_, arguments...);
    }

    const Grafcet& grafcet_;
    Language language_;
    std::size_t indent_ = 0;
    std::string text_;
};

std::string StoryWriter::condition(const EnabledTransition& enabled) const {
    const ExprId id = grafcet_.transitions[enabled.transition].condition;
    if (grafcet_.expressions.kind(id) == ExprKind::constant) return word(words::always_true);
    return expression(id);
}

std::string StoryWriter::values(const EnabledTransition& enabled) const {
    const std::vector<OperandValue>& operands = enabled.operands;
    if (operands.empty()) return {};
    if (operands.size() == 1 && operands[0].due == never &&
        operands[0].name == condition(enabled)) {
        return {};
    }
    std::vector<std::string> texts;
    for (const OperandValue& operand : operands) {
        texts.push_back(operand.due == never
                            ? fmt::format("{}={}", operand.name, operand.value)
                            : word(words::running_operand, operand.name, operand.value,
                                   format_milliseconds(operand.due)));
    }
    return fmt::format(" ({})", joined(texts, " "));
}

std::string StoryWriter::situation(const BitTable& table) const {
    std::vector<std::string> active;
    for_each_bit(table, [&](std::size_t i) { active.push_back(step(grafcet_.steps.id_at(i))); });
    return active.empty() ? word(words::no_step) : list(active);
}

std::string StoryWriter::changed_steps(const BitTable& before, const BitTable& after,
                                       Range<StepId> among) const {
    std::vector<std::string> down;
    std::vector<std::string> up;
    for (const StepId id : among) {
        const bool was = before.test(index_of(id));
        const bool is = after.test(index_of(id));
        if (was && !is) down.push_back(step(id));
        if (!was && is) up.push_back(step(id));
    }
    std::vector<std::string> parts;
    if (!down.empty()) parts.push_back(word(words::deactivated, list(down)));
    if (!up.empty()) parts.push_back(word(words::activated, list(up)));
    if (parts.empty()) return word(words::no_step_changes);
    return joined(parts, word(words::separator));
}

void StoryWriter::tell_beginning(const InstantStory& story) {
    std::vector<std::string> changes;
    for (const Stimuli::Assignment& set : story.inputs) {
        changes.push_back(fmt::format("{}={}", quoted_where_needed(input_name(grafcet_, set.input)),
                                      set.value ? 1 : 0));
    }
    std::vector<std::string> parts;
    if (!changes.empty()) parts.push_back(joined(changes, " "));
    for (const TimeConditionChange& ended : story.ended) {
        parts.push_back(word(words::delay_is_over, expression(ended.condition)));
    }
    if (parts.empty()) {
        parts.push_back(word(story.is_quiet   ? words::nothing_changes
                             : story.is_first ? words::all_inputs_0
                                              : words::no_input_changes));
    }
    say(words::at, format_milliseconds(story.at), joined(parts, word(words::separator)));
}

void StoryWriter::tell(const InstantStory& story) {
    if (story.repeated > 0) {
        say(words::nothing_changes_until, format_milliseconds(story.at),
            format_milliseconds(story.last), story.repeated + 1);
        return;
    }
    tell_beginning(story);
    if (story.is_quiet) return;
    indent_ = 2;
    if (story.is_first) {
        BitTable initial(grafcet_.steps.size());
        for (std::size_t i = 0; i < initial.size(); ++i) {
            initial.assign(i, grafcet_.steps[grafcet_.steps.id_at(i)].initial);
        }
        say(words::rule_1, situation(initial));
    }
    const bool is_numbered = story.scans.size() > 1;
    for (std::size_t i = 0; i < story.scans.size(); ++i) {
        if (is_numbered) say(words::evolution_number, i + 1);
        indent_ = is_numbered ? 4 : 2;
        tell_scan(story.scans[i], story);
        indent_ = 2;
    }
    if (story.untold > 0) {
        text_.append(indent_, ' ') += words::untold.in(language_, story.untold);
    }
    tell_outcome(story);
    indent_ = 0;
}

void StoryWriter::tell_scan(const ScanStory& scan, const InstantStory& story) {
    if (scan.init) {
        if (scan.before != scan.record.after_clearing) {
            say(words::init_sets, changed_steps(scan.before, scan.record.after_clearing));
        }
    } else {
        tell_clearing(scan, story);
    }
    tell_orders(scan);
    if (scan.au_dur) {
        if (scan.before != scan.situation) {
            say(words::au_dur_empties, changed_steps(scan.before, scan.situation));
        }
    } else {
        tell_enclosures(scan);
    }
    tell_writes(scan);
    tell_times(scan);
}

void StoryWriter::tell_clearing(const ScanStory& scan, const InstantStory& story) {
    const std::vector<TransitionId>& cleared = scan.record.cleared;
    for (const EnabledTransition& enabled : scan.enabled) {
        const TransitionId id = enabled.transition;
        if (std::binary_search(cleared.begin(), cleared.end(), id)) {
            const auto preceding = grafcet_.preceding(grafcet_.transitions[id]);
            std::vector<std::string> steps;
            for (const StepId before : preceding) steps.push_back(step(before));
            say(steps.empty()       ? words::cleared_by_none
                : steps.size() == 1 ? words::cleared_by_one
                                    : words::cleared_by_many,
                transition(id), list(steps), condition(enabled), values(enabled));
            continue;
        }
        const bool waits_at_end =
            std::any_of(story.enabled.begin(), story.enabled.end(),
                        [&](const EnabledTransition& other) { return other.transition == id; });
        if (waits_at_end && story.is_stable) continue;
        if (enabled.is_frozen) {
            say(words::not_cleared_frozen, transition(id), graph(grafcet_.transitions[id].graph));
        } else {
            say(words::not_cleared, transition(id), condition(enabled), values(enabled));
        }
    }
    if (cleared.empty()) return;
    if (cleared.size() > 1) {
        std::vector<std::string> names;
        for (const TransitionId id : cleared) {
            names.push_back(fmt::format("({})", grafcet_.transitions[id].name));
        }
        say(words::cleared_together, list(names));
    }
    if (scan.before != scan.record.after_clearing) {
        say(words::rule_3, changed_steps(scan.before, scan.record.after_clearing));
    }
    std::vector<std::string> kept;
    for (const StepId id : scan.kept) kept.push_back(step(id));
    if (!kept.empty()) say(words::rule_5, list(kept));
}

/// Those that are new, and those that change something.
void StoryWriter::tell_orders(const ScanStory& scan) {
    const ScanRecord& record = scan.record;
    for (const OrderId id : record.orders) {
        const Order& order = grafcet_.orders[id];
        const bool is_new = !scan.before.test(index_of(order.step));
        const Range<StepId> steps = grafcet_.graphs[order.graph].steps;
        if (order.kind == OrderKind::freeze) {
            if (is_new) say(words::freezes, step(order.step), graph(order.graph));
            continue;
        }
        const std::string changes =
            changed_steps(record.after_clearing, record.after_forcing, steps);
        if (is_new || changes != word(words::no_step_changes)) {
            say(words::forces, step(order.step), write_order(grafcet_, order), changes);
        }
    }
}

void StoryWriter::tell_enclosures(const ScanStory& scan) {
    const ScanRecord& record = scan.record;
    for (std::size_t i = 0; i < grafcet_.enclosures.size(); ++i) {
        const EnclosureId id = grafcet_.enclosures.id_at(i);
        const Enclosure& enclosure = grafcet_.enclosures[id];
        const std::string changes = changed_steps(record.after_forcing, scan.situation,
                                                  grafcet_.graphs[enclosure.graph].steps);
        if (changes == word(words::no_step_changes)) continue;
        const bool is_opened =
            std::find(record.opened.begin(), record.opened.end(), id) != record.opened.end();
        say(is_opened ? words::opens : words::empties, step(enclosure.step), graph(enclosure.graph),
            changes);
    }
}

void StoryWriter::tell_writes(const ScanStory& scan) {
    for (const ScanRecord::StoredWrite& run : scan.record.writes) {
        const auto tell_write = [&](const auto& message, const std::string& whose,
                                    const Write& write) {
            say(message, whose, write_write(grafcet_, write),
                fmt::format("{}={}", variable_name(grafcet_, write.target), run.value));
        };
        if (run.on_clearing) {
            const ClearingAction& action = grafcet_.clearing_actions[run.action];
            const std::string& name = grafcet_.transitions[action.transition].name;
            tell_write(words::on_clearing, fmt::format("({})", name), action.write);
            continue;
        }
        const Action& action = grafcet_.actions[run.action];
        tell_write(action.trigger == Trigger::activation     ? words::on_activation
                   : action.trigger == Trigger::deactivation ? words::on_deactivation
                                                             : words::on_event,
                   step(action.step), action.write);
    }
}

void StoryWriter::tell_times(const ScanStory& scan) {
    using Kind = TimeConditionChange::Kind;
    for (const TimeConditionChange& change : scan.times) {
        const std::string name = expression(change.condition);
        switch (change.kind) {
            case Kind::becomes_1:
                say(words::becomes_1, name);
                break;
            case Kind::becomes_0:
                say(words::becomes_0, name);
                break;
            case Kind::delay_begins:
                say(words::delay_begins, name, format_milliseconds(change.due));
                break;
            case Kind::delay_is_dropped:
                say(words::delay_is_dropped, name);
                break;
        }
    }
}

void StoryWriter::tell_outcome(const InstantStory& story) {
    indent_ = 2;
    if (story.is_stable) {
        tell_end(story);
    } else {
        say(words::unstable, list(story.changing));
    }
}

void StoryWriter::tell_end(const InstantStory& story) {
    say(story.by_scans ? words::situation : words::stable_situation, situation(story.situation));
    tell_values(story);
    if (story.enabled.empty()) say(words::none_enabled);
    for (const EnabledTransition& enabled : story.enabled) tell_waiting(enabled, story);
}

void StoryWriter::tell_values(const InstantStory& story) {
    std::vector<std::string> names;
    if (!grafcet_.outputs.empty()) {
        for_each_bit(story.outputs, [&](std::size_t i) {
            names.push_back(grafcet_.outputs[grafcet_.outputs.id_at(i)].name);
        });
        say(words::outputs, names.empty() ? word(words::no_output) : list(names));
    }
    if (story.au_doux) say(words::outputs_off);
    if (!grafcet_.vars.empty()) {
        names.clear();
        for_each_bit(story.vars, [&](std::size_t i) {
            names.push_back(grafcet_.vars[grafcet_.vars.id_at(i)].name);
        });
        say(words::vars, names.empty() ? word(words::no_var) : list(names));
    }
    if (!grafcet_.counters.empty()) {
        names.clear();
        for (std::size_t i = 0; i < story.counters.size(); ++i) {
            names.push_back(fmt::format("{}={}", grafcet_.counters[grafcet_.counters.id_at(i)].name,
                                        story.counters[i]));
        }
        say(words::counters, list(names));
    }
    if (!story.orders.empty()) {
        names.clear();
        for (const OrderId id : story.orders) {
            const Order& order = grafcet_.orders[id];
            names.push_back(fmt::format("{} ({})", write_order(grafcet_, order), step(order.step)));
        }
        say(words::orders, list(names));
    }
}

void StoryWriter::tell_waiting(const EnabledTransition& enabled, const InstantStory& story) {
    const TransitionId id = enabled.transition;
    if (story.init) {
        say(words::waits_init, transition(id));
    } else if (enabled.is_frozen) {
        say(words::waits_frozen, transition(id), graph(grafcet_.transitions[id].graph));
    } else if (enabled.condition) {
        say(story.by_scans ? words::clearable : words::clearable_idly, transition(id),
            condition(enabled), values(enabled));
    } else {
        say(words::waits, transition(id), condition(enabled), values(enabled));
    }
}

}  // namespace

std::string write_story(const Grafcet& grafcet, const InstantStory& story, Language language) {
    StoryWriter writer(grafcet, language);
    writer.tell(story);
    return writer.take();
}

std::string write_stories(const Grafcet& grafcet, const std::vector<InstantStory>& stories,
                          Language language) {
    std::string text;
    for (const InstantStory& story : stories) {
        if (!text.empty()) text += '\n';
        text += write_story(grafcet, story, language);
    }
    return text;
}

std::string write_end(const Grafcet& grafcet, const InstantStory& story, Language language) {
    StoryWriter writer(grafcet, language);
    writer.tell_outcome(story);
    return writer.take();
}

}  // namespace grafwire
