#pragma once

#include "text/message.h"

namespace grafwire::messages::ladder_draw {

// The lists of variables, at the head; no longer than eleven characters.
inline constexpr Message<> inputs{"Inputs", "Entrées"};
inline constexpr Message<> outputs{"Outputs", "Sorties"};
/// The same in both languages.
inline constexpr Message<> bits{"Bits", "Bits"};
inline constexpr Message<> integers{"Integers", "Entiers"};
inline constexpr Message<> blocks{"Blocks", "Blocs"};

/// Of a rung that begins on the page before.
inline constexpr Message<> continued{"continued", "suite"};

}  // namespace grafwire::messages::ladder_draw
