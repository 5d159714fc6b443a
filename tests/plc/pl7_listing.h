#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "support/plc_machine.h"

namespace grafwire::testing {

/// `contacts --coil`.
struct Pl7Rung {
    std::string contacts;
    std::string coil;
    std::size_t line = 0;
};

struct Pl7Transition {
    std::vector<std::string> before;
    std::vector<std::string> after;
    Pl7Rung rung;
};

/// A PL7-2 listing.
struct Pl7Listing {
    /// The object of a name of the chart, by its letter.
    std::map<std::pair<std::string, char>, std::string> symbols;
    std::vector<Pl7Rung> preliminary, posterior;
    std::vector<Pl7Transition> transitions;
    std::set<std::string> steps, initial;
};

/// Reads a listing by its parts; what stands in the rungs is checked when they are executed.
Pl7Listing read_pl7(const std::string& text);

/// Whether an object is a bit: an input, output, internal bit, step, system bit or end of a timer.
bool is_pl7_bit(const std::string& object);

}  // namespace grafwire::testing
