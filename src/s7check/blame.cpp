// Which network of a listing is to blame for a difference.
//
// X and outputs are what the check compares; they differ at the end of a chain. So the tables are
// looked at in the order in which the scan works them out: Tt, Ta and Td, Tf0 and Tf1, Ts, outputs.
// The first deviation that matters is the cause: of a transition that is not enabled Tt may be what
// it likes, and a step that is not active may be forced to 0. What the tables should hold comes
// from the reference (expected_tables.h).
//
// A receptivity is also wrong because of what an earlier scan has left: a freezing bit, a var, a
// timer. Where one of these was wrong when it was read, it is the cause, in the scan in which it
// began to deviate.

#include "s7check/blame.h"

#include "s7check/investigation.h"

namespace grafwire {

Investigation::Investigation(const Grafcet& grafcet, const s7::Listing& listing, s7::Cpu cpu,
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

std::optional<Finding> Investigation::run() {
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
bool Investigation::follow() {
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
        state_before_ = state_;
        expected_ = scan_with_tables(evolution_, reference, {inputs}, now_);
        if (!machine_.scan(state_, image_of(binding_, inputs), now_).is_done()) return false;
        suspects_.look_at(machine_, now_);
        if (witness_.scan_period > witness_.stimuli.end - now_) return true;
        note_what_is_kept();
    }
}

void Investigation::note_what_is_kept() {
    for (std::size_t g = 0; g < binding_.graphs.size(); ++g) {
        const std::string& name = grafcet_.graphs[static_cast<GraphId>(g)].name;
        note(Kind::may_evolve, name, binding_.graphs[g], expected_.may_evolve.test(g));
    }
    for (std::size_t v = 0; v < binding_.vars.size(); ++v) {
        const std::string& name = grafcet_.vars[static_cast<VarId>(v)].name;
        note(Kind::var, name, binding_.vars[v], expected_.vars.test(v));
    }
}

void Investigation::note(Kind kind, const std::string& name, const std::optional<Operand>& place,
                         bool expected) {
    if (!place) return;
    if (got(*place) == expected) {
        kept_.erase(name);
    } else if (!kept_.contains(name)) {
        kept_.emplace(name, suspects_.written(kind, name, *place, expected));
    }
}

Investigation::Deviation Investigation::in_situation() {
    for (std::size_t s = 0; s < binding_.steps.size(); ++s) {
        const bool expected = expected_.situation.test(s);
        if (got(step_place(s)) == expected) continue;
        Finding finding = suspects_.written(Kind::situation, step_name(s), step_place(s), expected);
        // The tables are right, so what works Ts out of them is not.
        if (has_tables_) suspects_.blame_instead(finding, suspects_.silent_writers_of_ts());
        return finding;
    }
    return std::nullopt;
}

Investigation::Deviation Investigation::in_outputs() {
    for (std::size_t o = 0; o < binding_.outputs.size(); ++o) {
        const bool expected = expected_.outputs.test(o);
        const Operand& place = *binding_.outputs[o];
        if (got(place) == expected) continue;
        const std::string& name = grafcet_.outputs[static_cast<OutputId>(o)].name;
        return suspects_.written(Kind::output, name, place, expected);
    }
    return std::nullopt;
}

std::optional<Finding> find_cause(const Grafcet& grafcet, const s7::Listing& listing, s7::Cpu cpu,
                                  const s7::Binding& binding, const Witness& witness) {
    return Investigation(grafcet, listing, cpu, binding, witness).run();
}

}  // namespace grafwire
