#include "plc/write_s7.h"

#include "s7/generate/assignment.h"
#include "s7/generate/listing_from.h"
#include "s7/write_listing.h"

namespace grafwire {

namespace {

std::optional<s7::AssignedListing> listing(const Grafcet& grafcet, const ScanProgram& program,
                                           const PlcOptions& options, Diagnostics& diagnostics) {
    return s7::listing_from(
        grafcet, program,
        {options.io, options.wide_tables, options.cpu, options.mnemonics, options.language},
        diagnostics);
}

}  // namespace

std::string write_s7(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                     Diagnostics& diagnostics) {
    const auto made = listing(grafcet, program, options, diagnostics);
    if (!made) return {};
    return s7::write_listing(made->listing, {options.mnemonics, options.offsets});
}

void check_s7_io(const Grafcet& grafcet, const PlcOptions& options, Diagnostics& diagnostics) {
    s7::resolve_assignment(grafcet, *options.io, options.wide_tables, diagnostics);
}

std::string write_s7_addresses(const Grafcet& grafcet, const ScanProgram& program,
                               const PlcOptions& options, Diagnostics& diagnostics) {
    const auto made = listing(grafcet, program, options, diagnostics);
    if (!made) return {};
    return s7::write_io_assignment(made->assignment, options.mnemonics);
}

}  // namespace grafwire
