#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "s7/addresses/io_assignment.h"
#include "text/message.h"
#include "text/source.h"

namespace grafwire::s7 {

/// A word of a line of a listing: what stands between white space and commas. A name in quotes is
/// one word, whatever it holds.
struct ListingWord {
    std::string_view text;  ///< without the quotes
    bool quoted = false;
    Location where;
};

/// One line: its words, then perhaps a comment.
struct ListingLine {
    std::vector<ListingWord> words;
    bool has_comment = false;
    std::string_view comment;  ///< without the slashes and the white space around it
    Location comment_at;
    Location unterminated;  ///< a quoted name that is not ended on the line
};

/// `number` counts from 1.
ListingLine split_line(std::string_view line, std::uint32_t number);

/// Whether a word consists of digits alone, as an offset does.
bool is_offset(const ListingWord& word);
/// The digits behind NETWORK (perhaps none); empty where the word is another.
std::optional<std::string_view> network_digits(const ListingWord& word);
/// Up to nine digits as a number.
std::uint32_t number_of(std::string_view digits);

/// What to say of a word that is no instruction; `suggests`: with the nearest that is one.
Localized unknown_instruction_message(std::string_view word, bool suggests);

/// What to say of a word that is no operand, where names have addresses in `io` (may be null).
Localized unknown_operand_message(std::string_view word, bool quoted, const IoAssignment* io,
                                  bool suggests);

}  // namespace grafwire::s7
