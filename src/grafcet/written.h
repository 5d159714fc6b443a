#pragma once

#include <string>
#include <string_view>

#include "grafcet/grafcet.h"

namespace grafwire {

/// The name of a step, graph or transition: digits stand without quotes.
void append_name(std::string& out, std::string_view name);

/// The name of a variable: digits alone would be read as a number and are quoted.
void append_variable_name(std::string& out, std::string_view name);

void append_sum(std::string& out, const Grafcet& grafcet, const Sum& sum);

}  // namespace grafwire
