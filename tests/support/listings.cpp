#include "support/listings.h"

#include <doctest/doctest.h>

#include "s7/addresses/operand.h"

namespace grafwire::testing {

s7::Listing read_listing(const std::string& text, s7::Cpu cpu) {
    const SourceFile source{"test.awl", text};
    Diagnostics diagnostics;
    auto listing = s7::parse_listing(source, {cpu, nullptr, false}, diagnostics);
    REQUIRE_MESSAGE(listing.has_value(), format_diagnostics(diagnostics, source));
    return std::move(*listing);
}

s7::IoAssignment read_assignment(const std::string& text) {
    const SourceFile source{"test.io", text};
    Diagnostics diagnostics;
    auto assignment = s7::parse_io_assignment(source, diagnostics);
    REQUIRE_MESSAGE(assignment.has_value(), format_diagnostics(diagnostics, source));
    return std::move(*assignment);
}

std::string messages_of(const std::string& text, s7::Cpu cpu) {
    const SourceFile source{"test.awl", text};
    Diagnostics diagnostics;
    const auto listing = s7::parse_listing(source, {cpu, nullptr, false}, diagnostics);
    CHECK(listing.has_value() != diagnostics.has_errors());
    return format_diagnostics(diagnostics, source);
}

s7::Operand operand(const std::string& text) {
    const auto parsed = s7::parse_operand(text);
    REQUIRE_MESSAGE(parsed.has_value(), text);
    return *parsed;
}

void Controller::set(const std::string& input, bool value) {
    const s7::Operand place = operand(input);
    REQUIRE(place.area == s7::Area::input);
    std::uint8_t& byte = inputs.value[static_cast<std::size_t>(place.address)];
    const auto mask = static_cast<std::uint8_t>(1U << place.bit);
    byte = static_cast<std::uint8_t>(value ? byte | mask : byte & ~mask);
}

void Controller::scan(Time later) {
    if (has_scanned) now += later;
    has_scanned = true;
    const auto end = machine.scan(state, inputs, now);
    REQUIRE(end.is_done());
}

}  // namespace grafwire::testing
