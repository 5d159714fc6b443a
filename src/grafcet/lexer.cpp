// The text of a chart as tokens, and the reader that looks at one of them.
//
// The lexer keeps no list of tokens: it makes the next one when it is asked, so a chart of millions
// of lines costs no memory here, and looking ahead is a copy of the lexer. Columns count
// characters, so bytes of a name that is not ASCII are decoded as they pass; everything else is
// found byte by byte.

#include "grafcet/lexer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "grafcet/checking.h"
#include "grafcet/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

constexpr std::array<std::string_view, 29> reserved_words = {
    "activation", "and",   "assume",    "counter", "deactivation", "define", "do",    "encloses",
    "entry",      "exit",  "expansion", "fall",    "grafcet",      "graph",  "if",    "initial",
    "input",      "macro", "not",       "on",      "or",           "output", "reset", "rise",
    "set",        "step",  "time",      "var",     "xor"};

constexpr auto first_reserved = static_cast<std::size_t>(TokenKind::kw_activation);
static_assert(static_cast<std::size_t>(TokenKind::kw_xor) - first_reserved + 1 ==
              reserved_words.size());

constexpr std::array<std::string_view, 5> units = {"min", "us", "ms", "s", "h"};

/// U+0305, which stands behind the character that it is drawn over.
constexpr std::string_view overline = "\u0305";

bool is_ascii(char c) {
    return static_cast<unsigned char>(c) < 0x80;
}

/// The words that are keywords where nothing else could be meant; all are compared in lower case.
struct WordInContext {
    std::string_view word;
    TokenKind keyword;
};
constexpr WordInContext words_in_context[] = {
    {"compteur", TokenKind::kw_counter},
    {"debut", TokenKind::kw_entry},
    {"definir", TokenKind::kw_define},
    {"desactivation", TokenKind::kw_deactivation},
    {"duree", TokenKind::kw_time},
    {"début", TokenKind::kw_entry},
    {"définir", TokenKind::kw_define},
    {"désactivation", TokenKind::kw_deactivation},
    {"durée", TokenKind::kw_time},
    {"englobe", TokenKind::kw_encloses},
    {"entree", TokenKind::kw_input},
    {"entrée", TokenKind::kw_input},
    {"et", TokenKind::kw_and},
    {"etape", TokenKind::kw_step},
    {"faire", TokenKind::kw_do},
    {"fin", TokenKind::kw_exit},
    {"graphe", TokenKind::kw_graph},
    {"initiale", TokenKind::kw_initial},
    {"non", TokenKind::kw_not},
    {"ou", TokenKind::kw_or},
    {"si", TokenKind::kw_if},
    {"sortie", TokenKind::kw_output},
    {"suppose", TokenKind::kw_assume},
    {"sur", TokenKind::kw_on},
    {"variable", TokenKind::kw_var},
    {"étape", TokenKind::kw_step},
};

/// In small letters, for the letters that keywords have.
std::string small_letters(std::string_view word) {
    std::string small;
    for (std::size_t at = 0; at < word.size(); ++at) {
        if (word.substr(at, 2) == "É") {
            small += "é";
            ++at;
        } else {
            small += lower_case(word[at]);
        }
    }
    return small;
}

/// The reserved word, or `word`. Most names are put aside by their length or first letter.
TokenKind keyword_of(std::string_view word) {
    constexpr std::size_t longest = 12;
    if (word.size() < 2 || word.size() > longest || word[0] < 'a' || word[0] > 'x') {
        return TokenKind::word;
    }
    const auto place = std::lower_bound(reserved_words.begin(), reserved_words.end(), word);
    if (place == reserved_words.end() || *place != word) return TokenKind::word;
    const auto index = static_cast<std::size_t>(place - reserved_words.begin());
    return static_cast<TokenKind>(first_reserved + index);
}

/// Spaces of Unicode, which come with text that is pasted from elsewhere.
bool is_wide_space(char32_t c) {
    return c == 0x85 || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) || c == 0x2028 ||
           c == 0x2029 || c == 0x202f || c == 0x205f || c == 0x3000;
}

