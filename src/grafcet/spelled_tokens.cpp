// One spelling of each token, and whether a blank stands before it.
//
// A keyword in French is one only where no variable has its name, so a chart with a variable called
// `étape` keeps the English word there. A name loses its quotation marks only where it could not be
// taken for a keyword without them. An overline becomes the `/` before what it is drawn over:
//
//     "V0"         V0          initial step 3   initial 3, étape initiale 3
//     a et non b   a . /b      (a + b)̅          /(a + b)
//     rise(a)      ↑a          : =1, :=1        : =1, as on paper

#include "grafcet/spelled_tokens.h"

#include <set>

#include "text/utf8.h"

namespace grafwire {

namespace {

/// The text of an operator or bracket.
std::string_view symbol_of(TokenKind kind) {
    switch (kind) {
        case TokenKind::arrow:
            return "->";
        case TokenKind::assign:
            return ":=";
        case TokenKind::colon:
            return ":";
        case TokenKind::comma:
            return ",";
        case TokenKind::left_parenthesis:
            return "(";
        case TokenKind::right_parenthesis:
            return ")";
        case TokenKind::left_brace:
            return "{";
        case TokenKind::right_brace:
            return "}";
        case TokenKind::left_bracket:
            return "[";
        case TokenKind::right_bracket:
            return "]";
        case TokenKind::equal:
            return "=";
        case TokenKind::not_equal:
            return "<>";
        case TokenKind::less:
            return "<";
        case TokenKind::less_equal:
            return "<=";
        case TokenKind::greater:
            return ">";
        case TokenKind::greater_equal:
            return ">=";
        case TokenKind::minus:
            return "-";
        case TokenKind::dot_dot:
            return "..";
        case TokenKind::dot:
        case TokenKind::star:
        case TokenKind::ampersand:
        case TokenKind::kw_and:
            return ".";
        case TokenKind::plus:
        case TokenKind::bar:
        case TokenKind::kw_or:
            return "+";
        case TokenKind::circled_plus:
        case TokenKind::kw_xor:
            return "⊕";
        case TokenKind::slash:
        case TokenKind::exclamation:
        case TokenKind::kw_not:
            return "/";
        case TokenKind::up_arrow:
        case TokenKind::kw_rise:
            return "↑";
        case TokenKind::down_arrow:
        case TokenKind::kw_fall:
            return "↓";
        default:
            return {};
    }
}

/// A sign that stands right before its operand, always.
bool is_sign(TokenKind kind) {
    const std::string_view symbol = symbol_of(kind);
    return symbol == "↑" || symbol == "↓" || kind == TokenKind::exclamation ||
           kind == TokenKind::kw_not;
}

/// Whether an operand may end with such a token.
bool ends_operand(TokenKind kind) {
    return TokenReader::is_name(kind) || kind == TokenKind::duration ||
           kind == TokenKind::right_parenthesis || kind == TokenKind::right_bracket;
}

bool begins_transition(TokenKind kind) {
    return kind == TokenKind::arrow || kind == TokenKind::left_parenthesis ||
           TokenReader::is_name(kind);
}

/// Whether such a part declares names.
bool declares_names(TokenKind kind) {
    return kind == TokenKind::kw_input || kind == TokenKind::kw_output ||
           kind == TokenKind::kw_var || kind == TokenKind::kw_counter ||
           kind == TokenKind::kw_define || kind == TokenKind::kw_time;
}

class Speller {
  public:
    Speller(std::string_view source, std::span<const ReadToken> tokens, Language language)
        : source_(source), tokens_(tokens), language_(language), is_negated_(tokens.size()) {}

    std::vector<SpelledToken> spell() {
        look_through();
        for (std::size_t i = 0; i < tokens_.size(); ++i) spell_token(i);
        return std::move(spelled_);
    }

  private:
    const Token& token(std::size_t i) const { return tokens_[i].token; }
    /// The end of the file behind the last token.
    TokenKind kind(std::size_t i) const {
        return i < tokens_.size() ? token(i).kind : TokenKind::end;
    }
    std::string_view written(std::size_t i) const {
        return source_.substr(token(i).offset, token(i).length);
    }
    std::size_t begin_of(std::size_t i) const {
        return token(i).offset - (kind(i) == TokenKind::quoted ? 1U : 0U);
    }
    std::size_t end_of(std::size_t i) const {
        return token(i).offset + token(i).length + (kind(i) == TokenKind::quoted ? 1U : 0U);
    }
    bool are_apart_by_comment(std::size_t first, std::size_t last) const {
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t end = end_of(i);
            if (source_.substr(end, begin_of(i + 1) - end).find('#') != source_.npos) return true;
        }
        return false;
    }

