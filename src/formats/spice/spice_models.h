#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "text/time.h"

namespace grafwire {

/// The models that depend on the netlist, with their numbers.
struct SpiceModels {
    std::map<std::pair<Time, Time>, std::size_t> timers;  ///< by their delays, rise and fall
    std::map<Time, std::size_t> pulses;                   ///< by their widths
};

/// Writes the `.model` lines of a deck that counts in picoseconds: gates of 1 ns (`slow_`), of a
/// picosecond less for those that a quick one follows (`held_`), and of one picosecond (`fast_`).
void append_spice_models(std::string& out, const SpiceModels& models);

}  // namespace grafwire