/// The bytes of the letter, digit or `_` at `at`: 0 if there is none.
std::size_t name_character(std::string_view text, std::size_t at) {
    if (at >= text.size()) return 0;
    const char c = text[at];
    if (is_ascii(c)) return is_ascii_letter(c) || is_digit(c) || c == '_' ? 1 : 0;
    const CodePoint code_point = decode_utf8(text, at);
    return is_letter(code_point.value) ? code_point.length : 0;
}

}  // namespace

bool is_letter(char32_t c) {
    if (c < 0x80) return is_ascii_letter(static_cast<char>(c));
    if (c < 0xc0) return c == 0xaa || c == 0xb5 || c == 0xba;
    // Above Latin-1 every code point counts as a letter except the blocks of punctuation, symbols,
    // private use and specials: scripts are many, these blocks are few.
    struct Range {
        char32_t first, last;
    };
    constexpr Range not_letters[] = {{0xd7, 0xd7},     {0xf7, 0xf7},       {0x61c, 0x61c},
                                     {0x1680, 0x1680}, {0x2000, 0x206f},   {0x20a0, 0x20cf},
                                     {0x2190, 0x245f}, {0x2500, 0x2bff},   {0x2e00, 0x2e7f},
                                     {0x3000, 0x3004}, {0x3008, 0x3020},   {0xd800, 0xf8ff},
                                     {0xfe10, 0xfe1f}, {0xfe30, 0xfe6f},   {0xfeff, 0xff0f},
                                     {0xfff0, 0xffff}, {0x1f000, 0x1faff}, {0xe0000, 0x10ffff}};
    return std::none_of(std::begin(not_letters), std::end(not_letters),
                        [c](const Range& range) { return range.first <= c && c <= range.last; });
}

std::string_view reserved_word(TokenKind kind) {
    const auto index = static_cast<std::size_t>(kind);
    return index < first_reserved ? std::string_view() : reserved_words[index - first_reserved];
}

bool is_reserved_word(std::string_view text) {
    return keyword_of(text) != TokenKind::word;
}

TokenKind keyword_in_context(std::string_view word) {
    constexpr std::size_t longest = 16;
    if (word.size() < 2 || word.size() > longest) return TokenKind::end;
    if (is_digit(word.back())) return TokenKind::end;  // as most names of steps end
    const std::string small = small_letters(word);
    for (const WordInContext& row : words_in_context) {
        if (row.word == small) return row.keyword;
    }
    const TokenKind kind = keyword_of(small);
    return kind == TokenKind::word ? TokenKind::end : kind;
}

std::string_view keyword_in(Language language, TokenKind kind) {
    std::string_view word = reserved_word(kind);
    if (language == Language::english) return word;
    for (const WordInContext& row : words_in_context) {
        if (row.keyword == kind) word = row.word;  // of two the one with accents comes last
    }
    return word;
}

bool is_plain_word(std::string_view text) {
    if (text.empty() || !is_letter(decode_utf8(text, 0).value)) return false;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = name_character(text, at);
        if (length == 0) return false;
        at += length;
    }
    return !is_reserved_word(text) && text.find(overline) == text.npos;
}

bool is_integer(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

std::string name_of(std::string_view source, const Token& token) {
    std::string name(source.substr(token.offset, token.length));
    if (token.kind != TokenKind::quoted && token.is_overlined) {
        for (std::size_t at = name.find(overline); at != name.npos; at = name.find(overline)) {
            name.erase(at, overline.size());
        }
    }
    return is_ascii(name) ? name : normalised(name);
}

Localized token_in_message(std::string_view source, const Token& token) {
    if (token.kind == TokenKind::end) return say::end_of_file();
    const std::string_view text = source.substr(token.offset, token.length);
    if (token.kind != TokenKind::quoted) return quoted(text);
    return text.empty() ? say::empty_name() : say::quoted_word(quoted(text));
}

Lexer::Lexer(std::string_view text) : text_(text), at_(byte_order_mark_size(text)) {}

Token Lexer::next(Diagnostics* diagnostics) {
    while (true) {
        skip_space();
        Token token;
        token.offset = static_cast<std::uint32_t>(at_);
        token.where = {line_, column_};
        token.first_on_line = line_is_blank_;
        line_is_blank_ = false;
        if (at_ == text_.size()) return token;
        const char c = text_[at_];
        if (is_ascii_letter(c)) return word(token);
        if (is_digit(c)) return number(token);
        if (c == '"') return quoted(token, diagnostics);
        if (symbol(token)) return token;
        if (!is_ascii(c) && is_letter(decode_utf8(text_, at_).value)) return word(token);
        report_unexpected(token, diagnostics);
    }
}

void Lexer::skip_space() {
    while (at_ < text_.size()) {
        const char c = text_[at_];
        if (c == '\n') {
            ++at_;
            ++line_;
            column_ = 1;
            line_is_blank_ = true;
        } else if (c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f') {
            advance(1);
        } else if (c == '#') {
            skip_comment();
        } else if (is_ascii(c) || !skip_wide_space()) {
            return;
        }
    }
}

bool Lexer::skip_wide_space() {
    const CodePoint code_point = decode_utf8(text_, at_);
    if (!is_wide_space(code_point.value)) return false;
    at_ += code_point.length;
    ++column_;
    return true;
}

void Lexer::skip_comment() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    column_ += static_cast<std::uint32_t>(count_code_points(text_.substr(at_, end - at_)));
    at_ = end;
}

