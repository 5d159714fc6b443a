// Which network of a listing is to blame for a difference.
//
// X and outputs are what the check compares; they differ at the end of a chain. So the tables are
// looked at in the order in which the scan works them out: Tt, Ta and Td, Tf0 and Tf1, Ts, outputs.
// The first deviation that matters is the cause: of a transition that is not enabled Tt may be what
// it likes, and a step that is not active may be forced to 0. What the tables should hold comes
// from the reference (expected_tables.h).
//
// A receptivity is also wrong because of what an earlier scan has left: a freezing bit, a var, a
// timer. Where one of these deviates before the last scan and a receptivity does then, the former
// is the cause, in the scan in which it began to deviate.
//
// The network is the one that wrote the bit last. Where a bit is 0 and should be 1, that is mostly
// the one that clears the table; then it is the one that should have set it: it reads the
// transition (of Ta and Td) or the forcing step (of Tf0 and Tf1), and sets something in that table.

#include "s7check/blame.h"

#include <algorithm>
#include <map>

#include "s7check/expected_tables.h"
#include "s7check/method_tables.h"
#include "s7check/suspects.h"

namespace grafwire {

namespace {

using Kind = Finding::Kind;
using s7::Operand;

class Investigation {
  public:
    Investigation(const Grafcet& grafcet, const s7::Listing& listing, s7::Cpu cpu,
                  const s7::Binding& binding, const Witness& witness)
        : grafcet_(grafcet),
          listing_(listing),
          binding_(binding),
          witness_(witness),
          evolution_(grafcet),
          machine_(listing, cpu),
          state_(machine_.start()),
          has_tables_(keeps_method_tables(binding)),
          suspects_(listing, binding) {
        machine_.record();
    }

    std::optional<Finding> run() {
        InputValues inputs(grafcet_.all_input_count(), 0);
        EvolutionState reference;
        const auto& changes = witness_.stimuli.changes;
        std::size_t next = 0;
        for (now_ = 0;; now_ += witness_.scan_period) {
            for (; next < changes.size() && changes[next].at <= now_; ++next) {
                for (const auto& set : changes[next].assignments) {
                    inputs[set.input] = set.value ? 1 : 0;
                }
            }
            if (now_ == 0) reference = evolution_.start({inputs});
            before_ = reference;
            timers_before_ = state_;
            expected_ = scan_with_tables(evolution_, reference, {inputs}, now_);
            if (!machine_.scan(state_, image_of(binding_, inputs), now_).is_done()) return {};
            suspects_.look_at(machine_, now_);
            if (witness_.scan_period > witness_.stimuli.end - now_) break;
            note_what_is_kept();
        }
        return first_deviation();
    }

  private:
    // Looking at bits.

    bool got(const Operand& place) const { return machine_.bit(state_, place).value; }
    const Operand& step_place(std::size_t step) const { return *binding_.steps[step]; }
    bool got_in(MethodTables::Distance table, std::size_t step) const {
        return got(MethodTables::in(table, step_place(step)));
    }
    std::string step_name(std::size_t step) const {
        return "X" + grafcet_.steps[static_cast<StepId>(step)].name;
    }

    // What is kept from scan to scan.

    void note_what_is_kept() {
        for (std::size_t g = 0; g < binding_.graphs.size(); ++g) {
            const std::string& name = grafcet_.graphs[static_cast<GraphId>(g)].name;
            note(Kind::may_evolve, name, binding_.graphs[g], expected_.may_evolve.test(g));
        }
        for (std::size_t v = 0; v < binding_.vars.size(); ++v) {
            const std::string& name = grafcet_.vars[static_cast<VarId>(v)].name;
            note(Kind::var, name, binding_.vars[v], expected_.vars.test(v));
        }
    }

    void note(Kind kind, const std::string& name, const std::optional<Operand>& place,
              bool expected) {
        if (!place) return;
        if (got(*place) == expected) {
            kept_.erase(name);
        } else if (!kept_.contains(name)) {
            kept_.emplace(name, suspects_.written(kind, name, *place, expected));
        }
    }

    // The deviations of the last scan, in its order.

    std::optional<Finding> first_deviation() {
        std::optional<Finding> found;
        if (has_tables_) {
            found = in_receptivities();
            if (!found) found = in_evolution();
            if (!found) found = in_forcing();
        }
        if (!found) found = in_situation();
        if (!found) found = in_outputs();
        return found;
    }

    std::optional<Finding> in_receptivities() {
        for (std::size_t t = 0; t < binding_.transitions.size(); ++t) {
            const bool expected = expected_.cleared.test(t);
            const Operand& place = *binding_.transitions[t];
            if (!expected_.enabled.test(t) || got(place) == expected) continue;
            const Transition& transition = grafcet_.transitions[static_cast<TransitionId>(t)];
            const auto frozen = kept_.find(grafcet_.graphs[transition.graph].name);
            if (frozen != kept_.end()) return frozen->second;
            for (const auto& [name, finding] : kept_) {
                if (finding.kind == Kind::var) return finding;
            }
            Finding finding =
                suspects_.written(Kind::receptivity, transition.name, place, expected);
            if (auto timer = in_timer(finding, transition)) return timer;
            return finding;
        }
        return std::nullopt;
    }

    /// The time conditions that an expression reads.
    void collect_time_conditions(ExprId id, std::vector<ExprId>& found) const {
        if (id == no_expr) return;
        if (grafcet_.expressions.kind(id) == ExprKind::time_condition) found.push_back(id);
        for (const ExprId operand : grafcet_.expressions.operands(id)) {
            collect_time_conditions(operand, found);
        }
    }