    void look_through();
    void declare(std::string name) {
        if (keyword_in_context(name) != TokenKind::end) declared_.insert(std::move(name));
    }
    void spell_token(std::size_t i);
    void begin_part(std::size_t i);
    std::string text_of(std::size_t i) const;
    std::string name(std::size_t i) const;
    std::string keyword(TokenKind kind) const;
    std::string initial() const;
    bool is_usable(TokenKind kind) const {
        return declared_.count(keyword_in(language_, kind)) == 0;
    }
    bool is_initial_step() const {
        return part_ == TokenKind::kw_initial ||
               (part_ == TokenKind::kw_step && kind(part_begin_ + 1) == TokenKind::kw_initial);
    }
    bool may_be_number(std::size_t i) const;
    bool joins(std::size_t i) const;
    bool joins_next(std::size_t i) const;
    bool holds_one_name(std::size_t i) const;

    std::string_view source_;
    std::span<const ReadToken> tokens_;
    Language language_;
    std::vector<bool> is_negated_;  ///< of each token: `/` comes before it, for an overline
    std::set<std::string, std::less<>> declared_;  ///< those names that are keywords elsewhere
    std::vector<SpelledToken> spelled_;

    // Of the part that is being spelled.
    TokenKind part_ = TokenKind::end;  ///< its first token
    std::size_t part_begin_ = 0;
    bool is_in_body_ = false;    ///< behind the `:` or `=`
    bool is_in_braces_ = false;  ///< of an order or enclosure
    bool joins_next_ = false;    ///< the last token asks for no blank behind it
    std::size_t dropped_ = 0;    ///< a parenthesis that is left out
};

/// Finds the overlines, and the declared names that stand in the way of keywords.
void Speller::look_through() {
    std::vector<std::size_t> open;
    bool is_declaration = false;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (tokens_[i].begins_part) is_declaration = declares_names(kind(i));
        if (kind(i) == TokenKind::left_parenthesis) {
            open.push_back(i);
        } else if (kind(i) == TokenKind::right_parenthesis) {
            // One over a label says nothing.
            is_negated_[open.back()] = token(i).is_overlined && !tokens_[open.back()].begins_part;
            open.pop_back();
        } else if (kind(i) == TokenKind::word || kind(i) == TokenKind::quoted) {
            is_negated_[i] = token(i).is_overlined;
            if (is_declaration) declare(name_of(source_, token(i)));
        }
    }
}

void Speller::begin_part(std::size_t i) {
    part_ = kind(i);
    part_begin_ = i;
    is_in_body_ = false;
    is_in_braces_ = false;
    joins_next_ = false;
}

void Speller::spell_token(std::size_t i) {
    if (tokens_[i].begins_part) begin_part(i);
    // `initial step` and `étape initiale` are one.
    const bool is_second_word =
        i == part_begin_ + 1 && (kind(i) == TokenKind::kw_step || kind(i) == TokenKind::kw_initial);
    if (is_second_word || (dropped_ != 0 && i == dropped_)) return;
    if (i > 0 && holds_one_name(i)) {
        dropped_ = i + 2;
        return;
    }
    const bool is_brace = kind(i) == TokenKind::left_brace;
    is_in_braces_ = is_in_braces_ ||
                    (is_brace && part_ != TokenKind::kw_graph && part_ != TokenKind::kw_expansion);
    spelled_.push_back({kind(i), text_of(i), begin_of(i), end_of(i), tokens_[i].begins_part,
                        !tokens_[i].begins_part && (joins_next_ || joins(i))});
    joins_next_ = joins_next(i);
    if (kind(i) == TokenKind::right_brace) is_in_braces_ = false;
    if (kind(i) == TokenKind::colon || kind(i) == TokenKind::assign) is_in_body_ = true;
}

/// Whether `(a)` behind `rise` begins here, which needs no parentheses behind `↑`.
bool Speller::holds_one_name(std::size_t i) const {
    return (kind(i - 1) == TokenKind::kw_rise || kind(i - 1) == TokenKind::kw_fall) &&
           TokenReader::is_name(kind(i + 1)) && kind(i + 2) == TokenKind::right_parenthesis &&
           !is_negated_[i] && !are_apart_by_comment(i - 1, i + 2);
}

