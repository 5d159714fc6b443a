#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "s7/listing.h"

namespace grafwire::s7 {

/// A listing seen as what is executed: the instructions in one row, and the blocks they form, OB1
/// first. The listing must outlive it.
struct Outline {
    struct Line {
        const Instruction* instruction = nullptr;
        std::uint32_t network = 0;  ///< index into Listing::networks
        bool begins_network = false;
    };
    struct Block {
        static constexpr std::int32_t main_program = -1;
        std::int32_t number = main_program;          ///< of the subroutine
        std::size_t first = 0;                       ///< index of its first line, SBR included
        std::size_t end = 0;                         ///< one past its last
        std::map<std::int32_t, std::size_t> labels;  ///< the line of each; the first of its number
    };
    std::vector<Line> lines;
    std::vector<Block> blocks;
    std::map<std::int32_t, std::size_t> subroutines;  ///< number to block; the first of its number

    const Instruction& at(std::size_t line) const { return *lines[line].instruction; }
};

Outline outline_of(const Listing& listing);

}  // namespace grafwire::s7
