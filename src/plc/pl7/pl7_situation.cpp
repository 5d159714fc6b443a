// Forcing orders and enclosures: the situation is worked out beforehand and preset.
//
// Steps may be set and reset in the preliminary processing alone, before the chart evolves, and
// SY23 makes the controller take them as they are then and not evolve in that scan (Schneider, "PL7
// Micro/Junior/Pro, Reference manual", 35015365, "Description of preliminary processing", whose
// bits %S21 to %S24 descend from SY21 to SY24). So where a chart has orders, the scan is worked out
// by the table method, SBR 4 and 5, on internal bits that stand for the steps. Where the orders
// change nothing, which is most scans of a machine in production, SY23 stays 0 and the chart
// evolves by itself, as its animation on the terminal shows it.
//
// One bit a step is enough. Ta and Td are written out, there being one formula for each step; Tf1
// and Tf0 vanish, for the graphs are forced from the lowest of the hierarchy upwards, each after
// all those that its own steps give orders to, so that every order is read as SBR 4 left it.

#include "plc/pl7/pl7_situation.h"

#include <algorithm>
#include <utility>

#include "grafcet/grafcet.h"
#include "grafcet/write_grafcet.h"
#include "plc/pl7/messages.h"

namespace grafwire {

namespace {

namespace say = messages::plc_pl7;

/// The bit that says whether a step is active once the scan is over: what is Ta of the method, the
/// steps to be activated, is all the steps that are to be active here.
Bit to_be_active(std::uint32_t step) {
    return {BitKind::activate, step};
}

Condition step_is_to_be_active(std::uint32_t step) {
    return bit_condition(to_be_active(step));
}

Condition control(ControlInput input) {
    return bit_condition({BitKind::control, static_cast<std::uint32_t>(input)});
}

/// A condition of SBR 5 in its terms: Ts is being worked out, and the steps themselves are still
/// Tp.
Condition worked_out(const Condition& condition) {
    Condition result = condition;
    if (condition.kind == Condition::Kind::bit) {
        if (condition.bit.kind == BitKind::step) result.bit = to_be_active(condition.bit.index);
        if (condition.bit.kind == BitKind::previous) result.bit.kind = BitKind::step;
    }
    for (Condition& operand : result.operands) operand = worked_out(operand);
    return result;
}

/// Graphs with the deepest in the hierarchy of forcing orders first.
std::vector<GraphId> graphs_upwards(const Grafcet& grafcet) {
    const std::vector<std::size_t> depth = forcing_depths(grafcet);
    std::vector<GraphId> graphs;
    for (std::uint32_t g = 0; g < depth.size(); ++g) graphs.push_back(GraphId{g});
    std::stable_sort(graphs.begin(), graphs.end(),
                     [&](GraphId a, GraphId b) { return depth[index_of(a)] > depth[index_of(b)]; });
    return graphs;
}

class Situation {
  public:
    Situation(const Grafcet& grafcet, const ScanProgram& program, Language language,
              Pl7Objects& objects, Pl7Rungs& rungs)
        : grafcet_(grafcet),
          program_(program),
          language_(language),
          objects_(objects),
          rungs_(rungs) {}

    void evolve(const std::vector<Condition>& conditions);
    void obey_orders();

