#pragma once

#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire::playground::say {

inline constexpr Message<> bad_request{"the request is no object in JSON",
                                       "la requête n'est pas un objet JSON"};
inline constexpr Message<std::string> unknown_request{"there is no request {}",
                                                      "il n'y a pas de requête {}"};
inline constexpr Message<std::string> wrong_type{"{}: the argument is of another type",
                                                 "{} : l'argument est d'un autre type"};
inline constexpr Message<std::string_view, std::string> unknown_value{"{}: there is no {}",
                                                                      "{} : il n'y a pas de {}"};
inline constexpr Message<> bad_chart{"the GRAFCET has errors", "le GRAFCET a des erreurs"};
inline constexpr Message<> bad_stimuli{"the stimuli have errors", "les stimuli ont des erreurs"};
inline constexpr Message<> bad_assumption{"the assumption has errors", "l'hypothèse a des erreurs"};
inline constexpr Message<> bad_netlist{"the netlist has errors", "la netlist a des erreurs"};
inline constexpr Message<> bad_assignment{"the assignment has errors",
                                          "l'affectation a des erreurs"};
inline constexpr Message<std::string> no_duration{"{}: this is no duration such as 10ms",
                                                  "{} : ce n'est pas une durée comme 10ms"};
inline constexpr Message<std::string> no_situation_at{"there is no stable situation at {}",
                                                      "il n'y a pas de situation stable à {}"};
inline constexpr Message<std::string> no_netlist_file{
    "{}: no netlist that can be read", "{} : ce n'est pas une netlist que l'on sait lire"};
inline constexpr Message<> ports_do_not_fit{
    "the netlist lacks steps or outputs of the GRAFCET",
    "il manque à la netlist des étapes ou des sorties du GRAFCET"};

// What exports are.

inline constexpr Message<> canonical_text{"the text of the GRAFCET in its canonical layout",
                                          "le texte du GRAFCET dans sa présentation canonique"};
inline constexpr Message<> waveform{"a waveform of inputs, steps and outputs",
                                    "un chronogramme VCD des entrées, étapes et sorties"};
inline constexpr Message<> gate_waveform{"a waveform of every net",
                                         "un chronogramme VCD de tous les fils"};
inline constexpr Message<> story{"the run in words", "l'exécution racontée"};
inline constexpr Message<> gate_story{"what the gates do, in words",
                                      "ce que font les portes, raconté"};

// Runs.

inline constexpr Message<> unknown_run{"this run is not open", "cette exécution n'est pas ouverte"};
inline constexpr Message<std::string> unknown_input{"there is no input {}",
                                                    "il n'y a pas d'entrée {}"};
inline constexpr Message<> no_way_on{"there is no stable situation any more: go back",
                                     "il n'y a plus de situation stable : revenez en arrière"};
inline constexpr Message<> gates_do_not_settle{
    "the gates do not settle any more: go back",
    "les portes ne se stabilisent plus : revenez en arrière"};
inline constexpr Message<> time_goes_on{"time does not go back: use back",
                                        "le temps ne recule pas : utilisez le retour"};
inline constexpr Message<> instant_is_over{
    "this instant is over: let time pass first",
    "cet instant est passé : laissez d'abord passer du temps"};
inline constexpr Message<> no_delay_runs{"no delay is running",
                                         "aucune temporisation n'est en cours"};
inline constexpr Message<> nothing_to_take_back{"there is nothing to take back",
                                                "il n'y a rien à annuler"};
inline constexpr Message<> too_long_way{
    "there are too many instants on the way: go on in smaller steps",
    "il y a trop d'instants en chemin : avancez par pas plus courts"};

}  // namespace grafwire::playground::say
