#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/lexer.h"
#include "grafcet/named_expression.h"
#include "text/diagnostics.h"

namespace grafwire {

/// The text as tokens, one of which is looked at. What is not as expected is reported; the methods
/// return false then.
class TokenReader {
  public:
    TokenReader(std::string_view source, Diagnostics& diagnostics);

    const Token& token() const { return token_; }
    /// The tokens behind the present one.
    Lexer ahead() const { return lexer_; }
    Diagnostics& diagnostics() { return diagnostics_; }

    bool at(TokenKind kind) const { return token_.kind == kind; }
    bool at_name() const {
        return at(TokenKind::word) || at(TokenKind::integer) || at(TokenKind::quoted);
    }
    void take() { token_ = lexer_.next(&diagnostics_); }
    bool take_if(TokenKind kind);
    bool expect(TokenKind kind, const Message<>& expected);
    bool parse_name(Name& name, const Message<>& what, bool may_be_integer);
    bool parse_names(std::vector<Name>& names, const Message<>& what, bool may_be_integer);
    /// Expects a token of digits. A number that is too large is reported and read as 0.
    bool parse_number(std::int64_t& value);

    Name name() const { return {text(), token_.where}; }
    /// The text of the token.
    std::string_view text() const { return source_.substr(token_.offset, token_.length); }
    /// The token as it is shown in messages.
    Localized shown() const;
    /// Reports an unexpected token.
    bool fail(Localized message);
    bool fail_expecting(const Localized& expected);

  private:
    std::string_view source_;
    Diagnostics& diagnostics_;
    Lexer lexer_;
    Token token_;
};

}  // namespace grafwire
