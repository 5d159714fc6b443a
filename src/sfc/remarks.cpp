// A sequential function chart (IEC 61131-3) evolves otherwise than a GRAFCET (IEC 60848): branches
// have priorities, actions run once more after deactivation, there are no forcing orders. The chart
// is gone through construct by construct, and each that the two standards treat differently gives a
// remark; "exact" is said only where nothing but initial steps and the observer is left to remark.

#include "sfc/remarks.h"

#include <algorithm>

#include "grafcet/write_grafcet.h"
#include "sfc/messages.h"

namespace grafwire::sfc {

namespace {

namespace say = messages::sfc;
using Kind = Remark::Kind;

class Remarks {
  public:
    Remarks(const Plan& plan, const Names& names)
        : plan_(plan), grafcet_(*plan.grafcet), names_(names) {}

    std::vector<Remark> make() {
        orders();
        enclosures();
        clearing_actions();
        selections();
        meetings();
        const bool is_exact = remarks_.empty();
        initial_steps();
        if (plan_.has_observer()) add(Kind::observer, say::observer_comes_last(names_.observer));
        remarks_.insert(remarks_.begin(),
                        {Kind::scope, is_exact ? say::exact() : say::almost_exact()});
        return std::move(remarks_);
    }

  private:
    void add(Kind kind, Localized text) { remarks_.push_back({kind, std::move(text)}); }
    std::string name_of(StepId step) const {
        return quoted_where_needed(grafcet_.steps[step].name);
    }
    std::string name_of(GraphId graph) const {
        return quoted_where_needed(grafcet_.graphs[graph].name);
    }
    std::string transition_text(const Transition& transition) const {
        return "(" + quoted_where_needed(transition.name) + ")";
    }
    Localized trigger_text(const Action& action) const;
    void orders();
    void enclosures();
    void clearing_actions();
    void selections();
    void meetings();
    void initial_steps();

    const Plan& plan_;
    const Grafcet& grafcet_;
    const Names& names_;
    std::vector<Remark> remarks_;
};

void Remarks::orders() {
    for (const Order& order : grafcet_.orders) {
        add(Kind::order, say::gives_order(name_of(order.step), write_order(grafcet_, order)));
    }
}

void Remarks::enclosures() {
    for (const Enclosure& enclosure : grafcet_.enclosures) {
        add(Kind::enclosure, say::encloses(name_of(enclosure.step), name_of(enclosure.graph)));
    }
}

void Remarks::clearing_actions() {
    for (const ClearingAction& action : grafcet_.clearing_actions) {
        const Transition& transition = grafcet_.transitions[action.transition];
        add(Kind::clearing,
            say::on_clearing(transition_text(transition), write_write(grafcet_, action.write)));
    }
}

/// Per step, the transitions after it of which two can be cleared at once.
void Remarks::selections() {
    std::vector<std::vector<TransitionId>> after(grafcet_.steps.size());
    for (std::uint32_t t = 0; t < grafcet_.transitions.size(); ++t) {
        for (const StepId step : grafcet_.preceding(grafcet_.transitions[TransitionId{t}])) {
            after[index_of(step)].push_back(TransitionId{t});
        }
    }
    for (std::uint32_t s = 0; s < after.size(); ++s) {
        std::string list;
        for (const TransitionId a : after[s]) {
            const bool meets = std::any_of(after[s].begin(), after[s].end(), [&](TransitionId b) {
                return a != b && !plan_.exclusion.never_both(grafcet_.transitions[a],
                                                             grafcet_.transitions[b]);
            });
            if (!meets) continue;
            list += (list.empty() ? "" : ", ") + transition_text(grafcet_.transitions[a]);
        }
        if (list.empty()) continue;
        add(Kind::selection, say::clears_leftmost(name_of(StepId{s}), list));
    }
}

Localized Remarks::trigger_text(const Action& action) const {
    switch (action.trigger) {
        case Trigger::activation:
            return say::on_activation(name_of(action.step));
        case Trigger::deactivation:
            return say::on_deactivation(name_of(action.step));
        case Trigger::event:
            break;
    }
    return say::on_event(name_of(action.step),
                         write_expression(grafcet_, grafcet_.expressions, action.expression));
}

void Remarks::meetings() {
    for (const Plan::Meeting& meeting : plan_.meetings) {
        Localized triggers;
        for (const std::size_t action : meeting.actions) {
            const Localized trigger = trigger_text(grafcet_.actions[action]);
            triggers = triggers.english.empty() ? trigger : say::and_also(triggers, trigger);
        }
        add(Kind::meeting_writes,
            say::last_write_wins(quoted_where_needed(variable_name(grafcet_, meeting.target)),
                                 triggers));
    }
}

void Remarks::initial_steps() {
    for (std::uint32_t g = 0; g < grafcet_.graphs.size(); ++g) {
        const auto steps = plan_.chart.steps_of(GraphId{g});
        const auto count = std::count_if(steps.begin(), steps.end(),
                                         [&](StepId step) { return plan_.chart.is_initial(step); });
        if (count == 1) continue;
        add(Kind::initial_steps,
            say::initial_step_count(static_cast<std::size_t>(count), name_of(GraphId{g})));
    }
}

}  // namespace

std::vector<Remark> remarks_of(const Plan& plan, const Names& names) {
    return Remarks(plan, names).make();
}

std::vector<Remark> remarks_of(const Grafcet& grafcet) {
    const Plan plan = plan_of(grafcet);
    return remarks_of(plan, names_of(plan));
}

}  // namespace grafwire::sfc
