#pragma once

#include <cstdint>
#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

/// What the verdicts of checks are called where they stand among other messages.
namespace grafwire::code {
inline constexpr Code different{"different"};
inline constexpr Code undecided{"undecided"};
inline constexpr Code skipped{"skipped"};
}  // namespace grafwire::code

namespace grafwire::messages::workflow {

inline constexpr Message<> clocked_has_transition_form{
    "the clocked style has the transition form of CDX only: leave out --cdx successor",
    "le style clocked n'existe qu'avec la forme transition de CDX : enlevez --cdx successor"};
inline constexpr Message<> handshake_has_successor_form{
    "the handshake style has the successor form of CDX only: leave out --cdx transition",
    "le style handshake n'existe qu'avec la forme successor de CDX : enlevez --cdx transition"};

// The order in which transitions clear, of the style handshake.

/// Argument: a race.
inline constexpr Message<Localized> order_matters{
    "under some delays of its gates the wiring may not do what the chart does: {}",
    "sous certains retards de ses portes, le câblage peut ne pas faire ce que fait le grafcet : "
    "{}"};
/// Argument: how many cases.
inline constexpr Message<Localized> order_seen_in_part{
    "whether the order in which transitions clear matters was looked at in {}, not all that "
    "there are",
    "l'influence de l'ordre des franchissements a été examinée dans {}, pas dans tous ceux qui "
    "existent"};
/// Of a chart with interlocks, before what is left of its races.
inline constexpr Message<> interlocks_do_not_suffice{
    "interlocks do not help against all that depends on the order in which transitions clear",
    "les verrouillages ne remédient pas à tout ce qui dépend de l'ordre des franchissements"};
inline constexpr Message<> no_interlock_needed{
    "no interlock was added: the chart does not depend on the order in which its transitions clear",
    "aucun verrouillage ajouté : le grafcet ne dépend pas de l'ordre de ses franchissements"};
inline constexpr CountedMessage<Localized> interlocks_added{
    {"{} interlock added to the chart:\n{}", "{} verrouillage ajouté au grafcet :\n{}"},
    {"{} interlocks added to the chart:\n{}", "{} verrouillages ajoutés au grafcet :\n{}"}};
inline constexpr Message<> remark_on_orders{
    "\nRemark: the chart itself depends on the order in which its transitions clear. No wiring "
    "under any delay can be held to it there:\n",
    "\nRemarque : le grafcet lui-même dépend de l'ordre de ses franchissements. Aucun câblage à "
    "retards quelconques ne peut y être tenu :\n"};

inline constexpr Message<> clocked_has_no_races{
    "between two edges of its clock everything in a clocked netlist rests, whatever the delays: "
    "leave "
    "out --delay",
    "entre deux fronts de l'horloge tout est au repos dans un câblage synchrone, quels que soient "
    "les "
    "retards : enlevez --delay"};

inline constexpr Message<std::string_view> nothing_ever_happens{
    "{}: no step is initial and no source transition activates any, so nothing ever happens in "
    "this GRAFCET: make a step initial",
    "{} : aucune étape n'est initiale et aucune transition source n'en active, il ne se passe donc "
    "jamais rien dans ce GRAFCET : rendez une étape initiale"};
inline constexpr Message<> assumptions_leave_no_input{
    "the assumptions leave no input: without modes Init, AUdur and AUdoux stay 0",
    "les hypothèses ne laissent aucune entrée possible : sans les modes, Init, AUdur et AUdoux "
    "restent à 0"};

// Several checks. A file, what it was to be compared with, and why it was not.

inline constexpr Message<std::string, Localized, Localized> skipped{
    "{}: skipped ({}): {}\n", "{} : laissé de côté ({}) : {}\n"};
inline constexpr Message<std::string, Localized, Localized> not_checked{
    "{}: not checked ({}): {}\n", "{} : non vérifié ({}) : {}\n"};
inline constexpr Message<std::string> no_style_holds{
    "{}: no style can hold this GRAFCET as it is asked for, so nothing was checked",
    "{} : aucun style n'admet ce GRAFCET tel que demandé, rien n'a donc été vérifié"};

/// The kind of a difference, and what was compared.
inline constexpr Message<std::string, Localized> sarif_different{
    "it does not do what this GRAFCET says ({}; {})",
    "il ne fait pas ce que dit ce GRAFCET ({} ; {})"};
inline constexpr Message<Localized> sarif_undecided{"undecided within the given bounds ({})",
                                                    "indécis dans les limites données ({})"};
inline constexpr Message<Localized, Localized> sarif_skipped{"skipped ({}): {}",
                                                             "laissé de côté ({}) : {}"};

inline constexpr Message<> column_file{"File", "Fichier"};
inline constexpr Message<> column_compared{"Compared with", "Comparé à"};
/// The same in both languages.
inline constexpr Message<> column_verdict{"Verdict", "Verdict"};
inline constexpr Message<> column_cases{"Cases", "Cas"};
inline constexpr Message<> column_seconds{"Seconds", "Secondes"};
inline constexpr Message<> outcome_equivalent{"equivalent", "équivalent"};
inline constexpr Message<> outcome_different{"different", "différent"};
inline constexpr Message<> outcome_undecided{"undecided", "indécis"};
inline constexpr Message<> outcome_skipped{"skipped", "laissé de côté"};
inline constexpr Message<> outcome_error{"error", "erreur"};
/// The last line: how many there are, and how many of each outcome.
inline constexpr CountedMessage<std::string> checks{{"{} check: {}\n", "{} vérification : {}\n"},
                                                    {"{} checks: {}\n", "{} vérifications : {}\n"}};
inline constexpr CountedMessage<> equivalent_checks{{"{} equivalent", "{} équivalente"},
                                                    {"{} equivalent", "{} équivalentes"}};
inline constexpr CountedMessage<> different_checks{{"{} different", "{} différente"},
                                                   {"{} different", "{} différentes"}};
inline constexpr CountedMessage<> undecided_checks{{"{} undecided", "{} indécise"},
                                                   {"{} undecided", "{} indécises"}};
inline constexpr CountedMessage<> skipped_checks{{"{} skipped", "{} laissée de côté"},
                                                 {"{} skipped", "{} laissées de côté"}};
inline constexpr CountedMessage<> wrong_checks{{"{} in error", "{} en erreur"},
                                               {"{} in error", "{} en erreur"}};

inline constexpr Message<std::string_view, std::string_view> missing_variables{
    "{}: no BOOL variable of this name: {}; every step (X...) and every output must have its own",
    "{} : pas de variable BOOL de ce nom : {} ; chaque étape (X...) et chaque sortie doit avoir la "
    "sienne"};
inline constexpr Message<std::string_view, std::string_view> missing_inputs{
    "{}: has no input {}", "{} : sans l'entrée {}"};
inline constexpr Message<> modes_all_or_none{
    "Init, AUdur and AUdoux: give all three an address, or none",
    "Init, AUdur et AUdoux : donnez une adresse aux trois, ou à aucun"};

inline constexpr Message<std::string_view, std::string_view> written_by{
    "Written by grafwire {} with: {}", "Écrit par grafwire {} avec : {}"};

inline constexpr Message<std::string_view, std::string_view> broken_assumption{
    "at {} ms the stimuli break what the GRAFCET assumes: {}",
    "à {} ms, les stimuli contredisent ce que le GRAFCET suppose : {}"};

/// Behind the title of a drawing.
inline constexpr Message<Localized> situation_at{"situation at {}", "situation à {}"};
inline constexpr Message<Localized> values_at{"values at {}", "valeurs à {}"};
inline constexpr Message<Localized> gates_at{"gates at {}", "portes à {}"};
inline constexpr Message<Localized> idle_gates_at{"gates at {}: nothing changes",
                                                  "portes à {} : rien ne change"};
inline constexpr Message<Localized> unsettled_gates_at{"gates at {}, which do not settle",
                                                       "portes à {}, qui ne se stabilisent pas"};
inline constexpr Message<> schematic_svg{"a schematic, as a picture",
                                         "un schéma, sous forme d'image"};
inline constexpr Message<> schematic_tikz{"a schematic, as a TikZ picture for LaTeX",
                                          "un schéma, sous forme de figure TikZ pour LaTeX"};

/// A message about a chart, and the line that it is about.
inline constexpr Message<std::uint32_t, Localized> at_line{"line {}: {}", "ligne {} : {}"};

}  // namespace grafwire::messages::workflow
