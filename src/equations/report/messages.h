#pragma once

#include <array>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::equation_report {

// What the reports on equations say: headings, heads of tables, and a remark for every row of the
// truth table of a step. CSV and JSON have none of it.

/// Of a GRAFCET by its name; with the title that it may have.
inline constexpr Message<std::string_view> title{"Equations of {}", "Équations de {}"};
inline constexpr Message<std::string_view, std::string_view> title_in_full{"Equations of {} ({})",
                                                                           "Équations de {} ({})"};

// How they were derived.

inline constexpr Message<> successor_form_with_modes{
    "CDX from the steps that follow (successor form), with Init, AUdur and AUdoux.",
    "CDX d'après les étapes suivantes (forme successeur), avec Init, AUdur et AUdoux."};
inline constexpr Message<> successor_form_without_modes{
    "CDX from the steps that follow (successor form), without Init, AUdur and AUdoux.",
    "CDX d'après les étapes suivantes (forme successeur), sans Init, AUdur ni AUdoux."};
inline constexpr Message<> transition_form_with_modes{
    "CDX from the transitions that are cleared (transition form), with Init, AUdur and AUdoux.",
    "CDX d'après les transitions franchies (forme transition), avec Init, AUdur et AUdoux."};
inline constexpr Message<> transition_form_without_modes{
    "CDX from the transitions that are cleared (transition form), without Init, AUdur and AUdoux.",
    "CDX d'après les transitions franchies (forme transition), sans Init, AUdur ni AUdoux."};

// Transitions and steps.

/// The same in both languages.
inline constexpr Message<> transitions{"Transitions", "Transitions"};
/// The same in both languages.
inline constexpr Message<> transition{"Transition", "Transition"};
inline constexpr Message<> passage{"Steps", "Étapes"};
inline constexpr Message<> transition_condition{"Transition condition", "Réceptivité"};
inline constexpr Message<> clearing_condition{"Clearing condition", "Condition de franchissement"};
inline constexpr Message<> conditions{"Activation and deactivation conditions",
                                      "Conditions d'activation et de désactivation"};
inline constexpr Message<> step{"Step", "Étape"};
inline constexpr Message<> steps{"Equations of the steps", "Équations des étapes"};

// Outputs and variables.

inline constexpr Message<> outputs{"Outputs", "Sorties"};
inline constexpr Message<> held{"Variables held by steps",
                                "Variables internes tenues par des étapes"};
inline constexpr Message<> stored{"Stored outputs and variables",
                                  "Sorties et variables mémorisées"};
/// The same in both languages.
inline constexpr Message<> variable{"Variable", "Variable"};
inline constexpr Message<> set{"Set", "Mise à 1"};
inline constexpr Message<> reset{"Reset", "Mise à 0"};
inline constexpr Message<> counters{"Counters", "Compteurs"};
inline constexpr Message<> counter{"Counter", "Compteur"};
inline constexpr Message<> range{"Range", "Plage"};
inline constexpr Message<> when{"When", "Quand"};
inline constexpr Message<> write{"Write", "Affectation"};

// Time conditions and edges, and what they remember.

inline constexpr Message<> time_conditions{"Time conditions", "Temporisations"};
inline constexpr Message<> time_condition{"Time condition", "Temporisation"};
inline constexpr Message<> operand{"Operand", "Opérande"};
inline constexpr Message<> on_after{"1 after", "1 après"};
inline constexpr Message<> off_after{"0 after", "0 après"};
inline constexpr Message<> edges{"Edges", "Fronts"};
inline constexpr Message<> edge{"Edge", "Front"};

// The truth table and the Karnaugh map of a step.

inline constexpr Message<> karnaugh{"Truth table and Karnaugh map of a step",
                                    "Table de vérité et tableau de Karnaugh d'une étape"};
inline constexpr Message<> same_for_all{"They are the same for every step.",
                                        "Ils sont les mêmes pour toutes les étapes."};
inline constexpr Message<> remark{"Remark", "Remarque"};
inline constexpr Message<> group{"Group", "Groupe"};
inline constexpr Message<> covers{"Product", "Produit"};
inline constexpr Message<> cells{"Cells (X, CAX CDX)", "Cases (X, CAX CDX)"};
inline constexpr Message<> smaller{"Smaller forms", "Formes réduites"};

inline constexpr Message<> stays_inactive{"The step stays inactive (memory effect)",
                                          "L'étape reste inactive (effet mémoire)"};
inline constexpr Message<> stays_inactive_on_cdx{"The step stays inactive",
                                                 "L'étape reste inactive"};
inline constexpr Message<> activation{"Activation of the step", "Activation de l'étape"};
inline constexpr Message<> activation_wins{"Activation AND deactivation = activation",
                                           "Activation ET désactivation = activation"};
inline constexpr Message<> stays_active{"The step stays active (memory effect)",
                                        "L'étape reste active (effet mémoire)"};
inline constexpr Message<> deactivation{"Deactivation of the step", "Désactivation de l'étape"};
inline constexpr Message<> stays_active_on_cax{"The step stays active", "L'étape reste active"};

/// Per row of the truth table of X, in the order of X, CAX, CDX counted in binary.
inline constexpr std::array<const Message<>*, 8> remarks{
    &stays_inactive, &stays_inactive_on_cdx, &activation,          &activation_wins,
    &stays_active,   &deactivation,          &stays_active_on_cax, &activation_wins};

// In LaTeX only.

inline constexpr Message<> slash{
    "A slash before parentheses negates what stands in them: it is too long for a line above it.",
    "Une barre oblique devant une parenthèse note le complément d'une expression trop longue pour "
    "être surlignée."};

}  // namespace grafwire::messages::equation_report
