#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <set>
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
    word,                ///< a name that begins with a letter and is no reserved word
    integer,             ///< digits
    digits_and_letters,  ///< `1S1`: what may have been meant as a name
    quoted,              ///< text in quotation marks
    duration,            ///< `1.5s`
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
    kw_define,
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
    kw_time,
    kw_var,
    kw_xor,
};

/// A piece of the text. It points into the source rather than holding a copy.
struct Token {
    TokenKind kind = TokenKind::end;
    bool first_on_line = false;
    bool is_overlined = false;  ///< a word or `)` with a combining overline: NOT on paper
    /// The bytes of the token; of a quoted text those between the quotation marks.
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    Location where;
};

/// A token as the reader of a chart has understood it: a word that stands for a keyword or an
/// operator has the kind of that. Nothing else is lost but blanks, line ends and comments, which
/// stand in the source between the tokens.
struct ReadToken {
    Token token;
    bool begins_part = false;  ///< of a declaration, block, step, transition or closing brace
};

/// Cuts the text of a `.grafcet` file, which must be UTF-8 of less than 4 GiB, into tokens; always
/// the longest that fits. What belongs to no token is reported and skipped. A lexer can be copied
/// to look ahead.
class Lexer {
  public:
    explicit Lexer(std::string_view text);

    /// Reports to `diagnostics` unless it is null.
    Token next(Diagnostics* diagnostics);
    /// The end of the last token.
    Location place() const { return {line_, column_}; }

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
/// What else a word means where a keyword may stand and a name may not: the French keywords, with
/// and without accents, and all of them in capitals; `et`, `ou`, `non` and the like. `end` where it
/// means nothing else. The word is normalised.
TokenKind keyword_in_context(std::string_view word);

/// How a reserved word is written in a language; in French with accents. What has no French
/// spelling is the same in both.
std::string_view keyword_in(Language language, TokenKind kind);

/// Whether the language reads the text as a name without quotes: letters, digits and `_` after a
/// letter, and not reserved.
bool is_plain_word(std::string_view text);
/// Whether the text is digits and nothing else.
bool is_integer(std::string_view text);

/// The name that a token spells: in normal form C, and without overlines, which are a NOT.
std::string name_of(std::string_view source, const Token& token);

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
    /// The kind of the token before the present one, and where it ended.
    TokenKind previous_kind() const { return previous_kind_; }
    Location previous_end() const { return previous_end_; }
    Diagnostics& diagnostics() { return diagnostics_; }

    bool at(TokenKind kind) const { return token_.kind == kind; }
    bool at_name() const { return is_name(token_.kind); }
    static bool is_name(TokenKind kind) {
        return kind == TokenKind::word || kind == TokenKind::integer || kind == TokenKind::quoted;
    }
    void take();
    /// From now on each token that is taken is kept there as well.
    void keep_tokens_in(std::vector<ReadToken>& tokens) { taken_ = &tokens; }
    /// The present token begins a part of the chart.
    void begin_part() { begins_part_ = true; }
    bool take_if(TokenKind kind);
    /// The same of a keyword that may be written as keyword_in_context() says.
    bool take_keyword(TokenKind keyword);
    bool expect(TokenKind kind, const Message<>& expected);
    bool parse_name(Name& name, const Message<>& what, bool may_be_integer);
    bool parse_names(std::vector<Name>& names, const Message<>& what, bool may_be_integer);
    /// Expects a token of digits. A number that is too large is reported and read as 0.
    bool parse_number(std::int64_t& value);

    /// Whether `[ (label) ] [ names ] ->` begins at the present token.
    bool looks_like_transition() const;
    /// What the token means as a keyword; `end` for a name. A word that begins the next transition
    /// on a line of its own is a name, and so is one that has been declared.
    TokenKind keyword() const;
    /// From now on this word is a name wherever it stands; `is_time`: that of a duration.
    void declare(Name name, bool is_time = false);
    /// Whether the token is the name of a duration.
    bool at_time_name();
    /// Reads the present word as that keyword.
    void read_as(TokenKind keyword) { token_.kind = keyword; }

    /// The token as a name, normalised, as long as the reader lives.
    Name name();
    std::string_view source() const { return source_; }
    /// The bytes of the token.
    std::string_view text() const { return source_.substr(token_.offset, token_.length); }
    /// The token as it is shown in messages.
    Localized shown() const;
    /// Reports an unexpected token.
    bool fail(Localized message);
    bool fail_at(Location where, Localized message);
    bool fail_expecting(const Localized& expected);

  private:
    std::string_view normalised_text(const Token& token);
    void report_digits_and_letters();

    std::string_view source_;
    Diagnostics& diagnostics_;
    Lexer lexer_;
    Token token_;
    TokenKind previous_kind_ = TokenKind::end;
    Location previous_end_{1, 1};
    std::vector<ReadToken>* taken_ = nullptr;
    bool begins_part_ = false;
    std::deque<std::string> spelled_;      ///< names that are not as they stand in the source
    std::set<std::string_view> reported_;  ///< names that begin with a digit
    std::set<std::string, std::less<>> declared_;  ///< names that mean something else in context
    std::set<std::string, std::less<>> times_;     ///< names of durations
};

}  // namespace grafwire
