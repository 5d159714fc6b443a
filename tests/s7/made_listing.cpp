#include "s7/made_listing.h"

#include <doctest/doctest.h>

#include <sstream>

#include "random/read_text.h"
#include "s7/generate/assignment.h"
#include "s7/write_listing.h"

namespace grafwire::testing {

MadeListing make_listing(const std::string& chart, const std::string& io,
                         s7::ListingOptions options, bool modes) {
    MadeListing result;
    const auto grafcet = read_grafcet(chart, &result.messages);
    REQUIRE_MESSAGE(grafcet, result.messages);
    const auto say = [&](const Diagnostics& diagnostics) {
        for (const Diagnostic& item : diagnostics.items()) {
            const std::string place = item.where.is_known()
                                          ? std::to_string(item.where.line) + ":" +
                                                std::to_string(item.where.column) + ": "
                                          : "";
            result.messages += place + item.message.english + "\n";
        }
    };
    result.messages.clear();
    std::optional<s7::IoAssignment> assignment;
    if (!io.empty()) {
        Diagnostics of_io;
        assignment = s7::parse_io_assignment({"test.io", io}, of_io);
        if (assignment) s7::resolve_assignment(*grafcet, *assignment, options.wide_tables, of_io);
        say(of_io);
        if (of_io.has_errors()) return result;
        options.io = &*assignment;
    }
    Diagnostics diagnostics;
    result.made = s7::listing_from(*grafcet, program_from(*grafcet, {modes}), options, diagnostics);
    say(diagnostics);
    CHECK(result.made.has_value() != diagnostics.has_errors());
    return result;
}

std::string subroutine_text(const s7::Listing& listing, int number) {
    int at = -1;
    s7::Listing part;
    for (const s7::Network& network : listing.networks) {
        const s7::Instruction& first = network.instructions.front();
        if (first.operation == s7::Operation::subroutine) {
            at = first.operands[0].address;
        } else if (at == number && first.operation != s7::Operation::return_ &&
                   first.operation != s7::Operation::main_end) {
            part.networks.push_back(network);
            part.networks.back().number = 0;
        }
    }
    std::istringstream lines(s7::write_listing(part, {s7::Mnemonics::simatic, false}));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("NETWORK0")) line.replace(0, 8, "--");
        text += (line.starts_with("  ") ? line.substr(4) : line) + "\n";
    }
    return text;
}

}  // namespace grafwire::testing
