#include "sfc/remarks.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/write_grafcet.h"

namespace grafwire::sfc {

namespace {

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
        if (plan_.has_observer()) {
            const std::string text = fmt::format(
                "The action of step {} is to be executed after all others of the scan, as it "
                "stands in this file: it prepares edges and time conditions for the next scan and "
                "assigns outputs.",
                names_.observer);
            add(Kind::observer, text);
        }
        std::string scope =
            "The ladder diagram is the whole GRAFCET. This chart does without Init, AUdur and "
            "AUdoux; otherwise it is the GRAFCET, scan for scan";
        scope += is_exact ? "." : ", but for what SFC cannot say:";
        remarks_.insert(remarks_.begin(), {Kind::scope, std::move(scope)});
        return std::move(remarks_);
    }

  private:
    void add(Kind kind, std::string text) { remarks_.push_back({kind, std::move(text)}); }
    std::string step_text(StepId step) const {
        return "step " + quoted_where_needed(grafcet_.steps[step].name);
    }
    std::string graph_text(GraphId graph) const {
        return quoted_where_needed(grafcet_.graphs[graph].name);
    }
    std::string transition_text(const Transition& transition) const {
        return "(" + quoted_where_needed(transition.name) + ")";
    }
    std::string trigger_text(const Action& action) const;
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
        add(Kind::order,
            step_text(order.step) + " gives the order " + write_order(grafcet_, order));
    }
}

void Remarks::enclosures() {
    for (const Enclosure& enclosure : grafcet_.enclosures) {
        add(Kind::enclosure,
            step_text(enclosure.step) + " encloses " + graph_text(enclosure.graph));
    }
}

void Remarks::clearing_actions() {
    for (const ClearingAction& action : grafcet_.clearing_actions) {
        const Transition& transition = grafcet_.transitions[action.transition];
        add(Kind::clearing,
            fmt::format("transition {}: {} on clearing", transition_text(transition),
                        write_write(grafcet_, action.write)));
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
        add(Kind::selection,
            fmt::format("{}: where several of the transitions {} can be cleared at once, a GRAFCET "
                        "clears them all (rule 4), SFC the leftmost",
                        step_text(StepId{s}), list));
    }
}

std::string Remarks::trigger_text(const Action& action) const {
    switch (action.trigger) {
        case Trigger::activation:
            return step_text(action.step) + " on activation";
        case Trigger::deactivation:
            return step_text(action.step) + " on deactivation";
        case Trigger::event:
            break;
    }
    return step_text(action.step) + " on " +
           write_expression(grafcet_, grafcet_.expressions, action.expression);
}

void Remarks::meetings() {
    for (const Plan::Meeting& meeting : plan_.meetings) {
        std::string list;
        for (const std::size_t action : meeting.actions) {
            list += (list.empty() ? "" : "; ") + trigger_text(grafcet_.actions[action]);
        }
        add(Kind::meeting_writes,
            fmt::format("{} can be written by several actions in one scan ({}): the last one wins, "
                        "and SFC leaves their order open",
                        quoted_where_needed(variable_name(grafcet_, meeting.target)), list));
    }
}

void Remarks::initial_steps() {
    for (std::uint32_t g = 0; g < grafcet_.graphs.size(); ++g) {
        const auto steps = plan_.chart.steps_of(GraphId{g});
        const auto count = std::count_if(steps.begin(), steps.end(),
                                         [&](StepId step) { return plan_.chart.is_initial(step); });
        if (count == 1) continue;
        add(Kind::initial_steps,
            fmt::format("graph {} has {} initial steps here; many tools ask for exactly one",
                        graph_text(GraphId{g}), count));
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
