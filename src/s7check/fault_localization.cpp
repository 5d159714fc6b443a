// Fault localization: which network of a listing a difference comes from.
//
// X and outputs are what the check compares; they differ at the end of a chain. So reference and
// listing run side by side up to the end of the witness, and there the tables are compared in the
// order in which the scan works them out: Tt, Ta and Td, Tf0 and Tf1, Ts, outputs. The first
// deviation that matters is the diagnosis: of a transition that is not enabled Tt may be anything,
// and a step that is not active may be forced to 0. A deviation in a table of steps counts only if
// the result for its step, `Tp . /Td + Ta` or `Ts . /Tf0 + Tf1`, is another one. What the tables
// should hold comes from the reference (method_tables.h).
//
// A transition condition is also wrong because of what an earlier scan has left: a freezing bit, a
// var, a timer. Where one of these was wrong when it was read, it is the fault, in the scan in
// which it began to deviate.
//
// The first candidate is the network that wrote the bit last. But where a bit is 0 and should be 1
// that is mostly the one that clears the table; then it is the one that should have set it: it
// reads the transition (of Ta and Td) or the forcing step (of Tf0 and Tf1), and sets something.
//
// The method is that of declarative debugging, on one run: the first part that is wrong although
// all it builds on is right has the fault (E. Y. Shapiro, "Algorithmic Program Debugging", 1983).

#include "s7check/fault_localization.h"

#include <algorithm>
#include <map>

#include "s7check/candidate_networks.h"
#include "s7check/method_tables.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

constexpr CandidateNetworks::Bytes ta_and_td{40, 20};
constexpr CandidateNetworks::Bytes tf1_and_tf0{60, 20};

/// Follows a witness to its end, reference and listing side by side, and looks for the first bit
/// that deviates there. What it refers to must outlive it.
class FaultLocalizer {
  public:
    FaultLocalizer(const Grafcet& grafcet, const s7::Listing& listing, s7::Cpu cpu,
                   const s7::Binding& binding, const Witness& witness);
    std::optional<Diagnosis> run();

  private:
    using Kind = Diagnosis::Kind;
    using Operand = s7::Operand;
    using Deviation = std::optional<Diagnosis>;

    bool follow();
    void note_what_is_kept();
    void note(Kind kind, const std::string& name, const std::optional<Operand>& place,
              bool expected);

    // The deviations of the last scan, in its order.
    Deviation in_receptivities();
    Deviation in_freezing(const Transition& transition);
    Deviation in_vars(const Transition& transition);
    Deviation in_timer(const Diagnosis& receptivity, const Transition& transition);
    Deviation in_evolution();
    Deviation in_forcing();
    Deviation in_situation();
    Deviation in_outputs();
    Diagnosis set_by_transition(Kind kind, MethodTables::Distance distance, std::size_t step,
                                bool expected);
    Diagnosis set_by_order(Kind kind, MethodTables::Distance distance, std::size_t step,
                           bool expected);

    void collect(ExprId id, ExprKind kind, std::vector<ExprId>& found) const;
    bool got(const Operand& place) const { return machine_.bit(state_, place).is_one(); }
    bool got_in(MethodTables::Distance table, std::size_t step) const {
        return got(MethodTables::in(table, step_place(step)));
    }
    const Operand& step_place(std::size_t step) const { return *binding_.steps[step]; }
    std::string step_name(std::size_t step) const {
        return "X" + grafcet_.steps[static_cast<StepId>(step)].name;
    }

    const Grafcet& grafcet_;
    const s7::Listing& listing_;
    const s7::Binding& binding_;
    const Witness& witness_;
    Evolution evolution_;
    s7::Machine machine_;
    s7::MachineState state_;
    s7::MachineState state_before_;  ///< of the machine, before the scan
    bool has_tables_;
    CandidateNetworks candidates_;
    Time now_ = 0;
    EvolutionState before_;    ///< the reference before the scan
    ExpectedTables expected_;  ///< and what it expects after it
    /// What is kept from scan to scan and deviates now, since when, by name.
    std::map<std::string, Diagnosis> kept_;
};

