// The cells of Yosys with a memory: flip-flops on the rising edge, latches.

#include "formats/yosys/yosys_cell_reader.h"

namespace grafwire {

/// `$_DFF_P_`, `$_DFFE_PN_`, `$_SDFF_PP0_`, `$_SDFFE_PP0P_`, `$_SDFFCE_PP0P_`: the letters give the
/// clock, the reset with its value, and the enable; C before E gates the reset with the enable.
std::string YosysCellReader::add_flip_flop() {
    const std::string_view type = cell_.type;
    const std::size_t middle = type.find('_', 2);
    const std::string_view kind = type.substr(2, middle - 2);
    const std::string_view letters = type.substr(middle + 1, type.size() - middle - 2);
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
    return {};
}

std::string YosysCellReader::add_word_flip_flop() {
    const NetId data = bit("D");
    const NetId clock = bit("CLK");
    if (!fault_.empty()) return fault_;
    if (!is_positive("CLK_POLARITY")) return "flip-flops on the falling edge are not supported";
    drive(CellType::flip_flop, {data, clock});
    return {};
}

std::string YosysCellReader::add_latch(bool enable_is_high) {
    const NetId data = bit("D");
    const NetId enable = bit(cell_.type == "$dlatch" ? "EN" : "E", enable_is_high);
    if (!fault_.empty()) return fault_;
    drive(CellType::hold_latch, {data, enable});
    return {};
}

/// In Yosys's set-reset latches the reset wins.
std::string YosysCellReader::add_set_reset(bool set_is_high, bool reset_is_high) {
    const bool is_word = cell_.type == "$sr";
    const NetId set = bit(is_word ? "SET" : "S", set_is_high);
    const NetId reset = bit(is_word ? "CLR" : "R", reset_is_high);
    if (!fault_.empty()) return fault_;
    drive(CellType::latch,
          {make(CellType::and_gate, {set, assembly_.inverted(reset, cell_.where)}), reset});
    return {};
}

}  // namespace grafwire
