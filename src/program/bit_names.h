#pragma once

#include <string>
#include <string_view>

#include "program/program.h"
#include "text/message.h"

namespace grafwire {

// What a program and its bits are called, before a language makes names of its own of it.

/// What a program is headed with: the name of the chart and, where it has one, its title.
std::string titled_name(const std::string& name, const std::string& title, Language language);

/// The table of the method that holds the bits of a kind (Cordier, section 3.2): `Ts`, `Tp`,
/// `Tfig`; empty for bits that stand alone.
std::string_view table_name(BitKind kind);

/// Whether the kind is a table with one bit per step.
bool is_step_table(BitKind kind);

/// What a bit stands for, in the words of the chart: the name of the input, output, var, step,
/// transition or graph; of edges, their memories and time conditions their text, `↑dcy`; of bits
/// that no part of the chart stands behind their number.
std::string name_in_chart(const Grafcet& grafcet, Bit bit);

}  // namespace grafwire
