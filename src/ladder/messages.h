#pragma once

#include "text/message.h"

namespace grafwire::messages::ladder {

inline constexpr Message<> sum_too_wide{
    "a sum here can exceed 64 bits, which no ladder diagram holds; use counters of smaller ranges",
    "une somme peut ici dépasser 64 bits, ce qu'aucun schéma à contacts ne contient ; prenez des "
    "compteurs à plages plus petites"};

}  // namespace grafwire::messages::ladder
