#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/scanned_device.h"
#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "s7/listing.h"
#include "s7check/fault_localization.h"
#include "text/message.h"

namespace grafwire {

/// A witness against a listing explained: what changes, what the reference makes of it, where the
/// two part, and which network of the listing that comes from. `stop`: where the listing
/// stopped in the last scan, if it did; then nothing could be compared, and that is all there is to
/// say.
std::string explain_listing_witness(const Grafcet& grafcet, const s7::Listing& listing,
                                    const Witness& witness,
                                    const std::optional<Diagnosis>& diagnosis,
                                    const std::optional<ScannedDevice::Stop>& stop,
                                    Language language);

/// Of a network the instructions that write one of some places: the logic before each of them, up
/// to it. Where none does, those that set something or leave the network, for one of them should
/// have; and where there are none of these either, its first ones. At most `most` of them.
std::vector<const s7::Instruction*> excerpt(const s7::Network& network,
                                            const std::vector<s7::Operand>& places,
                                            std::size_t most);

}  // namespace grafwire
