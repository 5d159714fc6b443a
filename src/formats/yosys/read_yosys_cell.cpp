// The cells of Yosys after its manual, chapters "Word-level cells" and "Gates": one-bit word-level
// cells, gates, look-up tables, flip-flops on the rising edge, latches, and our own black boxes. A
// cell that has no counterpart becomes gates, as many as its function takes.

#include "formats/yosys/read_yosys_cell.h"

#include <fmt/format.h>

#include <array>

#include "formats/shared/cover.h"
#include "formats/shared/helper_cells.h"
#include "formats/shared/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace say = messages::formats;

/// A cell whose function is one gate over the bits of its inputs, perhaps with inverters.
struct GateRow {
    std::string_view type;
    std::string_view ports;  ///< the inputs, one letter each; a small letter: inverted
    CellType gate;
    bool inverts_output;
    bool is_wide;  ///< the input may have any number of bits
};

constexpr auto gates = std::to_array<GateRow>({
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
});

const GateRow* gate_row(std::string_view type) {
    for (const GateRow& row : gates) {
        if (row.type == type) return &row;
    }
    return nullptr;
}

/// Takes one cell apart. The first thing that is wrong with it is reported, and nothing is added
/// then.
class YosysCellReader {
  public:
    YosysCellReader(NetlistAssembly& assembly, const YosysCell& cell, Logic initial,
                    Diagnostics& diagnostics)
        : assembly_(assembly), cell_(cell), initial_(initial), diagnostics_(diagnostics) {}

    void add();

  private:
    using Add = void (YosysCellReader::*)();
    Add add_for_type() const;

    void add_gate(const GateRow& row);
    void add_comparison();
    void add_logic_and();
    void add_mux();
    void add_and_or();
    void add_lut();
    void add_flip_flop();
    void add_word_flip_flop();
    void add_latch();
    void add_set_reset();
    void add_helper(CellType type);

    /// The net of a one-bit port; no_net where it has another width, which is refused.
    NetId bit(std::string_view port);
    /// The same, inverted where the port is active low.
    NetId bit(std::string_view port, bool is_high);
    /// The nets of a port of any width.
    std::vector<NetId> word(std::string_view port);
    /// The net that the cell drives, likewise.
    NetId output(std::string_view port);
    /// The net of a further gate of this cell.
    NetId make(CellType type, std::vector<NetId> pins) {
        return assembly_.gate(type, pins, output_, cell_.where);
    }
    /// The gate that drives the output of this cell.
    void drive(CellType type, const std::vector<NetId>& pins) {
        assembly_.add_cell(type, output_, pins, cell_.where, {initial_, {}});
    }
    bool is_positive(std::string_view parameter) const {
        return cell_.parameter(parameter).ends_with('1');
    }
    void refuse(const Localized& reason);

    NetlistAssembly& assembly_;
    const YosysCell& cell_;
    Logic initial_;
    Diagnostics& diagnostics_;
    NetId output_ = no_net;
    bool is_refused_ = false;
};

void YosysCellReader::refuse(const Localized& reason) {
    if (!is_refused_) refuse_yosys_cell(cell_, reason, diagnostics_);
    is_refused_ = true;
}

NetId YosysCellReader::bit(std::string_view port) {
    const YosysCell::Connection* connection = cell_.find(port);
    if (connection != nullptr && connection->bits.size() == 1) return connection->bits[0];
    if (connection == nullptr) {
        refuse(say::pin_not_connected(port));
    } else {
        refuse(say::wide_pin(connection->bits.size(), port));
    }
    return no_net;
}

NetId YosysCellReader::bit(std::string_view port, bool is_high) {
    const NetId net = bit(port);
    return net == no_net || is_high ? net : assembly_.inverted(net, cell_.where);
}

std::vector<NetId> YosysCellReader::word(std::string_view port) {
    const YosysCell::Connection* connection = cell_.find(port);
    if (connection != nullptr && !connection->bits.empty()) return connection->bits;
    refuse(say::pin_not_connected(port));
    return {};
}

NetId YosysCellReader::output(std::string_view port) {
    const NetId net = bit(port);
    if (!is_refused_ && cell_.find(port)->constants[0] != '-') {
        refuse(say::output_is_constant(port));
    }
    return net;
}

