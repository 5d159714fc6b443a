// The table of languages, which the command line, its help and the library read. A row says what a
// language is called and who writes it.

#include "plc/formats.h"

#include "ladder/draw/write_drawings.h"
#include "ladder/ladder_from.h"
#include "plc/computer/languages.h"
#include "plc/iec/languages.h"
#include "plc/pl7/write_pl7.h"
#include "plc/shared/source_text.h"
#include "plc/step7/write_stl.h"
#include "plcopen/write_project.h"
#include "program/bit_names.h"
#include "s7/generate/assignment.h"
#include "s7/generate/listing_from.h"
#include "s7/write_listing.h"

namespace grafwire {

namespace {

// Forms that have a folder of their own, as rows of the table.

std::string text(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                 Diagnostics&) {
    std::string head =
        comment_text(titled_name(grafcet.name, grafcet.title, options.language)) + '\n';
    if (!options.made_by.empty()) head += "# " + comment_text(options.made_by) + '\n';
    return "# " + head + write_program_text(grafcet, program, options.language);
}

void check_io_names(const Grafcet& grafcet, const PlcOptions& options, Diagnostics& diagnostics) {
    s7::check_assigned_names(grafcet, *options.io, diagnostics);
}

/// The ladder diagram of a program, written by `write`; nothing where it has none.
template <typename Write>
std::string ladder_of(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                      Diagnostics& diagnostics, const Write& write) {
    ladder::Ladder ladder = ladder::ladder_from(grafcet, program, diagnostics, options.language);
    if (!options.made_by.empty()) ladder.remarks.push_back(options.made_by);
    return diagnostics.has_errors() ? std::string() : write(ladder);
}

std::string write_ladder_text(const Grafcet& grafcet, const ScanProgram& program,
                              const PlcOptions& options, Diagnostics& diagnostics) {
    return ladder_of(grafcet, program, options, diagnostics, [&](const ladder::Ladder& ladder) {
        return ladder::write_text(ladder, 80, options.language);
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
        return plcopen::write_ladder_project(ladder, options.language);
    });
}

std::string write_sfc(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                      Diagnostics&) {
    return plcopen::write_sfc_project(grafcet,
                                      {program.has_modes, options.made_by, options.language});
}

std::optional<s7::AssignedListing> listing(const Grafcet& grafcet, const ScanProgram& program,
                                           const PlcOptions& options, Diagnostics& diagnostics) {
    return s7::listing_from(grafcet, program,
                            {options.io, options.wide_tables, options.cpu, options.mnemonics,
                             options.language, options.made_by},
                            diagnostics);
}

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

constexpr PlcFormat table[] = {
    {"text",
     ".txt",
     {"the program of one scan, a statement a line",
      "le programme d'une scrutation, une instruction par ligne"},
     text},
    {"il",
     ".il",
     {"Instruction List, a function block (IEC 61131-3)",
      "liste d'instructions (IL), un bloc fonctionnel (CEI 61131-3)"},
     write_il},
    {"ladder",
     ".txt",
     {"ladder diagram, in characters", "schéma à contacts, en caractères"},
     write_ladder_text},
    {"ladder-svg",
     ".svg",
     {"ladder diagram, as a picture in pages of A4", "schéma à contacts, en image par pages A4"},
     write_ladder_svg},
    {"pl7-2",
     ".txt",
     {"PL7-2 with its GRAFCET (Telemecanique TSX 17-20, TSX 27, TSX 47)",
      "PL7-2 avec son GRAFCET (Telemecanique TSX 17-20, TSX 27, TSX 47)"},
     write_pl7},
    {"plcopen",
     ".xml",
     {"ladder diagram, as a project (PLCopen TC6 XML 2.01)",
      "schéma à contacts, en projet (PLCopen TC6 XML 2.01)"},
     write_plcopen},
    {"sfc",
     ".xml",
     {"sequential function chart (SFC), as a project (PLCopen TC6 XML 2.01)",
      "diagramme fonctionnel en séquence (SFC), en projet (PLCopen TC6 XML 2.01)"},
     write_sfc},
    {"s7-200",
     ".awl",
     {"instruction list of the table method (SIMATIC S7-200)",
      "liste d'instructions de la méthode des tables (SIMATIC S7-200)"},
     write_s7,
     "--io --addresses --mnemonics --offsets --tables --cpu",
     check_s7_io,
     write_s7_addresses},
    {"st",
     ".st",
     {"Structured Text, a function block (IEC 61131-3)",
      "texte structuré (ST), un bloc fonctionnel (CEI 61131-3)"},
     write_st},
    {"stl",
     ".awl",
     {"Statement List for STEP 7 (SIMATIC S7-300, S7-400)",
      "liste d'instructions LIST (SIMATIC S7-300, S7-400)"},
     write_stl,
     "--io --mnemonics",
     check_io_names},
    {"c", ".c", {"C99, and C++", "C99, et C++"}, write_c},
    {"arduino",
     ".ino",
     {"a sketch for Arduino boards", "un croquis pour les cartes Arduino"},
     write_arduino,
     "--pull-up"},
    {"pascal", ".pas", {"Free Pascal", "Free Pascal"}, write_pascal},
    {"python", ".py", {"Python 3", "Python 3"}, write_python},
};

}  // namespace

std::span<const PlcFormat> plc_formats() {
    return table;
}

const PlcFormat* plc_format_named(std::string_view name) {
    for (const PlcFormat& format : table) {
        if (format.name == name) return &format;
    }
    return nullptr;
}

std::vector<std::string_view> plc_format_names() {
    std::vector<std::string_view> names;
    for (const PlcFormat& format : table) names.push_back(format.name);
    return names;
}

}  // namespace grafwire
