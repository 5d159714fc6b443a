#pragma once

#include <string>

#include "text/message.h"

namespace grafwire::messages::ladder {

inline constexpr Message<> sum_too_wide{
    "a sum here can exceed 64 bits, which no ladder diagram holds; use counters of smaller ranges",
    "une somme peut ici dépasser 64 bits, ce qu'aucun schéma à contacts ne contient ; prenez des "
    "compteurs à plages plus petites"};

// Remarks at the head of a diagram.
inline constexpr Message<> how_it_runs{
    "Executed from top to bottom, once a scan. The transitions (T...) are worked out first; then "
    "every step (X...) is reset by those out of it and set by those into it.",
    "Exécution de haut en bas, une fois par scrutation. Les transitions (T...) sont évaluées "
    "d'abord ; chaque étape (X...) est ensuite mise à 0 par celles qui en partent, puis mise à 1 "
    "par celles qui y mènent."};
inline constexpr Message<> modes{
    "Inputs of the modes: Init = 1 holds the initial situation, AUdur = 1 deactivates every step, "
    "AUdoux = 1 switches off every continuous output.",
    "Entrées des modes de marche : Init = 1 maintient la situation initiale, AUdur = 1 désactive "
    "toutes les étapes, AUdoux = 1 met à 0 toutes les sorties continues."};

// Headings of the parts of a diagram.
inline constexpr Message<> first_scan{"First scan: the initial situation",
                                      "Première scrutation : situation initiale"};
inline constexpr Message<> situation_before{"Situation at the start of the scan",
                                            "Situation en début de scrutation"};
inline constexpr Message<> edges{"Edges", "Fronts"};
inline constexpr Message<> transitions{"Transitions that are cleared", "Transitions franchies"};
inline constexpr Message<> steps{"Steps: CDX resets, CAX sets",
                                 "Étapes : CDX met à 0, CAX met à 1"};
inline constexpr Message<> orders{"Forcing, enclosures, emergency stop",
                                  "Forçages, encapsulations, arrêt d'urgence"};
inline constexpr Message<> stored_actions{"Stored actions", "Actions mémorisées"};
inline constexpr Message<> times{"Time conditions", "Temporisations"};
inline constexpr Message<> outputs{"Outputs", "Sorties"};

// What rungs are for.
inline constexpr Message<> first_scan_over{"the first scan is over",
                                           "la première scrutation est passée"};
inline constexpr Message<std::string> step_before{"step {} before the scan",
                                                  "étape {} avant la scrutation"};
inline constexpr Message<std::string> just_activated{"step {} has just been activated",
                                                     "l'étape {} vient d'être activée"};
inline constexpr Message<std::string> activation{"step {} is activated",
                                                 "activation de l'étape {}"};
inline constexpr Message<std::string> deactivation{"step {} is deactivated",
                                                   "désactivation de l'étape {}"};
inline constexpr Message<> forced_off{"forcing orders: to the empty situation",
                                      "ordres de forçage : à la situation vide"};
inline constexpr Message<> forced_on{"forcing orders: steps that are to be active",
                                     "ordres de forçage : étapes à activer"};
inline constexpr Message<Localized> part_of{"part of {}", "partie de {}"};

// What variables are.
inline constexpr Message<std::string> step{"step {}", "étape {}"};
inline constexpr Message<std::string> initial_step{"initial step {}", "étape initiale {}"};
inline constexpr Message<> started{"0 in the first scan only",
                                   "0 à la première scrutation seulement"};

}  // namespace grafwire::messages::ladder
