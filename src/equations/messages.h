#pragma once

#include <string>

#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

/// What diagnostics on the equations are about.
namespace code {
inline constexpr Code wiring_hazard{"wiring-hazard"};
}  // namespace code

/// What is said of charts that a wiring without a clock may get wrong. Names of steps stand bare.
namespace messages::equations {

inline constexpr Message<std::string> step_follows_itself{
    "step {} follows itself: with --cdx successor it resets itself as soon as it is set; use --cdx "
    "transition or the clocked style",
    "l'étape {} se succède à elle-même : avec --cdx successor, elle se remet à 0 dès qu'elle passe "
    "à 1 ; utilisez --cdx transition ou le style clocked"};
inline constexpr Message<std::string, std::string> steps_follow_each_other{
    "steps {} and {} follow each other: with --cdx successor either is reset by the one from which "
    "it is set; put a step between them, or use style nand or the clocked style",
    "les étapes {} et {} se succèdent mutuellement : avec --cdx successor, chacune est remise à 0 "
    "par celle qui l'active ; intercalez une étape, ou utilisez le style nand ou le style clocked"};
inline constexpr Message<> way_back_here{"the way back is here", "le retour est ici"};
inline constexpr Message<std::string, std::string> active_together{
    "steps {0} and {1} can be active together: with --cdx successor step {0} is then reset without "
    "this transition being cleared; use --cdx transition or the clocked style",
    "les étapes {0} et {1} peuvent être actives ensemble : avec --cdx successor, l'étape {0} est "
    "alors remise à 0 sans que cette transition soit franchie ; utilisez --cdx transition ou le "
    "style clocked"};
inline constexpr Message<std::string, std::string> edge_read_again{
    "{} is read again right after step {} was activated by it: a pulse longer than the passage "
    "through the step clears both transitions; wait for its end in a step between them, or use the "
    "clocked style",
    "{} est relu juste après avoir activé l'étape {} : une impulsion plus longue que le passage "
    "par l'étape franchit les deux transitions ; attendez sa fin dans une étape intermédiaire, ou "
    "utilisez le style clocked"};
inline constexpr Message<> transition_before_here{"the transition before is here",
                                                  "la transition précédente est ici"};

}  // namespace messages::equations

}  // namespace grafwire
