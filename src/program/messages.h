#pragma once

#include <string>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on programs in other languages are about.
namespace code {
inline constexpr Code beyond_limit{"beyond-limit"};
inline constexpr Code unsupported_by_language{"unsupported-by-language"};
}  // namespace code

/// What statements are for, as programs in all languages say it in their comments.
namespace messages::program {

/// A chart and its title, as every program is headed.
inline constexpr Message<std::string, std::string> titled{"{}: {}", "{} : {}"};

inline constexpr Message<> no_graph_frozen{"no graph is frozen",
                                           "aucun grafcet partiel n'est figé"};
inline constexpr Message<std::string> initial_step{"initial step {}", "étape initiale {}"};
inline constexpr Message<std::string> memory_of_edge{"memory of {}", "mémoire de {}"};
inline constexpr Message<> init_sets{"Init: initial steps", "Init : étapes initiales"};
inline constexpr Message<> init_resets{"Init: all other steps", "Init : toutes les autres étapes"};
inline constexpr Message<> au_dur_resets{"AUdur: every step", "AUdur : toutes les étapes"};
inline constexpr Message<std::string> may_evolve{"{} may evolve", "{} peut évoluer"};
/// A whole-table operation written out for one step, the same in both languages.
inline constexpr Message<Localized, std::string> for_step{"{}, X{}", "{}, X{}"};

// Forcing and enclosures.
inline constexpr Message<std::string> is_ordered{"an order bears on {}", "{} reçoit un ordre"};
inline constexpr Message<std::string> forcing_orders{"forcing orders of step {}",
                                                     "ordres de forçage de l'étape {}"};
inline constexpr Message<std::string, std::string> is_enclosed{"{} is enclosed by step {}",
                                                               "{} est encapsulé par l'étape {}"};
inline constexpr Message<std::string> activation_links{"activation links of {}",
                                                       "liens d'activation de {}"};

// Stored actions: what is written, and when.
inline constexpr Message<std::string, std::string> on_activation{"{} on activation of step {}",
                                                                 "{} à l'activation de l'étape {}"};
inline constexpr Message<std::string, std::string> on_deactivation{
    "{} on deactivation of step {}", "{} à la désactivation de l'étape {}"};
inline constexpr Message<std::string, std::string> on_clearing{"{} on clearing of {}",
                                                               "{} au franchissement de {}"};
inline constexpr Message<std::string, std::string> on_event{"{} on an event in step {}",
                                                            "{} sur événement à l'étape {}"};
inline constexpr Message<Localized> event_of{"event of {}", "événement pour {}"};
inline constexpr Message<Localized> value_of{"value of {}", "valeur de {}"};

}  // namespace messages::program

}  // namespace grafwire
