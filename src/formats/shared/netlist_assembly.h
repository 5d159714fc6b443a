#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "netlist/netlist_builder.h"
#include "text/diagnostics.h"

namespace grafwire {

/// A NetlistBuilder for what stands in a file: nets come into being when first mentioned, cells
/// know their places, and finish() tells whether the whole is a netlist. Errors go into
/// `diagnostics` with their places as they are found.
class NetlistAssembly {
  public:
    explicit NetlistAssembly(Diagnostics& diagnostics);

    /// The net of that name; `where` is kept as the place of its first mention.
    NetId net(std::string_view name, Location where);
    /// A further net, which the file gives no name. It is named after `owner` (which may be no_net)
    /// once all names of the file are known.
    NetId inner_net(NetId owner, Location where);

    void add_input(std::string_view name, NetId net, Location where);
    void add_output(std::string_view name, NetId net, Location where);
    /// Whether a net of that name is an input of the netlist.
    bool is_input(std::string_view name) const;

    void add_cell(CellType type, NetId output, std::span<const NetId> pins, Location where,
                  const CellDetails& details);
    void add_cell(CellType type, NetId output, std::span<const NetId> pins, Location where) {
        add_cell(type, output, pins, where, CellDetails());
    }
    /// The net of a gate of its own, for a cell of the file that has been taken apart.
    NetId gate(CellType type, std::span<const NetId> pins, NetId owner, Location where);
    /// The complement of a net, made once.
    NetId inverted(NetId net, Location where) { return builder_.inverted(place(where), net); }
    /// A net that is always 0 or 1.
    NetId constant(bool value, Location where) { return builder_.constant(place(where), value); }

    void set_initial(NetId net, bool value) { builder_.set_initial(net, value); }

    /// Reports a name, of the netlist itself say, that no netlist may hold; those of nets and ports
    /// are looked at as they come.
    void check_name(std::string_view name, Location where);

    /// The netlist: one module, the clock found by the flip-flops. What keeps it from being one (a
    /// net without driver or with two, flip-flops on different clocks) is reported, and the result
    /// is empty then.
    std::optional<Netlist> finish(std::string name);

  private:
    /// What a netlist does not keep of a net in the file.
    struct FileNet {
        bool is_of_file = false;  ///< and none that the builder has made by itself
        Location where;
        Location driver;
        bool is_driven = false;
        bool is_input = false;
    };
    CellPlace place(Location where);
    void add_file_net(NetId net, Location where);
    void check_port(std::string_view name, NetId net, Location where);
    void drive(NetId net, Location where);
    void check_drivers(const Netlist& netlist);
    void find_clock(Netlist& netlist);

    Diagnostics& diagnostics_;
    NetlistBuilder builder_;
    ModuleId module_;
    std::vector<FileNet> nets_;  ///< per net, up to the last of the file
    std::unordered_set<std::string> output_names_;
};

}  // namespace grafwire
