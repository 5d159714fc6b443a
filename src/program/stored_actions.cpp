// Stored actions (the end of SBR 5).
//
// The reference reads all right-hand sides and events first and writes afterwards, in the order
// deactivation, clearing, activation, event. A program that writes as it goes gives the same result
// wherever an action reads nothing that an earlier one writes; only where it does, what it reads is
// first worked out into scratch bits and integers. So the common program has none.

#include <algorithm>
#include <set>

#include "grafcet/write_grafcet.h"
#include "program/messages.h"
#include "program/program_parts.h"

namespace grafwire {

namespace {

namespace say = messages::program;

/// What an action writes, and the step or transition that it belongs to.
using WhenWritten = Message<std::string, std::string>;

/// One stored action on its way into the program.
struct StoredAction {
    Variable target;
    Condition trigger;
    Condition value;           ///< of a bit
    const Sum* sum = nullptr;  ///< of a counter
    IntegerCell source;        ///< of a counter whose sum was worked out beforehand
    Localized comment;
    Location where;
};

Bit bit_of(Variable target) {
    return {target.kind == VariableKind::output ? BitKind::output : BitKind::var, target.index};
}

void list_reads(const Sum& sum, std::set<Variable>& variables) {
    for (const SumTerm& term : sum) {
        if (term.counter != SumTerm::no_counter) {
            variables.insert({VariableKind::counter, term.counter});
        }
    }
}

void list_reads(const Condition& condition, std::set<Variable>& variables) {
    if (condition.kind == Condition::Kind::bit) {
        const Bit bit = condition.bit;
        if (bit.kind == BitKind::output) variables.insert({VariableKind::output, bit.index});
        if (bit.kind == BitKind::var) variables.insert({VariableKind::var, bit.index});
    }
    if (condition.kind == Condition::Kind::comparison) {
        list_reads(condition.comparison.left, variables);
        list_reads(condition.comparison.right, variables);
    }
    for (const Condition& operand : condition.operands) list_reads(operand, variables);
}

bool overlap(const Condition& condition, const std::set<Variable>& written) {
    std::set<Variable> read;
    list_reads(condition, read);
    return std::any_of(read.begin(), read.end(), [&](Variable v) { return written.count(v) > 0; });
}

bool overlap(const Sum& sum, const std::set<Variable>& written) {
    std::set<Variable> read;
    list_reads(sum, read);
    return std::any_of(read.begin(), read.end(), [&](Variable v) { return written.count(v) > 0; });
}

class StoredActions {
  public:
    StoredActions(const Grafcet& grafcet, const ChartConditions& conditions, ScanProgram& program)
        : grafcet_(grafcet),
          conditions_(conditions),
          program_(program),
          section_(program, SectionKind::stored) {}

    void add() {
        std::vector<StoredAction> actions = in_order();
        read_before_writing(actions);
        for (const StoredAction& action : actions) write(action);
    }

  private:
    std::vector<StoredAction> in_order() const;
    Condition trigger_of(const Action& action) const;
    Condition clearing_of(TransitionId transition) const;
    void read_before_writing(std::vector<StoredAction>& actions);
    void write(const StoredAction& action);

