#pragma once

#include <string>

#include "text/message.h"

namespace grafwire::messages::draw {

// What a viewer shows of the parts of a picture, and reads aloud.

inline constexpr Message<std::string> step{"step {}", "étape {}"};
inline constexpr Message<std::string> active_step{"step {}, active", "étape {}, active"};
inline constexpr Message<std::string> macro_step{"macro-step {}", "macro-étape {}"};

// Headings.

inline constexpr Message<std::string> expansion{"Expansion of {}", "Expansion de {}"};

/// The page, and how many there are.
inline constexpr Message<std::size_t, std::size_t> sheet{"sheet {} of {}", "folio {} sur {}"};
/// At a cut link: the step, and the page that it stands on.
inline constexpr Message<std::string, std::size_t> on_sheet{"{}, sheet {}", "{}, folio {}"};

// Timing diagrams.

/// The line that shows it; the same in both languages.
inline constexpr Message<> situation{"Situation", "Situation"};
/// The second line of a signal that two runs do not have in common.
inline constexpr Message<std::string> found{"{} found", "{} constaté"};
inline constexpr Message<> time{"time", "temps"};
inline constexpr Message<> inputs{"inputs", "entrées"};
inline constexpr Message<> steps{"steps", "étapes"};
inline constexpr Message<> outputs{"outputs", "sorties"};
/// Vars and counters.
inline constexpr Message<> internals{"internal", "internes"};
inline constexpr Message<> not_to_scale{
    "Only moments at which something changes are shown; time is not to scale.",
    "Seuls les instants où quelque chose change sont montrés ; le temps n'est pas à l'échelle."};

}  // namespace grafwire::messages::draw
