#pragma once

#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire {

/// How cells are named to people.
namespace messages::netlist {

// The types of cells.
inline constexpr Message<> constant_0{"constant 0", "constante 0"};
inline constexpr Message<> constant_1{"constant 1", "constante 1"};
inline constexpr Message<> buffer{"buffer", "porte OUI"};
inline constexpr Message<> not_gate{"NOT gate", "porte NON"};
inline constexpr Message<> and_gate{"AND gate", "porte ET"};
inline constexpr Message<> or_gate{"OR gate", "porte OU"};
inline constexpr Message<> nand_gate{"NAND gate", "porte NON-ET"};
inline constexpr Message<> nor_gate{"NOR gate", "porte NON-OU"};
inline constexpr Message<> xor_gate{"XOR gate", "porte OU exclusif"};
inline constexpr Message<> latch{"set-priority latch", "bascule RS"};
inline constexpr Message<> hold_latch{"hold latch", "bascule D à verrouillage"};
inline constexpr Message<> rise_pulse{"rising-edge pulse cell", "cellule de front montant"};
inline constexpr Message<> fall_pulse{"falling-edge pulse cell", "cellule de front descendant"};
inline constexpr Message<> timer{"timer", "temporisateur"};
inline constexpr Message<> flip_flop{"D flip-flop", "bascule D"};
inline constexpr Message<> clocked_timer{"clocked timer", "temporisateur synchrone"};
inline constexpr Message<> clocked_timer_next{"look-ahead of a clocked timer",
                                              "anticipation de temporisateur synchrone"};

// What else is to be said of the figures of a part.
inline constexpr Message<> maximum_is_guessed{
    "no maximum was found: that of the next wider gate",
    "aucun maximum trouvé : celui de la porte plus large"};
inline constexpr Message<> maximum_is_widened{
    "with the maximum of its neighbours, which is the longer one",
    "avec le maximum de ses voisines, plus long"};
inline constexpr Message<> is_not_buffered{"not buffered", "non tamponné"};
inline constexpr Message<> is_not_of_ub_parts{"the UB parts are faster",
                                              "les modèles UB sont plus rapides"};

/// A cell: its type and its net.
inline constexpr Message<std::string_view, std::string_view> cell{"{} {}", "{} {}"};

// A cell with what it was made for.
inline constexpr Message<std::string, std::string> cell_of_input{"{} of input {}",
                                                                 "{} de l'entrée {}"};
inline constexpr Message<std::string, std::string> cell_of_step{"{} of step {}",
                                                                "{} de l'étape {}"};
inline constexpr Message<std::string, std::string> cell_of_transition{"{} of transition {}",
                                                                      "{} de la transition {}"};
inline constexpr Message<std::string, std::string> cell_of_output{"{} of output {}",
                                                                  "{} de la sortie {}"};
inline constexpr Message<std::string, std::string> cell_of_var{"{} of var {}",
                                                               "{} de la variable {}"};
inline constexpr Message<std::string, std::string> cell_of_counter{"{} of counter {}",
                                                                   "{} du compteur {}"};
inline constexpr Message<std::string, std::string> cell_of_graph{"{} of graph {}",
                                                                 "{} du grafcet partiel {}"};
inline constexpr Message<std::string, std::string> cell_of_edge{"{} of edge {}", "{} du front {}"};
inline constexpr Message<std::string, std::string> cell_of_time_condition{
    "{} of time condition {}", "{} de la temporisation {}"};

}  // namespace messages::netlist

}  // namespace grafwire
