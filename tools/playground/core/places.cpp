#include "core/places.h"

#include <algorithm>
#include <tuple>

#include "grafcet/lexer.h"
#include "text/utf8.h"

namespace grafwire::playground {

namespace {

bool is_before(Location a, Location b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
}

}  // namespace

Places::Places(std::string_view text) : text_(text) {
    lines_.push_back(byte_order_mark_size(text));
    utf16_.reserve(text.size() + 1);
    std::uint32_t units = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        utf16_.push_back(units);
        if (text[at] == '\n') lines_.push_back(at + 1);
        // A character of four bytes is two units; they count where it begins.
        if (begins_character(text[at])) {
            units += static_cast<unsigned char>(text[at]) >= 0xf0 ? 2U : 1U;
        }
    }
    utf16_.push_back(units);
    Lexer lexer(text);
    for (auto token = lexer.next(nullptr); token.kind != TokenKind::end;
         token = lexer.next(nullptr)) {
        const std::size_t marks = token.kind == TokenKind::quoted ? 1 : 0;
        const std::size_t end = std::size_t{token.offset} + token.length + marks;
        tokens_.push_back({token.offset - marks, std::min(end, text.size()), token.where});
    }
}

/// The end of the line where the column is beyond it.
std::size_t Places::byte_of(Location where) const {
    if (where.line > lines_.size()) return text_.size();
    std::size_t at = lines_[where.line - 1];
    for (std::uint32_t column = 1; column < where.column; ++column) {
        if (at == text_.size() || text_[at] == '\n') break;
        at += std::max<std::size_t>(decode_utf8(text_, at).length, 1);
    }
    return at;
}

Span Places::at(Location where) const {
    if (!where.is_known()) return {};
    const auto token = std::lower_bound(
        tokens_.begin(), tokens_.end(), where,
        [](const Token& item, Location place) { return is_before(item.where, place); });
    if (token != tokens_.end() && !is_before(where, token->where)) {
        return {utf16_[token->begin], utf16_[token->end]};
    }
    const std::size_t begin = byte_of(where);
    if (begin == text_.size() || text_[begin] == '\n') return {utf16_[begin], utf16_[begin]};
    const std::size_t length = std::max<std::size_t>(decode_utf8(text_, begin).length, 1);
    return {utf16_[begin], utf16_[begin + length]};
}

}  // namespace grafwire::playground
