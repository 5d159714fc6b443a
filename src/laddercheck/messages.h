#pragma once

#include <cstdint>
#include <string>

#include "text/message.h"

namespace grafwire::messages::laddercheck {

inline constexpr Message<> the_ladder_diagram{"the ladder diagram", "le schéma à contacts"};
inline constexpr Message<std::string> no_network_has_written{
    "  no network has written {} in this scan\n",
    "  aucun réseau n'a écrit {} dans cette scrutation\n"};
inline constexpr Message<std::string, std::uint32_t> was_last_written{
    "  {} was last written in network {}\n", "  {} a été écrit en dernier dans le réseau {}\n"};
inline constexpr Message<> networks_that_decide{
    "The networks that decide it, in this scan:\n",
    "Les réseaux qui en décident, dans cette scrutation :\n"};
/// Argument: the network, with its comment and line.
inline constexpr Message<std::string> power_passes{"  {}: power reaches its end\n",
                                                   "  {} : le courant passe\n"};
inline constexpr Message<std::string> power_does_not_pass{"  {}: power does not reach its end\n",
                                                          "  {} : le courant ne passe pas\n"};

}  // namespace grafwire::messages::laddercheck
