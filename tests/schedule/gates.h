#pragma once

#include "support/small_netlist.h"

namespace grafwire::testing {

/// Inputs a and b, the gates X1$set, X1$q, "two words" and été, and the pulse cell a$rise.
inline Netlist some_gates() {
    SmallNetlist small;
    small.input("a");
    small.input("b");
    small.timed(CellType::rise_pulse, "a$rise", {"a"}, {0, 3 * nanosecond, 0});
    small.cell(CellType::nand_gate, "X1$set", {"a$rise", "b"});
    small.cell(CellType::nand_gate, "X1$q", {"X1$set", "a"});
    small.cell(CellType::buffer, "two words", {"X1$q"});
    small.cell(CellType::inverter, "été", {"two words"});
    small.netlist.modules.push_back({"all", "", 0, 5});
    return small.netlist;
}

}  // namespace grafwire::testing
