#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire::messages::check {

// The verdict, and what it rests on.

/// Arguments: the file of the GRAFCET, what it is compared with.
inline constexpr Message<std::string, std::string> equivalent{"{}: equivalent ({})\n",
                                                              "{} : équivalent ({})\n"};
inline constexpr Message<std::string, std::string> different{"{}: different ({})\n",
                                                             "{} : différent ({})\n"};
inline constexpr Message<std::string, std::string> undecided{"{}: undecided ({})\n",
                                                             "{} : indécis ({})\n"};
/// The same in both languages: options and their values.
inline constexpr Message<std::string, std::string> made_in{"style {}, CDX {}", "style {}, CDX {}"};
inline constexpr Message<std::string> program{"program {}", "programme {}"};
inline constexpr Message<std::string> netlist{"netlist {}", "câblage {}"};

/// Between the parts of a line.
inline constexpr Message<> separator{"; ", " ; "};
inline constexpr Message<std::string> delays{"delays: every gate {} ns",
                                             "retards : {} ns par porte"};
inline constexpr Message<std::string, std::string> bounded_delays{
    "delays: every change of a gate {} to {} ns", "retards : {} à {} ns par changement de porte"};
/// Argument: which figures of which part family.
inline constexpr Message<Localized> family_delays{"delays: {}", "retards : {}"};
inline constexpr Message<> figures_of_parts{"  every change of a gate takes, in ns:\n",
                                            "  chaque changement de porte prend, en ns :\n"};
/// Counts inputs; argument: the type of the cell.
inline constexpr CountedMessage<Localized> cell_with_inputs{
    {"{1}, {0} input", "{1}, {0} entrée"}, {"{1}, {0} inputs", "{1}, {0} entrées"}};
inline constexpr Message<std::string, std::string> from_to{"{} to {}", "{} à {}"};
/// Arguments: bounds of the rise, of the fall.
inline constexpr Message<std::string, std::string> rise_and_fall{"rise {}, fall {}",
                                                                 "montée {}, descente {}"};
/// Arguments: the cell, its bounds, what they are taken from.
inline constexpr Message<std::string, std::string, std::string> figures_of_cell{
    "    {}: {} ({})\n", "    {} : {} ({})\n"};
/// Arguments: the part, its sources.
inline constexpr Message<std::string_view, std::string_view> figures_of_part{"{}: {}", "{} : {}"};
inline constexpr Message<> composed_of_parts{"composed of several parts, taken as one gate",
                                             "composée de plusieurs, prise pour une seule porte"};
inline constexpr Message<> any_delays{"delays: any finite one of every gate",
                                      "retards : finis et quelconques, de chaque porte"};
inline constexpr Message<> any_wire_delays{
    "delays: any finite one of every gate and of every wire",
    "retards : finis et quelconques, de chaque porte et de chaque fil"};
inline constexpr Message<> one_change{"changes: one input at a time",
                                      "changements : une entrée à la fois"};
inline constexpr Message<> many_changes{"changes: many inputs at once",
                                        "changements : plusieurs entrées à la fois"};
inline constexpr Message<> any_period{"scan period: any", "période de scrutation : quelconque"};
inline constexpr Message<Localized> scan_period{"scan period: {}", "période de scrutation : {}"};
inline constexpr Message<> no_assumptions{"assumptions: none", "hypothèses : aucune"};
inline constexpr Message<std::string> assumptions{"assumptions: {}", "hypothèses : {}"};
inline constexpr Message<> power_up_init{"power-up: Init", "mise sous tension : Init"};
inline constexpr Message<> power_up_initial_values{"power-up: initial values",
                                                   "mise sous tension : valeurs initiales"};
inline constexpr Message<> power_up_given{
    "power-up: initial situation, taken as given",
    "mise sous tension : situation initiale, supposée donnée"};
inline constexpr Message<> power_up_unknown{"power-up: unknown", "mise sous tension : inconnue"};

// Coverage.

/// Arguments: situations, scans compared. The same in both languages.
inline constexpr Message<Localized, Localized> scans_compared{"  {}, {}\n", "  {}, {}\n"};
/// Arguments: stable situations, cases compared, cases without a stable situation.
inline constexpr Message<Localized, Localized, std::uint64_t> cases_compared{
    "  {}, {}, {} without a stable situation\n", "  {}, {}, {} sans situation stable\n"};
inline constexpr Message<std::string> never_active{"never active: {}",
                                                   "étapes jamais actives : {}"};
inline constexpr Message<std::string> never_cleared{"never cleared: {}",
                                                    "transitions jamais franchies : {}"};
inline constexpr Message<std::string> never_changed{"never changed: {}",
                                                    "entrées jamais changées : {}"};
