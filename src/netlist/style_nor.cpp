// The reset-priority latch of NOR gates, which the course "Mise en œuvre du GRAFCET" (section 2.2)
// warns of: S = R = 1 gives 0, so that a step which is activated and deactivated at the same time
// is lost, against rule 5. It is kept so that this can be shown.
//
//     X = NOR(r1, r2, …, Q)         r: the terms of CDX
//     Q = NOR(s1, s2, …, X)         s: the clearing conditions of the transitions into the step

#include "netlist/asynchronous.h"

namespace grafwire {

namespace {

class NorPhase {
  public:
    NorPhase(AsynchronousBuild& build, const PhaseSignals& phase)
        : builder_(build.builder), build_(build), phase_(phase), name_(build.step_name(phase.x)) {}

    void make() {
        make_sets();
        make_resets();
        const NetId complement = builder_.add_net(name_, "q");
        resets_.push_back(complement);
        builder_.drive(phase_.x, CellType::nor_gate, resets_);
        sets_.push_back(phase_.x);
        builder_.drive(complement, CellType::nor_gate, sets_);
        if (phase_.init == no_net) {
            builder_.netlist().initial_values.push_back({complement, !phase_.initial});
        }
    }

  private:
    void make_sets() {
        for (const TransitionId into : phase_.into) {
            sets_.push_back(build_.clearing_net(into));
        }
        if (phase_.initial && phase_.init != no_net) sets_.push_back(phase_.init);
        if (phase_.forced_on != no_net) sets_.push_back(phase_.forced_on);
        if (!phase_.link.empty()) {
            sets_.push_back(phase_.link.size() == 1
                                ? phase_.link[0]
                                : builder_.gate(CellType::and_gate, phase_.link, name_, "link"));
        }
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

    NetlistBuilder& builder_;
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
