#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// The part that an inner net plays, as its name says: `set0` of `X7$set0`. A name may say several,
/// `c$value$a3`; the owner stands in front of all.
struct NetRole {
    /// What may stand behind the name.
    enum class Tail { nothing, number, transition };
    std::string_view name;  ///< `set`; empty where there is a number only
    Tail tail = Tail::nothing;
    std::string_view meaning;  ///< in English, as netlist files are
};

/// The role that a part of a name says, by `owner`, what stands before it; nullptr if it says none.
const NetRole* role_of(std::string_view owner, std::string_view part);

/// What the roles mean that occur in a netlist made of a GRAFCET, a line each; empty where there
/// are none.
std::vector<std::string> legend_of_roles(const Netlist& netlist);

}  // namespace grafwire