/// A token of ASCII characters.
Token Lexer::finish(Token token, TokenKind kind, std::size_t bytes) {
    token.kind = kind;
    token.length = static_cast<std::uint32_t>(bytes);
    advance(bytes);
    return token;
}

/// A name, or a reserved word: letters, digits and `_` after a letter.
Token Lexer::word(Token token) {
    const std::size_t start = at_;
    for (std::size_t length = name_character(text_, at_); length != 0;
         length = name_character(text_, at_)) {
        at_ += length;
        ++column_;
    }
    const std::string_view text = text_.substr(start, at_ - start);
    token.kind = keyword_of(text);
    token.length = static_cast<std::uint32_t>(text.size());
    token.is_overlined = text.find(overline) != text.npos;
    return token;
}

/// `12`, or `1.5s`. A point belongs to a duration only where digits follow it, and only with a
/// unit: in `X0.1s/a` it is an operator, and `12.m` is the number 12, then `.m`.
Token Lexer::number(Token token) {
    const auto digits_from = [this](std::size_t at) {
        while (at < text_.size() && is_digit(text_[at])) ++at;
        return at;
    };
    const std::size_t whole_end = digits_from(at_ + 1);
    std::size_t end = whole_end;
    if (end + 1 < text_.size() && text_[end] == '.' && is_digit(text_[end + 1])) {
        end = digits_from(end + 2);
    }
    TokenKind kind = TokenKind::integer;
    std::size_t token_end = whole_end;
    for (const std::string_view unit : units) {
        if (text_.substr(end, unit.size()) != unit) continue;
        kind = TokenKind::duration;
        token_end = end + unit.size();
        break;
    }
    if (name_character(text_, token_end) == 0) return finish(token, kind, token_end - at_);
    word(token);
    token.kind = TokenKind::digits_and_letters;
    token.length = static_cast<std::uint32_t>(at_ - token.offset);
    return token;
}

/// Ends at the second quotation mark, or with the line, which is an error: a text that lacks its
/// mark shall not take in the rest of the file.
Token Lexer::quoted(Token token, Diagnostics* diagnostics) {
    const std::size_t start = at_ + 1;
    const std::size_t end = std::min(text_.find_first_of("\"\r\n", start), text_.size());
    const bool is_closed = end < text_.size() && text_[end] == '"';
    const std::string_view text = text_.substr(start, end - start);
    if (!is_closed && diagnostics != nullptr) {
        diagnostics->error(code::unterminated_text, token.where, say::unterminated_text());
    }
    report_control(text, diagnostics);
    token.kind = TokenKind::quoted;
    token.offset = static_cast<std::uint32_t>(start);
    token.length = static_cast<std::uint32_t>(text.size());
    column_ += static_cast<std::uint32_t>(count_code_points(text) + (is_closed ? 2 : 1));
    at_ = end + (is_closed ? 1 : 0);
    return token;
}

