#include "netlist/styles/nand_latch.h"

#include <string>
#include <utility>
#include <vector>

namespace grafwire {

namespace {

class NandModule : LatchModule {
  public:
    NandModule(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates,
               ResetWhileSet reset)
        : LatchModule(build, step, gates), reset_(reset) {}

    void make() {
        make_sets();
        make_resets();
        cross_couple(CellType::nand_gate, sets_, resets_);
    }

  private:
    void add_set(std::vector<NetId> pins, std::string_view role) {
        if (step_.not_au_dur != no_net) pins.push_back(step_.not_au_dur);
        if (step_.enclosing != no_net) pins.push_back(step_.enclosing);
        sets_.push_back(gates_.gate(CellType::nand_gate, pins, role));
    }

    void make_sets() {
        const NetId off = step_.forced_off.net;
        for (const TransitionId into : step_.into) {
            std::vector<NetId> pins = build_.clearing_factors(into, gates_);
            if (!step_.initial && has_modes()) pins.push_back(step_.not_init);
            if (off != no_net) pins.push_back(gates_.inverted(off));
            add_set(std::move(pins), set_role(into));
        }
        if (step_.initial && has_modes()) {
            std::vector<NetId> pins{step_.init};
            if (off != no_net) pins.push_back(gates_.inverted(off));
            add_set(std::move(pins), "init");
        }
        if (step_.forced_on.net != no_net) {
            add_set({step_.forced_on.net}, "forced");
            forced_ = sets_.back();
        }
        if (!step_.link.empty()) add_set(step_.link, "link");
    }

    void make_resets() {
        for (std::size_t i = 0; i < step_.cdx.size(); ++i) {
            std::vector<NetId> pins = step_.cdx[i];
            if (reset_ == ResetWhileSet::blocked) {
                pins.insert(pins.end(), sets_.begin(), sets_.end());
            }
            resets_.push_back(gates_.gate(CellType::nand_gate, pins, "reset" + std::to_string(i)));
        }
        add_reset(step_.forced_off.net, "unforced");
        if (!step_.initial) add_reset(step_.init, "clear");
        if (step_.enclosing != no_net) resets_.push_back(step_.enclosing);
        if (step_.not_au_dur != no_net) resets_.push_back(step_.not_au_dur);
    }

    /// A reset that gives way only to an order that lists the step.
    void add_reset(NetId cause, std::string_view role) {
        if (cause == no_net) return;
        resets_.push_back(forced_ == no_net
                              ? gates_.inverted(cause)
                              : gates_.gate(CellType::nand_gate, {cause, forced_}, role));
    }

    ResetWhileSet reset_;
    NetId forced_ = no_net;  ///< 0 while an order lists the step
};

}  // namespace

void make_nand_latch(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates,
                     ResetWhileSet reset) {
    NandModule(build, step, gates, reset).make();
}

}  // namespace grafwire
