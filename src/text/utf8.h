#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "text/message.h"

namespace grafwire {

class Diagnostics;

/// The classes of characters that names and numbers are made of, in ASCII, whatever the locale.
constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
constexpr bool is_ascii_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
/// Letters of ASCII in the other case; all other characters as they are.
constexpr char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
constexpr char upper_case(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// A character of Unicode, and how many bytes of the text it takes.
struct CodePoint {
    char32_t value = 0;
    std::uint32_t length = 0;  ///< in bytes
};

/// Whether a byte of well-formed UTF-8 begins a character, rather than going on with one.
constexpr bool begins_character(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
}

/// The code point that begins at byte `at`, which must lie within the text. A byte that is not part
/// of well-formed UTF-8 gives a length of 0 and its own value.
CodePoint decode_utf8(std::string_view text, std::size_t at);

/// The number of code points in well-formed text (elsewhere: of bytes that begin one).
std::size_t count_code_points(std::string_view text);

/// Reports (as code::not_utf8, with its place) the first byte at which `text` is not UTF-8.
/// Returns whether the text is well-formed. The readers of all texts begin with it, so that none of
/// them meets a stray byte.
bool check_utf8(std::string_view text, Diagnostics& diagnostics);

/// The text in Unicode Normalisation Form C (Unicode Standard Annex 15), in which an accent and its
/// letter are one character where there is one: texts that look the same are the same then. ASCII
/// is in that form already. The text is well-formed UTF-8.
std::string normalised(std::string_view text);
/// Whether the text is ASCII, and so the same in every normalisation form.
bool is_ascii(std::string_view text);

/// The bytes of a byte-order mark at the beginning of the text: 0 or 3.
std::size_t byte_order_mark_size(std::string_view text);

/// Whether a character is not seen itself but acts on what is shown around it: the control
/// characters (of ASCII with tab and line feed, of Latin-1), the separators of lines and
/// paragraphs, and the marks that turn the direction of writing. A terminal obeys the first, and
/// the last make one text look like another; no name may hold them.
bool is_control(char32_t c);

/// Where the first of them begins; npos where there is none.
std::size_t find_control(std::string_view text);

/// A text of unknown origin, for people to read: control characters and stray bytes are replaced by
/// U+FFFD. Those in `kept` stay.
std::string visible(std::string_view text, std::string_view kept = "\t");

/// What is said of a name that holds a control character: which one, and that it cannot stay.
Localized control_in_name_message(std::string_view name);

/// The text, cut short with an ellipsis where it has more than `most` characters; 60 is what a
/// message shows of a name.
std::string shortened(std::string_view text, std::size_t most = 60);

}  // namespace grafwire
