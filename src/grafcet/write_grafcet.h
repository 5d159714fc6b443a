#pragma once

#include <string>

#include "grafcet/grafcet.h"

namespace grafwire {

/// The GRAFCET in the `.grafcet` language, in one canonical layout. Reading it back gives the same
/// model (apart from locations), and writing that gives the same text.
std::string write_grafcet(const Grafcet& grafcet);

/// One expression in the same notation, with no parentheses beyond those it needs: `X0.↑m + /(a +
/// b)`. Names that the language would not read as one word are quoted.
std::string write_expression(const Grafcet& grafcet, const Expressions& expressions, ExprId id);

/// A forcing or freezing order, `H{10, 20}`, and a stored write, `c := c + 1`, likewise.
std::string write_order(const Grafcet& grafcet, const Order& order);
std::string write_write(const Grafcet& grafcet, const Write& write);

/// A name as the language writes it: quoted only where it has to be.
std::string quoted_where_needed(std::string_view name);

/// The name of a step, graph or transition: digits stand without quotes.
void append_name(std::string& out, std::string_view name);

/// The name of a variable: digits alone would be read as a number and are quoted.
void append_variable_name(std::string& out, std::string_view name);

void append_sum(std::string& out, const Grafcet& grafcet, const Sum& sum);

}  // namespace grafwire
