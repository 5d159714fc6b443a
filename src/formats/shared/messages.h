#pragma once

#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on netlists of other programs are about.
namespace code {
inline constexpr Code bad_netlist{"bad-netlist"};
}  // namespace code

namespace messages::formats {

// Of every netlist.

inline constexpr Message<std::string_view> second_driver{"net '{}' has a second driver",
                                                         "le fil « {} » a une deuxième source"};
inline constexpr Message<> first_driver{"the first one is here", "la première est ici"};
inline constexpr Message<std::string_view> output_twice{"output '{}' is listed twice",
                                                        "la sortie « {} » figure deux fois"};
inline constexpr Message<Localized, std::string_view> pulse_without_width{
    "the pulse of {} '{}' has no width", "{} « {} » : son impulsion n'a pas de largeur"};
inline constexpr Message<std::string_view> no_driver{
    "net '{}' has no driver: it is neither an input nor the output of a cell",
    "le fil « {} » n'a pas de source : il n'est ni une entrée ni la sortie d'une cellule"};
inline constexpr Message<std::string_view, Localized, std::string_view> clock_is_no_input{
    "the clock '{}' of {} '{}' is not an input",
    "l'horloge « {} » ({} « {} ») n'est pas une entrée"};
inline constexpr Message<Localized, std::string_view, std::string_view, std::string_view>
    second_clock{
        "{} '{}' has the clock '{}', others have '{}': one clock is supported",
        "{} « {} » a pour horloge « {} », d'autres ont « {} » : une seule horloge est admise"};

// BLIF.

inline constexpr Message<> no_model{"there is no .model in the file",
                                    "il n'y a pas de .model dans le fichier"};
inline constexpr Message<> expected_model{"expected .model at the start of the netlist",
                                          ".model est attendu au début du câblage"};
inline constexpr Message<std::string_view> no_command{"'{}' is not a BLIF command",
                                                      "« {} » n'est pas une commande BLIF"};
inline constexpr Message<> second_model{
    "a second model with cells of its own; flatten the netlist first",
    "un deuxième modèle a ses propres cellules ; mettez d'abord le câblage à plat"};
inline constexpr Message<std::string_view> library_cell{
    "library cell '{}': its function is not in the file; write the netlist with .names instead",
    "cellule de bibliothèque « {} » : sa fonction n'est pas dans le fichier ; écrivez plutôt le "
    "câblage avec .names"};
inline constexpr Message<std::string_view> not_supported{"'{}' is not supported",
                                                         "« {} » n'est pas admis"};
inline constexpr Message<> names_without_output{".names without an output", ".names sans sortie"};
inline constexpr CountedMessage<> expected_row{
    {"expected a row of {} character 0, 1 or - and a 0 or 1",
     "une ligne de {} caractère 0, 1 ou -, puis un 0 ou un 1, est attendue"},
    {"expected a row of {} characters 0, 1 or - and a 0 or 1",
     "une ligne de {} caractères 0, 1 ou -, puis un 0 ou un 1, est attendue"}};
inline constexpr Message<> rows_differ{
    "the rows of one .names must end alike, all 0 or all 1",
    "les lignes d'un même .names doivent finir de la même façon, toutes par 0 ou toutes par 1"};
inline constexpr Message<> expected_latch{
    "expected .latch input output [type control] [initial value]",
    "la forme attendue est .latch entrée sortie [type commande] [valeur initiale]"};
inline constexpr Message<> latch_initial_value{"the initial value of a latch is 0, 1, 2 or 3",
                                               "la valeur initiale d'une bascule est 0, 1, 2 ou 3"};
inline constexpr Message<std::string_view> latch_type{
    "latch type '{}': only re (rising edge) and ah (transparent while high) are supported",
    "bascule de type « {} » : seuls re (front montant) et ah (transparente à l'état 1) sont admis"};
inline constexpr Message<> subcircuit_without_model{".subckt without a model",
                                                    ".subckt sans modèle"};
inline constexpr Message<std::string_view> unknown_subcircuit{
    "subcircuit '{}' is not known; flatten the netlist first",
    "le sous-circuit « {} » est inconnu ; mettez d'abord le câblage à plat"};
inline constexpr Message<std::string_view, Localized> no_connection{
    "'{}' is not a connection of a {}", "« {} » n'est pas une connexion de ce modèle ({})"};
inline constexpr Message<Localized> connection_missing{"a connection of this {} is missing",
                                                       "il manque une connexion à ce modèle ({})"};
inline constexpr Message<std::string_view> parameter_does_not_fit{
    "the value of {} does not fit; INIT is 0 or 1, RISE and FALL are durations, ORDINAL is a "
    "number",
    "la valeur de {} ne convient pas ; INIT vaut 0 ou 1, RISE et FALL sont des durées, ORDINAL "
    "est un nombre"};

// JSON of Yosys.

inline constexpr Message<std::size_t> nested_too_deep{
    "values are nested more than {} deep: not a netlist",
    "les valeurs sont imbriquées sur plus de {} niveaux : ce n'est pas un câblage"};
/// Why is quoted from the JSON reader, which speaks English.
inline constexpr Message<std::string_view> not_json{
    "not JSON: the JSON reader says \"{}\"", "ce n'est pas du JSON : l'analyseur JSON dit « {} »"};
inline constexpr Message<> no_modules{
    "not a Yosys netlist: there is no \"modules\"",
    "ce n'est pas un câblage de Yosys : il n'y a pas de \"modules\""};
inline constexpr Message<> no_module{"there is no module in the file",
                                     "il n'y a pas de module dans le fichier"};
inline constexpr Message<> several_modules{
    "there are several modules and none is marked as the top; flatten the netlist first (Yosys: "
    "hierarchy -auto-top; flatten)",
    "il y a plusieurs modules et aucun n'est marqué comme le premier ; mettez d'abord le câblage "
    "à plat (Yosys : hierarchy -auto-top puis flatten)"};
inline constexpr CountedMessage<std::string_view> wide_port{
    {"port '{1}' has {0} bit; ports of one bit are supported",
     "le port « {1} » a {0} bit ; seuls les ports d'un bit sont admis"},
    {"port '{1}' has {0} bits; ports of one bit are supported",
     "le port « {1} » a {0} bits ; seuls les ports d'un bit sont admis"}};
inline constexpr Message<std::string_view, std::string_view> port_connected_to{
    "port '{}' is connected to '{}'", "le port « {} » est connecté à « {} »"};
inline constexpr Message<std::string_view> port_without_direction{
    "port '{}' is neither an input nor an output",
    "le port « {} » n'est ni une entrée ni une sortie"};
inline constexpr Message<std::string_view> cell_without_connections{
    "cell '{}' has no connections", "la cellule « {} » n'a pas de connexions"};

/// What is wrong with a cell; the rest of this list says what.
inline constexpr Message<std::string_view, std::string_view, Localized> cell_refused{
    "cell '{}' of type {}: {}", "cellule « {} » de type {} : {}"};
inline constexpr Message<std::string_view, std::string_view> pin_connected_to{
    "port {} is connected to '{}'", "le port {} est connecté à « {} »"};
inline constexpr Message<std::string_view> pin_not_connected{"its port {} is not connected",
                                                             "son port {} n'est pas connecté"};
inline constexpr CountedMessage<std::string_view> wide_pin{
    {"its port {1} has {0} bit; split words into bits first (Yosys: simplemap)",
     "son port {1} a {0} bit ; décomposez d'abord les mots en bits (Yosys : simplemap)"},
    {"its port {1} has {0} bits; split words into bits first (Yosys: simplemap)",
     "son port {1} a {0} bits ; décomposez d'abord les mots en bits (Yosys : simplemap)"}};
inline constexpr Message<std::string_view> output_is_constant{
    "its output {} is connected to a constant", "sa sortie {} est connectée à une constante"};
inline constexpr Message<> operands_differ{"its operands differ in width",
                                           "ses opérandes n'ont pas la même largeur"};
inline constexpr Message<> table_does_not_fit{"its table does not fit its inputs",
                                              "sa table ne correspond pas à ses entrées"};
inline constexpr Message<> table_undefined{"its table has undefined entries",
                                           "sa table a des cases indéfinies"};
inline constexpr Message<> set_reset_latch{
    "latches with set or reset are not supported",
    "les bascules à verrouillage avec mise à 1 ou à 0 ne sont pas admises"};
inline constexpr Message<> asynchronous_flip_flop{
    "flip-flops with asynchronous set or reset are not supported",
    "les bascules avec mise à 1 ou à 0 asynchrone ne sont pas admises"};
inline constexpr Message<> falling_flip_flop{
    "flip-flops on the falling edge are not supported",
    "les bascules sur front descendant ne sont pas admises"};
inline constexpr Message<std::string_view, std::string_view> bad_parameter{
    "its {} is not valid: '{}'", "son paramètre {} n'est pas valable : « {} »"};
inline constexpr Message<> cell_not_supported{
    "cells of this type are not supported (Yosys: techmap; opt)",
    "les cellules de ce type ne sont pas admises (Yosys : techmap puis opt)"};
inline constexpr Message<> module_of_its_own{
    "it is a module of its own; flatten the netlist first",
    "c'est un module à part entière ; mettez d'abord le câblage à plat"};

}  // namespace messages::formats

}  // namespace grafwire
