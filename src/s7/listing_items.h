#pragma once

#include <vector>

#include "s7/listing.h"
#include "text/diagnostics.h"

namespace grafwire::s7 {

/// What a text of a listing consists of, in the order in which it is read: the beginnings of
/// networks, and instructions.
struct ListingItem {
    bool is_network = false;
    Network network;          ///< of a beginning: its number and comment
    Instruction instruction;  ///< else
    /// The column of print: 0, or 1 for what stands to the right of something else on its line.
    std::uint8_t column = 0;
};

/// Puts the items of a page with two columns in the order of the offsets, and says so in a warning.
/// Leaves items alone whose offsets ascend already, or that have none.
void order_columns(std::vector<ListingItem>& items, Diagnostics& diagnostics);

/// Appends the items to a listing, network by network. Instructions outside a network are an error,
/// numbers that do not ascend a warning.
void assemble(std::vector<ListingItem> items, Listing& listing, Diagnostics& diagnostics);

}  // namespace grafwire::s7
