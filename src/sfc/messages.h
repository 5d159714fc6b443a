#pragma once

#include <cstddef>
#include <string>

#include "text/message.h"

namespace grafwire::messages::sfc {

// Remarks: what the chart is, and where SFC differs from it.
inline constexpr Message<> exact{
    "This chart does without Init, AUdur and AUdoux; otherwise it is the GRAFCET, scan for scan. "
    "The ladder diagram (--to plcopen) is the whole GRAFCET.",
    "Ce SFC se passe de Init, AUdur et AUdoux ; pour le reste, il est le GRAFCET, scrutation par "
    "scrutation. Le schéma à contacts (--to plcopen) est le GRAFCET complet."};
inline constexpr Message<> almost_exact{
    "The ladder diagram (--to plcopen) is the whole GRAFCET. This chart does without Init, AUdur "
    "and AUdoux; otherwise it is the GRAFCET, scan for scan, but for what SFC cannot say:",
    "Le schéma à contacts (--to plcopen) est le GRAFCET complet. Ce SFC se passe de Init, AUdur et "
    "AUdoux ; pour le reste, il est le GRAFCET, scrutation par scrutation, sauf ce que le SFC ne "
    "sait pas dire :"};
inline constexpr Message<std::string> observer_comes_last{
    "The action of step {} is to be executed after all others of the scan, as it stands in this "
    "file: it prepares edges and time conditions for the next scan and assigns outputs.",
    "L'action de l'étape {} doit s'exécuter après toutes les autres de la scrutation, comme dans "
    "ce fichier : elle prépare les fronts et les temporisations de la scrutation suivante et "
    "affecte les sorties."};
inline constexpr Message<std::string, std::string> gives_order{"step {} gives the order {}",
                                                               "l'étape {} donne l'ordre {}"};
inline constexpr Message<std::string, std::string> encloses{"step {} encloses {}",
                                                            "l'étape {} encapsule {}"};
inline constexpr Message<std::string, std::string> on_clearing{
    "transition {}: {} on clearing", "transition {} : {} au franchissement"};
inline constexpr Message<std::string, std::string> clears_leftmost{
    "step {}: where several of the transitions {} can be cleared at once, a GRAFCET clears them "
    "all (rule 4), SFC the leftmost",
    "étape {} : quand plusieurs des transitions {} sont franchissables à la fois, un GRAFCET les "
    "franchit toutes (règle 4), un SFC celle de gauche"};
inline constexpr Message<std::string, Localized> last_write_wins{
    "{} can be written by several actions in one scan ({}): the last one wins, and SFC leaves "
    "their "
    "order open",
    "{} peut être écrit par plusieurs actions dans une scrutation ({}) : la dernière l'emporte, et "
    "le SFC ne fixe pas leur ordre"};
inline constexpr Message<Localized, Localized> and_also{"{}; {}", "{} ; {}"};
inline constexpr Message<std::string> on_activation{"step {} on activation",
                                                    "étape {} à l'activation"};
inline constexpr Message<std::string> on_deactivation{"step {} on deactivation",
                                                      "étape {} à la désactivation"};
inline constexpr Message<std::string, std::string> on_event{"step {} on {}", "étape {} sur {}"};
inline constexpr CountedMessage<std::string> initial_step_count{
    {"graph {1} has {0} initial step here; many tools ask for exactly one",
     "le grafcet partiel {1} a ici {0} étape initiale ; beaucoup d'outils en demandent exactement "
     "une"},
    {"graph {1} has {0} initial steps here; many tools ask for exactly one",
     "le grafcet partiel {1} a ici {0} étapes initiales ; beaucoup d'outils en demandent "
     "exactement une"}};

// Beside steps and transitions, and comments within actions.
inline constexpr Message<std::string> not_reached{"no initial step leads to {}",
                                                  "aucune étape initiale ne mène à {}"};
inline constexpr Message<> deferred_actions{"Stored actions that read the situation",
                                            "Actions mémorisées qui lisent la situation"};
inline constexpr Message<std::string, std::string> assigned_elsewhere{"{}: assigned by {}",
                                                                      "{} : affecté par {}"};
inline constexpr Message<std::string, std::string, std::string> assigned_elsewhere_if{
    "{} if {}: assigned by {}", "{} si {} : affecté par {}"};
inline constexpr Message<> times_for_next_scan{
    "Time conditions, as the next scan sees them",
    "Temporisations, telles que les verra la scrutation suivante"};
inline constexpr Message<> outputs_with_conditions{"Outputs with conditions",
                                                   "Sorties conditionnelles"};
inline constexpr Message<> compared_next{"What the next scan compares with",
                                         "Ce à quoi la scrutation suivante compare"};

}  // namespace grafwire::messages::sfc
