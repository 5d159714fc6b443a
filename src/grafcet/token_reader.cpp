#include "grafcet/token_reader.h"

#include "grafcet/checking.h"
#include "grafcet/messages.h"

namespace grafwire {

namespace say = messages::grafcet;

TokenReader::TokenReader(std::string_view source, Diagnostics& diagnostics)
    : source_(source), diagnostics_(diagnostics), lexer_(source) {
    take();
}

bool TokenReader::take_if(TokenKind kind) {
    if (!at(kind)) return false;
    take();
    return true;
}

bool TokenReader::expect(TokenKind kind, const Message<>& expected) {
    if (take_if(kind)) return true;
    return fail_expecting(expected());
}

bool TokenReader::parse_name(Name& read, const Message<>& what, bool may_be_integer) {
    const bool is_name =
        at(TokenKind::word) || at(TokenKind::quoted) || (may_be_integer && at(TokenKind::integer));
    if (is_name && token_.length != 0) {
        read = name();
        take();
        return true;
    }
    if (is_name) {
        fail(say::expected(what(), say::empty_name()));
        take();
        return false;
    }
    if (!reserved_word(token_.kind).empty()) {
        return fail(say::reserved_word_as_name(what(), text()));
    }
    if (at(TokenKind::integer) || at(TokenKind::duration)) {
        return fail(say::number_as_name(what(), shown()));
    }
    return fail_expecting(what());
}

bool TokenReader::parse_names(std::vector<Name>& names, const Message<>& what,
                              bool may_be_integer) {
    do {
        Name name;
        if (!parse_name(name, what, may_be_integer)) return false;
        names.push_back(name);
    } while (take_if(TokenKind::comma));
    return true;
}

bool TokenReader::parse_number(std::int64_t& value) {
    value = 0;
    for (const char digit : text()) {
        value = value * 10 + (digit - '0');
        if (value <= largest_number) continue;
        diagnostics_.error(code::number_too_large, token_.where,
                           say::written_number_too_large(shown(), largest_number));
        value = 0;
        break;
    }
    take();
    return true;
}

Localized TokenReader::shown() const {
    return token_in_message(source_, token_);
}

bool TokenReader::fail(Localized message) {
    diagnostics_.error(code::unexpected_token, token_.where, std::move(message));
    return false;
}

bool TokenReader::fail_expecting(const Localized& expected) {
    return fail(say::expected(expected, shown()));
}

}  // namespace grafwire
