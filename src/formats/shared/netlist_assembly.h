#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "netlist/netlist.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Puts together a netlist read from a file: nets come into being when first mentioned, and
/// finish() tells whether the whole is a netlist.
class NetlistAssembly {
  public:
    NetlistAssembly(std::string name, Diagnostics& diagnostics);

    /// The net of that name; `where` is kept as the place of its first mention.
    NetId net(std::string_view name, Location where);
    /// A further net, for a gate that a cell of the file has been taken apart into or for one that
    /// the file gives no name. It is named after `owner` (which may be no_net) once all names of
    /// the file are known.
    NetId inner_net(NetId owner);

    void add_input(std::string_view name, NetId net, Location where);
    void add_output(std::string_view name, NetId net, Location where);
    /// Whether a net of that name is an input of the netlist.
    bool is_input(std::string_view name) const;

    /// What a cell has beyond its pins.
    struct Details {
        Logic initial = Logic::unknown;
        Timing timing;
    };
    void add_cell(CellType type, NetId output, std::span<const NetId> pins, Location where,
                  const Details& details);
    void add_cell(CellType type, NetId output, std::span<const NetId> pins, Location where) {
        add_cell(type, output, pins, where, Details());
    }
    /// The complement of a net, through an inverter that is made once.
    NetId inverted(NetId net, Location where);
    /// A net that is always 0 or 1.
    NetId constant(bool value, Location where);
    /// The net of a gate of its own.
    NetId gate(CellType type, std::span<const NetId> pins, NetId owner, Location where);

    void set_initial(NetId net, bool value);
    std::string_view name_of(NetId net) const;

    /// Reports a name, of the netlist itself say, that no netlist may hold; those of nets and ports
    /// are looked at as they come.
    void check_name(std::string_view name, Location where);

    /// The netlist: one module, the clock found by the flip-flops. What keeps it from being one (a
    /// net without driver or with two, flip-flops on different clocks) is reported, and the result
    /// is empty then.
    std::optional<Netlist> finish();

  private:
    struct Net {
        std::string name;      ///< empty: an inner net
        NetId owner = no_net;  ///< of an inner net
        Location where;
        NetId inverted = no_net;
        bool is_driven = false;
        bool is_input = false;
        Location driver;
    };
    void check_port(std::string_view name, NetId net, Location where);
    void drive(NetId net, Location where);
    void name_inner_nets();
    void check_drivers();
    void find_clock();
    void set_origins();

    Diagnostics& diagnostics_;
    Netlist netlist_;
    std::vector<Net> nets_;
    std::vector<Location> cell_places_;
    std::unordered_map<std::string, NetId> by_name_;
    std::unordered_set<std::string> output_names_;
    NetId constants_[2] = {no_net, no_net};
};

/// Undoes what the writers do to characters that a format cannot hold in a name: `%20` and so on.
/// Other percent signs stay.
std::string decoded_name(std::string_view name);

/// The type behind a cell named `grafwire_latch`, `grafwire_timer`, …
std::optional<CellType> helper_type_named(std::string_view name);

/// The names of the input pins of such a cell, in the order of its pins; the output is `q`.
std::span<const std::string_view> helper_pin_names(CellType type);

/// Sets what a parameter of such a cell says: INIT (0, 1 or x), RISE and FALL (durations), ORDINAL.
/// Returns whether there is such a parameter and the value fits it.
bool set_helper_parameter(NetlistAssembly::Details& details, std::string_view name,
                          std::string_view value);

}  // namespace grafwire
