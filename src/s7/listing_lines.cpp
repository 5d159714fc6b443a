// A line of a listing as words: `  125 LD    "start" // Start` is an offset, a mnemonic, a quoted
// name and a comment. Commas count as blanks, for some tools print them between operands.

#include "s7/listing_lines.h"

#include "s7/addresses/operand.h"
#include "s7/instruction_set.h"
#include "s7/messages.h"
#include "text/nearest_name.h"
#include "text/trimmed.h"
#include "text/utf8.h"

namespace grafwire::s7 {

namespace {

constexpr std::string_view blanks = " \t\r\v\f,";

}  // namespace

ListingLine split_line(std::string_view line, std::uint32_t number) {
    ListingLine result;
    // Places are asked for from left to right, so that a long line is counted once.
    std::size_t counted = 0;
    std::size_t column = 1;
    const auto place = [&](std::size_t to) {
        column += count_code_points(line.substr(counted, to - counted));
        counted = to;
        return Location{number, static_cast<std::uint32_t>(column)};
    };
    std::size_t at = 0;
    while (at < line.size()) {
        at = line.find_first_not_of(blanks, at);
        if (at == std::string_view::npos) break;
        if (line.substr(at).starts_with("//")) {
            result.has_comment = true;
            result.comment = trimmed(line.substr(at + 2));
            result.comment_at = place(at);
            break;
        }
        if (line[at] == '"') {
            const std::size_t end = line.find('"', at + 1);
            if (end == std::string_view::npos) {
                result.unterminated = place(at);
                break;
            }
            result.words.push_back({line.substr(at + 1, end - at - 1), true, place(at)});
            at = end + 1;
            continue;
        }
        std::size_t end = at;
        while (end < line.size() && blanks.find(line[end]) == std::string_view::npos &&
               line[end] != '"' && !line.substr(end).starts_with("//")) {
            ++end;
        }
        result.words.push_back({line.substr(at, end - at), false, place(at)});
        at = end;
    }
    return result;
}

bool is_offset(const ListingWord& word) {
    return !word.quoted && !word.text.empty() && word.text.size() <= 9 &&
           word.text.find_first_not_of("0123456789") == std::string_view::npos;
}

std::optional<std::string_view> network_digits(const ListingWord& word) {
    constexpr std::string_view network_word = "NETWORK";
    if (word.quoted || word.text.size() < network_word.size()) return std::nullopt;
    for (std::size_t i = 0; i < network_word.size(); ++i) {
        const char c = word.text[i];
        const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        if (upper != network_word[i]) return std::nullopt;
    }
    const std::string_view rest = word.text.substr(network_word.size());
    if (rest.find_first_not_of("0123456789") != std::string_view::npos || rest.size() > 6) {
        return std::nullopt;
    }
    return rest;
}

std::uint32_t number_of(std::string_view digits) {
    std::uint32_t number = 0;
    for (const char c : digits) number = number * 10 + static_cast<std::uint32_t>(c - '0');
    return number;
}

Localized unknown_instruction_message(std::string_view word, bool suggests) {
    const std::string shown = shortened(word);
    const auto known = mnemonic_names();
    const std::string_view nearest =
        suggests ? nearest_name(word, {known.begin(), known.end()}) : "";
    if (nearest.empty()) return messages::s7::unknown_instruction(shown);
    return messages::s7::unknown_instruction_near(shown, nearest);
}

Localized unknown_operand_message(std::string_view word, bool quoted, const IoAssignment* io,
                                  bool suggests) {
    const std::string shown = shortened(word);
    if (!quoted && looks_like_address(word)) return messages::s7::malformed_address(shown);
    if (io == nullptr) return messages::s7::no_operand_without_table(shown);
    if (!suggests) return messages::s7::no_operand(shown);
    std::vector<std::string_view> assigned;
    for (const auto& entry : io->entries) assigned.push_back(entry.name);
    const std::string_view nearest = nearest_name(word, assigned);
    if (nearest.empty()) return messages::s7::no_operand(shown);
    return messages::s7::no_operand_near(shown, nearest);
}

}  // namespace grafwire::s7
