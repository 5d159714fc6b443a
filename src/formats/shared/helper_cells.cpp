// Told once for all formats: writers and readers that do not agree on a pin or a parameter would
// lose it without a word.

#include "formats/shared/helper_cells.h"

#include <fmt/format.h>

#include <charconv>

namespace grafwire {

namespace {

constexpr std::string_view general_prefix = "grafwire_";

constexpr std::string_view latch_pins[] = {"s", "r"};
constexpr std::string_view hold_latch_pins[] = {"d", "e"};
constexpr std::string_view flip_flop_pins[] = {"d", "c"};
constexpr std::string_view operand_pin[] = {"a"};
constexpr std::string_view scan_timer_pins[] = {"a", "c"};
constexpr std::string_view scan_timer_next_pins[] = {"a", "h", "c"};

constexpr std::string_view parameter_names[] = {"INIT", "RISE", "FALL", "ORDINAL"};

}  // namespace

std::span<const std::string_view> helper_pins(CellType type) {
    switch (type) {
        case CellType::latch:
            return latch_pins;
        case CellType::hold_latch:
            return hold_latch_pins;
        case CellType::flip_flop:
            return flip_flop_pins;
        case CellType::scan_timer:
            return scan_timer_pins;
        case CellType::scan_timer_next:
            return scan_timer_next_pins;
        default:
            return operand_pin;
    }
}

std::string helper_prefix(const Netlist& netlist) {
    std::string prefix(general_prefix);
    while (netlist.name.starts_with(prefix)) prefix += '_';
    return prefix;
}

std::optional<CellType> helper_type_named(std::string_view name) {
    if (!name.starts_with(general_prefix)) return std::nullopt;
    name.remove_prefix(general_prefix.size());
    while (name.starts_with('_')) name.remove_prefix(1);
    const std::optional<CellType> type = cell_type_named(name);
    if (!type || (!row_of(*type).has_memory && !row_of(*type).has_timing)) return std::nullopt;
    return type;
}

std::vector<HelperParameter> helper_parameters(const Netlist& netlist, const Cell& cell) {
    std::vector<HelperParameter> parameters;
    const CellTypeRow& row = row_of(cell.type);
    if (row.has_timing) {
        const Timing& timing = netlist.timings[cell.timing];
        if (is_timer(cell.type)) parameters.push_back({"RISE", format_duration(timing.rise)});
        parameters.push_back({"FALL", format_duration(timing.fall)});
        if (timing.ordinal != Timing::no_ordinal) {
            parameters.push_back({"ORDINAL", fmt::format("{}", timing.ordinal)});
        }
    }
    if (row.has_memory && cell.initial != Logic::unknown) {
        parameters.push_back({"INIT", cell.initial == Logic::one ? "1" : "0"});
    }
    return parameters;
}

bool set_helper_parameter(Logic& initial, Timing& timing, std::string_view name,
                          std::string_view value) {
    if (name == "INIT") {
        if (value != "0" && value != "1" && value != "x") return false;
        initial = value == "0" ? Logic::zero : value == "1" ? Logic::one : Logic::unknown;
        return true;
    }
    if (name == "ORDINAL") {
        std::uint32_t number = 0;
        const char* end = value.data() + value.size();
        const auto [last, error] = std::from_chars(value.data(), end, number);
        if (error != std::errc() || last != end || value.size() > 9) return false;
        timing.ordinal = number;
        return true;
    }
    if (name != "RISE" && name != "FALL") return false;
    const std::optional<Time> duration = parse_duration(value);
    if (!duration) return false;
    (name == "RISE" ? timing.rise : timing.fall) = *duration;
    return true;
}

std::span<const std::string_view> helper_parameter_names() {
    return parameter_names;
}

}  // namespace grafwire
