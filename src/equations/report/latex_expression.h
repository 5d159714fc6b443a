#pragma once

#include <string>

#include "grafcet/grafcet.h"

namespace grafwire {

/// The name of a variable in mathematical mode: `X_{10}`, `m`, `\mathrm{dcy}`, `\text{H+}`.
std::string latex_name(const Grafcet& grafcet, Variable variable);

/// `\mathrm{pieces} + 1`
std::string latex_sum(const Grafcet& grafcet, const Sum& sum);

/// A formula, and whether a slash stands in it for an overline that would have been too wide.
struct LatexFormula {
    std::string text;
    bool has_slash = false;
};

/// An expression in mathematical mode, with overlines for negations. No part that cannot be broken
/// is much wider than `room` points. A formula that is wider itself says where it is best broken:
/// before a plus sign.
LatexFormula latex_expression(const Grafcet& grafcet, const Expressions& pool, ExprId id,
                              double room);

}  // namespace grafwire
