#pragma once

#include <cstdint>
#include <string>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the order of clearing are about.
namespace code {
inline constexpr Code order_of_clearing{"order-of-clearing"};
}  // namespace code

namespace messages::orders {

// Races. Transitions are told with their steps: `(1) 2 -> 3`.

/// Arguments: the transition that is cleared first, the other.
inline constexpr Message<std::string, std::string> withdrawn{
    "{} and {} can be cleared at the same moment, but where the former goes first the latter can "
    "no longer be cleared, or not for the same reason",
    "{} et {} sont franchissables au même moment, mais si la première est franchie d'abord, la "
    "seconde ne peut plus l'être, ou plus pour la même raison"};
inline constexpr Message<std::string> withdrawn_by_time{
    "{} can be cleared only until a time condition has fallen that falls at the same moment",
    "{} n'est franchissable que tant qu'une temporisation n'est pas retombée, ce qu'elle fait au "
    "même moment"};
inline constexpr Message<std::string, std::string> arrival{
    "{} activates a step that is active and that {} is to leave at the same moment",
    "{} active une étape déjà active, que {} doit quitter au même moment"};
inline constexpr Message<std::string> arrival_at_itself{
    "{} activates the step that it leaves, again and again while its receptivity is 1",
    "{} active l'étape qu'elle quitte, sans cesse tant que sa réceptivité vaut 1"};
inline constexpr Message<std::string, std::string> difference{
    "{} and {} can be cleared at the same moment, and what there is in the end depends on which of "
    "them goes first",
    "{} et {} sont franchissables au même moment, et le résultat dépend de celle qui est franchie "
    "la première"};
inline constexpr Message<std::string> difference_by_time{
    "what there is in the end depends on whether {} is cleared before a time condition falls",
    "le résultat dépend de ce que {} soit franchie ou non avant qu'une temporisation ne retombe"};
inline constexpr Message<std::string, std::string> unrest{
    "{} and {} can be cleared at the same moment, and where the former goes first the evolution "
    "may never end",
    "{} et {} sont franchissables au même moment, et si la première est franchie d'abord, "
    "l'évolution peut ne jamais finir"};
inline constexpr Message<std::string> unrest_by_time{
    "where a time condition falls before {} is cleared the evolution may never end",
    "si une temporisation retombe avant que {} ne soit franchie, l'évolution peut ne jamais finir"};

/// Arguments: situations, as `{2, 12}`.
inline constexpr Message<std::string, std::string> ends{
    "situation in the end: {} if they are cleared together, {} otherwise",
    "situation finale : {} si elles sont franchies ensemble, {} sinon"};
inline constexpr Message<std::string> ends_alike{
    "the situation in the end is {} either way; but on the way a gate may be cut short, or a "
    "variable differ",
    "la situation finale est {} dans les deux cas ; mais en chemin une porte peut être "
    "interrompue, "
    "ou une variable différer"};
inline constexpr Message<std::string> no_end{
    "situation in the end: {} if they are cleared together, none otherwise",
    "situation finale : {} si elles sont franchies ensemble, aucune sinon"};

/// Argument: the stimuli, line by line.
inline constexpr Message<std::string> stimuli{"stimuli that lead there:\n{}",
                                              "stimuli qui y mènent :\n{}"};

inline constexpr Message<std::string> stimuli_in_one_line{"stimuli that lead there: {}",
                                                          "stimuli qui y mènent : {}"};

// Interlocks.

/// Arguments: the transition that waits, the one it waits for, its new receptivity.
inline constexpr Message<std::string, std::string, std::string> interlock{
    "{} waits until {} has been cleared or cannot be: its receptivity is {}",
    "{} attend que {} soit franchie ou ne puisse l'être : sa réceptivité est {}"};
/// Arguments: the interlocks, one a line.
inline constexpr Message<Localized> cure{"--interlock adds what helps:\n{}",
                                         "--interlock ajoute le remède :\n{}"};
/// Argument: an interlock.
inline constexpr Message<Localized> one_cure{"--interlock adds what helps: {}",
                                             "--interlock ajoute le remède : {}"};
inline constexpr Message<> no_cure{
    "no interlock was found that helps without changing what the chart does",
    "aucun verrouillage n'a été trouvé qui y remédie sans changer ce que fait le grafcet"};

}  // namespace messages::orders
}  // namespace grafwire