    /// Where the receptivity reads one time condition and its network one timer, and they were not
    /// the same before the scan: the network that runs the timer.
    std::optional<Finding> in_timer(const Finding& receptivity, const Transition& transition) {
        if (receptivity.networks.empty()) return std::nullopt;
        std::vector<ExprId> conditions;
        collect_time_conditions(transition.receptivity, conditions);
        if (conditions.size() != 1) return std::nullopt;
        const std::size_t place = grafcet_.expressions.ordinal(conditions[0]);
        const bool expected = before_.time_values.test(place);
        for (const s7::Network& network : listing_.networks) {
            if (network.number != receptivity.networks[0]) continue;
            for (const s7::Instruction& instruction : network.instructions) {
                if (instruction.operands.empty()) continue;
                const Operand& timer = instruction.operands[0];
                if (timer.area != s7::Area::timer || !loads(instruction, timer)) continue;
                if (machine_.bit(timers_before_, timer).value == expected) continue;
                Finding finding = receptivity;
                finding.kind = Kind::timer;
                finding.name = "T" + std::to_string(timer.address);
                finding.place = timer;
                finding.expected = expected;
                suspects_.blame_instead(finding, suspects_.runners_of(timer));
                finding.should_have_written = false;
                return finding;
            }
        }
        return std::nullopt;
    }

    std::optional<Finding> in_evolution() {
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
            return suspects_.written(Kind::previous, step_name(s),
                                     MethodTables::in(MethodTables::previous, step_place(s)),
                                     !previous);
        }
        return std::nullopt;
    }

    Finding set_by_transition(Kind kind, MethodTables::Distance distance, std::size_t s,
                              bool expected) {
        const Operand place = MethodTables::in(distance, step_place(s));
        Finding finding = suspects_.written(kind, step_name(s), place, expected);
        if (!expected) return finding;
        for (std::size_t t = 0; t < binding_.transitions.size(); ++t) {
            const Transition& transition = grafcet_.transitions[static_cast<TransitionId>(t)];
            const auto steps = kind == Kind::activate ? grafcet_.following(transition)
                                                      : grafcet_.preceding(transition);
            if (!expected_.cleared.test(t) ||
                std::find(steps.begin(), steps.end(), static_cast<StepId>(s)) == steps.end()) {
                continue;
            }
            // The network that reads the transition, then the one that works for its preceding
            // step.
            for (const StepId before : grafcet_.preceding(transition)) {
                suspects_.blame_instead(finding, suspects_.setters_for_step(index_of(before)));
            }
            suspects_.blame_instead(finding, suspects_.setters_for(*binding_.transitions[t]));
        }
        return finding;
    }

    std::optional<Finding> in_forcing() {
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

    Finding set_by_order(Kind kind, MethodTables::Distance distance, std::size_t s, bool expected) {
        const Operand place = MethodTables::in(distance, step_place(s));
        Finding finding = suspects_.written(kind, step_name(s), place, expected);
        if (!expected) return finding;
        const GraphId graph = grafcet_.steps[static_cast<StepId>(s)].graph;
        for (const Order& order : grafcet_.orders) {
            if (order.graph != graph || order.kind == OrderKind::freeze ||
                !expected_.evolved.test(index_of(order.step))) {
                continue;
            }
            suspects_.blame_instead(finding, suspects_.setters_for_step(index_of(order.step)));
        }
        return finding;
    }

    std::optional<Finding> in_situation() {
        for (std::size_t s = 0; s < binding_.steps.size(); ++s) {
            const bool expected = expected_.situation.test(s);
            if (got(step_place(s)) == expected) continue;
            Finding finding =
                suspects_.written(Kind::situation, step_name(s), step_place(s), expected);
            // The tables are right, so what works Ts out of them is not: a network that did not
            // write Ts in this scan comes first.
            if (has_tables_) suspects_.blame_instead(finding, suspects_.silent_writers_of_ts());
            return finding;
        }
        return std::nullopt;
    }

    std::optional<Finding> in_outputs() {
        for (std::size_t o = 0; o < binding_.outputs.size(); ++o) {
            const bool expected = expected_.outputs.test(o);
            const Operand& place = *binding_.outputs[o];
            if (got(place) == expected) continue;
            const std::string& name = grafcet_.outputs[static_cast<OutputId>(o)].name;
            return suspects_.written(Kind::output, name, place, expected);
        }
        return std::nullopt;
    }

    const Grafcet& grafcet_;
    const s7::Listing& listing_;
    const s7::Binding& binding_;
    const Witness& witness_;
    Evolution evolution_;
    s7::Machine machine_;
    s7::MachineState state_;
    s7::MachineState timers_before_;  ///< the machine's state before the scan
    bool has_tables_;
    Suspects suspects_;
    Time now_ = 0;
    EvolutionState before_;    ///< the reference before the scan
    ExpectedTables expected_;  ///< and what it expects after it
    /// What is kept from scan to scan and deviates now, from when on, by name.
    std::map<std::string, Finding> kept_;
};

}  // namespace

std::optional<Finding> find_cause(const Grafcet& grafcet, const s7::Listing& listing, s7::Cpu cpu,
                                  const s7::Binding& binding, const Witness& witness) {
    return Investigation(grafcet, listing, cpu, binding, witness).run();
}

}  // namespace grafwire
