// Words and white space are told by code points, not by bytes: a name may hold `é`, and a no-break
// space is two bytes long. Columns are counted in code points as well, as editors count them.

#include "trace/line_cursor.h"

#include <algorithm>

#include "grafcet/lexer.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

bool is_ascii_byte(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

/// White space beyond ASCII, such as the no-break space that French typography puts before a colon.
bool is_wide_blank(char32_t c) {
    return c == 0x85 || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x2028 ||
           c == 0x2029 || c == 0x202f || c == 0x205f || c == 0x3000;
}

}  // namespace

/// The bytes of the white space at the cursor: 0 if there is none.
std::size_t LineCursor::blank_size() const {
    if (at_ == line_.size()) return 0;
    const char c = line_[at_];
    if (is_ascii_byte(c)) return c == ' ' || (c >= '\t' && c <= '\r') ? 1 : 0;
    const CodePoint code_point = decode_utf8(line_, at_);
    return is_wide_blank(code_point.value) ? code_point.length : 0;
}

std::size_t LineCursor::word_character_size() const {
    const char c = line_[at_];
    if ((c >= '0' && c <= '9') || c == '_') return 1;
    const CodePoint code_point = decode_utf8(line_, at_);
    return is_letter(code_point.value) ? code_point.length : 0;
}

bool LineCursor::skip_if(char c) {
    if (at_end() || peek() != c) return false;
    ++at_;
    return true;
}

void LineCursor::skip_blanks() {
    while (const std::size_t size = blank_size()) at_ += size;
}

std::string_view LineCursor::take_word() {
    const std::size_t first = at_;
    while (!at_end()) {
        const std::size_t size = word_character_size();
        if (size == 0) break;
        at_ += size;
    }
    return line_.substr(first, at_ - first);
}

std::string_view LineCursor::take_until_blank(char stop) {
    const std::size_t first = at_;
    while (!at_end() && blank_size() == 0 && peek() != stop) {
        at_ += std::max<std::size_t>(decode_utf8(line_, at_).length, 1);
    }
    return line_.substr(first, at_ - first);
}

Location LineCursor::here() {
    column_ += count_code_points(line_.substr(counted_, at_ - counted_));
    counted_ = at_;
    return {number_, static_cast<std::uint32_t>(column_)};
}

}  // namespace grafwire
