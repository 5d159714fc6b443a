#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "text/diagnostics.h"

namespace grafwire {

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
    Token quoted_name(Token token, Diagnostics* diagnostics);
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

}  // namespace grafwire
