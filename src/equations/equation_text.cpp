#include "equations/equation_text.h"

#include "grafcet/write_grafcet.h"

namespace grafwire {

std::string equation_text(const Equations& equations, ExprId id) {
    return write_expression(*equations.grafcet, equations.expressions, id);
}

}  // namespace grafwire
