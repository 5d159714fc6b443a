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

namespace grafwire {

namespace {

class NorPhase {
  public:
    NorPhase(AsynchronousBuild& build, const PhaseSignals& phase)
        : builder_(build.builder), build_(build), phase_(phase), name_(build.step_name(phase.x)) {}

    void make() {
        make_resets();
        make_sets();
        const NetId complement = builder_.add_net(name_, "q");
        resets_.push_back(complement);
        builder_.drive(phase_.x, CellType::nor_gate, resets_);
        sets_.push_back(phase_.x);
        builder_.drive(complement, CellType::nor_gate, sets_);
        if (phase_.init == no_net) {
            builder_.set_initial(complement, !phase_.initial);
        }
    }

  private:
    void add_set(std::vector<NetId> pins, const std::string& role) {
        for (const NetId reset : resets_) pins.push_back(builder_.inverted(reset));
        sets_.push_back(builder_.gate(CellType::and_gate, pins, name_, role));
    }

    void make_sets() {
        for (const TransitionId into : phase_.into) {
            add_set(build_.clearing_factors(into),
                    "set" + build_.equations.grafcet->transitions[into].name);
        }
        if (phase_.initial && phase_.init != no_net) add_set({phase_.init}, "init");
        if (phase_.forced_on != no_net) {
            // Only what an order does not outweigh blocks it: the resets of add_reset give way.
            std::vector<NetId> pins{phase_.forced_on};
            if (phase_.enclosing != no_net) pins.push_back(phase_.enclosing);
            if (phase_.not_au_dur != no_net) pins.push_back(phase_.not_au_dur);
            sets_.push_back(pins.size() == 1
                                ? pins[0]
                                : builder_.gate(CellType::and_gate, pins, name_, "forced"));
        }
        if (!phase_.link.empty()) add_set(phase_.link, "link");
    }

    void make_resets() {
        for (std::size_t i = 0; i < phase_.cdx.size(); ++i) {
            std::vector<NetId> pins = phase_.cdx[i];
            if (phase_.initial && phase_.init != no_net) pins.push_back(phase_.not_init);
            add_reset(std::move(pins), "reset" + std::to_string(i));
        }
        if (phase_.forced_off != no_net) add_reset({phase_.forced_off}, "unforced");
        if (!phase_.initial && phase_.init != no_net) add_reset({phase_.init}, "clear");
        if (phase_.enclosing != no_net) resets_.push_back(builder_.inverted(phase_.enclosing));
        if (phase_.not_au_dur != no_net) resets_.push_back(builder_.inverted(phase_.not_au_dur));
    }

    /// A reset that gives way to an order that lists the step.
    void add_reset(std::vector<NetId> pins, const std::string& role) {
        if (phase_.forced_on != no_net) pins.push_back(builder_.inverted(phase_.forced_on));
        resets_.push_back(pins.size() == 1 ? pins[0]
                                           : builder_.gate(CellType::and_gate, pins, name_, role));
    }

    ChartNetlist& builder_;
    AsynchronousBuild& build_;
    const PhaseSignals& phase_;
    std::string name_;
    std::vector<NetId> sets_;
    std::vector<NetId> resets_;
};

}  // namespace

void make_nor_phase(AsynchronousBuild& build, const PhaseSignals& phase) {
    NorPhase(build, phase).make();
}

}  // namespace grafwire
