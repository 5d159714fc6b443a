#include "s7/unknown_words.h"

#include <fmt/format.h>

#include "s7/addresses/operand_text.h"
#include "s7/instruction_set.h"
#include "text/utf8.h"

namespace grafwire::s7 {

namespace {

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names) {
    const auto nearest = nearest_name(word, names);
    return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

}  // namespace

std::string unknown_instruction_message(std::string_view word, bool suggests) {
    const auto known = mnemonic_names();
    return fmt::format("unknown instruction {}{}", in_quotes(word),
                       suggests ? did_you_mean(word, {known.begin(), known.end()}) : "");
}

std::string unknown_operand_message(std::string_view word, bool quoted, const IoAssignment* io) {
    if (!quoted && looks_like_address(word)) {
        return fmt::format(
            "{} is no address: bits are written as V20.1 with bits 0 … 7, bytes, words and double "
            "words as VB20, VW20 and VD20",
            in_quotes(word));
    }
    std::string message =
        fmt::format("{} is no address, no constant and no name with an address", in_quotes(word));
    if (io == nullptr) {
        return message + "; names are given addresses by a table of assignment (--io)";
    }
    std::vector<std::string_view> assigned;
    for (const auto& entry : io->entries) assigned.push_back(entry.name);
    return message + did_you_mean(word, assigned);
}

}  // namespace grafwire::s7
