#pragma once

#include <optional>
#include <string>

#include "check/scan_check.h"
#include "s7check/fault_localization.h"
#include "s7check/listing_device.h"
#include "support/listings.h"

namespace grafwire::testing {

/// One of the three published applications: its GRAFCET and its table of assignment.
struct Application {
    explicit Application(const std::string& name);

    /// What the check says of a listing, with a period or (0) its natural one.
    CheckResult check(const s7::Listing& listing, Time period = 0) const;
    /// And what the difference comes from; there must be one.
    std::optional<Diagnosis> cause(const s7::Listing& listing, const CheckResult& result) const;

    std::string name;
    Grafcet grafcet;
    s7::Binding binding;
};

}  // namespace grafwire::testing