inline constexpr Message<std::string> never_on{"never on: {}", "sorties jamais à 1 : {}"};

// Why a check is undecided.

inline constexpr Message<> depends_on_period{
    "  for no scan period could a difference be shown, nor excluded for every one: give one with "
    "--scan\n",
    "  pour aucune période de scrutation une différence n'a pu être montrée, ni exclue pour toutes "
    ": en donner une avec --scan\n"};
inline constexpr Message<> depends_on_memory{
    "  a memory whose value at power-up is not known may make a difference, and no run was found "
    "that shows one: give it an initial value\n",
    "  une mémoire dont la valeur à la mise sous tension est inconnue peut faire une différence, "
    "sans qu'un essai la montre : lui donner une valeur initiale\n"};
inline constexpr Message<> depends_on_orders{
    "  there is a case in which gates can change in more orders than were gone through\n",
    "  il y a un cas où les portes peuvent changer dans plus d'ordres qu'il n'en a été essayé\n"};
inline constexpr Message<> depends_on_delays{
    "  delays of gates may make a difference, and none were found that show one\n",
    "  des retards de portes peuvent faire une différence, sans qu'on en ait trouvé qui la "
    "montrent\n"};
inline constexpr CountedMessage<> states_waiting{
    {"  exploration incomplete within the bounds given: {} state reached is still to be left\n",
     "  exploration incomplète dans les limites données : {} état atteint reste à quitter\n"},
    {"  exploration incomplete within the bounds given: {} states reached are still to be left\n",
     "  exploration incomplète dans les limites données : {} états atteints restent à "
     "quitter\n"}};

// Charts with interlocks.

/// In the place of the file in a verdict. Argument: the file.
inline constexpr Message<std::string> interlocked_file{"{} with interlocks",
                                                       "{} avec verrouillages"};
inline constexpr Message<> interlocked_reference{
    "  compared with the chart of the file and these interlocks, not with that chart itself:\n",
    "  comparé au grafcet du fichier muni de ces verrouillages, non à ce grafcet lui-même :\n"};
inline constexpr Message<> order_is_immaterial{
    "  with them the order in which transitions clear does not matter\n",
    "  avec eux, l'ordre des franchissements n'importe plus\n"};
/// Argument: how many cases.
inline constexpr Message<std::uint64_t> interlocked_is_alike{
    "  in every case with one change at a time, {} in all, the chart comes with them to what it "
    "came to without\n",
    "  dans chaque cas à un changement à la fois, {} en tout, le grafcet aboutit avec eux à ce à "
    "quoi il aboutissait sans eux\n"};
inline constexpr Message<Localized> interlocked_is_alike_so_far{
    "  in {}, not all that there are, the chart comes with them to what it came to without\n",
    "  dans {}, pas dans tous ceux qui existent, le grafcet aboutit avec eux à ce à quoi il "
    "aboutissait sans eux\n"};

// Remarks.

inline constexpr Message<std::string> chart_is_unstable{
    "\nRemark: the GRAFCET itself has no stable situation here ({} keep changing):\n",
    "\nRemarque : le GRAFCET n'a pas de situation stable ici ({} changent sans cesse) :\n"};
inline constexpr Message<> many_changes_hold{
    "\nRemark: it holds as well when many inputs change at once.\n",
    "\nRemarque : cela reste vrai quand plusieurs entrées changent à la fois.\n"};
inline constexpr Message<> many_changes_undecided{
    "\nRemark: whether it holds as well when many inputs change at once is undecided; --changes "
    "many "
    "asks for it.\n",
    "\nRemarque : il reste indécis si cela est vrai aussi quand plusieurs entrées changent à la "
    "fois ; --changes many le demande.\n"};
inline constexpr Message<> many_changes_fail{
    "\nRemark: it does not hold when many inputs change at once.\n",
    "\nRemarque : cela n'est plus vrai quand plusieurs entrées changent à la fois.\n"};
inline constexpr Message<> for_instance{"For instance:\n", "Par exemple :\n"};
inline constexpr Message<std::string> apart_from_delay{
    "{} must not change within a settling time of the end of a delay. Otherwise:\n",
    "{} ne doit pas changer à moins d'un temps de stabilisation de la fin d'un retard. Sinon :\n"};
inline constexpr Message<std::string> apart_from_each_other{
    "These must not change within a settling time of each other: {}. Otherwise:\n",
    "Ces entrées ne doivent pas changer à moins d'un temps de stabilisation d'intervalle : {}. "
    "Sinon :\n"};
inline constexpr Message<std::string> holds_with_assumption{
    "It holds where the plant never does that, as the GRAFCET can say:\n  assume {}\n",
    "Cela redevient vrai si l'installation ne le fait jamais, ce que le GRAFCET peut dire :\n"
    "  assume {}\n"};

