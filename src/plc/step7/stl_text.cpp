#include "plc/step7/stl_text.h"

#include <fmt/format.h>

#include "plc/shared/source_text.h"

namespace grafwire {

namespace {

struct Mnemonic {
    std::string_view simatic;
    std::string_view international;
};

/// Those that differ.
constexpr Mnemonic differing[] = {
    {"U", "A"},      {"UN", "AN"},  {"U(", "A("},  {"UN(", "AN("}, {"UW", "AW"}, {"UD", "AD"},
    {"SPBN", "JCN"}, {"SPB", "JC"}, {"SPA", "JU"}, {"SE", "SD"},   {"SA", "SF"},
};

}  // namespace

std::string_view StlText::mnemonic(std::string_view simatic) const {
    if (mnemonics_ == s7::Mnemonics::simatic) return simatic;
    for (const Mnemonic& row : differing) {
        if (row.simatic == simatic) return row.international;
    }
    return simatic;
}

void StlText::comment(std::string_view text) {
    for (bool goes_on = true; goes_on;) {
        const std::size_t end = text.find('\n');
        const std::string_view one = text.substr(0, end);
        text_ += one.empty() ? "//\n" : fmt::format("// {}\n", comment_text(one));
        goes_on = end != std::string_view::npos;
        if (goes_on) text.remove_prefix(end + 1);
    }
}

void StlText::network(std::string_view title) {
    text_ += fmt::format("\nNETWORK\nTITLE = {}\n", title);
}

void StlText::op(std::string_view operation, std::string_view operand, std::string_view comment) {
    std::string written = operand.empty()
                              ? fmt::format("      {};", mnemonic(operation))
                              : fmt::format("      {:<5} {};", mnemonic(operation), operand);
    if (!comment.empty()) written = fmt::format("{:<28} // {}", written, comment_text(comment));
    text_ += written + "\n";
}

void StlText::label(std::string_view name) {
    text_ += fmt::format("{}: NOP   0;\n", name);
}

std::string StlText::operand(StlAddress address) const {
    char area = address.area;
    if (mnemonics_ == s7::Mnemonics::international && area == 'E') area = 'I';
    if (mnemonics_ == s7::Mnemonics::international && area == 'A') area = 'Q';
    return fmt::format("{} {}.{}", area, address.byte, address.bit);
}

std::string StlText::word(std::uint32_t byte, std::uint32_t bytes) {
    return fmt::format("{} {}", bytes == 2 ? "MW" : "MD", byte);
}

}  // namespace grafwire
