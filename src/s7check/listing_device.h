#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/scanned_device.h"
#include "grafcet/grafcet.h"
#include "s7/machine/binding.h"
#include "s7/machine/machine.h"

namespace grafwire {

/// An S7-200 listing as a check sees it. Its memory between scans is what is alive of the
/// controller's (Machine::live_at_start), its timers and counters; the rest cannot matter.
class ListingDevice : public ScannedDevice {
  public:
    /// The binding gives an address to every input, step and output of the GRAFCET. It has modes if
    /// it gives one to a control input.
    ListingDevice(const s7::Listing& listing, s7::Cpu cpu, const s7::Binding& binding);

    std::string start() const override { return {}; }
    Outcome scan(const std::string& memory, const PartialInputs& inputs, Time now) const override;
    std::string key(const std::string& memory, Time now) const override;
    std::vector<Time> delays() const override { return machine_.delays(); }
    bool has_modes() const override;

  private:
    s7::MachineState unpacked(const std::string& memory) const;
    std::string packed(const s7::MachineState& state) const;
    std::optional<std::uint32_t> unknown_alive(const s7::MachineState& state) const;
    std::optional<std::uint32_t> observe(const s7::MachineState& state, Outcome& outcome) const;
    s7::InputImage image_of(const PartialInputs& inputs) const;

    s7::Binding binding_;
    /// A scan begins by forgetting what the one before has noted in it, so it is no state; a copy
    /// for each scan, of all memory, takes a fifth of the time of a check.
    mutable s7::Machine machine_;
    s7::MachineState blank_;
    std::vector<std::uint8_t> alive_;          ///< a mask per byte of memory
    std::vector<std::size_t> alive_bytes_;     ///< those whose mask is not 0
    std::vector<std::uint32_t> input_of_bit_;  ///< of the GRAFCET, per bit of the image
};

}  // namespace grafwire