FaultLocalizer::FaultLocalizer(const Grafcet& grafcet, const s7::Listing& listing, s7::Cpu cpu,
                               const s7::Binding& binding, const Witness& witness)
    : grafcet_(grafcet),
      listing_(listing),
      binding_(binding),
      witness_(witness),
      evolution_(grafcet),
      machine_(listing, cpu),
      state_(machine_.start()),
      has_tables_(keeps_method_tables(binding)),
      candidates_(listing, binding) {
    machine_.record();
}

std::optional<Diagnosis> FaultLocalizer::run() {
    if (!follow()) return std::nullopt;
    Deviation found;
    if (has_tables_) {
        found = in_receptivities();
        if (!found) found = in_evolution();
        if (!found) found = in_forcing();
    }
    if (!found) found = in_situation();
    if (!found) found = in_outputs();
    return found;
}

/// Up to and including the last scan; false where the listing does not get there.
bool FaultLocalizer::follow() {
    StimuliPlayer player(witness_.stimuli, grafcet_.all_input_count());
    EvolutionState reference;
    for (now_ = 0;; now_ += witness_.scan_period) {
        player.advance(now_);
        const InputValues& inputs = player.inputs();
        if (now_ == 0) reference = evolution_.start({inputs});
        before_ = reference;
        state_before_ = state_;
        expected_ = scan_with_tables(evolution_, reference, {inputs}, now_);
        if (!machine_.scan(state_, image_of(binding_, inputs), now_).is_done()) return false;
        candidates_.look_at(machine_, now_);
        if (witness_.scan_period > witness_.stimuli.end - now_) return true;
        note_what_is_kept();
    }
}

void FaultLocalizer::note_what_is_kept() {
    for (std::size_t g = 0; g < binding_.graphs.size(); ++g) {
        const std::string& name = grafcet_.graphs[static_cast<GraphId>(g)].name;
        note(Kind::may_evolve, name, binding_.graphs[g], expected_.may_evolve.test(g));
    }
    for (std::size_t v = 0; v < binding_.vars.size(); ++v) {
        const std::string& name = grafcet_.vars[static_cast<VarId>(v)].name;
        note(Kind::var, name, binding_.vars[v], expected_.vars.test(v));
    }
}

void FaultLocalizer::note(Kind kind, const std::string& name, const std::optional<Operand>& place,
                          bool expected) {
    if (!place) return;
    if (got(*place) == expected) {
        kept_.erase(name);
    } else if (!kept_.contains(name)) {
        kept_.emplace(name, candidates_.written(kind, name, *place, expected));
    }
}

/// Of enabled transitions only: Tt is 1 where they are cleared.
FaultLocalizer::Deviation FaultLocalizer::in_receptivities() {
    for (std::size_t t = 0; t < binding_.transitions.size(); ++t) {
        const bool expected = expected_.cleared.test(t);
        const Operand& place = *binding_.transitions[t];
        if (!expected_.enabled.test(t) || got(place) == expected) continue;
        const Transition& transition = grafcet_.transitions[static_cast<TransitionId>(t)];
        if (auto kept = in_freezing(transition)) return kept;
        if (auto kept = in_vars(transition)) return kept;
        Diagnosis diagnosis =
            candidates_.written(Kind::receptivity, transition.name, place, expected);
        if (auto timer = in_timer(diagnosis, transition)) return timer;
        return diagnosis;
    }
    return std::nullopt;
}

/// Where the freezing bit was not what it should have been when it was read.
FaultLocalizer::Deviation FaultLocalizer::in_freezing(const Transition& transition) {
    const std::size_t graph = index_of(transition.graph);
    const std::optional<Operand>& place = binding_.graphs[graph];
    if (!place) return std::nullopt;
    const std::string& name = grafcet_.graphs[transition.graph].name;
    const auto kept = kept_.find(name);
    if (kept != kept_.end()) return kept->second;
    const bool expected = before_.may_evolve.test(graph);
    if (candidates_.read_as(*place).value_or(expected) == expected) return std::nullopt;
    return candidates_.written(Kind::may_evolve, name, *place, expected);
}