    const Grafcet& grafcet_;
    const ChartConditions& conditions_;
    ScanProgram& program_;
    SectionWriter section_;
};

/// Cleared: all preceding steps active when the scan began, the transition condition 1, and Init 0.
Condition StoredActions::clearing_of(TransitionId transition) const {
    std::vector<Condition> parts;
    for (const StepId step : grafcet_.preceding(grafcet_.transitions[transition])) {
        parts.push_back(bit_condition(step_bit(BitKind::previous, step)));
    }
    parts.push_back(
        bit_condition({BitKind::transition, static_cast<std::uint32_t>(index_of(transition))}));
    parts.push_back(conditions_.not_control(ControlInput::init));
    return and_condition(std::move(parts));
}

Condition StoredActions::trigger_of(const Action& action) const {
    std::vector<Condition> parts;
    switch (action.trigger) {
        case Trigger::activation:
            return bit_condition(step_bit(BitKind::pulse, action.step));
        case Trigger::deactivation:
            parts.push_back(bit_condition(step_bit(BitKind::previous, action.step)));
            parts.push_back(not_condition(bit_condition(step_bit(BitKind::step, action.step))));
            break;
        case Trigger::event:
            parts.push_back(bit_condition(step_bit(BitKind::step, action.step)));
            parts.push_back(conditions_.of(action.expression));
            break;
    }
    return and_condition(std::move(parts));
}

std::vector<StoredAction> StoredActions::in_order() const {
    std::vector<StoredAction> actions;
    const auto add_write = [&](const Write& write, Condition trigger, const WhenWritten& comment,
                               const std::string& of, Location where) {
        if (trigger.is_constant(false)) return;
        StoredAction action;
        action.target = write.target;
        action.trigger = std::move(trigger);
        if (write.operation == WriteOperation::assign) {
            if (write.target.kind == VariableKind::counter) {
                action.sum = &grafcet_.sums[write.sum];
            } else {
                action.value = conditions_.of(write.value);
            }
        } else {
            action.value = constant_condition(write.operation == WriteOperation::set);
        }
        action.comment = comment(quoted_where_needed(variable_name(grafcet_, write.target)), of);
        action.where = where;
        actions.push_back(std::move(action));
    };
    const auto add_triggered = [&](Trigger trigger, const WhenWritten& comment) {
        for (const Action& action : grafcet_.actions) {
            if (action.kind != ActionKind::stored || action.trigger != trigger) continue;
            add_write(action.write, trigger_of(action), comment,
                      quoted_where_needed(grafcet_.steps[action.step].name), action.where);
        }
    };
    add_triggered(Trigger::deactivation, say::on_deactivation);
    for (const ClearingAction& action : grafcet_.clearing_actions) {
        add_write(action.write, clearing_of(action.transition), say::on_clearing,
                  transition_text(grafcet_, action.transition), action.where);
    }
    add_triggered(Trigger::activation, say::on_activation);
    add_triggered(Trigger::event, say::on_event);
    return actions;
}

/// Works out beforehand what would be changed by an earlier action before it is read. A bit written
/// with a value that reads the bit itself is one of them, for it is written by a set and a reset.
void StoredActions::read_before_writing(std::vector<StoredAction>& actions) {
    std::set<Variable> written;
    for (StoredAction& action : actions) {
        if (overlap(action.trigger, written)) {
            const Bit scratch = new_scratch(program_);
            section_.assign(scratch, std::move(action.trigger), say::event_of(action.comment),
                            action.where);
            action.trigger = bit_condition(scratch);
        }
        if (action.sum != nullptr) {
            if (overlap(*action.sum, written)) {
                const Counter& counter = grafcet_.counters[CounterId{action.target.index}];
                action.source = {true, program_.scratch_integers++};
                Statement& statement = section_.add(Statement::Kind::move,
                                                    say::value_of(action.comment), action.where);
                statement.condition = constant_condition(true);
                statement.integer = action.source;
                statement.sum = *action.sum;
                statement.low = counter.low;
                statement.high = counter.high;
            }
            written.insert(action.target);
            continue;
        }
        std::set<Variable> with_itself = written;
        with_itself.insert(action.target);
        if (overlap(action.value, with_itself)) {
            const Bit scratch = new_scratch(program_);
            section_.assign(scratch, std::move(action.value), say::value_of(action.comment),
                            action.where);
            action.value = bit_condition(scratch);
        }
        // A trigger that reads the target would be read twice, the second time after a write.
        if (!action.value.is_constant(true) && !action.value.is_constant(false) &&
            overlap(action.trigger, {action.target})) {
            const Bit scratch = new_scratch(program_);
            section_.assign(scratch, std::move(action.trigger), say::event_of(action.comment),
                            action.where);
            action.trigger = bit_condition(scratch);
        }
        written.insert(action.target);
    }
}

void StoredActions::write(const StoredAction& action) {
    if (action.target.kind == VariableKind::counter) {
        const Counter& counter = grafcet_.counters[CounterId{action.target.index}];
        Statement& statement = section_.add(Statement::Kind::move, action.comment, action.where);
        statement.condition = action.trigger;
        statement.integer = {false, action.target.index};
        if (action.source.is_scratch) {
            statement.source = action.source;
        } else {
            statement.sum = *action.sum;
        }
        statement.low = counter.low;
        statement.high = counter.high;
        return;
    }
    const Bit target = bit_of(action.target);
    section_.set({target}, and_condition({action.trigger, action.value}), action.comment,
                 action.where);
    section_.reset({target}, and_condition({action.trigger, not_condition(action.value)}),
                   action.comment, action.where);
}

}  // namespace

void add_stored_actions(const Grafcet& grafcet, const ChartConditions& conditions,
                        ScanProgram& program) {
    StoredActions(grafcet, conditions, program).add();
}

}  // namespace grafwire
