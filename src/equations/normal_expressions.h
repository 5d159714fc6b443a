#pragma once

#include "equations/equations.h"

namespace grafwire {

/// Fills `expressions` and `from_grafcet` of the equations: every expression of the GRAFCET without
/// constant terms and without the variables of macro-steps and graphs. Edges and time conditions
/// keep their ordinals.
void normalise_expressions(Equations& equations);

}  // namespace grafwire
