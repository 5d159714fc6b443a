#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "text/message.h"

namespace grafwire::messages::story {

// Lists and values.

inline constexpr Message<> separator{"; ", " ; "};
inline constexpr Message<> no_step{"no step", "aucune étape"};
inline constexpr Message<> no_output{"none", "aucune"};
inline constexpr Message<> no_var{"none", "aucune"};
/// A time condition whose delay is running: the condition, its value, when the delay ends.
inline constexpr Message<std::string, std::int64_t, std::string> running_operand{
    "{}={} until {} ms", "{}={} jusqu'à {} ms"};

// How an instant begins.

inline constexpr Message<std::string, std::string> at{"At {} ms: {}\n", "À {} ms : {}\n"};
inline constexpr Message<> all_inputs_0{"all inputs are 0", "toutes les entrées sont à 0"};
inline constexpr Message<> no_input_changes{"no input changes", "aucune entrée ne change"};
inline constexpr Message<> nothing_changes{"nothing changes", "rien ne change"};
/// Of more than one.
inline constexpr Message<std::string, std::string, std::size_t> nothing_changes_until{
    "From {} ms to {} ms: nothing changes ({} scans)\n",
    "De {} ms à {} ms : rien ne change ({} scrutations)\n"};
inline constexpr Message<std::string> delay_is_over{"the delay of {} is over",
                                                    "la temporisation {} est écoulée"};
inline constexpr Message<std::string> rule_1{"initial situation: {} (rule 1)\n",
                                             "situation initiale : {} (règle 1)\n"};

// What a scan does.

inline constexpr Message<std::size_t> evolution_number{"evolution {}:\n", "évolution {} :\n"};
/// Arguments: the transition, its preceding steps, its condition, the values that this reads (or
/// nothing).
using ClearedMessage = Message<std::string, std::string, std::string, std::string>;
inline constexpr ClearedMessage cleared_by_one{
    "{0} is cleared (rule 2): {1} is active and {2} is 1{3}\n",
    "{0} est franchie (règle 2) : {1} est active et {2} vaut 1{3}\n"};
inline constexpr ClearedMessage cleared_by_many{
    "{0} is cleared (rule 2): {1} are active and {2} is 1{3}\n",
    "{0} est franchie (règle 2) : {1} sont actives et {2} vaut 1{3}\n"};
inline constexpr ClearedMessage cleared_by_none{
    "{0} is cleared (rule 2): no step precedes it and {2} is 1{3}\n",
    "{0} est franchie (règle 2) : aucune étape ne la précède et {2} vaut 1{3}\n"};
inline constexpr Message<> always_true{"its condition", "sa réceptivité"};
inline constexpr Message<std::string, std::string, std::string> not_cleared{
    "{} is not cleared: {} is 0{}\n", "{} n'est pas franchie : {} vaut 0{}\n"};
inline constexpr Message<std::string, std::string> not_cleared_frozen{
    "{} is not cleared: {} is frozen\n", "{} n'est pas franchie : {} est figé\n"};
inline constexpr Message<std::string> cleared_together{"cleared together: {} (rule 4)\n",
                                                       "franchies ensemble : {} (règle 4)\n"};
/// The arguments of the next ones say, or end with, which steps change.
inline constexpr Message<std::string> rule_3{"{} (rule 3)\n", "{} (règle 3)\n"};
inline constexpr Message<std::string> deactivated{"deactivated: {}", "désactivation : {}"};
inline constexpr Message<std::string> activated{"activated: {}", "activation : {}"};
inline constexpr Message<> no_step_changes{"no step changes", "aucune étape ne change"};
inline constexpr Message<std::string> rule_5{
    "deactivated and activated at once, so still active: {} (rule 5)\n",
    "désactivation et activation à la fois, donc toujours active : {} (règle 5)\n"};
/// The arguments of the next ones end with which steps change.
inline constexpr Message<std::string> init_sets{
    "Init=1: nothing is cleared, the initial situation is set; {}\n",
    "Init=1 : rien n'est franchi, la situation initiale est imposée ; {}\n"};
inline constexpr Message<std::string> au_dur_empties{"AUdur=1: every step is deactivated; {}\n",
                                                     "AUdur=1 : tout est désactivé ; {}\n"};
inline constexpr Message<std::string, std::string, std::string> forces{"{} forces {}; {}\n",
                                                                       "{} force {} ; {}\n"};
inline constexpr Message<std::string, std::string> freezes{"{} freezes {}\n", "{} fige {}\n"};
inline constexpr Message<std::string, std::string, std::string> opens{
    "{} has become active and opens {}, which it encloses; {}\n",
    "{} devient active et lance {}, qu'elle encapsule ; {}\n"};
inline constexpr Message<std::string, std::string, std::string> empties{
    "{} is not active, so {}, which it encloses, is emptied; {}\n",
    "{} n'est pas active, donc {}, qu'elle encapsule, se vide ; {}\n"};
/// Arguments: what is written, the variable and its new value.
inline constexpr Message<std::string, std::string, std::string> on_activation{
    "stored action on activation of {}: {}, gives {}\n",
    "action mémorisée à l'activation de {} : {}, donne {}\n"};
inline constexpr Message<std::string, std::string, std::string> on_deactivation{
    "stored action on deactivation of {}: {}, gives {}\n",
    "action mémorisée à la désactivation de {} : {}, donne {}\n"};
inline constexpr Message<std::string, std::string, std::string> on_event{
    "stored action of {} on an event: {}, gives {}\n",
    "action mémorisée de {} sur événement : {}, donne {}\n"};
inline constexpr Message<std::string, std::string, std::string> on_clearing{
    "stored action on clearing of {}: {}, gives {}\n",
    "action mémorisée au franchissement de {} : {}, donne {}\n"};
inline constexpr Message<std::string, std::string> delay_begins{
    "the delay of {} begins, until {} ms\n", "la temporisation {} commence, jusqu'à {} ms\n"};
inline constexpr Message<std::string> delay_is_dropped{"the delay of {} is broken off\n",
                                                       "la temporisation {} est interrompue\n"};
inline constexpr Message<std::string> becomes_1{"{} becomes 1\n", "{} passe à 1\n"};
inline constexpr Message<std::string> becomes_0{"{} becomes 0\n", "{} passe à 0\n"};

// How an instant ends.

inline constexpr CountedMessage<> untold{
    {"… and {} more evolution\n", "… et {} autre évolution\n"},
    {"… and {} more evolutions\n", "… et {} autres évolutions\n"}};
inline constexpr Message<std::string> unstable{
    "no stable situation: {} keep changing\n",
    "pas de situation stable : {} changent sans cesse\n"};
inline constexpr Message<std::string> stable_situation{"stable situation: {}\n",
                                                       "situation stable : {}\n"};
inline constexpr Message<std::string> situation{"situation: {}\n", "situation : {}\n"};
inline constexpr Message<std::string> outputs{"outputs at 1: {}\n", "sorties à 1 : {}\n"};
inline constexpr Message<> outputs_off{"AUdoux=1: continuous outputs are 0\n",
                                       "AUdoux=1 : les sorties continues sont à 0\n"};
inline constexpr Message<std::string> vars{"vars at 1: {}\n", "variables à 1 : {}\n"};
inline constexpr Message<std::string> counters{"counters: {}\n", "compteurs : {}\n"};
inline constexpr Message<std::string> orders{"orders in force: {}\n", "ordres en vigueur : {}\n"};
inline constexpr Message<std::string, std::string, std::string> waits{
    "enabled: {}, waits for {}{}\n", "validée : {}, attend {}{}\n"};
inline constexpr Message<std::string, std::string> waits_frozen{"enabled: {}, but {} is frozen\n",
                                                                "validée : {}, mais {} est figé\n"};
inline constexpr Message<std::string> waits_init{"enabled: {}, but Init=1\n",
                                                 "validée : {}, mais Init=1\n"};
inline constexpr Message<std::string, std::string, std::string> clearable{
    "clearable at the next scan: {}, since {} is 1{}\n",
    "franchissable à la prochaine scrutation : {}, car {} vaut 1{}\n"};
/// Of a stable situation, where clearing it leaves all as it is.
inline constexpr Message<std::string, std::string, std::string> clearable_idly{
    "clearable, without effect: {}, since {} is 1{}\n",
    "franchissable, sans effet : {}, car {} vaut 1{}\n"};
inline constexpr Message<> none_enabled{"no transition is enabled\n",
                                        "aucune transition n'est validée\n"};

// The session step by step. Lines end here.

/// In the order of Session::Word.
inline constexpr Message<> session_words[] = {
    {"scan", "scruter"},     {"back", "retour"}, {"show", "montrer"},
    {"save", "enregistrer"}, {"help", "aide"},   {"quit", "quitter"},
};
/// Arguments: the name of the GRAFCET, its inputs.
inline constexpr Message<std::string, std::string> greeting{
    "GRAFCET {}, step by step. Inputs: {}.\n"
    "Type the inputs of the first instant, such as a=1, or help.\n",
    "GRAFCET {}, pas à pas. Entrées : {}.\n"
    "Tapez les entrées du premier instant, comme a=1, ou aide.\n"};
inline constexpr Message<> session_help{
    "a=1 b=0       change inputs (the first ones: those at 0 ms; later: 1 ms after the last "
    "instant)\n"
    "+500ms        let time pass; delays end meanwhile\n"
    "+500ms b=1    let time pass, then change inputs; 2s b=1: at that time\n"
    "scan          go to the end of the next delay\n"
    "back          take back the last line, any number of times\n"
    "show          situation, outputs, and what the enabled transitions wait for\n"
    "save FILE     write all that was done as stimuli (.stim)\n"
    "quit          end\n",
    "a=1 b=0           changer des entrées (les premières : à 0 ms ; ensuite 1 ms après le dernier "
    "instant)\n"
    "+500ms            laisser passer le temps ; des temporisations s'écoulent\n"
    "+500ms b=1        laisser passer le temps, puis changer des entrées ; 2s b=1 : à ce moment\n"
    "scruter           aller à la fin de la prochaine temporisation\n"
    "retour            annuler la dernière ligne, autant de fois qu'on veut\n"
    "montrer           situation, sorties, et ce qu'attendent les transitions validées\n"
    "enregistrer FICH  écrire tout ce qui a été fait comme stimuli (.stim)\n"
    "quitter           finir\n"};
inline constexpr Message<> session_help_scans{
    "a=1 b=0       change inputs, for the next scan to read\n"
    "scan          one scan\n"
    "+500ms        the scans of that time\n"
    "+500ms b=1    the scans of that time, inputs changed at its end\n"
    "back          take back the last line, any number of times\n"
    "show          situation, outputs, and what the enabled transitions wait for\n"
    "save FILE     write all that was done as stimuli (.stim)\n"
    "quit          end\n",
    "a=1 b=0           changer des entrées, que lira la prochaine scrutation\n"
    "scruter           une scrutation\n"
    "+500ms            les scrutations de cette durée\n"
    "+500ms b=1        les scrutations de cette durée, avec des entrées changées à la fin\n"
    "retour            annuler la dernière ligne, autant de fois qu'on veut\n"
    "montrer           situation, sorties, et ce qu'attendent les transitions validées\n"
    "enregistrer FICH  écrire tout ce qui a été fait comme stimuli (.stim)\n"
    "quitter           finir\n"};
inline constexpr Message<std::string> nothing_follows{"nothing may follow here: '{}'\n",
                                                      "rien ne doit suivre ici : « {} »\n"};
inline constexpr Message<std::string> unknown_line{
    "'{}' is none of a=1, +500ms, scan, back, show, save, help, quit\n",
    "« {} » n'est ni a=1, ni +500ms, ni scruter, retour, montrer, enregistrer, aide ou quitter\n"};
inline constexpr Message<> no_delay_runs{
    "no delay is running: nothing happens until an input changes\n",
    "aucune temporisation ne court : rien ne se passe tant qu'aucune entrée ne change\n"};
inline constexpr Message<> nothing_to_take_back{"there is nothing to take back\n",
                                                "il n'y a rien à annuler\n"};
inline constexpr Message<> save_needs_path{"save where? Write save FILE.stim\n",
                                           "enregistrer où ? Écrivez enregistrer FICHIER.stim\n"};
inline constexpr Message<std::string> instant_is_over{
    "the instant {} ms is over: give a later time\n",
    "l'instant {} ms est passé : donnez un temps ultérieur\n"};
inline constexpr Message<> no_way_on{"there is no stable situation to go on from: go back\n",
                                     "il n'y a pas de situation stable d'où continuer : faites "
                                     "retour\n"};
inline constexpr Message<std::string> long_way{"a long way: stopped at {} ms\n",
                                               "c'est long : arrêt à {} ms\n"};
inline constexpr Message<std::string> read_by_next_scan{
    "The scan at {} ms will read the inputs.\n", "La scrutation à {} ms lira les entrées.\n"};
inline constexpr Message<std::string> breaks_assumption{
    "These inputs break what the GRAFCET assumes: {}\n",
    "Ces entrées contredisent ce que le GRAFCET suppose : {}\n"};
inline constexpr Message<> not_begun{"Not begun: all inputs are 0.\n",
                                     "Rien n'a commencé : toutes les entrées sont à 0.\n"};
/// Arguments: the time, the inputs at 1.
inline constexpr Message<std::string, std::string> shown_at{"At {} ms; inputs at 1: {}\n",
                                                            "À {} ms ; entrées à 1 : {}\n"};

}  // namespace grafwire::messages::story