/// Where a var that the transition condition reads has been wrong since an earlier scan.
FaultLocalizer::Deviation FaultLocalizer::in_vars(const Transition& transition) {
    std::vector<ExprId> parts;
    collect(transition.condition, ExprKind::variable, parts);
    for (const ExprId id : parts) {
        const Variable variable = grafcet_.expressions.variable_of(id);
        if (variable.kind != VariableKind::var) continue;
        const auto kept = kept_.find(variable_name(grafcet_, variable));
        if (kept != kept_.end()) return kept->second;
    }
    return std::nullopt;
}

/// Where the transition condition reads one time condition and its network a timer, and these were
/// not the same before the scan: the network that runs the timer.
FaultLocalizer::Deviation FaultLocalizer::in_timer(const Diagnosis& receptivity,
                                                   const Transition& transition) {
    std::vector<ExprId> conditions;
    collect(transition.condition, ExprKind::time_condition, conditions);
    if (receptivity.networks.empty() || conditions.size() != 1) return std::nullopt;
    const bool expected = before_.time_values.test(grafcet_.expressions.ordinal(conditions[0]));
    for (const s7::Network& network : listing_.networks) {
        if (network.number != receptivity.networks[0]) continue;
        for (const s7::Instruction& instruction : network.instructions) {
            if (instruction.operands.empty()) continue;
            const Operand& timer = instruction.operands[0];
            if (timer.area != s7::Area::timer || !loads(instruction, timer)) continue;
            if (machine_.bit(state_before_, timer).is_one() == expected) continue;
            Diagnosis diagnosis = receptivity;
            diagnosis.kind = Kind::timer;
            diagnosis.name = "T" + std::to_string(timer.address);
            diagnosis.place = timer;
            diagnosis.expected = expected;
            candidates_.put_first(diagnosis, candidates_.runners_of(timer));
            diagnosis.should_have_written = false;
            return diagnosis;
        }
    }
    return std::nullopt;
}

/// The parts of an expression that are of a kind.
void FaultLocalizer::collect(ExprId id, ExprKind kind, std::vector<ExprId>& found) const {
    if (id == no_expr) return;
    if (grafcet_.expressions.kind(id) == kind) found.push_back(id);
    for (const ExprId operand : grafcet_.expressions.operands(id)) collect(operand, kind, found);
}

FaultLocalizer::Deviation FaultLocalizer::in_evolution() {
    for (std::size_t s = 0; s < binding_.steps.size(); ++s) {
        const bool previous = got_in(MethodTables::previous, s);
        const bool on = got_in(MethodTables::activate, s);
        const bool off = got_in(MethodTables::deactivate, s);
        if (((previous && !off) || on) == expected_.evolved.test(s)) continue;
        if (on != expected_.activate.test(s)) {
            return set_by_transition(Kind::activate, MethodTables::activate, s, !on);
        }
        if (off != expected_.deactivate.test(s)) {
            return set_by_transition(Kind::deactivate, MethodTables::deactivate, s, !off);
        }
        const Operand place = MethodTables::in(MethodTables::previous, step_place(s));
        return candidates_.written(Kind::previous, step_name(s), place, !previous);
    }
    return std::nullopt;
}

Diagnosis FaultLocalizer::set_by_transition(Kind kind, MethodTables::Distance distance,
                                            std::size_t step, bool expected) {
    const Operand place = MethodTables::in(distance, step_place(step));
    Diagnosis diagnosis = candidates_.written(kind, step_name(step), place, expected);
    if (!expected) return diagnosis;
    for (std::size_t t = 0; t < binding_.transitions.size(); ++t) {
        const Transition& transition = grafcet_.transitions[static_cast<TransitionId>(t)];
        const auto steps = kind == Kind::activate ? grafcet_.following(transition)
                                                  : grafcet_.preceding(transition);
        const bool concerns =
            std::find(steps.begin(), steps.end(), static_cast<StepId>(step)) != steps.end();
        if (!expected_.cleared.test(t) || !concerns) continue;
        // The network that reads the transition, then those that work for its preceding steps.
        for (const StepId before : grafcet_.preceding(transition)) {
            candidates_.put_first(diagnosis,
                                  candidates_.setters_for_step(index_of(before), ta_and_td));
        }
        candidates_.put_first(diagnosis, candidates_.setters_for(*binding_.transitions[t]));
    }
    return diagnosis;
}

