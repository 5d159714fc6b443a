// The cells of Yosys after its manual, chapters "Word-level cells" and "Gates".

#include "import/yosys_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "import/cover.h"

namespace grafwire {

const YosysCell::Connection* YosysCell::find(std::string_view port) const {
    for (const Connection& connection : connections) {
        if (connection.port == port) return &connection;
    }
    return nullptr;
}

std::string_view YosysCell::parameter(std::string_view parameter_name) const {
    for (const auto& [key, value] : parameters) {
        if (key == parameter_name) return value;
    }
    return {};
}

namespace {

/// A cell whose function is one gate over the bits of its inputs, perhaps with inverters.
struct GateRow {
    std::string_view type;
    std::string_view ports;  ///< the inputs, one letter each; a small letter: inverted
    CellType gate;
    bool inverts_output;
    bool is_wide;  ///< the input may have any number of bits
};

constexpr std::array<GateRow, 24> gates{{
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

class CellReader {
  public:
    CellReader(NetlistAssembly& assembly, const YosysCell& cell, Logic initial)
        : assembly_(assembly), cell_(cell), initial_(initial) {}

    std::string add();

  private:
    std::string add_gate(const GateRow& row);
    std::string add_comparison(bool is_equal);
    std::string add_logic_and();
    std::string add_mux(bool inverts);
    std::string add_and_or(std::string_view inner_ports, bool or_first);
    std::string add_lut();
    std::string add_flip_flop();
    std::string add_word_flip_flop();
    std::string add_latch(bool enable_is_high);
    std::string add_set_reset(bool set_is_high, bool reset_is_high);
    std::string add_helper(CellType type);

    /// The net of a one-bit port; no_net, with `fault_` set, where it has another width.
    NetId bit(std::string_view port);
    NetId bit(std::string_view port, bool is_high);
    std::vector<NetId> word(std::string_view port);
    NetId make(CellType type, std::vector<NetId> pins) {
        return assembly_.gate(type, pins, output_, {});
    }
    void drive(CellType type, const std::vector<NetId>& pins) {
        assembly_.add_cell(type, output_, pins, {}, {initial_, {}});
    }
    bool is_positive(std::string_view parameter) const {
        return cell_.parameter(parameter).ends_with('1');
    }

    NetlistAssembly& assembly_;
    const YosysCell& cell_;
    Logic initial_;
    NetId output_ = no_net;
    std::string fault_;
};

NetId CellReader::bit(std::string_view port) {
    const YosysCell::Connection* connection = cell_.find(port);
    if (connection != nullptr && connection->bits.size() == 1) return connection->bits[0];
    if (fault_.empty()) {
        fault_ = connection == nullptr
                     ? fmt::format("its port {} is not connected", port)
                     : fmt::format(
                           "its port {} has {} bits; split words into bits first (Yosys: "
                           "simplemap)",
                           port, connection->bits.size());
    }
    return no_net;
}

NetId CellReader::bit(std::string_view port, bool is_high) {
    const NetId net = bit(port);
    return net == no_net || is_high ? net : assembly_.inverted(net, {});
}

std::vector<NetId> CellReader::word(std::string_view port) {
    const YosysCell::Connection* connection = cell_.find(port);
    if (connection != nullptr && !connection->bits.empty()) return connection->bits;
    if (fault_.empty()) fault_ = fmt::format("its port {} is not connected", port);
    return {};
}

std::string CellReader::add_gate(const GateRow& row) {
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
std::string CellReader::add_comparison(bool is_equal) {
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
            other = assembly_.constant(b_constants[i] == '1', {});
        }
        if (constant == '1') {
            equal_bits.push_back(other);
        } else if (constant == '0') {
            equal_bits.push_back(assembly_.inverted(other, {}));
        } else {
            equal_bits.push_back(assembly_.inverted(make(CellType::xor_gate, {a[i], b[i]}), {}));
        }
    }
    drive(is_equal ? CellType::and_gate : CellType::nand_gate, equal_bits);
    return {};
}

std::string CellReader::add_logic_and() {
    const std::vector<NetId> a = word("A");
    const std::vector<NetId> b = word("B");
    if (!fault_.empty()) return fault_;
    const auto any = [&](const std::vector<NetId>& bits) {
        return bits.size() == 1 ? bits[0] : make(CellType::or_gate, bits);
    };
    drive(CellType::and_gate, {any(a), any(b)});
    return {};
}

std::string CellReader::add_mux(bool inverts) {
    const NetId a = bit("A");
    const NetId b = bit("B");
    const NetId select = bit("S");
    if (!fault_.empty()) return fault_;
    const NetId low = make(CellType::and_gate, {a, assembly_.inverted(select, {})});
    const NetId high = make(CellType::and_gate, {b, select});
    drive(inverts ? CellType::nor_gate : CellType::or_gate, {low, high});
    return {};
}

/// `$_AOI3_` and its kin: A and B, perhaps C and D, meet in gates of one kind, these in the other.
std::string CellReader::add_and_or(std::string_view inner_ports, bool or_first) {
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

std::string CellReader::add_lut() {
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
    add_cover(assembly_, on.rows.size() <= off.rows.size() ? on : off, output_, {});
    return {};
}

/// `$_DFF_P_`, `$_DFFE_PN_`, `$_SDFF_PP0_`, `$_SDFFE_PP0P_`, `$_SDFFCE_PP0P_`: the letters give the
/// clock, the reset with its value, and the enable; C before E gates the reset with the enable.
std::string CellReader::add_flip_flop() {
    const std::string_view type = cell_.type;
    const std::size_t second = type.find('_', 2);
    const std::string_view kind = type.substr(2, second - 2);
    const std::string_view letters = type.substr(second + 1, type.size() - second - 2);
    const bool has_reset = kind.starts_with("SDFF");
    const bool has_enable = kind.ends_with('E');
    const std::size_t expected = 1U + (has_reset ? 2U : 0U) + (has_enable ? 1U : 0U);
    const bool is_known =
        kind == "DFF" || kind == "DFFE" || kind == "SDFF" || kind == "SDFFE" || kind == "SDFFCE";
    if (!is_known || letters.size() != expected) {
        return "flip-flops with asynchronous set or reset are not supported";
    }
    if (letters[0] != 'P') return "flip-flops on the falling edge are not supported";
    NetId data = bit("D");
    const NetId clock = bit("C");
    const NetId enable = has_enable ? bit("E", letters.back() == 'P') : no_net;
    const NetId reset = has_reset ? bit("R", letters[1] == 'P') : no_net;
    if (!fault_.empty()) return fault_;
    const auto apply_reset = [&] {
        if (!has_reset) return;
        data = letters[2] == '1' ? make(CellType::or_gate, {data, reset})
                                 : make(CellType::and_gate, {data, assembly_.inverted(reset, {})});
    };
    const auto apply_enable = [&] {
        if (!has_enable) return;
        const NetId taken = make(CellType::and_gate, {data, enable});
        const NetId kept = make(CellType::and_gate, {output_, assembly_.inverted(enable, {})});
        data = make(CellType::or_gate, {taken, kept});
    };
    if (kind == "SDFFCE") apply_reset();
    apply_enable();
    if (kind != "SDFFCE") apply_reset();
    drive(CellType::flip_flop, {data, clock});
    return {};
}

std::string CellReader::add_word_flip_flop() {
    const NetId data = bit("D");
    const NetId clock = bit("CLK");
    if (!fault_.empty()) return fault_;
    if (!is_positive("CLK_POLARITY")) return "flip-flops on the falling edge are not supported";
    drive(CellType::flip_flop, {data, clock});
    return {};
}

std::string CellReader::add_latch(bool enable_is_high) {
    const NetId data = bit("D");
    const NetId enable = bit(cell_.type == "$dlatch" ? "EN" : "E", enable_is_high);
    if (!fault_.empty()) return fault_;
    drive(CellType::hold_latch, {data, enable});
    return {};
}

/// In Yosys's set-reset latches the reset wins.
std::string CellReader::add_set_reset(bool set_is_high, bool reset_is_high) {
    const bool is_word = cell_.type == "$sr";
    const NetId set = bit(is_word ? "SET" : "S", set_is_high);
    const NetId reset = bit(is_word ? "CLR" : "R", reset_is_high);
    if (!fault_.empty()) return fault_;
    drive(CellType::latch, {make(CellType::and_gate, {set, assembly_.inverted(reset, {})}), reset});
    return {};
}

std::string CellReader::add_helper(CellType type) {
    NetlistAssembly::Details details;
    for (const std::string_view name : {"INIT", "RISE", "FALL", "ORDINAL"}) {
        std::string text(cell_.parameter(name));
        if (text.empty()) continue;
        // Yosys writes whole numbers as 32 bits.
        if (name == "ORDINAL" && text.size() == 32) {
            std::uint32_t number = 0;
            for (const char c : text) number = number * 2 + (c == '1' ? 1U : 0U);
            text = fmt::format("{}", number);
        }
        if (!set_helper_parameter(details, name, text)) {
            return fmt::format("its {} is not right: '{}'", name, text);
        }
    }
    std::vector<NetId> pins;
    for (const std::string_view pin : helper_pin_names(type)) pins.push_back(bit(pin));
    if (!fault_.empty()) return fault_;
    assembly_.add_cell(type, output_, pins, {}, details);
    return {};
}

std::string CellReader::add() {
    const std::string_view type = cell_.type;
    const std::optional<CellType> helper = helper_type_named(type);
    const std::string_view output_port = helper ? "q" : is_yosys_memory(type) ? "Q" : "Y";
    for (const GateRow& row : gates) {
        if (row.type != type) continue;
        output_ = bit(output_port);
        return fault_.empty() ? add_gate(row) : fault_;
    }
    const bool is_known = helper || is_yosys_memory(type) || type == "$eq" || type == "$ne" ||
                          type == "$logic_and" || type == "$mux" || type == "$_MUX_" ||
                          type == "$_NMUX_" || type == "$_AOI3_" || type == "$_OAI3_" ||
                          type == "$_AOI4_" || type == "$_OAI4_" || type == "$lut";
    if (!is_known) {
        return type.starts_with('$') ? "cells of this type are not supported (Yosys: techmap; opt)"
                                     : "it is a module of its own; flatten the netlist first";
    }
    output_ = bit(output_port);
    if (!fault_.empty()) return fault_;
    if (helper) return add_helper(*helper);
    if (type == "$eq" || type == "$ne") return add_comparison(type == "$eq");
    if (type == "$logic_and") return add_logic_and();
    if (type == "$mux" || type == "$_MUX_") return add_mux(false);
    if (type == "$_NMUX_") return add_mux(true);
    if (type == "$_AOI3_" || type == "$_AOI4_")
        return add_and_or(type == "$_AOI4_" ? "ABCD" : "ABC", false);
    if (type == "$_OAI3_" || type == "$_OAI4_")
        return add_and_or(type == "$_OAI4_" ? "ABCD" : "ABC", true);
    if (type == "$lut") return add_lut();
    if (type == "$dff") return add_word_flip_flop();
    if (type == "$dlatch") return add_latch(is_positive("EN_POLARITY"));
    if (type.starts_with("$_DLATCH_") && type.size() == 11) return add_latch(type[9] == 'P');
    if (type == "$sr")
        return add_set_reset(is_positive("SET_POLARITY"), is_positive("CLR_POLARITY"));
    if (type.starts_with("$_SR_")) return add_set_reset(type[5] == 'P', type[6] == 'P');
    if (type.starts_with("$_DLATCH")) return "latches with set or reset are not supported";
    return add_flip_flop();
}

}  // namespace

bool is_yosys_memory(std::string_view type) {
    if (type == "$dff" || type == "$dlatch" || type == "$sr") return true;
    const bool is_gate = type.starts_with("$_") && type.ends_with('_') && type.size() > 6;
    return is_gate && (type.starts_with("$_DFF") || type.starts_with("$_SDFF") ||
                       type.starts_with("$_ALDFF") || type.starts_with("$_DLATCH") ||
                       (type.starts_with("$_SR_") && type.size() == 8));
}

std::string add_yosys_cell(NetlistAssembly& assembly, const YosysCell& cell, Logic initial) {
    return CellReader(assembly, cell, initial).add();
}

}  // namespace grafwire
