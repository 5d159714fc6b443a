#include "equations/report/words.h"

namespace grafwire {

namespace {

constexpr Words english{
    .title = "Equations of",
    .successor_form = "CDX from the steps that follow (successor form)",
    .transition_form = "CDX from the transitions that are cleared (transition form)",
    .with_modes = "with Init, AUdur and AUdoux",
    .without_modes = "without Init, AUdur and AUdoux",
    .conditions = "Activation and deactivation conditions",
    .step = "Step",
    .steps = "Equations of the steps",
    .outputs = "Outputs",
    .stored = "Stored outputs and variables",
    .variable = "Variable",
    .set = "Set",
    .reset = "Reset",
    .counters = "Counters",
    .counter = "Counter",
    .range = "Range",
    .when = "When",
    .write = "Write",
    .time_conditions = "Time conditions",
    .time_condition = "Time condition",
    .operand = "Operand",
    .on_after = "1 after",
    .off_after = "0 after",
    .edges = "Edges",
    .edge = "Edge",
    .karnaugh = "Truth table and Karnaugh map of",
    .group = "Group",
    .covers = "Product",
    .cells = "Cells (X, CAX CDX)",
    .smaller = "Smaller forms:",
    .remark = "Remark",
    .remarks = {"The step stays inactive (memory effect)", "The step stays inactive",
                "Activation of the step", "Activation AND deactivation = activation",
                "The step stays active (memory effect)", "Deactivation of the step",
                "The step stays active", "Activation AND deactivation = activation"},
};

constexpr Words french{
    .title = "Équations de",
    .successor_form = "CDX d'après les étapes suivantes (forme successeur)",
    .transition_form = "CDX d'après les transitions franchies (forme transition)",
    .with_modes = "avec Init, AUdur et AUdoux",
    .without_modes = "sans Init, AUdur ni AUdoux",
    .conditions = "Conditions d'activation et de désactivation",
    .step = "Étape",
    .steps = "Équations des étapes",
    .outputs = "Sorties",
    .stored = "Sorties et variables mémorisées",
    .variable = "Variable",
    .set = "Mise à 1",
    .reset = "Mise à 0",
    .counters = "Compteurs",
    .counter = "Compteur",
    .range = "Plage",
    .when = "Quand",
    .write = "Affectation",
    .time_conditions = "Temporisations",
    .time_condition = "Temporisation",
    .operand = "Opérande",
    .on_after = "1 après",
    .off_after = "0 après",
    .edges = "Fronts",
    .edge = "Front",
    .karnaugh = "Table de vérité et tableau de Karnaugh de",
    .group = "Groupe",
    .covers = "Produit",
    .cells = "Cases (X, CAX CDX)",
    .smaller = "Formes réduites :",
    .remark = "Remarque",
    .remarks = {"L'étape reste inactive (effet mémoire)", "L'étape reste inactive",
                "Activation de l'étape", "Activation ET désactivation = activation",
                "L'étape reste active (effet mémoire)", "Désactivation de l'étape",
                "L'étape reste active", "Activation ET désactivation = activation"},
};

}  // namespace

const Words& words(Language language) {
    return language == Language::french ? french : english;
}

}  // namespace grafwire
