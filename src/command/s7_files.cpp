#include <cstdio>

#include "command/inputs.h"
#include "s7/parse_listing.h"

namespace grafwire {

s7::Cpu cpu_named(const std::string& name) {
    return name == "212" ? s7::Cpu::cpu_212 : s7::Cpu::cpu_214;
}

std::optional<LoadedAssignment> load_assignment(const std::string& path) {
    Diagnostics diagnostics;
    SourceFile source = read_source(path, diagnostics);
    std::optional<s7::IoAssignment> assignment;
    if (!diagnostics.has_errors()) assignment = s7::parse_io_assignment(source, diagnostics);
    show_diagnostics(diagnostics, source);
    if (!assignment) return std::nullopt;
    return LoadedAssignment{std::move(source), std::move(*assignment)};
}

std::optional<s7::Listing> load_listing(const std::string& path, const std::string& cpu,
                                        const s7::IoAssignment* io) {
    Diagnostics diagnostics;
    const SourceFile source = read_source(path, diagnostics);
    std::optional<s7::Listing> listing;
    if (!diagnostics.has_errors()) {
        listing = s7::parse_listing(source, {cpu_named(cpu), io, false}, diagnostics);
    }
    show_diagnostics(diagnostics, source);
    return listing;
}

std::optional<s7::Binding> bind_listing(const Grafcet& grafcet, const s7::IoAssignment& io,
                                        const SourceFile& source) {
    Diagnostics diagnostics;
    auto binding = s7::bind(grafcet, io, diagnostics);
    show_diagnostics(diagnostics, source);
    return binding;
}

}  // namespace grafwire
