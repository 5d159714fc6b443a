#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "formats/yosys/yosys_cells.h"

namespace grafwire {

/// Takes one cell of a Yosys netlist apart into gates. Every function gives the reason where the
/// cell cannot be used, else nothing.
class YosysCellReader {
  public:
    YosysCellReader(NetlistAssembly& assembly, const YosysCell& cell, Logic initial)
        : assembly_(assembly), cell_(cell), initial_(initial) {}

    std::string add();

  private:
    // yosys_gates.cpp
    struct GateRow;
    static const GateRow* gate_row(std::string_view type);
    std::string add_gate(const GateRow& row);
    std::string add_comparison(bool is_equal);
    std::string add_logic_and();
    std::string add_mux(bool inverts);
    std::string add_and_or(std::string_view inner_ports, bool or_first);
    std::string add_lut();

    // yosys_memories.cpp
    std::string add_flip_flop();
    std::string add_word_flip_flop();
    std::string add_latch(bool enable_is_high);
    std::string add_set_reset(bool set_is_high, bool reset_is_high);

    // yosys_cells.cpp
    std::string add_helper(CellType type);
    /// The net of a one-bit port; no_net, with `fault_` set, where it has another width.
    NetId bit(std::string_view port);
    NetId bit(std::string_view port, bool is_high);
    std::vector<NetId> word(std::string_view port);
    NetId make(CellType type, std::vector<NetId> pins) {
        return assembly_.gate(type, pins, output_, cell_.where);
    }
    void drive(CellType type, const std::vector<NetId>& pins) {
        assembly_.add_cell(type, output_, pins, cell_.where, {initial_, {}});
    }
    bool is_positive(std::string_view parameter) const {
        return cell_.parameter(parameter).ends_with('1');
    }

    NetlistAssembly& assembly_;
    const YosysCell& cell_;
    Logic initial_;
    NetId output_ = no_net;
    std::string fault_;
};

}  // namespace grafwire
