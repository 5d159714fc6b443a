#include "plc/formats.h"

#include "plc/write_il.h"
#include "plc/write_pl7.h"
#include "plc/write_st.h"
#include "plc/write_stl.h"
#include "s7/listing_from.h"
#include "s7/write_listing.h"

namespace grafwire {

namespace {

std::string text(const ScanProgram& program, const PlcOptions&, Diagnostics&) {
    return write_program_text(program);
}

std::string s7_200(const ScanProgram& program, const PlcOptions& options,
                   Diagnostics& diagnostics) {
    const auto made = s7::listing_from(
        program, {options.io, options.wide_tables, options.cpu, options.mnemonics}, diagnostics);
    if (!made) return {};
    return s7::write_listing(made->listing, {options.mnemonics, true});
}

constexpr PlcFormat table[] = {
    {"text", ".txt", "the program of one scan, a statement a line", text},
    {"il", ".il", "Instruction List, a function block (IEC 61131-3)", write_il},
    {"pl7-2", ".txt", "PL7-2 with its GRAFCET (Telemecanique TSX 17-20, TSX 27, TSX 47)",
     write_pl7},
    {"st", ".st", "Structured Text, a function block (IEC 61131-3)", write_st},
    {"stl", ".awl", "Statement List for STEP 7 (SIMATIC S7-300, S7-400)", write_stl},
    {"s7-200", ".awl", "instruction list of the table method for Siemens S7-200", s7_200, true},
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
