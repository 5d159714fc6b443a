#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "text/message.h"

namespace grafwire {

/// How the ports of a netlist fit the names of a GRAFCET.
struct PortComparison {
    std::vector<std::string> missing_inputs;
    std::vector<std::string> missing_outputs;  ///< X variables and outputs
    std::vector<std::string> extra_inputs;
    std::vector<std::string> extra_outputs;
    /// Timer cells that do not say which time condition of the GRAFCET they stand for, or a wrong
    /// one.
    std::vector<std::string> unrelated_timers;

    /// Whether a comparison is possible: all X and outputs are there, and all timers are related.
    bool can_compare() const { return missing_outputs.empty() && unrelated_timers.empty(); }
    bool fits() const {
        return can_compare() && missing_inputs.empty() && extra_inputs.empty() &&
               extra_outputs.empty();
    }
};

/// Init, AUdur and AUdoux count as missing only where some of them are there.
PortComparison compare_ports(const Grafcet& grafcet, const Netlist& netlist);

/// The table of what is missing or extra; empty where everything fits.
std::string write_port_table(const PortComparison& comparison, Language language);

/// Settles what a netlist from elsewhere leaves open: whether it has the control inputs, and that
/// its first outputs are the X of the steps, in their order. Only where can_compare().
void adopt_ports(const Grafcet& grafcet, Netlist& netlist);

}  // namespace grafwire