  private:
    Condition cleared(const Transition& transition, const Condition& condition,
                      const StepId* but_step) const;
    Condition with_init(std::uint32_t step, Condition evolved) const;
    void obey(const Statement& statement);
    static Condition any_changed(const std::vector<Bit>& steps, bool sets);
    void force(const Graph& graph);
    void note_change(const Condition& condition);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Language language_;
    Pl7Objects& objects_;
    Pl7Rungs& rungs_;
    /// Per step: where one of these is 1, Tf1 or Tf0 is.
    std::vector<std::vector<Condition>> forced_on_, forced_off_;
    bool has_noted_ = false;
};

/// Its preceding steps, perhaps all but one, are active and its transition condition is 1.
Condition Situation::cleared(const Transition& transition, const Condition& condition,
                             const StepId* but_step) const {
    std::vector<Condition> parts;
    for (const StepId step : grafcet_.preceding(transition)) {
        if (but_step != nullptr && step == *but_step) continue;
        parts.push_back(bit_condition({BitKind::step, static_cast<std::uint32_t>(index_of(step))}));
    }
    parts.push_back(condition);
    return and_condition(std::move(parts));
}

/// SBR 4: X . /Td + Ta, and Init.
void Situation::evolve(const std::vector<Condition>& conditions) {
    const std::size_t steps = grafcet_.steps.size();
    std::vector<std::vector<Condition>> out_of(steps);
    std::vector<std::vector<Condition>> into(steps);
    for (std::size_t t = 0; t < conditions.size(); ++t) {
        const Transition& transition = grafcet_.transitions[grafcet_.transitions.id_at(t)];
        for (const StepId step : grafcet_.preceding(transition)) {
            out_of[index_of(step)].push_back(cleared(transition, conditions[t], &step));
        }
        for (const StepId step : grafcet_.following(transition)) {
            into[index_of(step)].push_back(cleared(transition, conditions[t], nullptr));
        }
    }
    for (std::uint32_t s = 0; s < steps; ++s) {
        std::vector<Condition> stays;
        stays.push_back(bit_condition({BitKind::step, s}));
        stays.push_back(not_condition(or_condition(std::move(out_of[s]))));
        std::vector<Condition>& causes = into[s];
        causes.insert(causes.begin(), and_condition(std::move(stays)));
        rungs_.label(say::step_to_be_active.in(
            language_, quoted_where_needed(grafcet_.steps[StepId{s}].name)));
        rungs_.rung(with_init(s, or_condition(std::move(causes))),
                    "( ) " + objects_.of(to_be_active(s)));
    }
}

Condition Situation::with_init(std::uint32_t step, Condition evolved) const {
    if (!program_.has_modes) return evolved;
    const Condition init = control(ControlInput::init);
    if (grafcet_.steps[StepId{step}].initial) return or_condition({init, std::move(evolved)});
    return and_condition({not_condition(init), std::move(evolved)});
}

/// SBR 5.
void Situation::obey_orders() {
    forced_on_.resize(grafcet_.steps.size());
    forced_off_.resize(grafcet_.steps.size());
    for (const Statement& statement : program_.section(SectionKind::orders)) {
        if (statement.kind != Statement::Kind::table) {
            obey(statement);
        } else if (statement.operation == TableOperation::force) {
            for (const GraphId graph : graphs_upwards(grafcet_)) force(grafcet_.graphs[graph]);
        }
    }
}

/// An enclosure, AUdur, a bit that says whether an order applies to a graph; forcing orders are
/// kept until all are known. AUdur has the steps preset in any case, which is shorter than to look
/// whether any is active.
void Situation::obey(const Statement& statement) {
    const Condition condition = worked_out(statement.condition);
    const BitKind kind = statement.targets.front().kind;
    if (kind == BitKind::forced_on || kind == BitKind::forced_off) {
        for (const Bit bit : statement.targets) {
            (bit.kind == BitKind::forced_on ? forced_on_ : forced_off_)[bit.index].push_back(
                condition);
        }
        return;
    }
    rungs_.label(statement.comment.in(language_));
    if (kind != BitKind::step) {
        return rungs_.rung(condition, "( ) " + objects_.of(statement.targets.front()));
    }
    const bool sets = statement.kind == Statement::Kind::set;
    note_change(statement.condition == control(ControlInput::au_dur)
                    ? condition
                    : and_condition({condition, any_changed(statement.targets, sets)}));
    for (const Bit bit : statement.targets) {
        rungs_.rung(condition, (sets ? "(S) " : "(R) ") + objects_.of(to_be_active(bit.index)));
    }
}

/// Whether setting or resetting steps makes a difference.
Condition Situation::any_changed(const std::vector<Bit>& steps, bool sets) {
    std::vector<Condition> changes;
    for (const Bit step : steps) {
        const Condition active = step_is_to_be_active(step.index);
        changes.push_back(sets ? not_condition(active) : active);
    }
    return or_condition(std::move(changes));
}

/// Ts . /Tf0 + Tf1. Every order on a graph has all its steps in Tf0.
void Situation::force(const Graph& graph) {
    if (graph.steps.count == 0 || forced_off_[graph.steps.first].empty()) return;
    const Condition forced = or_condition(forced_off_[graph.steps.first]);
    std::vector<Condition> deactivated;
    std::vector<Condition> changes;
    for (std::uint32_t s = graph.steps.first; s < graph.steps.first + graph.steps.count; ++s) {
        const Condition on = or_condition(forced_on_[s]);
        deactivated.push_back(and_condition({step_is_to_be_active(s), not_condition(on)}));
        changes.push_back(and_condition({on, not_condition(step_is_to_be_active(s))}));
    }
    changes.insert(changes.begin(), and_condition({forced, or_condition(std::move(deactivated))}));
    rungs_.label(say::forcing_orders.in(language_, quoted_where_needed(graph.name)));
    note_change(or_condition(std::move(changes)));
    for (std::uint32_t s = graph.steps.first; s < graph.steps.first + graph.steps.count; ++s) {
        const Condition stays = and_condition({step_is_to_be_active(s), not_condition(forced)});
        rungs_.rung(or_condition({stays, or_condition(forced_on_[s])}),
                    "( ) " + objects_.of(to_be_active(s)));
    }
}

/// SY23 is 1 once anything has been changed.
void Situation::note_change(const Condition& condition) {
    rungs_.rung(condition, has_noted_ ? "(S) SY23" : "( ) SY23");
    has_noted_ = true;
}

}  // namespace

bool has_orders(const Grafcet& grafcet) {
    return !grafcet.enclosures.empty() ||
           std::any_of(grafcet.orders.begin(), grafcet.orders.end(),
                       [](const Order& order) { return order.kind != OrderKind::freeze; });
}

void write_situation(const Grafcet& grafcet, const ScanProgram& program,
                     const std::vector<Condition>& conditions, Language language,
                     Pl7Objects& objects, Pl7Rungs& rungs) {
    Situation situation(grafcet, program, language, objects, rungs);
    situation.evolve(conditions);
    situation.obey_orders();
}

void write_presets(const Grafcet& grafcet, Language language, Pl7Objects& objects,
                   Pl7Rungs& rungs) {
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        const std::string bit = objects.of(to_be_active(s));
        const std::string step = objects.of(Bit{BitKind::step, s});
        rungs.label(
            say::presetting_of.in(language, quoted_where_needed(grafcet.steps[StepId{s}].name)));
        rungs.line("SY23 . " + bit, "(S) " + step);
        rungs.line("SY23 . /" + bit, "(R) " + step);
    }
}

}  // namespace grafwire
