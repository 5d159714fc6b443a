#include "s7check/application.h"

#include <doctest/doctest.h>

#include "random/read_text.h"

namespace grafwire::testing {

namespace {

s7::Binding read_binding(const Grafcet& grafcet, const std::string& name) {
    Diagnostics diagnostics;
    const std::string text = example_text("s7-200/" + name + ".io");
    const auto binding = s7::bind(grafcet, read_assignment(text), diagnostics);
    REQUIRE_MESSAGE(binding.has_value(), format_diagnostics(diagnostics, {name + ".io", text}));
    return *binding;
}

}  // namespace

Application::Application(const std::string& application_name)
    : name(application_name),
      grafcet(*read_grafcet(example_text(application_name + ".grafcet"))),
      binding(read_binding(grafcet, application_name)) {}

CheckResult Application::check(const s7::Listing& listing, Time period) const {
    const ListingDevice device(listing, s7::Cpu::cpu_214, binding);
    return check_scans(grafcet, device, period != 0 ? period : natural_period(grafcet, device), {});
}

std::optional<Diagnosis> Application::cause(const s7::Listing& listing,
                                            const CheckResult& result) const {
    REQUIRE(result.witness);
    return localize_fault(grafcet, listing, s7::Cpu::cpu_214, binding, *result.witness);
}

}  // namespace grafwire::testing