FaultLocalizer::Deviation FaultLocalizer::in_forcing() {
    for (std::size_t s = 0; s < binding_.steps.size(); ++s) {
        const bool on = got_in(MethodTables::forced_on, s);
        const bool off = got_in(MethodTables::forced_off, s);
        const bool evolved = expected_.evolved.test(s);
        const bool expected =
            (evolved && !expected_.forced_off.test(s)) || expected_.forced_on.test(s);
        if (((evolved && !off) || on) == expected) continue;
        if (on != expected_.forced_on.test(s)) {
            return set_by_order(Kind::forced_on, MethodTables::forced_on, s, !on);
        }
        return set_by_order(Kind::forced_off, MethodTables::forced_off, s, !off);
    }
    return std::nullopt;
}

Diagnosis FaultLocalizer::set_by_order(Kind kind, MethodTables::Distance distance, std::size_t step,
                                       bool expected) {
    const Operand place = MethodTables::in(distance, step_place(step));
    Diagnosis diagnosis = candidates_.written(kind, step_name(step), place, expected);
    if (!expected) return diagnosis;
    const GraphId graph = grafcet_.steps[static_cast<StepId>(step)].graph;
    for (const Order& order : grafcet_.orders) {
        const std::size_t giving = index_of(order.step);
        if (order.graph != graph || order.kind == OrderKind::freeze ||
            !expected_.evolved.test(giving)) {
            continue;
        }
        const auto setters = candidates_.setters_for_step(giving, tf1_and_tf0);
        // They cannot have set it where they found the forcing step inactive: then Ts had not been
        // worked out.
        for (const std::uint32_t network : setters) {
            if (candidates_.read_as(step_place(giving), network).value_or(true)) continue;
            Diagnosis earlier =
                candidates_.written(Kind::situation, step_name(giving), step_place(giving), true);
            candidates_.put_first(earlier, candidates_.silent_writers_of_ts());
            return earlier;
        }
        candidates_.put_first(diagnosis, setters);
    }
    return diagnosis;
}

FaultLocalizer::Deviation FaultLocalizer::in_situation() {
    for (std::size_t s = 0; s < binding_.steps.size(); ++s) {
        const bool expected = expected_.situation.test(s);
        if (got(step_place(s)) == expected) continue;
        Diagnosis diagnosis =
            candidates_.written(Kind::situation, step_name(s), step_place(s), expected);
        // The tables are right, so what works Ts out of them is not.
        if (has_tables_) candidates_.put_first(diagnosis, candidates_.silent_writers_of_ts());
        return diagnosis;
    }
    return std::nullopt;
}

FaultLocalizer::Deviation FaultLocalizer::in_outputs() {
    for (std::size_t o = 0; o < binding_.outputs.size(); ++o) {
        const bool expected = expected_.outputs.test(o);
        const Operand& place = *binding_.outputs[o];
        if (got(place) == expected) continue;
        const std::string& name = grafcet_.outputs[static_cast<OutputId>(o)].name;
        return candidates_.written(Kind::output, name, place, expected);
    }
    return std::nullopt;
}

}  // namespace

std::optional<Diagnosis> localize_fault(const Grafcet& grafcet, const s7::Listing& listing,
                                        s7::Cpu cpu, const s7::Binding& binding,
                                        const Witness& witness) {
    return FaultLocalizer(grafcet, listing, cpu, binding, witness).run();
}

}  // namespace grafwire
