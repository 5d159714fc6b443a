#pragma once

#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::report {

// Headings; those of sections stand in the contents as well.

inline constexpr Message<> contents{"Contents", "Sommaire"};
inline constexpr Message<std::string, std::string> about{"GRAFCET {}, read from {}",
                                                         "GRAFCET {}, lu dans {}"};
inline constexpr Message<> chart{"The GRAFCET", "Le GRAFCET"};
inline constexpr Message<> names{"Inputs and outputs", "Entrées et sorties"};
inline constexpr Message<> equations{"Equations", "Équations"};
inline constexpr Message<std::string> schematic{"Schematic, style {}", "Schéma, style {}"};
inline constexpr Message<> run{"A run of the reference", "Une évolution de référence"};
/// The same in both languages.
inline constexpr Message<> verdicts{"Verdicts", "Verdicts"};
/// The same in both languages.
inline constexpr Message<std::string> style{"Style {}", "Style {}"};
inline constexpr Message<> warnings{"Remarks on the GRAFCET", "Remarques sur le GRAFCET"};
inline constexpr Message<> source{"The text of the GRAFCET", "Le texte du GRAFCET"};

// Inputs and outputs.

inline constexpr Message<> kind{"Kind", "Genre"};
inline constexpr Message<> name{"Name", "Nom"};
inline constexpr Message<> comment{"Comment where it is declared", "Commentaire de la déclaration"};
inline constexpr Message<> input{"input", "entrée"};
inline constexpr Message<> output{"output", "sortie"};
inline constexpr Message<> modes{
    "Besides these, every GRAFCET has the inputs Init (the initial situation), AUdur (every step "
    "is deactivated) and AUdoux (continuous outputs are 0).",
    "S'y ajoutent dans tout GRAFCET les entrées Init (situation initiale), AUdur (toute étape est "
    "désactivée) et AUdoux (les sorties continues sont à 0)."};

// The run.

inline constexpr Message<std::string> stimuli{"Stimuli: {}", "Stimuli : {}"};
inline constexpr Message<> story{"In words", "En toutes lettres"};

// Verdicts.

inline constexpr Message<> verdicts_are{
    "The equations are made into gates in each style, and each netlist is compared with the "
    "reference evolution in every case that can be reached. Equivalent is a proof under what the "
    "verdict rests on; different comes with a run that shows it; undecided is neither.",
    "Les équations sont câblées dans chaque style, et chaque câblage est comparé à l'évolution de "
    "référence dans tous les cas atteignables. « Équivalent » est une preuve, sous les conditions "
    "indiquées ; « différent » est montré par une évolution ; « indécis » n'est ni l'un ni "
    "l'autre."};
/// The same in both languages.
inline constexpr Message<> style_column{"Style", "Style"};
/// The same in both languages.
inline constexpr Message<> verdict{"Verdict", "Verdict"};
inline constexpr Message<> compared{"Compared", "Comparaison"};
inline constexpr Message<> rests_on{"Rests on", "Conditions"};
inline constexpr Message<> equivalent{"equivalent", "équivalent"};
inline constexpr Message<> different{"different", "différent"};
inline constexpr Message<> undecided{"undecided", "indécis"};
inline constexpr Message<> not_made{"not made", "non réalisé"};
inline constexpr Message<std::string> assumptions{
    "Whatever breaks an assumption of the GRAFCET is not looked at: {}.",
    "Ce qui contredit une hypothèse du GRAFCET n'est pas examiné : {}."};
inline constexpr Message<> witness_picture{
    "What the reference does, and below it, where it is not the same, what the gates do. The "
    "differences are marked by an exclamation mark.",
    "Ce que fait la référence et, dessous, là où c'est différent, ce que font les portes. Un point "
    "d'exclamation marque chaque écart."};

// Remarks.

inline constexpr Message<> in_wiring{"In asynchronous wiring:", "Dans un câblage asynchrone :"};

inline constexpr Message<std::string_view> made_by{"Written by grafwire {}.",
                                                   "Écrit par grafwire {}."};

}  // namespace grafwire::messages::report
