// BLIF after "Berkeley Logic Interchange Format (BLIF)", University of California, Berkeley, 1992,
// with the `.blackbox` and `.attr` lines of Yosys. (`.param` would say better what the figures are,
// but Yosys wants parameters declared, and BLIF cannot.)
//
// Every gate but the exclusive or is a single cube: an OR is written by the one case in which it is
// 0. So a gate of 200 inputs takes 200 characters and not 40 000, and its cover still says what it
// is.

#include "formats/blif/write_blif.h"

#include <array>

#include "formats/shared/append.h"
#include "formats/shared/helper_cells.h"
#include "formats/shared/net_spelling.h"

namespace grafwire {

namespace {

constexpr std::uint32_t widest_parity = 8;  ///< inputs of an exclusive or written as one cover

/// Words end at blanks, and `#`, `=`, `\` and `"` mean something.
void spell_blif(std::string& out, std::string_view name) {
    append_percent_escaped(out, name, [](char c) {
        return is_control_or_blank(c) || c == '#' || c == '=' || c == '\\' || c == '"';
    });
}

/// 2 would be "any value", 3 is "unknown".
char initial_digit(Logic value) {
    switch (value) {
        case Logic::zero:
            return '0';
        case Logic::one:
            return '1';
        case Logic::unknown:
            break;
    }
    return '3';
}

/// The file, from front to back.
class BlifWriter {
  public:
    explicit BlifWriter(const Netlist& netlist)
        : netlist_(netlist),
          nets_(netlist, spell_blif),
          suffix_(cell_suffix(netlist)),
          helpers_(helper_prefix(netlist)) {}

    std::string write();

  private:
    void write_ports(std::string_view keyword, const std::vector<Port>& ports);
    void write_module_comment(const Module& module);
    void write_aliases();
    void write_cell(const Cell& cell);
    void write_names(const Cell& cell);
    void write_cube(const Cell& cell, char input, char output);
    void write_parity(const Cell& cell);
    void write_parity_chain(const Cell& cell);
    void write_latch(const Cell& cell, std::string_view control);
    void write_black_box(const Cell& cell);
    void write_models();

