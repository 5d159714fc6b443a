// The reset-priority latch of NOR gates, which the course "Mise en œuvre du GRAFCET" (section 2.2)
// warns of: S = R = 1 gives 0, so that a step which is activated and deactivated at the same time
// is lost, against rule 5. It is kept so that this can be shown.
//
//     X = NOR(r1, r2, …, Q)         r: the terms of CDX
//     Q = NOR(s1, s2, …, X)         s: one AND per transition into the step, 1 while it is cleared
//
// Every s also takes in the complements of all r: the set is blocked while the latch is being
// reset. Without that both halves of the latch would be 0 while S = R = 1, and race when S and R
// end together.

#include "netlist/styles/asynchronous.h"
#include "netlist/styles/styles.h"

namespace grafwire {

namespace {

class NorModule : LatchModule {
  public:
    using LatchModule::LatchModule;

    void make() {
        make_resets();
        make_sets();
        cross_couple(CellType::nor_gate, resets_, sets_);
    }

  private:
    void add_set(std::vector<NetId> pins, std::string_view role) {
        for (const NetId reset : resets_) pins.push_back(gates_.inverted(reset));
        sets_.push_back(gates_.gate(CellType::and_gate, pins, role));
    }

    void make_sets() {
        for (const TransitionId into : step_.into) {
            add_set(build_.clearing_factors(into, gates_), set_role(into));
        }
        if (step_.initial && has_modes()) add_set({step_.init}, "init");
        if (step_.forced_on.net != no_net) {
            // Only what an order does not outweigh blocks it: the resets of add_reset give way.
            std::vector<NetId> pins{step_.forced_on.net};
            if (step_.enclosing != no_net) pins.push_back(step_.enclosing);
            if (step_.not_au_dur != no_net) pins.push_back(step_.not_au_dur);
            sets_.push_back(gates_.joined(CellType::and_gate, pins, "forced"));
        }
        if (!step_.link.empty()) add_set(step_.link, "link");
    }

    void make_resets() {
        for (std::size_t i = 0; i < step_.cdx.size(); ++i) {
            std::vector<NetId> pins = step_.cdx[i];
            if (step_.initial && has_modes()) pins.push_back(step_.not_init);
            add_reset(std::move(pins), "reset" + std::to_string(i));
        }
        if (step_.forced_off.net != no_net) add_reset({step_.forced_off.net}, "unforced");
        if (!step_.initial && has_modes()) add_reset({step_.init}, "clear");
        if (step_.enclosing != no_net) resets_.push_back(gates_.inverted(step_.enclosing));
        if (step_.not_au_dur != no_net) resets_.push_back(gates_.inverted(step_.not_au_dur));
    }

    /// A reset that gives way to an order that lists the step.
    void add_reset(std::vector<NetId> pins, std::string_view role) {
        if (step_.forced_on.net != no_net) pins.push_back(gates_.inverted(step_.forced_on.net));
        resets_.push_back(gates_.joined(CellType::and_gate, pins, role));
    }
};

void make_nor_step(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates) {
    NorModule(build, step, gates).make();
}

}  // namespace

Netlist make_nor(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays) {
    return make_asynchronous(
        grafcet, equations,
        {make_nor_step, {CellType::and_gate, CellType::nor_gate, CellType::nor_gate}}, delays);
}

}  // namespace grafwire
