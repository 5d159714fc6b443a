#pragma once

#include <functional>
#include <string>
#include <vector>

#include "check/scanned_device.h"
#include "support/naive_evolution.h"

namespace grafwire::testing {

/// The plain evolution as a device that is executed scan by scan, right or with a fault built in.
/// Which open inputs it needs it finds out by trying all their values.
class NaiveDevice : public ScannedDevice {
  public:
    /// Spoils the values that a scan shows. `extra` is a memory for the fault's own use, empty at
    /// first.
    using Fault = std::function<void(const NaiveState& state, const InputValues& inputs,
                                     Outcome& shown, std::string& extra)>;

    explicit NaiveDevice(const Grafcet& grafcet, Fault fault = {}, bool has_modes = true)
        : grafcet_(grafcet), evolution_(grafcet), fault_(std::move(fault)), has_modes_(has_modes) {}

    std::string start() const override { return {}; }
    Outcome scan(const std::string& memory, const PartialInputs& inputs, Time now) const override;
    std::string key(const std::string& memory, Time now) const override;
    std::vector<Time> delays() const override { return {}; }
    bool has_modes() const override { return has_modes_; }

  private:
    Outcome scan_assigned(const std::string& memory, const InputValues& inputs, Time now) const;
    std::string packed(const NaiveState& state, const std::string& extra) const;
    NaiveState unpacked(const std::string& memory, std::string& extra) const;

    const Grafcet& grafcet_;
    NaiveEvolution evolution_;
    Fault fault_;
    bool has_modes_;
};

}  // namespace grafwire::testing