/// Names and titles go into reports and programs, and from there to terminals and compilers.
void Lexer::report_control(std::string_view text, Diagnostics* diagnostics) const {
    const std::size_t at = find_control(text);
    if (at == std::string_view::npos || diagnostics == nullptr) return;
    const auto before = static_cast<std::uint32_t>(count_code_points(text.substr(0, at)));
    diagnostics->error(code::unexpected_character, {line_, column_ + 1 + before},
                       control_in_name_message(text));
}

/// An operator or bracket; false where none stands here.
bool Lexer::symbol(Token& token) {
    struct Symbol {
        std::string_view text;
        TokenKind kind;
    };
    // Longer ones before those they begin with.
    static constexpr Symbol symbols[] = {{"->", TokenKind::arrow},
                                         {":=", TokenKind::assign},
                                         {"..", TokenKind::dot_dot},
                                         {"<>", TokenKind::not_equal},
                                         {"<=", TokenKind::less_equal},
                                         {">=", TokenKind::greater_equal},
                                         {":", TokenKind::colon},
                                         {",", TokenKind::comma},
                                         {"(", TokenKind::left_parenthesis},
                                         {")", TokenKind::right_parenthesis},
                                         {"{", TokenKind::left_brace},
                                         {"}", TokenKind::right_brace},
                                         {"[", TokenKind::left_bracket},
                                         {"]", TokenKind::right_bracket},
                                         {"=", TokenKind::equal},
                                         {"<", TokenKind::less},
                                         {">", TokenKind::greater},
                                         {"+", TokenKind::plus},
                                         {"-", TokenKind::minus},
                                         {"|", TokenKind::bar},
                                         {".", TokenKind::dot},
                                         {"*", TokenKind::star},
                                         {"&", TokenKind::ampersand},
                                         {"/", TokenKind::slash},
                                         {"!", TokenKind::exclamation},
                                         {"→", TokenKind::arrow},
                                         {"≤", TokenKind::less_equal},
                                         {"≥", TokenKind::greater_equal},
                                         {"≠", TokenKind::not_equal},
                                         {"·", TokenKind::dot},
                                         {"⋅", TokenKind::dot},
                                         {"∧", TokenKind::ampersand},
                                         {"∨", TokenKind::bar},
                                         {"¬", TokenKind::exclamation},
                                         {"↑", TokenKind::up_arrow},
                                         {"↓", TokenKind::down_arrow},
                                         {"⊕", TokenKind::circled_plus}};
    for (const Symbol& candidate : symbols) {
        if (text_.substr(at_, candidate.text.size()) != candidate.text) continue;
        token.kind = candidate.kind;
        token.length = static_cast<std::uint32_t>(candidate.text.size());
        at_ += candidate.text.size();
        column_ += static_cast<std::uint32_t>(count_code_points(candidate.text));
        if (token.kind == TokenKind::right_parenthesis &&
            text_.substr(at_, overline.size()) == overline) {
            token.is_overlined = true;
            at_ += overline.size();
        }
        return true;
    }
    return false;
}

/// One report for a run of characters that begin no token.
void Lexer::report_unexpected(const Token& token, Diagnostics* diagnostics) {
    const CodePoint first = decode_utf8(text_, at_);
    while (at_ < text_.size()) {
        const char c = text_[at_];
        const CodePoint code_point = decode_utf8(text_, at_);
        Token ignored;
        if (c == '"' || c == '#' || c == '\n' || is_wide_space(code_point.value) || c == ' ' ||
            (c >= '\t' && c <= '\r') || is_letter(code_point.value) || is_digit(c)) {
            break;
        }
        Lexer ahead = *this;
        if (ahead.symbol(ignored)) break;
        at_ += std::max<std::size_t>(code_point.length, 1);
        ++column_;
    }
    if (diagnostics == nullptr) return;
    const bool is_visible = first.value != ' ' && first.value != 0xa0 && !is_control(first.value) &&
                            (first.value < 0x2000 || first.value > 0x206f) && first.value != 0xfeff;
    const Localized shown =
        is_visible ? grafwire::quoted(text_.substr(token.offset, std::max(first.length, 1U)))
                   : say::character_code(static_cast<std::uint32_t>(first.value));
    Localized message = say::unexpected_character(shown);
    if (first.value == U'\'' || first.value == U'\u2019') message = say::negation_before();
    if (first.value == U'^') message = say::rise_written();
    diagnostics->error(code::unexpected_character, token.where, std::move(message));
}

