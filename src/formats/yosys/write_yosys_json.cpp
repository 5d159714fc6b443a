// Yosys JSON after the help text of Yosys's write_json, its cells after the chapters on the
// internal cell library in the Yosys manual. Gates have two inputs at most there. Wider ones are
// single word-level cells, never trees of gates, which would take other delays:
//
//     AND  $reduce_and      NOR   $logic_not (1 where the word is 0)
//     OR   $reduce_or       NAND  $ne with a word of ones
//     XOR  $reduce_xor      constants: a buffer of "0" or "1"
//
// What a black box has for parameters stands among its attributes: Yosys wants parameters declared,
// which its JSON cannot.

#include "formats/yosys/write_yosys_json.h"

#include <array>

#include "formats/shared/append.h"
#include "formats/shared/helper_cells.h"
#include "formats/shared/net_spelling.h"
#include "text/version.h"

namespace grafwire {

namespace {

/// A name within a JSON string. Yosys has no white space and control characters in names.
void spell_json(std::string& out, std::string_view name) {
    std::string safe;
    append_percent_escaped(safe, name, is_control_or_blank);
    for (const char c : safe) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
}

/// Any text within a JSON string.
void append_json_text(std::string& out, std::string_view text) {
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        append_comment(out, std::string_view(&c, 1));
    }
}

/// The cells of Yosys for a type.
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

/// Whether Yosys has no cell for a type, so that a black box stands for it.
constexpr bool is_black_box(CellType type) {
    return form_of(type).gate.empty();
}

/// The file, written from front to back: nets are numbered as in the netlist, so nothing has to be
/// kept.
class JsonWriter {
  public:
    explicit JsonWriter(const Netlist& netlist)
        : netlist_(netlist),
          nets_(netlist, spell_json),
          suffix_(cell_suffix(netlist)),
          helpers_(helper_prefix(netlist)),
          initial_(netlist.net_count(), Logic::unknown) {
        for (const Netlist::InitialValue& item : netlist.initial_values) {
            initial_[index_of(item.net)] = logic_of(item.value);
        }
        for (const Cell& cell : netlist.cells) {
            const bool is_box = is_black_box(cell.type);
            if (is_box) used_boxes_[static_cast<std::size_t>(cell.type)] = true;
            if (row_of(cell.type).has_memory && !is_box)
                initial_[index_of(cell.output)] = cell.initial;
        }
    }

    std::string write();

  private:
    void write_ports();
    void write_cells();
    void write_cell(const Cell& cell, const Module& module);
    void write_gate(const Cell& cell, const Module& module);
    void write_word(const Cell& cell, const Module& module);
    void write_black_box(const Cell& cell, const Module& module);
    void write_attributes(const Cell& cell, const Module& module);
    void write_net_names();
    void write_black_box_module(const CellTypeRow& row);
    /// The number of a net in lists of bits; 0 and 1 are kept for constants.
    void write_bit(NetId net) { append(out_, index_of(net) + 2); }

    const Netlist& netlist_;
    NetSpelling nets_;
    std::string suffix_;
    std::string helpers_;  ///< begins the names of black boxes
    std::vector<Logic> initial_;
    std::array<bool, cell_table.size()> used_boxes_{};
    std::string out_;
};

std::string JsonWriter::write() {
    out_.reserve(netlist_.cells.size() * 400);
    out_ += "{\n  \"creator\": \"" + program_and_version() + "\",\n  \"modules\": {\n    \"";
    spell_json(out_, netlist_.name);
    out_ += "\": {\n      \"attributes\": { \"top\": 1 },\n";
    write_ports();
    write_cells();
    write_net_names();
    out_ += "    }";
    for (const CellTypeRow& row : cell_table) {
        if (used_boxes_[static_cast<std::size_t>(row.type)]) write_black_box_module(row);
    }
    out_ += "\n  }\n}\n";
    return std::move(out_);
}

/// `"X0": { "direction": "output", "bits": [ 7 ] }`
void JsonWriter::write_ports() {
    out_ += "      \"ports\": {";
    std::string_view separator = "\n";
    const auto write_all = [&](const std::vector<Port>& ports, std::string_view direction) {
        for (const Port& port : ports) {
            append(out_, separator, "        \"");
            spell_json(out_, port.name);
            append(out_, "\": { \"direction\": \"", direction, "\", \"bits\": [ ");
            write_bit(port.net);
            out_ += " ] }";
            separator = ",\n";
        }
    };
    write_all(netlist_.inputs, "input");
    write_all(netlist_.outputs, "output");
    out_ += "\n      },\n";
}

/// A cell is called like the net that it drives, with the suffix for cells.
void JsonWriter::write_cells() {
    out_ += "      \"cells\": {";
    std::string_view separator = "\n";
    for (const Module& module : netlist_.modules) {
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            const Cell& cell = netlist_.cells.items()[module.first_cell + i];
            append(out_, separator, "        \"", nets_[cell.output], suffix_, "\": ");
            write_cell(cell, module);
            separator = ",\n";
        }
    }
    out_ += "\n      },\n";
}

