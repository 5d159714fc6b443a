#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "netlist/netlist_builder.h"

namespace grafwire {

/// Makes gates at one place of a netlist, with names that begin with one owner. It is handed on to
/// whatever makes gates, so that no builder has to remember where it is at work.
class GateMaker {
  public:
    using Pins = std::initializer_list<NetId>;

    GateMaker(NetlistBuilder& builder, CellPlace place, std::string owner)
        : builder_(&builder), place_(place), owner_(std::move(owner)) {}

    /// The same in the same module, for another origin or under another name.
    GateMaker made_for(std::uint32_t origin) const {
        return {*builder_, {place_.module, origin}, owner_};
    }
    GateMaker named(std::string owner) const { return {*builder_, place_, std::move(owner)}; }

    NetlistBuilder& builder() const { return *builder_; }
    CellPlace place() const { return place_; }
    const std::string& owner() const { return owner_; }

    NetId add_net(std::string_view role) const { return builder_->add_inner_net(owner_, role); }
    void add_cell(CellType type, NetId output, std::span<const NetId> pins,
                  const CellDetails& details = CellDetails()) const {
        builder_->add_cell(place_, type, output, pins, details);
    }
    /// Drives an existing net by a gate; a gate of one pin becomes a buffer or an inverter.
    void drive(NetId output, CellType type, std::span<const NetId> pins) const {
        builder_->drive(place_, output, type, pins);
    }
    NetId gate(CellType type, std::span<const NetId> pins, std::string_view role) const {
        return builder_->gate(place_, type, pins, owner_, role);
    }
    NetId gate(CellType type, Pins pins, std::string_view role) const {
        return gate(type, std::span(pins.begin(), pins.size()), role);
    }
    /// The AND or OR of the nets; of a single one the net itself.
    NetId joined(CellType type, std::span<const NetId> nets, std::string_view role) const {
        return nets.size() == 1 ? nets[0] : gate(type, nets, role);
    }

    NetId inverted(NetId net) const { return builder_->inverted(place_, net); }
    NetId delayed(NetId net, std::uint32_t levels) const {
        return builder_->delayed(place_, net, levels);
    }
    NetId low() const { return builder_->constant(place_, false); }
    NetId high() const { return builder_->constant(place_, true); }
    bool is_low(NetId net) const { return builder_->is_constant(net, false); }
    bool is_high(NetId net) const { return builder_->is_constant(net, true); }

  private:
    NetlistBuilder* builder_;
    CellPlace place_;
    std::string owner_;
};

}  // namespace grafwire
