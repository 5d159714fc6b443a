#pragma once

#include <string>
#include <string_view>

#include "netlist/netlist.h"

namespace grafwire {

/// Whether Yosys has no cell for a type, so that a black box stands for it.
bool is_yosys_black_box(CellType type);

/// Writes the cells of a netlist as those of a Yosys JSON file.
class YosysCellWriter {
  public:
    /// `prefix` begins the names of black boxes.
    YosysCellWriter(std::string& out, const Netlist& netlist, std::string_view prefix)
        : out_(out), netlist_(netlist), prefix_(prefix) {}

    /// The object of one cell of a module of the netlist.
    void write(const Cell& cell, const Module& module);

    /// The number of a net in lists of bits; 0 and 1 are kept for constants.
    static std::size_t bit_of(NetId net) { return index_of(net) + 2; }

  private:
    void write_gate(const Cell& cell);
    void write_word(const Cell& cell);
    void write_black_box(const Cell& cell);
    void write_attributes(const Cell& cell);
    void write_bit(NetId net);

    std::string& out_;
    const Netlist& netlist_;
    std::string_view prefix_;
    std::string_view module_;  ///< of the cell being written
};

}  // namespace grafwire
