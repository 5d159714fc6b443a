#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "s7/listing.h"

namespace grafwire::testing {

/// One row of a table of mistakes in examples/s7-200/README.md.
struct Correction {
    std::uint32_t network = 0;
    /// What is printed, and what it must be: instructions, or single operands one for one.
    std::vector<std::string> printed;
    std::vector<std::string> must_be;
    bool of_offsets = false;  ///< nothing but offsets
};

/// The rows with one number.
struct Mistake {
    std::string number;
    std::string found_by;
    std::vector<Correction> corrections;

    bool concerns(std::uint32_t network) const;
    /// Whether a correction writes a bit.
    bool writes(const s7::Operand& bit) const;
};

/// The mistakes of an application, by the heading of its table.
std::vector<Mistake> mistakes_of(const std::string& heading);

/// Corrects a mistake; what is printed must be there.
void correct(s7::Listing& listing, const Mistake& mistake);

}  // namespace grafwire::testing
