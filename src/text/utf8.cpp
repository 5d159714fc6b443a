// Decodes UTF-8 as the Unicode standard defines it (table 3-7): overlong forms, surrogates and
// values beyond U+10FFFF are not well-formed, since a check passed by one spelling of a character
// could be got round by another. Texts are mostly ASCII, and files may be large, so check_utf8
// passes over ASCII eight bytes at a time.

#include "text/utf8.h"

#include <utf8proc.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <cstring>

#include "text/diagnostics.h"
#include "text/messages.h"

namespace grafwire {

namespace {

/// The smallest code point that may be written with so many bytes: shorter ones are overlong.
constexpr char32_t smallest_of_length[] = {0, 0, 0x80, 0x800, 0x10000};

/// How many bytes the character has that begins with this one; 0 where none does. (C0 and C1 would
/// begin overlong forms, F5 and above values that are no characters.)
std::uint32_t length_from_lead(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xc2 && lead < 0xe0) return 2;
    if (lead >= 0xe0 && lead < 0xf0) return 3;
    if (lead >= 0xf0 && lead < 0xf5) return 4;
    return 0;
}

/// The number of leading ASCII bytes, eight at a time.
std::size_t ascii_prefix(std::string_view text, std::size_t at) {
    constexpr std::uint64_t high_bits = 0x8080808080808080U;
    std::size_t end = at;
    while (end + 8 <= text.size()) {
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, text.data() + end, 8);
        if ((bytes & high_bits) != 0) break;
        end += 8;
    }
    while (end < text.size() && static_cast<unsigned char>(text[end]) < 0x80) ++end;
    return end - at;
}

}  // namespace

CodePoint decode_utf8(std::string_view text, std::size_t at) {
    assert(at < text.size());
    const auto lead = static_cast<unsigned char>(text[at]);
    const std::uint32_t length = length_from_lead(lead);
    if (length == 1) return {lead, 1};
    if (length == 0 || at + length > text.size()) return {lead, 0};
    auto value = static_cast<char32_t>(lead & (0x7fU >> length));
    for (std::uint32_t i = 1; i < length; ++i) {
        if (begins_character(text[at + i])) return {lead, 0};
        value = (value << 6U) | (static_cast<unsigned char>(text[at + i]) & 0x3fU);
    }
    const bool is_surrogate = value >= 0xd800 && value <= 0xdfff;
    if (value < smallest_of_length[length] || value > 0x10ffff || is_surrogate) return {lead, 0};
    return {value, length};
}

std::size_t count_code_points(std::string_view text) {
    std::size_t count = 0;
    for (const char byte : text) count += begins_character(byte) ? 1U : 0U;
    return count;
}

std::size_t byte_order_mark_size(std::string_view text) {
    return text.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0;
}

bool is_control(char32_t c) {
    return c < 0x20 || (c >= 0x7f && c < 0xa0) || c == 0x61c || c == 0x200e || c == 0x200f ||
           (c >= 0x2028 && c <= 0x202e) || (c >= 0x2066 && c <= 0x2069);
}

std::size_t find_control(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint code_point = decode_utf8(text, at);
        if (is_control(code_point.value)) return at;
        at += std::max<std::size_t>(code_point.length, 1);
    }
    return std::string_view::npos;
}

std::string visible(std::string_view text, std::string_view kept) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint code_point = decode_utf8(text, at);
        const std::size_t length = std::max<std::size_t>(code_point.length, 1);
        const bool is_shown = code_point.length != 0 &&
                              (!is_control(code_point.value) || kept.find(text[at]) != kept.npos);
        out += is_shown ? text.substr(at, length) : "\xef\xbf\xbd";
        at += length;
    }
    return out;
}

Localized control_in_name_message(std::string_view name) {
    const char32_t c = decode_utf8(name, find_control(name)).value;
    return messages::text::control_in_name(quoted(visible(name, {})),
                                           static_cast<std::uint32_t>(c));
}

std::string shortened(std::string_view text, std::size_t most) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (!begins_character(text[at]) || ++count <= most) continue;
        return std::string(text.substr(0, at)) + "…";
    }
    return std::string(text);
}

bool check_utf8(std::string_view text, Diagnostics& diagnostics) {
    std::uint32_t line = 1;
    std::size_t line_start = byte_order_mark_size(text);
    std::size_t at = line_start;
    std::size_t counted_from = at;
    while (at < text.size()) {
        at += ascii_prefix(text, at);
        if (at == text.size()) break;
        const CodePoint code_point = decode_utf8(text, at);
        if (code_point.length != 0) {
            at += code_point.length;
            continue;
        }
        // Lines are counted only now that a place is needed.
        for (std::size_t i = counted_from; i < at; ++i) {
            if (text[i] != '\n') continue;
            ++line;
            line_start = i + 1;
        }
        const auto column =
            static_cast<std::uint32_t>(count_code_points(text.substr(line_start, at - line_start)));
        diagnostics.error(code::not_utf8, {line, column + 1},
                          messages::text::not_utf8(static_cast<std::uint32_t>(code_point.value)));
        return false;
    }
    return true;
}

bool is_ascii(std::string_view text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

std::string normalised(std::string_view text) {
    if (is_ascii(text)) return std::string(text);
    utf8proc_uint8_t* result = nullptr;
    const utf8proc_ssize_t size =
        utf8proc_map(reinterpret_cast<const utf8proc_uint8_t*>(text.data()),
                     static_cast<utf8proc_ssize_t>(text.size()), &result,
                     static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE));
    if (size < 0) return std::string(text);  // not UTF-8, or no memory
    std::string composed(reinterpret_cast<const char*>(result), static_cast<std::size_t>(size));
    std::free(result);
    return composed;
}

}  // namespace grafwire
