#pragma once

#include <cstdint>
#include <string>

#include "text/message.h"

namespace grafwire::messages::s7check {

inline constexpr Message<> the_listing{"the listing", "la liste d'instructions"};
/// Arguments: the number of the network, the line, the error.
inline constexpr Message<std::uint32_t, std::uint32_t, Localized> listing_stops{
    "The listing stops (network {}, line {}): {}\n",
    "La liste d'instructions s'arrête (réseau {}, ligne {}) : {}\n"};

inline constexpr Message<> where_it_comes_from{"Where it comes from in the listing:\n",
                                               "D'où cela vient dans la liste d'instructions :\n"};
/// Arguments: the bit, its place, its value, the time, the value it should have.
inline constexpr Message<std::string, std::string, int, std::string, int> bit_is_wrong{
    "  {} ({}) is {} after the scan at {} ms, and should be {}\n",
    "  {} ({}) vaut {} après la scrutation à {} ms, et devrait valoir {}\n"};

// What the bit is.
inline constexpr Message<std::string> of_transition{"Tt of transition ({})",
                                                    "Tt de la transition ({})"};
inline constexpr Message<> the_timer{"the timer", "la temporisation"};
/// Arguments: the table, the step.
inline constexpr Message<std::string, std::string> of_step{"{} of {}", "{} de {}"};
inline constexpr Message<std::string> of_graph{"Tfig of graph {}", "Tfig du grafcet partiel {}"};

// The networks in question.
inline constexpr Message<> no_network_writes{"  no network writes it\n",
                                             "  aucun réseau ne l'écrit\n"};
inline constexpr Message<std::string> was_written_by{"  it was written by: {}\n",
                                                     "  l'a écrit : {}\n"};
inline constexpr Message<std::string> should_have_been_written_by{
    "  it should have been written by: {}\n", "  aurait dû l'écrire : {}\n"};
/// Arguments: the network that read, the place, its value, and the network that had written it.
inline constexpr Message<std::uint32_t, std::string, std::int32_t, std::uint32_t> network_reads{
    "  network {} reads {} = {}, written by network {}\n",
    "  réseau {} lit {} = {}, écrit par le réseau {}\n"};
inline constexpr Message<std::uint32_t, std::string, std::int32_t> network_reads_unwritten{
    "  network {} reads {} = {}, which nobody has written\n",
    "  réseau {} lit {} = {}, que personne n'a écrit\n"};
/// Counted: the networks. Argument: their numbers.
inline constexpr CountedMessage<std::string> look_at_networks{
    {"  if it is right, look at network {1}\n", "  s'il est juste, voir le réseau {1}\n"},
    {"  if it is right, look at networks {1}\n", "  s'il est juste, voir les réseaux {1}\n"}};
inline constexpr Message<> the_instructions{"The instructions:\n", "Les instructions :\n"};

}  // namespace grafwire::messages::s7check