void JsonWriter::write_cell(const Cell& cell, const Module& module) {
    out_ += "{ \"type\": \"";
    write_gate(cell, module);
    out_ += " } }";
}

/// Where a cell comes from, and the parameters of a black box.
void JsonWriter::write_attributes(const Cell& cell, const Module& module) {
    out_ += ", \"attributes\": { \"module\": \"";
    append_json_text(out_, module.name);
    out_ += '"';
    const Origin& origin = netlist_.origin_of(cell);
    const Location where = origin.where;
    // A cell of a netlist that was read stands in another file than the GRAFCET.
    if (where.is_known() && origin.kind != Origin::Kind::other)
        append(out_, ", \"grafcet_line\": \"line ", where.line, "\"");
    if (is_black_box(cell.type)) {
        for (const auto& [name, value] : helper_parameters(netlist_, cell)) {
            const std::string_view quote = name == "ORDINAL" ? "" : "\"";
            append(out_, ", \"", name, "\": ", quote, value, quote);
        }
    }
    out_ += " }";
}

/// A word-level cell over all pins; a NAND compares them with ones.
void JsonWriter::write_word(const Cell& cell, const Module& module) {
    const bool is_comparison = cell.type == CellType::nand_gate;
    append(out_, form_of(cell.type).word,
           "\", \"parameters\": { \"A_SIGNED\": 0, \"A_WIDTH\": ", cell.pin_count);
    if (is_comparison) append(out_, ", \"B_SIGNED\": 0, \"B_WIDTH\": ", cell.pin_count);
    out_ += ", \"Y_WIDTH\": 1 }";
    write_attributes(cell, module);
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

/// A cell of Yosys's gate library where it has the right number of inputs.
void JsonWriter::write_gate(const Cell& cell, const Module& module) {
    const CellForm form = form_of(cell.type);
    if (form.gate.empty()) return write_black_box(cell, module);
    if (!form.word.empty() && cell.pin_count != 2) return write_word(cell, module);
    append(out_, form.gate, "\", \"parameters\": {}");
    write_attributes(cell, module);
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

/// A cell that Yosys has not, by the names of its pins.
void JsonWriter::write_black_box(const Cell& cell, const Module& module) {
    append(out_, helpers_, row_of(cell.type).name, "\", \"parameters\": {}");
    write_attributes(cell, module);
    out_ += ", \"port_directions\": { ";
    const auto pins = netlist_.pins_of(cell);
    const auto names = helper_pins(cell.type);
    for (const std::string_view name : names) append(out_, '"', name, "\": \"input\", ");
    out_ += "\"q\": \"output\" }, \"connections\": { ";
    for (std::size_t i = 0; i < pins.size(); ++i) {
        append(out_, '"', names[i], "\": [ ");
        write_bit(pins[i]);
        out_ += " ], ";
    }
    out_ += "\"q\": [ ";
    write_bit(cell.output);
    out_ += " ]";
}

/// Every net by its name, with its initial value, and every output port that is called otherwise.
void JsonWriter::write_net_names() {
    out_ += "      \"netnames\": {";
    std::string_view separator = "\n";
    const auto write_net = [&](NetId net) {
        out_ += "\": { \"hide_name\": 0, \"bits\": [ ";
        write_bit(net);
        out_ += " ], \"attributes\": {";
        const Logic initial = initial_[index_of(net)];
        if (initial != Logic::unknown) {
            append(out_, " \"init\": \"", initial == Logic::one ? '1' : '0', "\" ");
        }
        out_ += "} }";
        separator = ",\n";
    };
    for (std::size_t i = 0; i < netlist_.net_count(); ++i) {
        const auto net = static_cast<NetId>(i);
        append(out_, separator, "        \"", nets_[net]);
        write_net(net);
    }
    std::string name;
    for (const Port& port : netlist_.outputs) {
        name.clear();
        spell_json(name, port.name);
        if (name == nets_[port.net]) continue;
        append(out_, separator, "        \"", name);
        write_net(port.net);
    }
    out_ += "\n      }\n";
}

/// The ports of a black box, which Yosys asks for.
void JsonWriter::write_black_box_module(const CellTypeRow& row) {
    append(out_, ",\n    \"", helpers_, row.name,
           "\": {\n      \"attributes\": { \"blackbox\": 1 },\n      \"ports\": {\n");
    std::uint32_t bit = 2;
    for (const std::string_view pin : helper_pins(row.type)) {
        append(out_, "        \"", pin, "\": { \"direction\": \"input\", \"bits\": [ ", bit++,
               " ] },\n");
    }
    append(out_, "        \"q\": { \"direction\": \"output\", \"bits\": [ ", bit,
           " ] }\n      },\n      \"cells\": {},\n      \"netnames\": {}\n    }");
}

}  // namespace

std::string write_yosys_json(const Netlist& netlist) {
    return JsonWriter(netlist).write();
}

}  // namespace grafwire
