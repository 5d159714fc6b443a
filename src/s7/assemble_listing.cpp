#include <fmt/format.h>

#include "s7/listing_items.h"

namespace grafwire::s7 {

void assemble(std::vector<ListingItem> items, Listing& listing, Diagnostics& diagnostics) {
    for (ListingItem& item : items) {
        if (item.is_network) {
            const std::uint32_t last =
                listing.networks.empty() ? 0 : listing.networks.back().number;
            if (!listing.networks.empty() && item.network.number <= last) {
                diagnostics.warning(
                    Code::read_leniently, item.network.where,
                    fmt::format("network {} comes after network {}: their numbers do not ascend",
                                item.network.number, last));
            }
            listing.networks.push_back(std::move(item.network));
            continue;
        }
        if (listing.networks.empty()) {
            diagnostics.error(Code::bad_network, item.instruction.where,
                              "an instruction outside a network: begin it with a line NETWORK 1");
            listing.networks.emplace_back();
        }
        listing.networks.back().instructions.push_back(std::move(item.instruction));
    }
}

}  // namespace grafwire::s7
