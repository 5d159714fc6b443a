#include "plc/write_ladder.h"

#include "ladder/draw/write_drawings.h"
#include "ladder/ladder_from.h"
#include "plcopen/write_project.h"

namespace grafwire {

namespace {

/// The ladder diagram of a program, written by `write`; nothing where it has none.
template <typename Write>
std::string ladder_of(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                      Diagnostics& diagnostics, const Write& write) {
    const ladder::Ladder ladder =
        ladder::ladder_from(grafcet, program, diagnostics, options.language);
    return diagnostics.has_errors() ? std::string() : write(ladder);
}

}  // namespace

std::string write_ladder_text(const Grafcet& grafcet, const ScanProgram& program,
                              const PlcOptions& options, Diagnostics& diagnostics) {
    return ladder_of(grafcet, program, options, diagnostics, [&](const ladder::Ladder& ladder) {
        return ladder::write_text(ladder, 100, options.language);
    });
}

std::string write_ladder_svg(const Grafcet& grafcet, const ScanProgram& program,
                             const PlcOptions& options, Diagnostics& diagnostics) {
    return ladder_of(grafcet, program, options, diagnostics, [&](const ladder::Ladder& ladder) {
        return ladder::write_svg(ladder, options.language);
    });
}

std::string write_plcopen(const Grafcet& grafcet, const ScanProgram& program,
                          const PlcOptions& options, Diagnostics& diagnostics) {
    return ladder_of(grafcet, program, options, diagnostics, [&](const ladder::Ladder& ladder) {
        return plcopen::write_project(grafcet, ladder, options.language);
    });
}

}  // namespace grafwire
