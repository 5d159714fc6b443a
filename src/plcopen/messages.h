#pragma once

#include <string>
#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on PLCopen projects are about.
namespace code {
inline constexpr Code bad_ladder{"bad-ladder"};
}  // namespace code

namespace messages::plcopen {

// The project.
/// Why is quoted from the XML reader, which speaks English.
inline constexpr Message<std::string_view> no_xml{
    "this is no XML: the XML reader says \"{}\"",
    "ce n'est pas du XML : l'analyseur XML dit « {} »"};
inline constexpr Message<> no_project{
    "this is no PLCopen project: its outermost element is not <project>",
    "ce n'est pas un projet PLCopen : son élément racine n'est pas <project>"};
inline constexpr Message<> no_ladder{
    "the project holds no program in ladder diagram (LD)",
    "le projet ne contient aucun programme en langage à contacts (LD)"};
inline constexpr Message<std::string_view> no_ladder_named{
    "the project holds no program '{}' in ladder diagram",
    "le projet ne contient aucun programme « {} » en langage à contacts"};
inline constexpr Message<std::string_view> several_ladders{
    "the project holds several programs in ladder diagram; say which: {}",
    "le projet contient plusieurs programmes en langage à contacts ; dites lequel : {}"};

// Variables.
inline constexpr Message<std::string_view, std::string_view> no_initial_value{
    "'{}' is no initial value of '{}'", "« {} » n'est pas une valeur initiale de « {} »"};
inline constexpr Message<std::string_view, std::string_view> foreign_type{
    "'{}' is of type {}; only BOOL, integers and the blocks of IEC 61131-3 are understood here",
    "« {} » est du type {} ; seuls BOOL, les entiers et les blocs de la CEI 61131-3 sont admis "
    "ici"};
inline constexpr Message<std::string_view> undeclared{
    "the program declares no variable '{}'", "le programme ne déclare aucune variable « {} »"};
inline constexpr Message<std::string_view, std::string_view> undeclared_near{
    "the program declares no variable '{}'; did you mean '{}'?",
    "le programme ne déclare aucune variable « {} » ; vouliez-vous dire « {} » ?"};
inline constexpr Message<std::string_view> no_bit{"'{}' is no bit", "« {} » n'est pas un bit"};
inline constexpr Message<std::string_view> no_integer{"'{}' is no integer",
                                                      "« {} » n'est pas un entier"};
inline constexpr Message<std::string_view, std::string_view> other_declaration{
    "'{}' is declared otherwise than as {}", "« {} » n'est pas déclaré comme {}"};
inline constexpr Message<std::string_view> no_constant_time{
    "'{}' is no time that is known beforehand: write one as T#1.5s",
    "« {} » n'est pas une durée connue d'avance : écrivez-en une comme T#1.5s"};

// Elements.
inline constexpr Message<std::string_view> unknown_element{
    "<{}> is not understood in a ladder diagram", "<{}> n'est pas admis dans un schéma à contacts"};
inline constexpr Message<> no_local_id{"an element needs a localId of its own",
                                       "un élément doit avoir un localId qui lui soit propre"};
inline constexpr Message<std::string_view> unknown_block{"a block of type '{}' is not understood",
                                                         "un bloc de type « {} » n'est pas admis"};
inline constexpr Message<> edge_at_block{
    "an edge at an input of a block is not understood; put R_TRIG or F_TRIG before it",
    "un front à l'entrée d'un bloc n'est pas admis ; placez R_TRIG ou F_TRIG avant lui"};
inline constexpr Message<> in_out_variable{
    "in-out variables of a block are not understood",
    "les variables d'entrée-sortie d'un bloc ne sont pas admises"};
inline constexpr Message<> negated_output{
    "a negated output of a block is not understood; negate the contact or coil after it",
    "une sortie inversée d'un bloc n'est pas admise ; inversez le contact ou la bobine qui suit"};
inline constexpr Message<std::string_view> no_such_element{"there is no element with localId {}",
                                                           "il n'y a pas d'élément de localId {}"};
inline constexpr Message<> without_outlet{"nothing comes out of that element",
                                          "rien ne sort de cet élément"};
inline constexpr Message<> no_connector{"a continuation here has no connector of its name",
                                        "une continuation n'a ici aucun connecteur de son nom"};

// Networks.
inline constexpr Message<> coil_marks{
    "a coil can be negated, set, reset or of an edge, only one of them",
    "une bobine peut être inversée, de mise à 1, de mise à 0 ou de front, mais une seule de ces "
    "choses à la fois"};
inline constexpr Message<> coil_not_connected{"this coil is not connected",
                                              "cette bobine n'est pas raccordée"};
inline constexpr Message<> block_in_a_circle{
    "this block depends on itself in a circle of wires",
    "ce bloc dépend de lui-même par une boucle de liaisons"};
inline constexpr Message<std::string_view> input_not_connected{
    "input {} of this block is not connected", "l'entrée {} de ce bloc n'est pas raccordée"};
inline constexpr Message<> nested_too_deeply{"the blocks of this network are nested too deeply",
                                             "les blocs de ce réseau sont trop imbriqués"};
inline constexpr Message<> too_entangled{
    "this network is too entangled; divide it into several",
    "ce réseau est trop enchevêtré ; partagez-le en plusieurs"};
inline constexpr Message<> element_not_connected{
    "this element is not connected to anything on its left",
    "cet élément n'est raccordé à rien sur sa gauche"};
inline constexpr Message<> too_long{"this network is too long; divide it into several",
                                    "ce réseau est trop long ; partagez-le en plusieurs"};
inline constexpr Message<> element_in_a_circle{
    "this element feeds itself in a circle of wires",
    "cet élément s'alimente lui-même par une boucle de liaisons"};
inline constexpr Message<> no_power{"no power comes out of this element",
                                    "aucun courant ne sort de cet élément"};
inline constexpr Message<> negated_edge{"a negated contact of an edge is not understood",
                                        "un contact de front inversé n'est pas admis"};
inline constexpr Message<> never_1{
    "a branch that is never 1 is not understood; leave it out",
    "une branche qui n'est jamais à 1 n'est pas admise ; supprimez-la"};
inline constexpr Message<> number_as_power{
    "the result of this block is a number; only its ENO is power",
    "le résultat de ce bloc est un nombre ; seul son ENO est une liaison de courant"};
inline constexpr Message<std::string_view> no_number{
    "input {} of this block is fed by no number",
    "l'entrée {} de ce bloc n'est alimentée par aucun nombre"};

// What a project that is written says of its variables.
inline constexpr Message<std::string, std::string> commented_name{"{}: {}", "{} : {}"};
inline constexpr Message<> changed_names{"Names that had to be changed:",
                                         "Noms qu'il a fallu changer :"};
inline constexpr Message<std::string, std::string> changed_name{"{} is \"{}\"", "{} pour « {} »"};
inline constexpr Message<std::string> when_scan_began{"when the scan began: {}",
                                                      "en début de scrutation : {}"};
inline constexpr Message<std::string> before_this_scan{"before this scan: {}",
                                                       "avant cette scrutation : {}"};
inline constexpr Message<> started{"0 in the first scan only",
                                   "0 à la première scrutation seulement"};

}  // namespace messages::plcopen

}  // namespace grafwire
