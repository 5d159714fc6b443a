#pragma once

#include "grafcet/named_expression.h"
#include "grafcet/token_reader.h"

namespace grafwire {

// Both read from the present token on and report what they do not understand; they return false
// then.

/// A Boolean expression. It is empty if it has not been understood.
bool parse_expression(TokenReader& tokens, NamedExpression& expression);

/// A sum of counters and numbers.
bool parse_sum(TokenReader& tokens, NamedSum& sum);

}  // namespace grafwire
