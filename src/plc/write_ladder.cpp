#include "plc/write_ladder.h"

#include "ladder/draw/write_drawings.h"
#include "ladder/ladder_from.h"
#include "plcopen/write_plcopen.h"

namespace grafwire {

namespace {

/// The ladder diagram of a program, written by `write`; nothing where it has none.
template <typename Write>
std::string ladder_of(const ScanProgram& program, Diagnostics& diagnostics, const Write& write) {
    const ladder::Ladder ladder = ladder::ladder_from(program, diagnostics);
    return diagnostics.has_errors() ? std::string() : write(ladder);
}

}  // namespace

std::string write_ladder_text(const ScanProgram& program, const PlcOptions&,
                              Diagnostics& diagnostics) {
    return ladder_of(program, diagnostics,
                     [](const ladder::Ladder& ladder) { return ladder::write_text(ladder); });
}

std::string write_ladder_svg(const ScanProgram& program, const PlcOptions&,
                             Diagnostics& diagnostics) {
    return ladder_of(program, diagnostics,
                     [](const ladder::Ladder& ladder) { return ladder::write_svg(ladder); });
}

std::string write_plcopen(const ScanProgram& program, const PlcOptions&, Diagnostics& diagnostics) {
    return ladder_of(program, diagnostics, [&](const ladder::Ladder& ladder) {
        return ladder::write_plcopen(program, ladder);
    });
}

}  // namespace grafwire
