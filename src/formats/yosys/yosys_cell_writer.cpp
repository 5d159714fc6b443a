// The cells after the Yosys manual's "Internal cell library". Yosys's gates have two inputs at
// most. Wider ones are single word-level cells, never trees of gates, which would take other
// delays:
//
//     AND  $reduce_and      NOR   $logic_not (1 where the word is 0)
//     OR   $reduce_or       NAND  $ne with a word of ones
//     XOR  $reduce_xor      constants: a buffer of "0" or "1"

#include "formats/yosys/yosys_cell_writer.h"

#include <array>

#include "formats/shared/append.h"
#include "formats/shared/helper_pins.h"

namespace grafwire {

namespace {

/// Any text within a JSON string.
void append_json_text(std::string& out, std::string_view text) {
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        append_comment(out, std::string_view(&c, 1));
    }
}

struct CellForm {
    std::string_view gate;  ///< of two inputs (of one, for types of one pin)
    std::string_view word;  ///< of any number
};

constexpr CellForm form_of(CellType type) {
    switch (type) {
        case CellType::low:
        case CellType::high:
        case CellType::buffer:
            return {"$_BUF_", ""};
        case CellType::inverter:
            return {"$_NOT_", ""};
        case CellType::and_gate:
            return {"$_AND_", "$reduce_and"};
        case CellType::or_gate:
            return {"$_OR_", "$reduce_or"};
        case CellType::nand_gate:
            return {"$_NAND_", "$ne"};
        case CellType::nor_gate:
            return {"$_NOR_", "$logic_not"};
        case CellType::xor_gate:
            return {"$_XOR_", "$reduce_xor"};
        case CellType::hold_latch:
            return {"$_DLATCH_P_", ""};
        case CellType::flip_flop:
            return {"$_DFF_P_", ""};
        default:
            return {"", ""};
    }
}

}  // namespace

bool is_yosys_black_box(CellType type) {
    return form_of(type).gate.empty();
}

void YosysCellWriter::write(const Cell& cell, const Module& module) {
    module_ = module.name;
    out_ += "{ \"type\": \"";
    write_gate(cell);
    out_ += " } }";
}

void YosysCellWriter::write_bit(NetId net) {
    append(out_, bit_of(net));
}

/// What a black box has for parameters stands here: those Yosys wants declared, which its JSON
/// cannot.
void YosysCellWriter::write_attributes(const Cell& cell) {
    const CellTypeRow& row = row_of(cell.type);
    out_ += ", \"attributes\": { \"module\": \"";
    append_json_text(out_, module_);
    out_ += '"';
    const Origin& origin = netlist_.origin_of(cell);
    const Location where = origin.where;
    // A cell of a netlist that was read stands in another file than the GRAFCET.
    if (where.is_known() && origin.kind != Origin::Kind::other)
        append(out_, ", \"grafcet_line\": \"line ", where.line, "\"");
    if (row.has_timing) {
        const Timing& timing = netlist_.timings[cell.timing];
        if (is_timer(cell.type)) append(out_, ", \"RISE\": \"", format_duration(timing.rise), '"');
        append(out_, ", \"FALL\": \"", format_duration(timing.fall), '"');
        if (timing.ordinal != Timing::no_ordinal) {
            append(out_, ", \"ORDINAL\": ", timing.ordinal);
        }
    }
    if (row.has_memory && form_of(cell.type).gate.empty() && cell.initial != Logic::unknown) {
        append(out_, ", \"INIT\": \"", cell.initial == Logic::one ? '1' : '0', '"');
    }
    out_ += " }";
}

void YosysCellWriter::write_word(const Cell& cell) {
    const bool is_comparison = cell.type == CellType::nand_gate;
    append(out_, form_of(cell.type).word,
           "\", \"parameters\": { \"A_SIGNED\": 0, \"A_WIDTH\": ", cell.pin_count);
    if (is_comparison) append(out_, ", \"B_SIGNED\": 0, \"B_WIDTH\": ", cell.pin_count);
    out_ += ", \"Y_WIDTH\": 1 }";
    write_attributes(cell);
    out_ += ", \"port_directions\": { \"A\": \"input\", ";
    if (is_comparison) out_ += "\"B\": \"input\", ";
    out_ += "\"Y\": \"output\" }, \"connections\": { \"A\": [ ";
    std::string_view separator;
    for (const NetId pin : netlist_.pins_of(cell)) {
        out_ += separator;
        write_bit(pin);
        separator = ", ";
    }
    if (is_comparison) {
        out_ += " ], \"B\": [ \"1\"";
        for (std::uint32_t i = 1; i < cell.pin_count; ++i) out_ += ", \"1\"";
    }
    out_ += " ], \"Y\": [ ";
    write_bit(cell.output);
    out_ += " ]";
}

void YosysCellWriter::write_gate(const Cell& cell) {
    const CellForm form = form_of(cell.type);
    if (form.gate.empty()) return write_black_box(cell);
    if (!form.word.empty() && cell.pin_count != 2) return write_word(cell);
    append(out_, form.gate, "\", \"parameters\": {}");
    write_attributes(cell);
    std::array<std::string_view, 2> inputs{"A", "B"};
    if (cell.type == CellType::hold_latch) inputs = {"D", "E"};
    if (cell.type == CellType::flip_flop) inputs = {"D", "C"};
    const std::string_view output = row_of(cell.type).has_memory ? "Q" : "Y";
    const bool is_constant = cell.pin_count == 0;
    const std::uint32_t input_count = is_constant ? 1 : cell.pin_count;
    out_ += ", \"port_directions\": { ";
    for (std::uint32_t i = 0; i < input_count; ++i) append(out_, '"', inputs[i], "\": \"input\", ");
    append(out_, '"', output, "\": \"output\" }, \"connections\": { ");
    if (is_constant) append(out_, "\"A\": [ \"", cell.type == CellType::high ? '1' : '0', "\" ], ");
    for (std::uint32_t i = 0; i < cell.pin_count; ++i) {
        append(out_, '"', inputs[i], "\": [ ");
        write_bit(netlist_.pins_of(cell)[i]);
        out_ += " ], ";
    }
    append(out_, '"', output, "\": [ ");
    write_bit(cell.output);
    out_ += " ]";
}

void YosysCellWriter::write_black_box(const Cell& cell) {
    const CellTypeRow& row = row_of(cell.type);
    append(out_, prefix_, row.name, "\", \"parameters\": {}");
    write_attributes(cell);
    out_ += ", \"port_directions\": { ";
    for (std::uint32_t i = 0; i < cell.pin_count; ++i) {
        append(out_, '"', helper_pin_name(cell.type, i), "\": \"input\", ");
    }
    out_ += "\"q\": \"output\" }, \"connections\": { ";
    for (std::uint32_t i = 0; i < cell.pin_count; ++i) {
        append(out_, '"', helper_pin_name(cell.type, i), "\": [ ");
        write_bit(netlist_.pins_of(cell)[i]);
        out_ += " ], ";
    }
    out_ += "\"q\": [ ";
    write_bit(cell.output);
    out_ += " ]";
}

}  // namespace grafwire
