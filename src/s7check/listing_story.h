#pragma once

#include <optional>
#include <string>

#include "check/witness.h"
#include "grafcet/grafcet.h"
#include "s7/machine/machine.h"
#include "s7check/blame.h"
#include "text/language.h"

namespace grafwire {

/// A witness against a listing in words: what changes, what the reference makes of it, where the
/// two part, and which network of the listing that comes from. `error`: what ended its last scan,
/// where something did.
std::string tell_listing_witness(const Grafcet& grafcet, const s7::Listing& listing,
                                 const Witness& witness, const std::optional<Finding>& finding,
                                 const std::optional<s7::RunError>& error, Language language);

}  // namespace grafwire
