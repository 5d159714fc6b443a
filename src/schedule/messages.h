#pragma once

#include <string>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on delays are about; `bad-time` and `time-order` are those of stimuli.
namespace code {
inline constexpr Code no_gate{"no-gate"};
}  // namespace code

/// What is said of delays.
namespace messages::schedule {

inline constexpr Message<> no_gate_name{
    "expected the name of a net that a gate drives (quoted, if it holds white space or '#')",
    "on attend le nom d'un fil commandé par une porte (entre guillemets droits s'il contient des "
    "espaces ou « # »)"};
inline constexpr Message<> unterminated_name{
    "the quoted name is not ended on its line",
    "le nom entre guillemets droits n'est pas fermé sur sa ligne"};
inline constexpr Message<Localized> unknown_gate{"the netlist has no net {}",
                                                 "le câblage n'a pas de fil {}"};
inline constexpr Message<Localized> is_an_input{
    "{} is an input of the netlist: no gate drives it",
    "{} est une entrée du câblage : aucune porte ne le commande"};
inline constexpr Message<Localized> named_twice{"{} has its delays already",
                                                "{} a déjà ses retards"};
inline constexpr Message<> others_named_twice{
    "'*', every other gate, has its delays already",
    "« * », toutes les autres portes, a déjà ses retards"};
inline constexpr Message<> given_here{"they are given here", "ils sont donnés ici"};
inline constexpr Message<> no_delay{
    "expected a time such as '3', '3.5' (in ns) or '12us'",
    "on attend un temps tel que « 3 », « 3.5 » (en ns) ou « 12us »"};
inline constexpr Message<Localized> bad_delay{
    "expected a time such as '3', '3.5' (in ns) or '12us', got {}",
    "on attend un temps tel que « 3 », « 3.5 » (en ns) ou « 12us » et non {}"};
inline constexpr Message<Localized> delay_not_positive{
    "a gate takes some time: {} is not more than 0",
    "une porte prend un certain temps : {} n'est pas supérieur à 0"};
inline constexpr Message<Localized> text_behind_delays{
    "nothing may follow the times of a gate but 'width' and the width of a pulse, got {}",
    "rien ne peut suivre les temps d'une porte, sauf « width » et la durée d'une impulsion ; {} "
    "est de trop"};
inline constexpr Message<Localized> pulse_has_one_delay{
    "{} gives pulses: it has one delay, and 'width' for how long they last",
    "{} donne des impulsions : un seul retard, et « width » pour leur durée"};
inline constexpr Message<Localized> has_no_width{
    "{} gives no pulses, so it has no width",
    "{} ne donne pas d'impulsions : pas de durée « width »"};
inline constexpr Message<> no_moment{
    "expected a moment after 'at', such as '20ms' or '20ms + 3'",
    "on attend un instant après « at », tel que « 20ms » ou « 20ms + 3 »"};
inline constexpr Message<Localized> bad_moment{
    "expected a moment after 'at', such as '20ms' or '20ms + 3', got {}",
    "on attend un instant après « at », tel que « 20ms » ou « 20ms + 3 », et non {}"};
inline constexpr Message<> text_behind_moment{"nothing may follow the moment on its line",
                                              "rien ne peut suivre l'instant sur sa ligne"};
inline constexpr Message<std::string, std::string> moment_order{
    "{} does not come after {}: sections stand in the order of time",
    "{} ne vient pas après {} : les sections suivent l'ordre du temps"};
inline constexpr Message<> from_the_start{
    "what holds from the start stands before the first 'at'",
    "ce qui vaut dès le début se place avant le premier « at »"};
inline constexpr Message<> that_moment_here{"that moment is here", "cet instant est ici"};

}  // namespace messages::schedule

}  // namespace grafwire
