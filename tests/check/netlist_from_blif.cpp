#include "netlist_from_blif.h"

#include <doctest/doctest.h>

#include "check/compare_ports.h"
#include "formats/blif/read_blif.h"

namespace grafwire::testing {

Netlist blif(const Grafcet& grafcet, const std::string& text, bool starts_initially) {
    Diagnostics diagnostics;
    auto netlist = read_blif({"test.blif", text}, diagnostics);
    REQUIRE(netlist);
    REQUIRE(compare_ports(grafcet, *netlist).can_compare());
    adopt_ports(grafcet, *netlist);
    netlist->starts_initially = starts_initially;
    return std::move(*netlist);
}

}  // namespace grafwire::testing
