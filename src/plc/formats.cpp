#include "plc/formats.h"

#include "plc/computer/languages.h"
#include "plc/iec/write_il.h"
#include "plc/iec/write_st.h"
#include "plc/pl7/write_pl7.h"
#include "plc/step7/write_stl.h"
#include "plc/write_ladder.h"
#include "plc/write_s7.h"
#include "s7/generate/assignment.h"

namespace grafwire {

namespace {

std::string text(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                 Diagnostics&) {
    return write_program_text(grafcet, program, options.language);
}

void check_io_names(const Grafcet& grafcet, const PlcOptions& options, Diagnostics& diagnostics) {
    s7::check_assigned_names(grafcet, *options.io, diagnostics);
}

constexpr PlcFormat table[] = {
    {"text", ".txt", "the program of one scan, a statement a line", text},
    {"il", ".il", "Instruction List, a function block (IEC 61131-3)", write_il},
    {"ladder", ".txt", "ladder diagram, in characters", write_ladder_text},
    {"ladder-svg", ".svg", "ladder diagram, as a picture", write_ladder_svg},
    {"pl7-2", ".txt", "PL7-2 with its GRAFCET (Telemecanique TSX 17-20, TSX 27, TSX 47)",
     write_pl7},
    {"plcopen", ".xml", "ladder diagram and SFC, as a project (PLCopen TC6 XML 2.01)",
     write_plcopen},
    {"s7-200", ".awl", "instruction list of the table method (SIMATIC S7-200)", write_s7,
     "--io --addresses --mnemonics --offsets --tables --cpu", check_s7_io, write_s7_addresses},
    {"st", ".st", "Structured Text, a function block (IEC 61131-3)", write_st},
    {"stl", ".awl", "Statement List for STEP 7 (SIMATIC S7-300, S7-400)", write_stl,
     "--io --mnemonics", check_io_names},
    {"c", ".c", "C99, and C++", write_c},
    {"arduino", ".ino", "a sketch for Arduino boards", write_arduino},
    {"pascal", ".pas", "Free Pascal", write_pascal},
    {"python", ".py", "Python 3", write_python},
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
