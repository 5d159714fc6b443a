// The cells of Yosys without a memory: one-bit word-level cells, gates, look-up tables.

#include <array>

#include "formats/shared/cover.h"
#include "formats/yosys/yosys_cell_reader.h"

namespace grafwire {

/// A cell whose function is one gate over the bits of its inputs, perhaps with inverters.
struct YosysCellReader::GateRow {
    std::string_view type;
    std::string_view ports;  ///< the inputs, one letter each; a small letter: inverted
    CellType gate;
    bool inverts_output;
    bool is_wide;  ///< the input may have any number of bits
};

const YosysCellReader::GateRow* YosysCellReader::gate_row(std::string_view type) {
    static constexpr std::array<GateRow, 24> gates{{
        {"$_BUF_", "A", CellType::buffer, false, false},
        {"$_NOT_", "A", CellType::inverter, false, false},
        {"$_AND_", "AB", CellType::and_gate, false, false},
        {"$_NAND_", "AB", CellType::nand_gate, false, false},
        {"$_OR_", "AB", CellType::or_gate, false, false},
        {"$_NOR_", "AB", CellType::nor_gate, false, false},
        {"$_XOR_", "AB", CellType::xor_gate, false, false},
        {"$_XNOR_", "AB", CellType::xor_gate, true, false},
        {"$_ANDNOT_", "Ab", CellType::and_gate, false, false},
        {"$_ORNOT_", "Ab", CellType::or_gate, false, false},
        {"$buf", "A", CellType::buffer, false, false},
        {"$pos", "A", CellType::buffer, false, false},
        {"$not", "A", CellType::inverter, false, false},
        {"$and", "AB", CellType::and_gate, false, false},
        {"$or", "AB", CellType::or_gate, false, false},
        {"$xor", "AB", CellType::xor_gate, false, false},
        {"$xnor", "AB", CellType::xor_gate, true, false},
        {"$reduce_and", "A", CellType::and_gate, false, true},
        {"$reduce_or", "A", CellType::or_gate, false, true},
        {"$reduce_bool", "A", CellType::or_gate, false, true},
        {"$reduce_xor", "A", CellType::xor_gate, false, true},
        {"$reduce_xnor", "A", CellType::xor_gate, true, true},
        {"$logic_not", "A", CellType::nor_gate, false, true},
        {"$logic_or", "AB", CellType::or_gate, false, true},
    }};
    for (const GateRow& row : gates) {
        if (row.type == type) return &row;
    }
    return nullptr;
}

std::string YosysCellReader::add_gate(const GateRow& row) {
    std::vector<NetId> pins;
    for (const char letter : row.ports) {
        const bool inverted = letter >= 'a';
        const char port = inverted ? static_cast<char>(letter - 'a' + 'A') : letter;
        if (row.is_wide) {
            for (const NetId net : word({&port, 1})) pins.push_back(net);
        } else {
            pins.push_back(bit({&port, 1}, !inverted));
        }
    }
    if (!fault_.empty()) return fault_;
    // A buffer of a constant is how the constant itself is written.
    const YosysCell::Connection* first = cell_.find("A");
    if (row.gate == CellType::buffer && first->constants[0] != '-') {
        drive(first->constants[0] == '1' ? CellType::high : CellType::low, {});
    } else if (row.inverts_output) {
        drive(CellType::inverter, {make(row.gate, pins)});
    } else {
        drive(row.gate, pins);
    }
    return {};
}

/// `$eq` and `$ne`: a product of equal bits, or its complement.
std::string YosysCellReader::add_comparison(bool is_equal) {
    const std::vector<NetId> a = word("A");
    const std::vector<NetId> b = word("B");
    if (!fault_.empty()) return fault_;
    if (a.size() != b.size()) return "its operands differ in width";
    const std::string& a_constants = cell_.find("A")->constants;
    const std::string& b_constants = cell_.find("B")->constants;
    if (a.size() == 1 && a_constants[0] == '-' && b_constants[0] == '-') {
        if (is_equal) {
            drive(CellType::inverter, {make(CellType::xor_gate, {a[0], b[0]})});
        } else {
            drive(CellType::xor_gate, {a[0], b[0]});
        }
        return {};
    }
    std::vector<NetId> equal_bits;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const char constant = a_constants[i] != '-' ? a_constants[i] : b_constants[i];
        NetId other = a_constants[i] != '-' ? b[i] : a[i];
        if (a_constants[i] != '-' && b_constants[i] != '-') {
            other = assembly_.constant(b_constants[i] == '1', cell_.where);
        }
        if (constant == '1') {
            equal_bits.push_back(other);
        } else if (constant == '0') {
            equal_bits.push_back(assembly_.inverted(other, cell_.where));
        } else {
            equal_bits.push_back(
                assembly_.inverted(make(CellType::xor_gate, {a[i], b[i]}), cell_.where));
        }
    }
    drive(is_equal ? CellType::and_gate : CellType::nand_gate, equal_bits);
    return {};
}

std::string YosysCellReader::add_logic_and() {
    const std::vector<NetId> a = word("A");
    const std::vector<NetId> b = word("B");
    if (!fault_.empty()) return fault_;
    const auto any = [&](const std::vector<NetId>& bits) {
        return bits.size() == 1 ? bits[0] : make(CellType::or_gate, bits);
    };
    drive(CellType::and_gate, {any(a), any(b)});
    return {};
}

std::string YosysCellReader::add_mux(bool inverts) {
    const NetId a = bit("A");
    const NetId b = bit("B");
    const NetId select = bit("S");
    if (!fault_.empty()) return fault_;
    const NetId low = make(CellType::and_gate, {a, assembly_.inverted(select, cell_.where)});
    const NetId high = make(CellType::and_gate, {b, select});
    drive(inverts ? CellType::nor_gate : CellType::or_gate, {low, high});
    return {};
}

/// `$_AOI3_` and its kin: A and B, perhaps C and D, meet in gates of one kind, these in the other.
std::string YosysCellReader::add_and_or(std::string_view inner_ports, bool or_first) {
    const CellType inner = or_first ? CellType::or_gate : CellType::and_gate;
    std::vector<NetId> terms;
    const NetId a = bit("A");
    const NetId b = bit("B");
    const NetId c = bit("C");
    const NetId d = inner_ports == "ABCD" ? bit("D") : no_net;
    if (!fault_.empty()) return fault_;
    terms.push_back(make(inner, {a, b}));
    terms.push_back(d == no_net ? c : make(inner, {c, d}));
    drive(or_first ? CellType::nand_gate : CellType::nor_gate, terms);
    return {};
}

std::string YosysCellReader::add_lut() {
    const std::vector<NetId> inputs = word("A");
    const std::string_view table = cell_.parameter("LUT");
    if (!fault_.empty()) return fault_;
    if (inputs.size() > 12 || table.size() != std::size_t{1} << inputs.size()) {
        return "its table does not fit its inputs";
    }
    Cover on{inputs, {}, true};
    Cover off{inputs, {}, false};
    for (std::size_t index = 0; index < table.size(); ++index) {
        std::string row;
        for (std::size_t i = 0; i < inputs.size(); ++i) row += (index >> i & 1U) != 0 ? '1' : '0';
        // The text begins with the highest entry.
        const char entry = table[table.size() - 1 - index];
        if (entry != '0' && entry != '1') return "its table has undefined entries";
        (entry == '1' ? on : off).rows.push_back(row);
    }
    add_cover(assembly_, on.rows.size() <= off.rows.size() ? on : off, output_, cell_.where);
    return {};
}

}  // namespace grafwire