// The witness.

inline constexpr Message<> witness{"\nWitness:\n", "\nContre-exemple :\n"};
/// Arguments: the net, its value.
inline constexpr Message<std::string, int> at_power_up{"  at power-up: {} = {}\n",
                                                       "  à la mise sous tension : {} = {}\n"};
inline constexpr Message<> no_initial_situation{
    "At power-up nothing brings the netlist into the initial situation. Give it an input Init or\n"
    "initial values; or check with --power-up initial, if the plant guarantees that situation.\n\n",
    "À la mise sous tension, rien ne met le câblage dans la situation initiale. Lui donner une "
    "entrée\nInit ou des valeurs initiales ; ou vérifier avec --power-up initial, si "
    "l'installation garantit cette\nsituation.\n\n"};
inline constexpr Message<> oscillates_beside{
    "Every X and output is right; what keeps changing beside them stands below.\n\n",
    "Chaque X et chaque sortie est juste ; ce qui change sans cesse à côté est dit plus bas.\n\n"};

// How much delays may differ.

inline constexpr Message<std::string> tolerance_holds{
    "\nTolerance: it holds as long as no change of a gate takes more than {} times as long as "
    "another.\n",
    "\nTolérance : cela reste vrai tant qu'aucun changement de porte ne prend plus de {} fois le "
    "temps d'un autre.\n"};
inline constexpr Message<> tolerance_unlimited{
    "\nTolerance: it holds however much the delays of gates differ.\n",
    "\nTolérance : cela reste vrai quels que soient les écarts entre les retards des portes.\n"};
inline constexpr Message<> tolerance_none{
    "\nTolerance: none. It does not even hold where every change of a gate takes the same.\n",
    "\nTolérance : aucune. Ce n'est pas vrai même si tous les changements de porte prennent le "
    "même temps.\n"};
inline constexpr Message<> tolerance_unproven{
    "\nTolerance: within the bounds given it could be proven for no ratio of delays.\n",
    "\nTolérance : dans les limites données, aucun rapport entre retards n'a pu être prouvé.\n"};
inline constexpr Message<> tolerance_open_between{
    "Between that and the next it is undecided within the bounds given.\n",
    "Entre celui-ci et le suivant, rien n'est décidé dans les limites données.\n"};
inline constexpr Message<> tolerance_open_above{
    "Above that no difference was found within the bounds given.\n",
    "Au-delà, aucun écart n'a été trouvé dans les limites données.\n"};
inline constexpr Message<std::string> tolerance_fails{"With {} times it does not:\n",
                                                      "Avec {} fois, cela n'est plus vrai :\n"};

// X and outputs that change too often in an instant.

inline constexpr Message<> pulses{
    "\nPulses, beside the verdict: these change more often in an instant than the GRAFCET asks "
    "for.\n",
    "\nImpulsions parasites, sans effet sur le verdict : ceci change plus souvent en un instant "
    "que le GRAFCET ne le demande.\n"};
inline constexpr Message<> no_pulses{
    "\nPulses: none. No X and no output changes more often in an instant than the GRAFCET asks "
    "for.\n",
    "\nImpulsions parasites : aucune. Ni X ni sortie ne change plus souvent en un instant que le "
    "GRAFCET ne le demande.\n"};
inline constexpr Message<> no_pulses_found{
    "\nPulses: none found, and not everything could be looked at.\n",
    "\nImpulsions parasites : aucune trouvée, mais tout n'a pas pu être examiné.\n"};
inline constexpr Message<> stimuli_of_pulse{"Stimuli:\n", "Stimuli :\n"};
inline constexpr CountedMessage<std::string> pulses_open{
    {"  {1}: in {0} case it could not be told whether it does\n",
     "  {1} : dans {0} cas, on n'a pas pu le savoir\n"},
    {"  {1}: in {0} cases it could not be told whether it does\n",
     "  {1} : dans {0} cas, on n'a pas pu le savoir\n"}};
inline constexpr CountedMessage<> pulses_incomplete{
    {"  {} case was looked at, and there are others that were not\n",
     "  {} cas examiné, et d'autres ne l'ont pas été\n"},
    {"  {} cases were looked at, and there are others that were not\n",
     "  {} cas examinés, et d'autres ne l'ont pas été\n"}};

// The table of ports.

inline constexpr Message<> missing_input{"missing input", "entrée manquante"};
inline constexpr Message<> missing_output{"missing output", "sortie manquante"};
inline constexpr Message<> extra_input{"extra input", "entrée en trop"};
inline constexpr Message<> extra_output{"extra output", "sortie en trop"};
inline constexpr Message<> unrelated_timer{"timer of no time condition",
                                           "temporisateur d'aucune temporisation"};

}  // namespace grafwire::messages::check
