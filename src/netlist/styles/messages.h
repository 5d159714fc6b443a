#pragma once

#include <string>
#include <string_view>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the netlist styles are about.
namespace code {
inline constexpr Code unsupported_by_style{"unsupported-by-style"};
}  // namespace code

namespace messages::netlist_styles {

inline constexpr Message<std::string_view, std::string> no_registers{
    "the {} style has no registers for the counter '{}'; use --style clocked",
    "le style {} n'a pas de registre pour le compteur « {} » ; utilisez --style clocked"};

// What the handshake style refuses. Names of transitions stand in brackets, as in the text.

inline constexpr Message<std::string> too_many_products{
    "the receptivity of transition ({}) is too long a sum of products for the handshake style; "
    "divide it between several transitions or steps",
    "la réceptivité de la transition ({}) est une somme de produits trop longue pour le style "
    "handshake ; répartissez-la entre plusieurs transitions ou étapes"};
inline constexpr Message<std::string> edge_of_expression{
    "the handshake style has only edges of inputs, not {}; wait for its level in two steps",
    "le style handshake ne connaît que les fronts d'entrées, pas {} ; attendez son niveau dans "
    "deux "
    "étapes"};
inline constexpr Message<std::string> edge_after_several_steps{
    "the handshake style has no edge {} after several steps: put a step between the convergence "
    "and "
    "the edge",
    "le style handshake n'admet pas le front {} après plusieurs étapes : intercalez une étape "
    "entre "
    "la convergence et le front"};
inline constexpr Message<std::string> edge_in_frozen_graph{
    "the handshake style has no edge {} in a graph that is frozen: an edge that comes meanwhile "
    "would not be lost",
    "le style handshake n'admet pas le front {} dans un graphe que l'on fige : un front survenu "
    "entre-temps ne serait pas perdu"};
inline constexpr Message<std::string, std::string, std::string> two_edges{
    "the handshake style leaves step {} on one edge only, not on {} and {}",
    "le style handshake ne quitte l'étape {} que sur un seul front, pas sur {} et {}"};
inline constexpr Message<std::string, std::string> edge_after_merge{
    "the handshake style has no edge {} after step {}, which may be entered while it is active or "
    "be active together with a step beside it",
    "le style handshake n'admet pas le front {} après l'étape {}, que l'on peut activer alors "
    "qu'elle l'est déjà, ou qui peut l'être en même temps qu'une étape voisine"};
inline constexpr Message<std::string, std::string> not_exclusive{
    "transitions ({}) and ({}) can be enabled and true at once: in the handshake style the faster "
    "one takes the token; make the receptivities exclude each other, or say with 'assume' that "
    "they do",
    "les transitions ({}) et ({}) peuvent être validées et vraies à la fois : dans le style "
    "handshake, la plus rapide prend le jeton ; rendez les réceptivités exclusives, ou déclarez-le "
    "par « suppose »"};
inline constexpr Message<std::string> time_of_sum{
    "the handshake style has time conditions of a product of inputs and steps only, with an "
    "on-delay "
    "and no off-delay, not {}",
    "le style handshake n'admet que des conditions de temps portant sur un produit d'entrées et "
    "d'étapes, avec un retard à la montée et aucun à la retombée, pas {}"};
inline constexpr Message<std::string, std::string> timed_step_entered_again{
    "{} is read where step {}, which has other ways out, may be left and entered again in one "
    "evolution: in the handshake style its timer might not notice",
    "{} est lue alors que l'étape {}, qui a d'autres sorties, peut être quittée et réactivée au "
    "cours "
    "d'une même évolution : dans le style handshake, son temporisateur pourrait ne rien voir"};
inline constexpr Message<std::string> reads_merging_step{
    "the handshake style has no X{0} in a receptivity: step {0} may be entered while it is active, "
    "or "
    "be active together with a step beside it",
    "le style handshake n'admet pas X{0} dans une réceptivité : l'étape {0} peut être activée "
    "alors "
    "qu'elle l'est déjà, ou l'être en même temps qu'une étape voisine"};
inline constexpr Message<std::string> true_after_time{
    "this receptivity is true only in the repetition in which {} still is, though its condition "
    "has "
    "ended: no gate of the handshake style can see that",
    "cette réceptivité n'est vraie que dans l'itération où {} l'est encore, bien que sa condition "
    "ait "
    "cessé : aucune porte du style handshake ne peut le voir"};
inline constexpr Message<std::string> reads_follower{
    "in the handshake style a transition cannot read X{}, which it activates itself",
    "dans le style handshake, une transition ne peut pas lire X{}, qu'elle active elle-même"};
inline constexpr Message<std::string> write_on_event{
    "the handshake style writes {} on activation, deactivation or clearing "
    "only, not on an event",
    "le style handshake n'écrit {} que sur activation, désactivation ou "
    "franchissement, pas sur un "
    "événement"};
inline constexpr Message<std::string> write_of_expression{
    "the handshake style sets and resets {}, but gives it no other value",
    "le style handshake met {} à 1 ou à 0, mais ne lui donne pas d'autre "
    "valeur"};
inline constexpr Message<std::string, std::string> activated_otherwise{
    "the handshake style writes {} where a transition is cleared; step {} is "
    "also activated by Init "
    "or by an order",
    "le style handshake écrit {} au franchissement d'une transition ; mais "
    "l'étape {} est aussi "
    "activée par Init ou par un ordre"};
inline constexpr Message<std::string, std::string> deactivated_otherwise{
    "the handshake style writes {} where a transition is cleared; step {} is "
    "also deactivated by "
    "Init, AUdur or an order",
    "le style handshake écrit {} au franchissement d'une transition ; mais "
    "l'étape {} est aussi "
    "désactivée par Init, AUdur ou un ordre"};
inline constexpr Message<std::string> write_while_active{
    "the handshake style has no stored actions on transition ({}): it is a "
    "source, or leads to a step "
    "that may be active already",
    "le style handshake n'admet pas d'actions mémorisées sur la transition "
    "({}) : elle est source, ou "
    "mène à une étape qui peut être déjà active"};
inline constexpr Message<std::string> enclosure{
    "the handshake style encloses only graphs without orders and sources, and not in one another; "
    "and step {} may not be forced, left on an edge or entered while it is active",
    "le style handshake n'englobe que des graphes sans ordres ni sources, et pas les uns dans les "
    "autres ; de plus, l'étape {} ne doit être ni forcée, ni quittée sur un front, ni activée "
    "alors "
    "qu'elle l'est déjà"};
inline constexpr Message<std::string> enclosure_entered_again{
    "step {} may be left and entered again in one evolution: in the handshake style nothing tells "
    "that the graph it encloses has been emptied in between",
    "l'étape {} peut être quittée et réactivée au cours d'une même évolution : dans le style "
    "handshake, rien n'indique que le graphe englobé a été vidé entre-temps"};
inline constexpr Message<std::string, std::string, std::string> rival_orders{
    "steps {} and {} can force graph {} at once: in the handshake style the slower order would win",
    "les étapes {} et {} peuvent forcer à la fois le graphe {} : dans le style handshake, l'ordre "
    "le "
    "plus lent l'emporterait"};
inline constexpr Message<std::string, std::string> forced_at_start{
    "step {} gives an order in a graph that the initial step {} forces: the handshake style has no "
    "initial situation for that",
    "l'étape {} donne un ordre dans un graphe que l'étape initiale {} force : le style handshake "
    "n'a "
    "pas de situation initiale pour cela"};
inline constexpr Message<std::string> edge_in_output{
    "the handshake style has no edge in the conditions of {}",
    "le style handshake n'admet pas de front dans les conditions de {}"};
inline constexpr Message<std::string> source_on_level{
    "the handshake style has sources on a single edge only: on a level, transition ({}) would be "
    "cleared again and again; write ↑ before the input",
    "le style handshake n'admet de transition source que sur un seul front : sur un niveau, la "
    "transition ({}) serait franchie sans cesse ; écrivez ↑ devant l'entrée"};

}  // namespace messages::netlist_styles

}  // namespace grafwire
