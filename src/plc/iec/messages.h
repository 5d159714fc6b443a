#pragma once

#include <string>

#include "text/message.h"

namespace grafwire::messages::plc_iec {

inline constexpr Message<> sum_too_wide{
    "a sum needs more than the 64 bits of LINT; make the ranges of its counters smaller",
    "une somme demande plus que les 64 bits de LINT ; réduisez les plages de ses compteurs"};

// The head of a function block.
inline constexpr Message<> structured_text{"Structured Text", "texte structuré ST"};
inline constexpr Message<> instruction_list{"Instruction List", "liste d'instructions IL"};
inline constexpr Message<Localized> what_it_is{
    "A GRAFCET (IEC 60848) in {} (IEC 61131-3), by the table method.",
    "GRAFCET (CEI 60848) en {} (CEI 61131-3), par la méthode des tables."};
inline constexpr Message<> how_to_call{
    "Call the block once in every cycle of a task, its inputs and outputs connected.",
    "Appeler le bloc une fois par cycle d'une tâche, entrées et sorties raccordées."};
inline constexpr Message<> modes{
    "Init: initial situation; AUdur: no step active; AUdoux: outputs off, the situation stays.",
    "Init : situation initiale ; AUdur : aucune étape active ; AUdoux : sorties à 0, la situation "
    "est conservée."};
inline constexpr Message<> changed_names{"Names of the chart that the language does not have:",
                                         "Noms du GRAFCET que le langage n'admet pas :"};
inline constexpr Message<std::string, std::string> changed_name{"  {} is {}", "  {} pour {}"};

// Blocks of declarations, and variables.
inline constexpr Message<> places_in_tables{
    "the places of steps, transitions and graphs in the tables",
    "rangs des étapes, transitions et grafcets partiels dans les tables"};
inline constexpr Message<> tables{"the tables", "les tables"};
inline constexpr Message<> steps{"the steps: 1 while active", "étapes : 1 si active"};
inline constexpr Message<> steps_before{"Tp, the steps as the scan began",
                                        "Tp, étapes en début de scrutation"};
inline constexpr Message<> to_activate{"to be activated", "étapes à activer"};
inline constexpr Message<> to_deactivate{"to be deactivated", "étapes à désactiver"};
inline constexpr Message<> just_activated{"activated in this scan",
                                          "étapes activées dans cette scrutation"};
inline constexpr Message<> forced_on{"to be forced to 1", "étapes à forcer à 1"};
inline constexpr Message<> forced_off{"to be forced to 0", "étapes à forcer à 0"};
inline constexpr Message<> transition_conditions{"transition conditions", "réceptivités"};
inline constexpr Message<> graphs{"the graphs: 0 while frozen", "Grafcets partiels : 0 si figé"};
inline constexpr Message<> started{"1 after the first scan", "1 après la première scrutation"};
inline constexpr Message<> runs_through{"runs through the tables", "parcourt les tables"};
inline constexpr Message<> held_values{"edges, time conditions, values held within a scan",
                                       "fronts, temporisations, valeurs gardées le temps d'une "
                                       "scrutation"};

}  // namespace grafwire::messages::plc_iec
