#pragma once

#include <string>
#include <vector>

#include "s7/generate/listing_from.h"

namespace grafwire::testing {

/// A listing made from the text of a chart, or why there is none (its messages, a line each).
struct MadeListing {
    std::optional<s7::AssignedListing> made;
    std::string messages;
};
/// `io` is the text of an assignment; where empty, there is none. Modes are off.
MadeListing make_listing(const std::string& chart, const std::string& io = {},
                         s7::ListingOptions options = {}, bool modes = false);

/// The networks of one subroutine (-1: of OB1) as text, without the one that begins it and the one
/// that ends it, without numbers of networks and without offsets.
std::string subroutine_text(const s7::Listing& listing, int number);

}  // namespace grafwire::testing
