#pragma once

#include <string>

#include "equations/equations.h"

namespace grafwire {

/// One expression of the equations in the notation of the course: `(X7.e + X9.f)./Init`.
std::string equation_text(const Equations& equations, ExprId id);

}  // namespace grafwire
