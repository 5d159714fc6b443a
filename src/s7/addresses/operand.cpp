// Operands as they are written.
//
// Both spellings are read everywhere, whatever the listing is written in: `E0.4` and `I0.4` are the
// same bit, `K10` and `10` the same constant. `VW20` is told from a name by its letters and digits
// alone; a text that only looks like an address (`V0.9`) is reported as a wrong one, not as an
// unknown name.

#include "s7/addresses/operand.h"

#include <fmt/format.h>

#include <charconv>

#include "text/utf8.h"

namespace grafwire::s7 {

namespace {

struct AreaLetters {
    Area area;
    std::string_view simatic;
    std::string_view international;
};

/// SM stands before M and T, of which it is no prefix, but the reader tries them in this order.
constexpr AreaLetters areas[] = {
    {Area::special, "SM", "SM"}, {Area::input, "E", "I"},   {Area::output, "A", "Q"},
    {Area::variable, "V", "V"},  {Area::memento, "M", "M"}, {Area::timer, "T", "T"},
    {Area::counter, "Z", "C"},
};

/// The whole text as a number in a base; empty where it is none or does not fit.
std::optional<std::int64_t> number_in(std::string_view text, int base) {
    std::int64_t value = 0;
    const auto [end, problem] =
        std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<Operand> constant(std::optional<std::int64_t> value) {
    if (!value || *value < INT32_MIN || *value > std::int64_t{UINT32_MAX}) return std::nullopt;
    Operand operand;
    operand.area = Area::constant;
    // Beyond the positive range a double word is its two's complement.
    operand.address = static_cast<std::int32_t>(static_cast<std::uint32_t>(*value));
    return operand;
}

std::optional<Operand> parse_constant(std::string_view text) {
    if (text.starts_with("16#")) return constant(number_in(text.substr(3), 16));
    if (text.starts_with("2#")) return constant(number_in(text.substr(2), 2));
    if (text.starts_with("KH")) return constant(number_in(text.substr(2), 16));
    if (text.starts_with("K")) text.remove_prefix(1);
    if (text.empty() || (!is_digit(text.front()) && text.front() != '-')) return std::nullopt;
    return constant(number_in(text, 10));
}

std::optional<std::int32_t> byte_number(std::string_view text) {
    if (text.empty() || !is_digit(text.front())) return std::nullopt;
    const auto value = number_in(text, 10);
    if (!value || *value > INT32_MAX) return std::nullopt;
    return static_cast<std::int32_t>(*value);
}

/// What follows the letters of an area.
std::optional<Operand> parse_place(Area area, std::string_view rest) {
    Operand operand;
    operand.area = area;
    if (area != Area::timer && area != Area::counter) {
        const std::size_t dot = rest.find('.');
        if (dot != std::string_view::npos) {
            const auto bit = number_in(rest.substr(dot + 1), 10);
            if (!bit || *bit < 0 || *bit > 7 || rest.size() != dot + 2) return std::nullopt;
            operand.bit = static_cast<std::uint8_t>(*bit);
            rest = rest.substr(0, dot);
        } else {
            if (rest.empty()) return std::nullopt;
            const std::size_t width = std::string_view("BWD").find(rest.front());
            if (width == std::string_view::npos) return std::nullopt;
            operand.width = static_cast<Width>(width + 1);
            rest.remove_prefix(1);
        }
    }
    const auto number = byte_number(rest);
    if (!number) return std::nullopt;
    operand.address = *number;
    return operand;
}

/// The letters that a text begins with, if they are those of an area.
std::size_t letters_of(std::string_view text, const AreaLetters& area) {
    if (text.starts_with(area.simatic)) return area.simatic.size();
    if (text.starts_with(area.international)) return area.international.size();
    return 0;
}

}  // namespace

std::optional<Operand> parse_operand(std::string_view text) {
    if (const auto operand = parse_constant(text)) return operand;
    for (const AreaLetters& area : areas) {
        const std::size_t letters = letters_of(text, area);
        if (letters == 0) continue;
        if (auto operand = parse_place(area.area, text.substr(letters))) return operand;
    }
    return std::nullopt;
}

bool looks_like_address(std::string_view text) {
    for (const AreaLetters& area : areas) {
        std::size_t at = letters_of(text, area);
        if (at == 0) continue;
        if (at < text.size() && text[at] >= 'A' && text[at] <= 'Z') ++at;
        if (at == text.size() || !is_digit(text[at])) continue;
        if (text.find_first_not_of("0123456789.", at) == std::string_view::npos) return true;
    }
    return false;
}

std::string write_operand(const Operand& operand, Mnemonics mnemonics, bool in_hex) {
    const bool simatic = mnemonics == Mnemonics::simatic;
    if (operand.area == Area::symbol || operand.area == Area::text) {
        return fmt::format("\"{}\"", operand.symbol);
    }
    if (operand.area == Area::constant) {
        if (in_hex) {
            return fmt::format("{}{:X}", simatic ? "KH" : "16#",
                               static_cast<std::uint32_t>(operand.address));
        }
        return fmt::format("{}{}", simatic ? "K" : "", operand.address);
    }
    std::string text;
    for (const AreaLetters& area : areas) {
        if (area.area == operand.area) text = simatic ? area.simatic : area.international;
    }
    if (operand.area == Area::timer || operand.area == Area::counter) {
        return text + fmt::to_string(operand.address);
    }
    if (operand.width == Width::bit) {
        return text + fmt::format("{}.{}", operand.address, unsigned{operand.bit});
    }
    return text +
           fmt::format("{}{}", "?BWD"[static_cast<std::size_t>(operand.width)], operand.address);
}

}  // namespace grafwire::s7
