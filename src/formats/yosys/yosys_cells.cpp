// The cells of Yosys after its manual, chapters "Word-level cells" and "Gates".

#include "formats/yosys/yosys_cells.h"

#include <fmt/format.h>

#include "formats/yosys/yosys_cell_reader.h"

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

NetId YosysCellReader::bit(std::string_view port) {
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

NetId YosysCellReader::bit(std::string_view port, bool is_high) {
    const NetId net = bit(port);
    return net == no_net || is_high ? net : assembly_.inverted(net, cell_.where);
}

std::vector<NetId> YosysCellReader::word(std::string_view port) {
    const YosysCell::Connection* connection = cell_.find(port);
    if (connection != nullptr && !connection->bits.empty()) return connection->bits;
    if (fault_.empty()) fault_ = fmt::format("its port {} is not connected", port);
    return {};
}

std::string YosysCellReader::add_helper(CellType type) {
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
    assembly_.add_cell(type, output_, pins, cell_.where, details);
    return {};
}

std::string YosysCellReader::add() {
    const std::string_view type = cell_.type;
    const std::optional<CellType> helper = helper_type_named(type);
    if (const GateRow* row = gate_row(type)) {
        output_ = bit("Y");
        return fault_.empty() ? add_gate(*row) : fault_;
    }
    const bool is_known = helper || is_yosys_memory(type) || type == "$eq" || type == "$ne" ||
                          type == "$logic_and" || type == "$mux" || type == "$_MUX_" ||
                          type == "$_NMUX_" || type == "$_AOI3_" || type == "$_OAI3_" ||
                          type == "$_AOI4_" || type == "$_OAI4_" || type == "$lut";
    if (!is_known) {
        return type.starts_with('$') ? "cells of this type are not supported (Yosys: techmap; opt)"
                                     : "it is a module of its own; flatten the netlist first";
    }
    output_ = bit(helper ? "q" : is_yosys_memory(type) ? "Q" : "Y");
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

bool is_yosys_memory(std::string_view type) {
    if (type == "$dff" || type == "$dlatch" || type == "$sr") return true;
    const bool is_gate = type.starts_with("$_") && type.ends_with('_') && type.size() > 6;
    return is_gate && (type.starts_with("$_DFF") || type.starts_with("$_SDFF") ||
                       type.starts_with("$_ALDFF") || type.starts_with("$_DLATCH") ||
                       (type.starts_with("$_SR_") && type.size() == 8));
}

std::string add_yosys_cell(NetlistAssembly& assembly, const YosysCell& cell, Logic initial) {
    return YosysCellReader(assembly, cell, initial).add();
}

}  // namespace grafwire
