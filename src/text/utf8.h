#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace grafwire {

struct CodePoint {
    char32_t value = 0;
    std::uint32_t length = 0;  ///< in bytes
};

/// The code point that begins at byte `at`, which must lie within the text. A byte that is not part
/// of well-formed UTF-8 gives a length of 0 and its own value.
CodePoint decode_utf8(std::string_view text, std::size_t at);

/// The number of code points in well-formed text (elsewhere: of bytes that begin one).
std::size_t count_code_points(std::string_view text);

/// The bytes of a byte-order mark at the beginning of the text: 0 or 3.
std::size_t byte_order_mark_size(std::string_view text);

/// A name as it is quoted in a message: `'name'`, a long one cut short with an ellipsis.
std::string in_quotes(std::string_view name);

}  // namespace grafwire
