#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafcet/grafcet_builder.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Operators have one kind for each of their spellings: `.`, `*`, `&` and `and` are all AND, and
/// the parser knows that.
enum class TokenKind : std::uint8_t {
    end,
    word,      ///< a name that begins with a letter and is no reserved word
    integer,   ///< digits
    quoted,    ///< text in quotation marks
    duration,  ///< `1.5s`
    arrow,
    assign,
    colon,
    comma,
    left_parenthesis,
    right_parenthesis,
    left_brace,
    right_brace,
    left_bracket,
    right_bracket,
    equal,
    not_equal,
    less,
    less_equal,
    greater,
    greater_equal,
    plus,
    minus,
    bar,
    circled_plus,
    dot,
    dot_dot,
    star,
    ampersand,
    slash,
    exclamation,
    up_arrow,
    down_arrow,
    // Reserved words, in the order of the table in lexer.cpp.
    kw_activation,
    kw_and,
    kw_assume,
    kw_counter,
    kw_deactivation,
    kw_do,
    kw_encloses,
    kw_entry,
    kw_exit,
    kw_expansion,
    kw_fall,
    kw_grafcet,
    kw_graph,
    kw_if,
    kw_initial,
    kw_input,
    kw_macro,
    kw_not,
    kw_on,
    kw_or,
    kw_output,
    kw_reset,
    kw_rise,
    kw_set,
    kw_step,
    kw_var,
    kw_xor,
};

/// A piece of the text. It points into the source rather than holding a copy.
struct Token {
    TokenKind kind = TokenKind::end;
    bool first_on_line = false;
    /// The bytes of the token; of a quoted text those between the quotation marks.
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    Location where;
};

/// Cuts the text of a `.grafcet` file, which must be UTF-8 of less than 4 GiB, into tokens; always
/// the longest that fits. What belongs to no token is reported and skipped. A lexer can be copied
/// to look ahead.
class Lexer {
  public:
    explicit Lexer(std::string_view text);

    /// Reports to `diagnostics` unless it is null.
    Token next(Diagnostics* diagnostics);

  private:
    void skip_space();
    bool skip_wide_space();
    void skip_comment();
    void advance(std::size_t bytes) {
        at_ += bytes;
        column_ += static_cast<std::uint32_t>(bytes);
    }
    Token finish(Token token, TokenKind kind, std::size_t bytes);
    Token word(Token token);
    Token number(Token token);
    Token quoted(Token token, Diagnostics* diagnostics);
    void report_control(std::string_view text, Diagnostics* diagnostics) const;
    bool symbol(Token& token);
    void report_unexpected(const Token& token, Diagnostics* diagnostics);

    std::string_view text_;
    std::size_t at_ = 0;
    std::uint32_t line_ = 1;
    std::uint32_t column_ = 1;
    bool line_is_blank_ = true;
};

/// Whether a code point may begin a name.
bool is_letter(char32_t code_point);

/// The spelling of a reserved word, empty for all other kinds.
std::string_view reserved_word(TokenKind kind);
bool is_reserved_word(std::string_view text);

/// Whether the language reads the text as a name without quotes: letters, digits and `_` after a
/// letter, and not reserved.
bool is_plain_word(std::string_view text);
/// Whether the text is digits and nothing else.
bool is_integer(std::string_view text);

/// The part of the source that a token was read from, as it is written in messages.
Localized token_in_message(std::string_view source, const Token& token);

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
