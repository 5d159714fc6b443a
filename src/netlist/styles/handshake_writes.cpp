// Stored actions as something that a transition does.
//
// A netlist without a clock has no moment at which "step 7 has just become
// active" is true and all can see it. What it has is the transition into step
// 7, which can stop half-way, write, see that it is written, and go on. So an
// action on activation, on deactivation or on clearing is done by each
// transition that brings it about, the last write to a variable counting, in
// the order of the reference: deactivation, clearing, activation. That is all
// there is to it where only transitions activate and deactivate the step: not
// Init, not AUdur, no order, and no token that is there already.

#include "netlist/styles/handshake_writes.h"

#include <algorithm>

#include "netlist/styles/messages.h"

namespace grafwire {

namespace {

using Cause = StoredWrite::Cause;

class Writes {
  public:
    Writes(const Grafcet& grafcet, const Equations& equations, Diagnostics& diagnostics)
        : grafcet_(grafcet),
          equations_(equations),
          diagnostics_(diagnostics),
          transitions_(transitions_by_step(grafcet)),
          result_(grafcet.transitions.size()) {}

    Table<TransitionId, std::map<std::uint32_t, bool>> find() {
        for (std::size_t i = 0; i < equations_.stored.size(); ++i) {
            const StoredEquation& stored = equations_.stored[i];
            if (stored.target.kind == VariableKind::counter) continue;
            // They stand in the order of execution, so that later ones replace
            // earlier ones.
            for (const StoredWrite& write : stored.writes) {
                if (is_refused(stored, write)) continue;
                const bool value = equations_.expressions.constant_value(write.value);
                for (const TransitionId id : causes_of(write)) {
                    result_[id][static_cast<std::uint32_t>(i)] = value;
                }
            }
        }
        return std::move(result_);
    }

  private:
    void refuse(const StoredWrite& write, Localized message) {
        diagnostics_.error(code::unsupported_by_style, write.where, std::move(message));
    }

    bool is_refused(const StoredEquation& stored, const StoredWrite& write) {
        const std::string name = variable_name(grafcet_, stored.target);
        const auto& pool = equations_.expressions;
        if (write.cause == Cause::event) {
            refuse(write, messages::netlist_styles::write_on_event(name));
        } else if (pool.kind(write.value) != ExprKind::constant) {
            refuse(write, messages::netlist_styles::write_of_expression(name));
        } else if (write.cause == Cause::activation && is_activated_otherwise(write.step)) {
            refuse(write, messages::netlist_styles::activated_otherwise(
                              name, grafcet_.steps[write.step].name));
        } else if (write.cause == Cause::deactivation && is_deactivated_otherwise(write.step)) {
            refuse(write, messages::netlist_styles::deactivated_otherwise(
                              name, grafcet_.steps[write.step].name));
        } else {
            return false;
        }
        return true;
    }

    bool is_ordered(StepId step, bool on) const {
        const GraphId graph = grafcet_.steps[step].graph;
        return std::any_of(grafcet_.orders.begin(), grafcet_.orders.end(), [&](const Order& order) {
            if (order.kind == OrderKind::freeze || order.graph != graph) return false;
            if (!on) return true;
            if (order.kind == OrderKind::initial) return grafcet_.steps[step].initial;
            return std::count(order.steps.begin(), order.steps.end(), step) != 0;
        });
    }

    bool is_activated_otherwise(StepId step) const {
        const bool by_init = equations_.options.modes && grafcet_.steps[step].initial;
        return by_init || is_ordered(step, true);
    }

    bool is_deactivated_otherwise(StepId step) const {
        return equations_.options.modes || is_ordered(step, false);
    }

    std::vector<TransitionId> causes_of(const StoredWrite& write) const {
        if (write.cause == Cause::clearing) return {write.transition};
        const bool in = write.cause == Cause::activation;
        std::vector<TransitionId> result;
        const auto all =
            in ? transitions_.into_step(write.step) : transitions_.out_of_step(write.step);
        for (const TransitionId id : all) {
            const Transition& item = grafcet_.transitions[id];
            const auto other = in ? grafcet_.preceding(item) : grafcet_.following(item);
            const bool stays = std::find(other.begin(), other.end(), write.step) != other.end();
            if (!stays) result.push_back(id);
        }
        return result;
    }

    const Grafcet& grafcet_;
    const Equations& equations_;
    Diagnostics& diagnostics_;
    StepTransitions transitions_;
    Table<TransitionId, std::map<std::uint32_t, bool>> result_;
};

}  // namespace

Table<TransitionId, std::map<std::uint32_t, bool>> writes_of_transitions(const Grafcet& grafcet,
                                                                         const Equations& equations,
                                                                         Diagnostics& diagnostics) {
    return Writes(grafcet, equations, diagnostics).find();
}

}  // namespace grafwire
