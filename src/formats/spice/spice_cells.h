#pragma once

#include <string_view>
#include <vector>

#include "formats/spice/spice_elements.h"
#include "netlist/netlist.h"

namespace grafwire {

/// Writes the cells of a netlist as elements of a deck. During the start (node `__start` at 1,
/// `__running` at 0) latches, timers and nets with initial values are held at these.
class SpiceCells {
  public:
    SpiceCells(const Netlist& netlist, const NetSpelling& nets, SpiceElements& elements);

    /// Writes one cell, of any type but those that count scans.
    void write(const Cell& cell);

    /// The models that the cells written so far need.
    const SpiceModels& models() const { return models_; }

  private:
    void write_driver(const Cell& cell, std::string_view output, std::string_view speed);
    void write_latch(const Cell& cell, std::string_view output);
    void write_memory(const Cell& cell, std::string_view model, std::string_view output);
    void write_pulse(const Cell& cell, std::string_view output);
    void write_timer(const Cell& cell, std::string_view output);

    std::string_view pin(const Cell& cell, std::size_t number) const {
        return nets_[netlist_.pins_of(cell)[number]];
    }

    const Netlist& netlist_;
    const NetSpelling& nets_;
    SpiceElements& elements_;
    std::vector<Logic> initial_;  ///< per net: Netlist::initial_values
    SpiceModels models_;
};

}  // namespace grafwire
