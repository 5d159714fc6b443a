#pragma once

#include <string>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on stimuli are about.
namespace code {
inline constexpr Code bad_time{"bad-time"};
inline constexpr Code time_order{"time-order"};
inline constexpr Code bad_value{"bad-value"};
}  // namespace code

/// What is said of stimuli.
namespace messages::trace {

inline constexpr Message<> line_after_end{"nothing may follow the line that says 'end'",
                                          "rien ne peut suivre la ligne « end »"};
inline constexpr Message<> end_here{"'end' is here", "« end » est ici"};
inline constexpr Message<> colon_missing{"expected ':' between the time and the assignments",
                                         "on attend « : » entre l'instant et les affectations"};
inline constexpr Message<> no_time{
    "expected a time such as '100ms', '1.5s' or '+50ms' (units us, ms, s, min, h; at most 106 "
    "days)",
    "on attend un instant tel que « 100ms », « 1.5s » ou « +50ms » (unités us, ms, s, min, h ; au "
    "plus 106 jours)"};
inline constexpr Message<Localized> bad_time{
    "expected a time such as '100ms', '1.5s' or '+50ms' (units us, ms, s, min, h; at most 106 "
    "days), got {}",
    "on attend un instant tel que « 100ms », « 1.5s » ou « +50ms » (unités us, ms, s, min, h ; au "
    "plus 106 jours) et non {}"};
inline constexpr Message<> relative_first_line{
    "a time with '+' counts from the line before, and there is none: leave out the '+'",
    "un instant avec « + » se compte depuis la ligne précédente, et il n'y en a pas : ôtez le "
    "« + »"};
inline constexpr Message<> time_out_of_range{"the time is beyond the range of 106 days",
                                             "l'instant dépasse la limite de 106 jours"};
inline constexpr Message<std::string, std::string> time_order{
    "{} comes before {}, the time of an earlier line: lines stand in the order of time",
    "{} vient avant {}, l'instant d'une ligne précédente : les lignes suivent l'ordre du temps"};
inline constexpr Message<> that_line_here{"that line is here", "cette ligne est ici"};
inline constexpr Message<> text_behind_end{"nothing may stand behind 'end'",
                                           "rien ne peut suivre « end » sur sa ligne"};
inline constexpr Message<Localized> no_assignment{"expected '=' and 0 or 1 after {}",
                                                  "on attend « = » et 0 ou 1 après {}"};
inline constexpr Message<Localized> no_value{
    "expected 0 or 1 for {}; assignments are separated by white space",
    "on attend 0 ou 1 pour {} ; les affectations sont séparées par des espaces"};
inline constexpr Message<Localized, Localized> bad_value{
    "expected 0 or 1 for {}, got {}; assignments are separated by white space",
    "on attend 0 ou 1 pour {} et non {} ; les affectations sont séparées par des espaces"};
inline constexpr Message<> unterminated_name{
    "the quoted name is not ended on its line",
    "le nom entre guillemets droits n'est pas fermé sur sa ligne"};
inline constexpr Message<> no_input_name{
    "expected the name of an input (quoted, if it holds other characters than letters, digits and "
    "'_')",
    "on attend le nom d'une entrée (entre guillemets droits s'il contient autre chose que des "
    "lettres, des chiffres et « _ »)"};
inline constexpr Message<Localized> bad_input_name{
    "expected the name of an input, got {} (a name that begins with no letter is quoted)",
    "on attend le nom d'une entrée et non {} (un nom qui ne commence pas par une lettre se met "
    "entre guillemets droits)"};
inline constexpr Message<Localized> unknown_input{
    "{} is not an input of the GRAFCET nor a control input",
    "{} n'est ni une entrée du GRAFCET ni une entrée de commande"};

// The heads of a table at the terminal.

inline constexpr Message<> inputs{"inputs", "entrées"};
/// The same in both languages.
inline constexpr Message<> situation{"situation", "situation"};
inline constexpr Message<> outputs{"outputs", "sorties"};
inline constexpr Message<> vars{"vars", "variables"};
inline constexpr Message<> counters{"counters", "compteurs"};

}  // namespace messages::trace

}  // namespace grafwire