    const Netlist& netlist_;
    NetSpelling nets_;
    std::string suffix_;
    std::string helpers_;  ///< begins the names of black boxes
    std::array<bool, cell_table.size()> used_boxes_{};
    std::string out_;
};

std::string BlifWriter::write() {
    out_.reserve(netlist_.cells.size() * 64);
    out_ +=
        "# In names, white space and # = \" \\ are written %20 %23 %3D %22 %5C, and % itself "
        "%25.\n";
    out_ += ".model ";
    spell_blif(out_, netlist_.name);
    out_ += '\n';
    write_ports(".inputs", netlist_.inputs);
    write_ports(".outputs", netlist_.outputs);
    for (const Netlist::InitialValue& item : netlist_.initial_values) {
        append(out_, "#@initially ", nets_[item.net], item.value ? " 1\n" : " 0\n");
    }
    write_aliases();
    for (const Module& module : netlist_.modules) {
        write_module_comment(module);
        for (std::uint32_t i = 0; i < module.cell_count; ++i) {
            write_cell(netlist_.cells.items()[module.first_cell + i]);
        }
    }
    out_ += ".end\n";
    write_models();
    return std::move(out_);
}

/// Yosys takes a comment that follows a constant for a part of it, so there is none then.
void BlifWriter::write_module_comment(const Module& module) {
    if (module.first_cell != 0 &&
        netlist_.pins_of(netlist_.cells.items()[module.first_cell - 1]).empty()) {
        return;
    }
    out_ += "# ";
    for (const char c : module.comment.empty() ? module.name : module.comment) {
        if (c == '\\') {
            out_ += "%5C";  // at the end of a line it would join it with the next
        } else {
            append_comment(out_, std::string_view(&c, 1));
        }
    }
    out_ += '\n';
}

/// Ten names a line.
void BlifWriter::write_ports(std::string_view keyword, const std::vector<Port>& ports) {
    out_ += keyword;
    std::size_t on_line = 0;
    for (const Port& port : ports) {
        if (on_line++ == 10) {
            out_ += " \\\n";
            on_line = 1;
        }
        out_ += ' ';
        spell_blif(out_, port.name);
    }
    out_ += '\n';
}

/// An output whose net has another name follows it through a buffer of BLIF, which is no cell.
void BlifWriter::write_aliases() {
    std::string port_name;
    for (const Port& port : netlist_.outputs) {
        port_name.clear();
        spell_blif(port_name, port.name);
        if (port_name == nets_[port.net]) continue;
        append(out_, ".names ", nets_[port.net], ' ', port_name, "\n1 1\n");
    }
}

void BlifWriter::write_names(const Cell& cell) {
    out_ += ".names";
    for (const NetId pin : netlist_.pins_of(cell)) append(out_, ' ', nets_[pin]);
    append(out_, ' ', nets_[cell.output], '\n');
}

/// `.names a b X1`, `11 1`: one row, all of whose inputs are alike.
void BlifWriter::write_cube(const Cell& cell, char input, char output) {
    write_names(cell);
    out_.append(cell.pin_count, input);
    append(out_, ' ', output, '\n');
}

/// All rows with an odd number of ones.
void BlifWriter::write_parity(const Cell& cell) {
    if (cell.pin_count > widest_parity) return write_parity_chain(cell);
    write_names(cell);
    for (std::uint32_t minterm = 0; minterm >> cell.pin_count == 0; ++minterm) {
        bool odd = false;
        for (std::uint32_t rest = minterm; rest != 0; rest &= rest - 1) odd = !odd;
        if (!odd) continue;
        for (std::uint32_t pin = 0; pin < cell.pin_count; ++pin) {
            out_ += (minterm >> (cell.pin_count - 1 - pin) & 1U) != 0 ? '1' : '0';
        }
        out_ += " 1\n";
    }
}

/// A cover of an exclusive or doubles with every input, so a wide one becomes two-input ones.
void BlifWriter::write_parity_chain(const Cell& cell) {
    const auto pins = netlist_.pins_of(cell);
    std::string so_far(nets_[pins[0]]);
    for (std::uint32_t pin = 1; pin < cell.pin_count; ++pin) {
        std::string next(nets_[cell.output]);
        if (pin + 1 != cell.pin_count) append(next, "$", pin, suffix_);
        append(out_, ".names ", so_far, ' ', nets_[pins[pin]], ' ', next, "\n01 1\n10 1\n");
        so_far = std::move(next);
    }
}

void BlifWriter::write_latch(const Cell& cell, std::string_view control) {
    const auto pins = netlist_.pins_of(cell);
    append(out_, ".latch ", nets_[pins[0]], ' ', nets_[cell.output], ' ', control, ' ',
           nets_[pins[1]], ' ', initial_digit(cell.initial), '\n');
}

/// `.subckt grafwire_timer a=X1 q=t`, and its parameters as attributes.
void BlifWriter::write_black_box(const Cell& cell) {
    used_boxes_[static_cast<std::size_t>(cell.type)] = true;
    append(out_, ".subckt ", helpers_, row_of(cell.type).name);
    const auto pins = netlist_.pins_of(cell);
    const auto names = helper_pins(cell.type);
    for (std::size_t i = 0; i < pins.size(); ++i) append(out_, ' ', names[i], '=', nets_[pins[i]]);
    append(out_, " q=", nets_[cell.output], '\n');
    for (const auto& [name, value] : helper_parameters(netlist_, cell)) {
        const std::string_view quote = name == "INIT" ? "" : "\"";
        append(out_, ".attr ", name, ' ', quote, value, quote, '\n');
    }
}

void BlifWriter::write_cell(const Cell& cell) {
    switch (cell.type) {
        case CellType::low:
        case CellType::high:
            write_names(cell);
            out_ += cell.type == CellType::low ? "0\n" : "1\n";
            return;
        case CellType::buffer:
            return write_cube(cell, '1', '1');
        case CellType::inverter:
            return write_cube(cell, '0', '1');
        case CellType::and_gate:
            return write_cube(cell, '1', '1');
        case CellType::or_gate:
            return write_cube(cell, '0', '0');
        case CellType::nand_gate:
            return write_cube(cell, '1', '0');
        case CellType::nor_gate:
            return write_cube(cell, '0', '1');
        case CellType::xor_gate:
            return write_parity(cell);
        case CellType::hold_latch:
            return write_latch(cell, "ah");
        case CellType::flip_flop:
            return write_latch(cell, "re");
        case CellType::latch:
        case CellType::rise_pulse:
        case CellType::fall_pulse:
        case CellType::timer:
        case CellType::scan_timer:
        case CellType::scan_timer_next:
            return write_black_box(cell);
    }
}

/// The ports of the black boxes that were used.
void BlifWriter::write_models() {
    for (const CellTypeRow& row : cell_table) {
        if (!used_boxes_[static_cast<std::size_t>(row.type)]) continue;
        append(out_, "\n.model ", helpers_, row.name, "\n.inputs");
        for (const std::string_view pin : helper_pins(row.type)) append(out_, ' ', pin);
        out_ += "\n.outputs q\n.blackbox\n.end\n";
    }
}

}  // namespace

std::string write_blif(const Netlist& netlist) {
    return BlifWriter(netlist).write();
}

}  // namespace grafwire
