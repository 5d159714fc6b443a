#include "grafcet/token_reader.h"

#include <fmt/format.h>

#include "grafcet/checking.h"

namespace grafwire {

TokenReader::TokenReader(std::string_view source, Diagnostics& diagnostics)
    : source_(source), diagnostics_(diagnostics), lexer_(source) {
    take();
}

bool TokenReader::take_if(TokenKind kind) {
    if (!at(kind)) return false;
    take();
    return true;
}

bool TokenReader::expect(TokenKind kind, std::string_view expected) {
    if (take_if(kind)) return true;
    return fail(fmt::format("expected {}, got {}", expected, shown()));
}

bool TokenReader::parse_name(Name& read, std::string_view what, bool may_be_integer) {
    const bool is_name =
        at(TokenKind::word) || at(TokenKind::quoted) || (may_be_integer && at(TokenKind::integer));
    if (is_name && token_.length != 0) {
        read = name();
        take();
        return true;
    }
    if (is_name) {
        fail(fmt::format("expected {}, got an empty name", what));
        take();
        return false;
    }
    if (!reserved_word(token_.kind).empty()) {
        return fail(
            fmt::format("expected {}, got '{}', a reserved word; to use it as a name write \"{}\"",
                        what, text(), text()));
    }
    if (at(TokenKind::integer) || at(TokenKind::duration)) {
        return fail(
            fmt::format("expected {}, got {}; to use it as a name put it between quotation "
                        "marks",
                        what, shown()));
    }
    return fail(fmt::format("expected {}, got {}", what, shown()));
}

bool TokenReader::parse_names(std::vector<Name>& names, std::string_view what,
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
        diagnostics_.error(code::number_too_large, token_.where, number_too_large_message(shown()));
        value = 0;
        break;
    }
    take();
    return true;
}

std::string TokenReader::shown() const {
    return token_in_message(source_, token_);
}

bool TokenReader::fail(std::string message) {
    diagnostics_.error(code::unexpected_token, token_.where, std::move(message));
    return false;
}

}  // namespace grafwire
