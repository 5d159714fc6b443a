// The set-priority latch of NAND gates, which the course "Mise en œuvre du GRAFCET" (section 2.2)
// retains for GRAFCET: S = R = 1 gives 1, as rule 5 demands.
//
//     X  = NAND(s1, s2, …, Q)       s: one NAND per transition into the step, 0 while it is cleared
//     Q  = NAND(r1, r2, …, X)       r: one NAND per term of CDX, 0 while it holds
//
// Every r also takes in all s: the reset is blocked while the latch is being set. Without that the
// two halves of the latch would both be 1 while S = R = 1, and race when S and R end together (in a
// loop of two steps one X is at once what sets and what resets). A step with one transition before
// and one after it takes four NAND gates.

#include "netlist/styles/asynchronous.h"

namespace grafwire {

namespace {

class NandPhase {
  public:
    NandPhase(AsynchronousBuild& build, const PhaseSignals& phase)
        : builder_(build.builder), build_(build), phase_(phase), name_(build.step_name(phase.x)) {}

    void make() {
        make_sets();
        make_resets();
        const NetId complement = builder_.add_net(name_, "q");
        std::vector<NetId> pins = sets_;
        pins.push_back(complement);
        builder_.drive(phase_.x, CellType::nand_gate, pins);
        resets_.push_back(phase_.x);
        builder_.drive(complement, CellType::nand_gate, resets_);
        if (phase_.init == no_net) {
            builder_.set_initial(complement, !phase_.initial);
        }
    }

  private:
    void add_set(std::vector<NetId> pins, const std::string& role) {
        if (phase_.not_au_dur != no_net) pins.push_back(phase_.not_au_dur);
        if (phase_.enclosing != no_net) pins.push_back(phase_.enclosing);
        sets_.push_back(builder_.gate(CellType::nand_gate, pins, name_, role));
    }

    void make_sets() {
        const bool init_blocks = !phase_.initial && phase_.init != no_net;
        for (const TransitionId into : phase_.into) {
            std::vector<NetId> pins = build_.clearing_factors(into);
            if (init_blocks) pins.push_back(phase_.not_init);
            if (phase_.forced_off != no_net) pins.push_back(builder_.inverted(phase_.forced_off));
            add_set(std::move(pins), "set" + build_.equations.grafcet->transitions[into].name);
        }
        if (phase_.initial && phase_.init != no_net) {
            std::vector<NetId> pins{phase_.init};
            if (phase_.forced_off != no_net) pins.push_back(builder_.inverted(phase_.forced_off));
            add_set(std::move(pins), "init");
        }
        if (phase_.forced_on != no_net) {
            add_set({phase_.forced_on}, "forced");
            forced_ = sets_.back();
        }
        if (!phase_.link.empty()) add_set(phase_.link, "link");
    }

    void make_resets() {
        for (std::size_t i = 0; i < phase_.cdx.size(); ++i) {
            std::vector<NetId> pins = phase_.cdx[i];
            pins.insert(pins.end(), sets_.begin(), sets_.end());
            resets_.push_back(
                builder_.gate(CellType::nand_gate, pins, name_, "reset" + std::to_string(i)));
        }
        add_reset(phase_.forced_off, "unforced");
        if (!phase_.initial) add_reset(phase_.init, "clear");
        if (phase_.enclosing != no_net) resets_.push_back(phase_.enclosing);
        if (phase_.not_au_dur != no_net) resets_.push_back(phase_.not_au_dur);
    }

    /// A reset that gives way only to an order that lists the step.
    void add_reset(NetId cause, const std::string& role) {
        if (cause == no_net) return;
        if (forced_ == no_net) {
            resets_.push_back(builder_.inverted(cause));
            return;
        }
        const NetId pins[] = {cause, forced_};
        resets_.push_back(builder_.gate(CellType::nand_gate, pins, name_, role));
    }

    ChartNetlist& builder_;
    AsynchronousBuild& build_;
    const PhaseSignals& phase_;
    std::string name_;
    std::vector<NetId> sets_;
    std::vector<NetId> resets_;
    NetId forced_ = no_net;  ///< 0 while an order lists the step
};

}  // namespace

void make_nand_phase(AsynchronousBuild& build, const PhaseSignals& phase) {
    NandPhase(build, phase).make();
}

}  // namespace grafwire
