#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire::testing {

/// A netlist written by hand, nets by their names; a name stands for its net from its first use.
class NetlistMaker {
  public:
    explicit NetlistMaker(std::string name);

    NetId net(std::string_view name);
    NetlistMaker& input(std::string_view name);
    NetlistMaker& output(std::string_view name);
    NetlistMaker& module(std::string name, std::string comment = {});
    NetlistMaker& cell(CellType type, std::string_view output, const std::vector<std::string>& pins,
                       Logic initial = Logic::unknown, Timing timing = {});
    NetlistMaker& starts_at(std::string_view name, bool value);
    Netlist make();

  private:
    Netlist netlist_;
    std::unordered_map<std::string, NetId> nets_;
};

/// The single sequence 0 -a-> 1 -b-> 2 -c-> 0 in NAND latches, with Init.
Netlist nand_sequencer();

/// One cell of every type an asynchronous netlist may have.
Netlist all_asynchronous_cells();

/// A flip-flop that toggles while `a` is 1, and a clocked timer of 30 ms, 10 ms.
Netlist clocked_sample();

/// A latch of two NAND gates without modes, which starts at 1.
Netlist latch_without_modes();

/// Inverters from inputs to outputs with names that file formats have trouble with.
Netlist odd_names();
/// The names of its inputs; the output for an input is called the same with `!` before it.
const std::vector<std::string>& odd_input_names();

/// A ring of so many steps, each a latch of two NAND gates; `a` lets the token go on.
Netlist nand_ring(std::size_t steps);

}  // namespace grafwire::testing