TokenReader::TokenReader(std::string_view source, Diagnostics& diagnostics)
    : source_(source), diagnostics_(diagnostics), lexer_(source) {
    take();
}

void TokenReader::take() {
    if (taken_ != nullptr && !at(TokenKind::end)) taken_->push_back({token_, begins_part_});
    begins_part_ = false;
    previous_kind_ = token_.kind;
    previous_end_ = lexer_.place();
    token_ = lexer_.next(&diagnostics_);
    if (at(TokenKind::digits_and_letters)) report_digits_and_letters();
}

/// Reported once, however often the name is used; it goes on as the name that was meant.
void TokenReader::report_digits_and_letters() {
    token_.kind = TokenKind::word;
    if (!reported_.insert(text()).second) return;
    diagnostics_.error(code::unexpected_token, token_.where,
                       say::digits_and_letters(shown(), text()));
}

bool TokenReader::take_keyword(TokenKind wanted) {
    if (!at(wanted) && keyword() != wanted) return false;
    read_as(wanted);
    take();
    return true;
}

TokenKind TokenReader::keyword() const {
    if (!reserved_word(token_.kind).empty()) return token_.kind;
    if (!at(TokenKind::word) || token_.is_overlined) return TokenKind::end;
    const bool is_ascii_text = is_ascii(text());
    const std::string composed = is_ascii_text ? std::string() : normalised(text());
    const std::string_view word = is_ascii_text ? text() : std::string_view(composed);
    const TokenKind kind = keyword_in_context(word);
    if (kind == TokenKind::end || declared_.find(word) != declared_.end()) return TokenKind::end;
    return token_.first_on_line && looks_like_transition() ? TokenKind::end : kind;
}

void TokenReader::declare(Name name, bool is_time) {
    if (keyword_in_context(name.text) != TokenKind::end) declared_.emplace(name.text);
    if (is_time) times_.emplace(name.text);
}

bool TokenReader::at_time_name() {
    if (times_.empty() || !(at(TokenKind::word) || at(TokenKind::quoted))) return false;
    return times_.find(name().text) != times_.end();
}

bool TokenReader::looks_like_transition() const {
    constexpr int longest_look_ahead = 64;
    Lexer lexer = ahead();
    Token next = token();
    const auto is_name_token = [&next] {
        return is_name(next.kind) || next.kind == TokenKind::digits_and_letters;
    };
    if (next.kind == TokenKind::left_parenthesis) {
        next = lexer.next(nullptr);
        if (!is_name_token()) return false;
        next = lexer.next(nullptr);
        if (next.kind != TokenKind::right_parenthesis) return false;
        next = lexer.next(nullptr);
    }
    for (int i = 0; i < longest_look_ahead && is_name_token(); ++i) {
        next = lexer.next(nullptr);
        if (next.kind != TokenKind::comma) break;
        next = lexer.next(nullptr);
    }
    return next.kind == TokenKind::arrow;
}

Name TokenReader::name() {
    return {normalised_text(token_), token_.where};
}

std::string_view TokenReader::normalised_text(const Token& token) {
    const std::string_view text = source_.substr(token.offset, token.length);
    if (is_ascii(text)) return text;
    std::string name = name_of(source_, token);
    if (name == text) return text;
    return spelled_.emplace_back(std::move(name));
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

/// A name, which digits may spell for steps, graphs and transitions but not for variables. What
/// else stands there decides which message helps: a reserved word could be quoted, a number could
/// not.
bool TokenReader::parse_name(Name& read, const Message<>& what, bool may_be_integer) {
    const bool is_name =
        at(TokenKind::word) || at(TokenKind::quoted) || (may_be_integer && at(TokenKind::integer));
    if (is_name && token_.is_overlined) {
        fail(say::overlined_name(what()));
    }
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
    return fail_at(token_.where, std::move(message));
}

bool TokenReader::fail_at(Location where, Localized message) {
    diagnostics_.error(code::unexpected_token, where, std::move(message));
    return false;
}

bool TokenReader::fail_expecting(const Localized& expected) {
    return fail(say::expected(expected, shown()));
}

}  // namespace grafwire
