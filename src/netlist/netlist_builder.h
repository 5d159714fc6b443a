#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// The modules of a netlist that is being made, in the order in which they were added.
enum class ModuleId : std::uint32_t {};

/// Where a cell belongs: its module, and what it is made for (a number in Netlist::origins).
struct CellPlace {
    CellPlace(ModuleId in_module, std::uint32_t made_for) : module(in_module), origin(made_for) {}

    ModuleId module;
    std::uint32_t origin;
};

/// How the nets between the cells get their names.
enum class InnerNames {
    /// `owner$role`. Only reserved names are looked up; that no pair of owner and role comes twice
    /// is the caller's part, so that no table of ten million names has to be kept.
    by_role,
    /// `owner$role`, with further `$` where any other net has that name.
    by_unused_role,
    /// `owner$1`, `owner$2`, …, given by finish() when all other names are known.
    by_number,
};

/// What a cell has beyond its pins.
struct CellDetails {
    Logic initial = Logic::unknown;
    Timing timing;  ///< of types that have one
};

/// Puts a netlist together cell by cell: the one way in which netlists are made, from a GRAFCET,
/// from a file or from another netlist. Cells may be added to any module at any time; finish()
/// brings those of a module together. That every net is driven once is the caller's part.
class NetlistBuilder {
  public:
    NetlistBuilder(std::string name, InnerNames inner_names);
    /// Goes on from a netlist of which everything stays but the cells and modules, for a pass that
    /// adds them again or puts others in their place. Names are found by_unused_role.
    static NetlistBuilder without_cells_of(const Netlist& netlist);

    /// Makes room for a number of cells, each of some 4 pins and 24 characters.
    void reserve(std::size_t cells);
    /// Keeps a name from being given to an inner net.
    void reserve_name(std::string_view name);

    ModuleId add_module(std::string name, std::string comment = {});
    std::uint32_t add_origin(Origin::Kind kind, std::string name, Location where);

    /// A net under exactly this name.
    NetId add_net(std::string_view name);
    /// The net of that name, made when it is first asked for, and whether it is new. Not with
    /// InnerNames::by_role, where names are not kept.
    std::pair<NetId, bool> net_named(std::string_view name);
    /// The net of that name, no_net if there is none; likewise.
    NetId find_net(std::string_view name) const;
    /// An inner net named after another net (no_net: after none) and the part it plays there.
    NetId add_inner_net(NetId owner, std::string_view role);
    /// An inner net named after anything else. Not with InnerNames::by_number.
    NetId add_inner_net(std::string_view owner, std::string_view role);
    /// Its name; empty while finish() is still to give it one.
    std::string_view name_of(NetId net) const { return netlist_.names[net]; }

    void add_input(std::string name, NetId net) {
        netlist_.inputs.push_back({std::move(name), net});
    }
    void add_output(std::string name, NetId net) {
        netlist_.outputs.push_back({std::move(name), net});
    }
    void add_var(Observed var) { netlist_.vars.push_back(std::move(var)); }
    void add_counter(Observed counter) { netlist_.counters.push_back(std::move(counter)); }
    /// The value at power-up of a net that gates drive.
    void set_initial(NetId net, bool value) { netlist_.initial_values.push_back({net, value}); }

    CellId add_cell(CellPlace place, CellType type, NetId output, std::span<const NetId> pins,
                    const CellDetails& details);
    CellId add_cell(CellPlace place, CellType type, NetId output, std::span<const NetId> pins) {
        return add_cell(place, type, output, pins, CellDetails());
    }
    /// A cell of the netlist gone on from (without_cells_of), as it is.
    void copy_cell(ModuleId module, const Netlist& source, const Cell& cell);
    /// Drives an existing net by a gate; a gate of one pin becomes a buffer or an inverter.
    void drive(CellPlace place, NetId output, CellType type, std::span<const NetId> pins);
    /// The same with an inner net of its own.
    NetId gate(CellPlace place, CellType type, std::span<const NetId> pins, std::string_view owner,
               std::string_view role);

    // What many gates want is made once, in the module and for the origin of who asks first.

    /// The complement of a net; a constant for a constant, and the net itself for its complement.
    NetId inverted(CellPlace place, NetId net);
    /// The net behind `levels` buffers; a constant as it is.
    NetId delayed(CellPlace place, NetId net, std::uint32_t levels);
    /// The net that is always 0 or 1.
    NetId constant(CellPlace place, bool value);
    bool is_constant(NetId net, bool value) const {
        return net != no_net && net == constants_[value ? 1 : 0];
    }

    /// As far as it has been made; cells in the order in which they came.
    const Netlist& netlist() const { return netlist_; }

    /// The netlist. What the builder does not ask for (modes, clock, number of steps) is the
    /// caller's to fill in.
    Netlist finish();

  private:
    struct Companion {
        NetId inverted = no_net;
        NetId delayed = no_net;
    };
    struct UnnamedNet {
        NetId net = no_net;
        NetId owner = no_net;
    };
    bool keeps_names() const { return inner_names_ != InnerNames::by_role; }
    void name_unnamed_nets();
    /// Brings the cells of each module together.
    void sort_cells();
    Companion& companion(NetId net);

    Netlist netlist_;
    InnerNames inner_names_;
    std::vector<std::uint32_t> cell_modules_;
    std::vector<Companion> companions_;
    /// All names (by_role: the reserved ones) and their nets; no_net for a name that is kept free.
    std::unordered_map<std::string, NetId> nets_by_name_;
    std::vector<UnnamedNet> unnamed_;
    std::string scratch_;
    NetId constants_[2] = {no_net, no_net};
};

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
