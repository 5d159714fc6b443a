#pragma once

// What grafwire needs of utf8proc: normal form C, which browsers have as String.normalize(). The
// Unicode standard guarantees that the form of a text never changes, so both give the same.

#include <cstdint>

using utf8proc_uint8_t = std::uint8_t;
using utf8proc_ssize_t = std::int32_t;
enum utf8proc_option_t { UTF8PROC_STABLE = 1 << 1, UTF8PROC_COMPOSE = 1 << 3 };

/// The size of the composed text, which is to be freed; negative where `text` is not UTF-8. Of the
/// options only those of normal form C together are understood.
utf8proc_ssize_t utf8proc_map(const utf8proc_uint8_t* text, utf8proc_ssize_t size,
                              utf8proc_uint8_t** result, utf8proc_option_t options);