void YosysCellReader::add_gate(const GateRow& row) {
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
    if (is_refused_) return;
    // A buffer of a constant is how the constant itself is written.
    const YosysCell::Connection* first = cell_.find("A");
    if (row.gate == CellType::buffer && first->constants[0] != '-') {
        drive(first->constants[0] == '1' ? CellType::high : CellType::low, {});
    } else if (row.inverts_output) {
        drive(CellType::inverter, {make(row.gate, pins)});
    } else {
        drive(row.gate, pins);
    }
}

/// `$eq` and `$ne`: a product of equal bits, or its complement.
void YosysCellReader::add_comparison() {
    const bool is_equal = cell_.type == "$eq";
    const std::vector<NetId> a = word("A");
    const std::vector<NetId> b = word("B");
    if (is_refused_) return;
    if (a.size() != b.size()) return refuse(say::operands_differ());
    const std::string& a_constants = cell_.find("A")->constants;
    const std::string& b_constants = cell_.find("B")->constants;
    if (a.size() == 1 && a_constants[0] == '-' && b_constants[0] == '-') {
        if (is_equal) {
            drive(CellType::inverter, {make(CellType::xor_gate, {a[0], b[0]})});
        } else {
            drive(CellType::xor_gate, {a[0], b[0]});
        }
        return;
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
}

/// `$logic_and`: each operand is 1 where any of its bits is.
void YosysCellReader::add_logic_and() {
    const std::vector<NetId> a = word("A");
    const std::vector<NetId> b = word("B");
    if (is_refused_) return;
    const auto any = [&](const std::vector<NetId>& bits) {
        return bits.size() == 1 ? bits[0] : make(CellType::or_gate, bits);
    };
    drive(CellType::and_gate, {any(a), any(b)});
}

/// `S ? B : A` as a sum of two products. It has a spike of a gate delay where A and B are 1 and S
/// falls, as any multiplexer of gates has.
void YosysCellReader::add_mux() {
    const NetId a = bit("A");
    const NetId b = bit("B");
    const NetId select = bit("S");
    if (is_refused_) return;
    const NetId low = make(CellType::and_gate, {a, assembly_.inverted(select, cell_.where)});
    const NetId high = make(CellType::and_gate, {b, select});
    drive(cell_.type == "$_NMUX_" ? CellType::nor_gate : CellType::or_gate, {low, high});
}

/// `$_AOI3_` and its kin: A and B, perhaps C and D, meet in gates of one kind, these in the other.
void YosysCellReader::add_and_or() {
    const bool or_first = cell_.type.starts_with("$_OAI");
    const CellType inner = or_first ? CellType::or_gate : CellType::and_gate;
    const NetId a = bit("A");
    const NetId b = bit("B");
    const NetId c = bit("C");
    const NetId d = cell_.type[5] == '4' ? bit("D") : no_net;
    if (is_refused_) return;
    const NetId first = make(inner, {a, b});
    const NetId second = d == no_net ? c : make(inner, {c, d});
    drive(or_first ? CellType::nand_gate : CellType::nor_gate, {first, second});
}

/// A table becomes a cover of its ones or of its zeros, whichever are fewer; add_cover() finds the
/// gate that it may be.
void YosysCellReader::add_lut() {
    const std::vector<NetId> inputs = word("A");
    const std::string_view table = cell_.parameter("LUT");
    if (is_refused_) return;
    if (inputs.size() > 12 || table.size() != std::size_t{1} << inputs.size()) {
        return refuse(say::table_does_not_fit());
    }
    Cover on{inputs, {}, true};
    Cover off{inputs, {}, false};
    for (std::size_t index = 0; index < table.size(); ++index) {
        std::string row;
        for (std::size_t i = 0; i < inputs.size(); ++i) row += (index >> i & 1U) != 0 ? '1' : '0';
        // The text begins with the highest entry.
        const char entry = table[table.size() - 1 - index];
        if (entry != '0' && entry != '1') return refuse(say::table_undefined());
        (entry == '1' ? on : off).rows.push_back(row);
    }
    add_cover(assembly_, on.rows.size() <= off.rows.size() ? on : off, output_, cell_.where);
}

/// Whatever else has a memory: `$_DFF_P_`, `$_DFFE_PN_`, `$_SDFF_PP0_`, `$_SDFFE_PP0P_`,
/// `$_SDFFCE_PP0P_`: the letters give the clock, the reset with its value, and the enable; C before
/// E gates the reset with the enable.
void YosysCellReader::add_flip_flop() {
    const std::string_view type = cell_.type;
    const std::size_t middle = type.find('_', 2);
    const std::string_view kind = type.substr(2, middle - 2);
    const std::string_view letters = type.substr(middle + 1, type.size() - middle - 2);
    const bool has_reset = kind.starts_with("SDFF");
    const bool has_enable = kind.ends_with('E');
    const std::size_t expected = 1U + (has_reset ? 2U : 0U) + (has_enable ? 1U : 0U);
    if (kind.starts_with("DLATCH")) return refuse(say::set_reset_latch());
    const bool is_known =
        kind == "DFF" || kind == "DFFE" || kind == "SDFF" || kind == "SDFFE" || kind == "SDFFCE";
    if (!is_known || letters.size() != expected) {
        return refuse(say::asynchronous_flip_flop());
    }
    if (letters[0] != 'P') return refuse(say::falling_flip_flop());
    NetId data = bit("D");
    const NetId clock = bit("C");
    const NetId enable = has_enable ? bit("E", letters.back() == 'P') : no_net;
    const NetId reset = has_reset ? bit("R", letters[1] == 'P') : no_net;
    if (is_refused_) return;
    const auto apply_reset = [&] {
        if (!has_reset) return;
        data = letters[2] == '1'
                   ? make(CellType::or_gate, {data, reset})
                   : make(CellType::and_gate, {data, assembly_.inverted(reset, cell_.where)});
    };
    const auto apply_enable = [&] {
        if (!has_enable) return;
        const NetId taken = make(CellType::and_gate, {data, enable});
        const NetId kept =
            make(CellType::and_gate, {output_, assembly_.inverted(enable, cell_.where)});
        data = make(CellType::or_gate, {taken, kept});
    };
    if (kind == "SDFFCE") apply_reset();
    apply_enable();
    if (kind != "SDFFCE") apply_reset();
    drive(CellType::flip_flop, {data, clock});
}

/// `$dff` of one bit.
void YosysCellReader::add_word_flip_flop() {
    const NetId data = bit("D");
    const NetId clock = bit("CLK");
    if (is_refused_) return;
    if (!is_positive("CLK_POLARITY")) return refuse(say::falling_flip_flop());
    drive(CellType::flip_flop, {data, clock});
}

/// A latch that is transparent at one level of its enable.
void YosysCellReader::add_latch() {
    const bool is_word = cell_.type == "$dlatch";
    const NetId data = bit("D");
    const NetId enable =
        is_word ? bit("EN", is_positive("EN_POLARITY")) : bit("E", cell_.type.ends_with("P_"));
    if (is_refused_) return;
    drive(CellType::hold_latch, {data, enable});
}

/// In Yosys's set-reset latches the reset wins.
void YosysCellReader::add_set_reset() {
    const bool is_word = cell_.type == "$sr";
    const NetId set =
        is_word ? bit("SET", is_positive("SET_POLARITY")) : bit("S", cell_.type[5] == 'P');
    const NetId reset =
        is_word ? bit("CLR", is_positive("CLR_POLARITY")) : bit("R", cell_.type[6] == 'P');
    if (is_refused_) return;
    drive(CellType::latch,
          {make(CellType::and_gate, {set, assembly_.inverted(reset, cell_.where)}), reset});
}

/// A black box of our own (helper_cells.h).
void YosysCellReader::add_helper(CellType type) {
    CellDetails details;
    for (const std::string_view name : helper_parameter_names()) {
        std::string text(cell_.parameter(name));
        if (text.empty()) continue;
        // Yosys writes whole numbers as 32 bits.
        if (name == "ORDINAL" && text.size() == 32) {
            std::uint32_t number = 0;
            for (const char c : text) number = number * 2 + (c == '1' ? 1U : 0U);
            text = fmt::format("{}", number);
        }
        if (!set_helper_parameter(details.initial, details.timing, name, text)) {
            return refuse(say::bad_parameter(name, text));
        }
    }
    std::vector<NetId> pins;
    for (const std::string_view pin : helper_pins(type)) pins.push_back(bit(pin));
    if (is_refused_) return;
    assembly_.add_cell(type, output_, pins, cell_.where, details);
}

/// How a cell of Yosys's own that is more than one gate is taken apart; null where it is not
/// supported.
YosysCellReader::Add YosysCellReader::add_for_type() const {
    struct Row {
        std::string_view type;
        Add add;
    };
    static constexpr auto rows = std::to_array<Row>({
        {"$eq", &YosysCellReader::add_comparison},
        {"$ne", &YosysCellReader::add_comparison},
        {"$logic_and", &YosysCellReader::add_logic_and},
        {"$mux", &YosysCellReader::add_mux},
        {"$_MUX_", &YosysCellReader::add_mux},
        {"$_NMUX_", &YosysCellReader::add_mux},
        {"$_AOI3_", &YosysCellReader::add_and_or},
        {"$_AOI4_", &YosysCellReader::add_and_or},
        {"$_OAI3_", &YosysCellReader::add_and_or},
        {"$_OAI4_", &YosysCellReader::add_and_or},
        {"$lut", &YosysCellReader::add_lut},
        {"$dff", &YosysCellReader::add_word_flip_flop},
        {"$dlatch", &YosysCellReader::add_latch},
        {"$_DLATCH_N_", &YosysCellReader::add_latch},
        {"$_DLATCH_P_", &YosysCellReader::add_latch},
        {"$sr", &YosysCellReader::add_set_reset},
        {"$_SR_NN_", &YosysCellReader::add_set_reset},
        {"$_SR_NP_", &YosysCellReader::add_set_reset},
        {"$_SR_PN_", &YosysCellReader::add_set_reset},
        {"$_SR_PP_", &YosysCellReader::add_set_reset},
    });
    for (const Row& row : rows) {
        if (row.type == cell_.type) return row.add;
    }
    return is_yosys_memory(cell_.type) ? &YosysCellReader::add_flip_flop : nullptr;
}

void YosysCellReader::add() {
    const std::string_view type = cell_.type;
    if (const GateRow* row = gate_row(type)) {
        output_ = output("Y");
        if (!is_refused_) add_gate(*row);
    } else if (const std::optional<CellType> helper = helper_type_named(type)) {
        output_ = output("q");
        if (!is_refused_) add_helper(*helper);
    } else if (const Add add_cell = add_for_type()) {
        output_ = output(is_yosys_memory(type) ? "Q" : "Y");
        if (!is_refused_) (this->*add_cell)();
    } else if (type.starts_with('$')) {
        refuse(say::cell_not_supported());
    } else {
        refuse(say::module_of_its_own());
    }
}

/// Gives constant bits nets of their own, except where the cell itself is asked for the constant.
void give_nets_to_constants(NetlistAssembly& assembly, YosysCell& cell) {
    const bool takes_constants = cell.type == "$eq" || cell.type == "$ne" ||
                                 cell.type == "$_BUF_" || cell.type == "$buf" ||
                                 cell.type == "$pos";
    if (takes_constants) return;
    for (YosysCell::Connection& connection : cell.connections) {
        for (std::size_t i = 0; i < connection.bits.size(); ++i) {
            if (connection.constants[i] == '-') continue;
            connection.bits[i] = assembly.constant(connection.constants[i] == '1', cell.where);
        }
    }
}

}  // namespace

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

void refuse_yosys_cell(const YosysCell& cell, const Localized& reason, Diagnostics& diagnostics) {
    diagnostics.error(code::bad_netlist, cell.where,
                      say::cell_refused(shortened(cell.name), cell.type, reason));
}

bool is_yosys_memory(std::string_view type) {
    if (type == "$dff" || type == "$dlatch" || type == "$sr") return true;
    const bool is_gate = type.starts_with("$_") && type.ends_with('_') && type.size() > 6;
    return is_gate && (type.starts_with("$_DFF") || type.starts_with("$_SDFF") ||
                       type.starts_with("$_ALDFF") || type.starts_with("$_DLATCH") ||
                       (type.starts_with("$_SR_") && type.size() == 8));
}

void add_yosys_cell(NetlistAssembly& assembly, YosysCell cell, Logic initial,
                    Diagnostics& diagnostics) {
    give_nets_to_constants(assembly, cell);
    YosysCellReader(assembly, cell, initial, diagnostics).add();
}

}  // namespace grafwire