std::string Speller::text_of(std::size_t i) const {
    const std::string_view sign = is_negated_[i] ? "/" : "";
    const bool is_paper_one = kind(i) == TokenKind::assign && !is_in_body_;
    if (is_paper_one && begins_transition(part_)) return ": =";  // `:=1`
    if (kind(i) == TokenKind::star && is_in_braces_) return "*";
    if (const std::string_view symbol = symbol_of(kind(i)); !symbol.empty()) {
        return std::string(sign).append(symbol);
    }
    if (!reserved_word(kind(i)).empty()) {
        if (i == part_begin_ && is_initial_step()) return initial();
        // On a line of its own, before a source transition, it would be a step in French.
        const bool begins_line = i > 0 && are_apart_by_comment(i - 1, i);
        if (begins_line && kind(i) == TokenKind::kw_deactivation) return "deactivation";
        return keyword(kind(i));
    }
    if (kind(i) == TokenKind::word || kind(i) == TokenKind::quoted) {
        return std::string(sign) + name(i);
    }
    return std::string(written(i));
}

std::string Speller::keyword(TokenKind kind) const {
    return std::string(is_usable(kind) ? keyword_in(language_, kind) : reserved_word(kind));
}

std::string Speller::initial() const {
    if (language_ == Language::english || !is_usable(TokenKind::kw_step) ||
        !is_usable(TokenKind::kw_initial)) {
        return std::string(reserved_word(TokenKind::kw_initial));
    }
    return keyword(TokenKind::kw_step) + ' ' + keyword(TokenKind::kw_initial);
}

/// A title is no name, and stays as it is.
std::string Speller::name(std::size_t i) const {
    const bool is_title = part_ == TokenKind::kw_grafcet && i == part_begin_ + 2;
    if (is_title) return '"' + std::string(written(i)) + '"';
    std::string text = name_of(source_, token(i));
    const TokenKind other_meaning = keyword_in_context(text);
    bool is_plain = is_plain_word(text);
    if (kind(i) == TokenKind::quoted) {
        is_plain =
            is_plain && other_meaning == TokenKind::end && !(is_in_braces_ && text == "INIT");
        is_plain = is_plain || (is_integer(text) && may_be_number(i));
    } else if (is_initial_step() && spelled_.back().begins_part) {
        // `initial step étape`, from which `step` goes
        is_plain = is_plain && other_meaning != TokenKind::kw_step &&
                   other_meaning != TokenKind::kw_initial;
    }
    return is_plain ? text : '"' + text + '"';
}

/// Whether digits are a name here: of a step, a graph, an expansion or a transition.
bool Speller::may_be_number(std::size_t i) const {
    switch (part_) {
        case TokenKind::kw_graph:
        case TokenKind::kw_expansion:
        case TokenKind::kw_macro:
            return true;
        case TokenKind::kw_grafcet:
        case TokenKind::kw_input:
        case TokenKind::kw_output:
        case TokenKind::kw_var:
        case TokenKind::kw_counter:
        case TokenKind::kw_assume:
        case TokenKind::kw_define:
        case TokenKind::kw_time:
            return false;
        default:
            return !is_in_body_ || is_in_braces_ || kind(i + 1) == TokenKind::left_brace;
    }
}

/// Whether no blank stands before a token, whatever comes before it.
bool Speller::joins(std::size_t i) const {
    switch (kind(i)) {
        case TokenKind::comma:
        case TokenKind::right_parenthesis:
        case TokenKind::right_bracket:
        case TokenKind::right_brace:
        case TokenKind::dot_dot:
            return true;
        case TokenKind::left_brace:
            return is_in_braces_;
        case TokenKind::slash:  // of a time condition
            return ends_operand(kind(i - 1));
        default:
            return false;
    }
}

/// Whether no blank stands behind a token, whatever comes next.
bool Speller::joins_next(std::size_t i) const {
    const bool is_behind_operand = i > part_begin_ && ends_operand(kind(i - 1));
    switch (kind(i)) {
        case TokenKind::left_parenthesis:
        case TokenKind::left_bracket:
        case TokenKind::slash:
        case TokenKind::dot_dot:
            return true;
        case TokenKind::left_brace:
            return is_in_braces_;
        case TokenKind::minus:
            return !is_behind_operand;
        case TokenKind::equal:  // `: =1`
            return kind(i - 1) == TokenKind::colon;
        case TokenKind::assign:
            return !is_in_body_ && spelled_.back().text == ": =";
        default:
            return is_sign(kind(i));
    }
}

}  // namespace

std::vector<SpelledToken> spell_tokens(std::string_view source, std::span<const ReadToken> tokens,
                                       Language language) {
    return Speller(source, tokens, language).spell();
}

}  // namespace grafwire
