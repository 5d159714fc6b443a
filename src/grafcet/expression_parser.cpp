// Expressions by recursive descent: chains of operators of equal rank, from the weakest to the
// strongest, then what binds to the operand behind it. A node is added once its parts are,
// which is the postfix order of NamedExpression. Nesting is bounded (deepest_nesting), and with it
// the recursion here and in everything that later walks an expression.

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "grafcet/chart_parser.h"
#include "grafcet/checking.h"
#include "grafcet/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// The chains of operators of equal rank, from the weakest to the strongest.
constexpr std::array<ExprKind, 3> chain_kinds = {ExprKind::disjunction, ExprKind::exclusive_or,
                                                 ExprKind::conjunction};

/// `+ | or`, then `⊕ xor`, then `. * & and`.
bool is_chain_operator(int level, TokenKind kind) {
    switch (kind) {
        case TokenKind::plus:
        case TokenKind::bar:
        case TokenKind::kw_or:
            return level == 0;
        case TokenKind::circled_plus:
        case TokenKind::kw_xor:
            return level == 1;
        case TokenKind::dot:
        case TokenKind::star:
        case TokenKind::ampersand:
        case TokenKind::kw_and:
            return level == 2;
        default:
            return false;
    }
}

/// The kind of the token; of a word such as `et` that of the operator it stands for.
TokenKind operator_kind(const TokenReader& tokens) {
    return tokens.at(TokenKind::word) ? tokens.keyword() : tokens.token().kind;
}

std::optional<Relation> relation_of(TokenKind kind) {
    switch (kind) {
        case TokenKind::equal:
            return Relation::equal;
        case TokenKind::not_equal:
            return Relation::not_equal;
        case TokenKind::less:
            return Relation::less;
        case TokenKind::less_equal:
            return Relation::less_equal;
        case TokenKind::greater:
            return Relation::greater;
        case TokenKind::greater_equal:
            return Relation::greater_equal;
        default:
            return std::nullopt;
    }
}

/// A term of a sum: `n`, `12`.
bool parse_term(TokenReader& tokens, bool negative, NamedSum& sum) {
    NamedTerm term;
    term.negative = negative;
    term.where = tokens.token().where;
    if (tokens.at(TokenKind::integer)) {
        if (!tokens.parse_number(term.number)) return false;
    } else if (tokens.token().is_overlined) {
        return tokens.fail(say::overlined_name(say::counter_or_number()));
    } else if (tokens.at(TokenKind::word) || tokens.at(TokenKind::quoted)) {
        term.counter = tokens.name();
        tokens.take();
    } else {
        return tokens.fail_expecting(say::counter_or_number());
    }
    sum.push_back(term);
    return true;
}

/// Whether an overline stands over each character of a word, or over the last alone, as one over
/// the whole name is often typed.
bool is_wholly_overlined(std::string_view word) {
    constexpr std::string_view overline = "\u0305";
    std::size_t overlines = 0;
    std::size_t letters = 0;
    for (std::size_t at = 0; at < word.size();) {
        const bool is_overline = word.substr(at, overline.size()) == overline;
        ++(is_overline ? overlines : letters);
        at += is_overline ? overline.size() : decode_utf8(word, at).length;
    }
    const bool at_end = word.substr(word.size() - overline.size()) == overline;
    return at_end && (overlines == 1 || overlines == letters);
}

/// Reads an expression from the present token on and adds its nodes in postfix order.
class ExpressionParser {
  public:
    ExpressionParser(TokenReader& tokens, NamedExpression& expression)
        : tokens_(tokens), expression_(expression) {}

    bool parse_chain(int level);

  private:
    bool parse_unary();
    bool parse_prefixed(ExprKind kind);
    bool parse_called(ExprKind kind);
    bool parse_parenthesised();
    bool parse_time_condition();
    bool parse_delay(Delay& delay);
    bool parse_comparison();
    bool parse_variable();
    bool parse_constant();
    bool refuse_time_condition(const Name& first);

    TokenReader& tokens_;
    NamedExpression& expression_;
    int nesting_ = 0;
    int open_times_ = 0;  ///< time conditions whose operand is being read, in this parenthesis
};

/// `a + b + c` is one node with three operands, not two with two.
bool ExpressionParser::parse_chain(int level) {
    if (level == static_cast<int>(chain_kinds.size())) return parse_unary();
    const Location where = tokens_.token().where;
    std::uint32_t operands = 1;
    if (!parse_chain(level + 1)) return false;
    while (is_chain_operator(level, operator_kind(tokens_))) {
        tokens_.read_as(operator_kind(tokens_));
        tokens_.take();
        if (!parse_chain(level + 1)) return false;
        ++operands;
    }
    if (operands > 1) {
        expression_.join(chain_kinds[static_cast<std::size_t>(level)], operands, where);
    }
    return true;
}

/// What binds to the operand behind it: `/e`, `↑e`, `5s/e`; or an operand.
bool ExpressionParser::parse_unary() {
    if (++nesting_ > deepest_nesting) {
        tokens_.diagnostics().error(code::nested_too_deep, tokens_.token().where,
                                    nested_too_deep_message());
        return false;
    }
    bool is_good = false;
    TokenKind kind = tokens_.token().kind;
    if (tokens_.at_time_name()) kind = TokenKind::duration;
    if (kind == TokenKind::word && tokens_.keyword() == TokenKind::kw_not) {
        kind = TokenKind::kw_not;
        tokens_.read_as(kind);
    }
    switch (kind) {
        case TokenKind::slash:
        case TokenKind::exclamation:
        case TokenKind::kw_not:
            is_good = parse_prefixed(ExprKind::negation);
            break;
        case TokenKind::up_arrow:
            is_good = parse_prefixed(ExprKind::rise);
            break;
        case TokenKind::down_arrow:
            is_good = parse_prefixed(ExprKind::fall);
            break;
        case TokenKind::kw_rise:
            is_good = parse_called(ExprKind::rise);
            break;
        case TokenKind::kw_fall:
            is_good = parse_called(ExprKind::fall);
            break;
        case TokenKind::duration:
            is_good = parse_time_condition();
            break;
        case TokenKind::left_bracket:
            is_good = parse_comparison();
            break;
        case TokenKind::left_parenthesis:
            is_good = parse_parenthesised();
            break;
        default:
            is_good = tokens_.at(TokenKind::integer) ? parse_constant() : parse_variable();
            break;
    }
    --nesting_;
    return is_good;
}

/// `/e`, `↑e`, `↓e`: what binds to the sign, so that `/a.b` is (/a).b. A parenthesis behind it is
/// no level of its own, as behind `rise`.
bool ExpressionParser::parse_prefixed(ExprKind kind) {
    const Location where = tokens_.token().where;
    tokens_.take();
    const bool is_parenthesised = tokens_.at(TokenKind::left_parenthesis);
    if (!(is_parenthesised ? parse_parenthesised() : parse_unary())) return false;
    expression_.join(kind, 1, where);
    return true;
}

/// `rise(e)`, `fall(e)`.
bool ExpressionParser::parse_called(ExprKind kind) {
    const Location where = tokens_.token().where;
    const std::string_view name = reserved_word(tokens_.token().kind);
    tokens_.take();
    if (!tokens_.at(TokenKind::left_parenthesis)) {
        return tokens_.fail_expecting(say::parenthesis_after(name));
    }
    if (!parse_parenthesised()) return false;
    expression_.join(kind, 1, where);
    return true;
}

bool ExpressionParser::parse_parenthesised() {
    const Location where = tokens_.token().where;
    tokens_.take();
    const int outer_times = std::exchange(open_times_, 0);
    const bool is_good = parse_chain(0);
    open_times_ = outer_times;
    const bool is_overlined = tokens_.token().is_overlined;
    if (!is_good || !tokens_.expect(TokenKind::right_parenthesis, say::operator_or_parenthesis)) {
        return false;
    }
    if (is_overlined) expression_.join(ExprKind::negation, 1, where);
    return true;
}

/// `1s/e`, `1s/e/2s`. An off-delay belongs to the innermost time condition before it.
bool ExpressionParser::parse_time_condition() {
    const Location where = tokens_.token().where;
    Delay on_delay;
    Delay off_delay;
    if (!parse_delay(on_delay) || !tokens_.expect(TokenKind::slash, say::slash_after_duration)) {
        return false;
    }
    ++open_times_;
    const bool is_good = parse_unary();
    --open_times_;
    if (!is_good) return false;
    if (tokens_.take_if(TokenKind::slash) && !parse_delay(off_delay)) return false;
    expression_.time_condition(on_delay, off_delay, where);
    return true;
}

/// A duration, or the name of one.
bool ExpressionParser::parse_delay(Delay& delay) {
    if (tokens_.at(TokenKind::word) || tokens_.at(TokenKind::quoted)) {
        if (tokens_.token().is_overlined) {
            return tokens_.fail(say::overlined_name(say::a_duration()));
        }
        delay.name = tokens_.name();
        tokens_.take();
        return true;
    }
    if (!tokens_.at(TokenKind::duration)) {
        return tokens_.fail_expecting(say::duration_after_slash());
    }
    std::optional<Time> value;
    parse_duration_token(tokens_, value);
    delay.time = value.value_or(0);
    return true;
}

/// `[n + 1 >= 10]`
bool ExpressionParser::parse_comparison() {
    const Location where = tokens_.token().where;
    tokens_.take();
    NamedSum left;
    NamedSum right;
    if (!parse_sum(tokens_, left)) return false;
    const std::optional<Relation> relation = relation_of(tokens_.token().kind);
    if (!relation) {
        return tokens_.fail_expecting(say::relation());
    }
    tokens_.take();
    if (!parse_sum(tokens_, right) ||
        !tokens_.expect(TokenKind::right_bracket, say::end_of_comparison)) {
        return false;
    }
    expression_.comparison(std::move(left), *relation, std::move(right), where);
    return true;
}

/// `0`, `1`, a name. Other numbers are most often steps, whose variable has an X.
bool ExpressionParser::parse_variable() {
    const bool is_name = tokens_.at(TokenKind::word) || tokens_.at(TokenKind::quoted);
    const Token token = tokens_.token();
    const bool begins_transition = token.first_on_line && tokens_.looks_like_transition();
    if (!is_name || token.length == 0 || begins_transition) {
        const bool is_elsewhere = token.first_on_line || token.kind == TokenKind::end;
        return tokens_.fail_at(is_elsewhere ? tokens_.previous_end() : token.where,
                               say::expected(say::a_condition(), tokens_.shown()));
    }
    const Name name = tokens_.name();
    const std::string_view written = tokens_.text();
    expression_.variable(name);
    tokens_.take();
    if (token.is_overlined) {
        if (!is_wholly_overlined(written))
            return tokens_.fail_at(token.where, say::partly_overlined());
        expression_.join(ExprKind::negation, 1, token.where);
    }
    if (tokens_.at(TokenKind::slash) && open_times_ == 0) return !refuse_time_condition(name);
    if (tokens_.at(TokenKind::left_parenthesis) && !tokens_.token().first_on_line &&
        (name.text == "FM" || name.text == "FD" || name.text == "fm" || name.text == "fd" ||
         name.text == "RE" || name.text == "FE")) {
        return tokens_.fail_at(name.where, say::edge_called(name.text));
    }
    return true;
}

/// `X5/3s`, `t1/X5/3s`: the order of other notations, behind their first name. False where it is
/// none of these.
bool ExpressionParser::refuse_time_condition(const Name& first) {
    Lexer lexer = tokens_.ahead();
    const auto text_of = [this](const Token& token) {
        return tokens_.source().substr(token.offset, token.length);
    };
    Token next = lexer.next(nullptr);
    if (next.kind == TokenKind::duration) {
        tokens_.fail_at(first.where, say::time_condition_order(text_of(next), first.text));
        return true;
    }
    if (next.kind != TokenKind::word && next.kind != TokenKind::quoted) return false;
    const std::string_view variable = text_of(next);
    std::string_view duration = "5s";
    next = lexer.next(nullptr);
    if (next.kind == TokenKind::slash) {
        next = lexer.next(nullptr);
        if (next.kind == TokenKind::duration) duration = text_of(next);
    }
    tokens_.fail_at(first.where, say::time_condition_order(duration, variable));
    return true;
}

/// `0` or `1`. A longer number may be a duration with a comma or a space in it, or the number of a
/// step.
bool ExpressionParser::parse_constant() {
    if (tokens_.token().first_on_line && tokens_.looks_like_transition()) {
        return tokens_.fail_at(tokens_.previous_end(),
                               say::expected(say::a_condition(), tokens_.shown()));
    }
    const Name number = tokens_.name();
    Lexer lexer = tokens_.ahead();
    Token next = lexer.next(nullptr);
    const std::string_view source = tokens_.source();
    if (next.kind == TokenKind::word) {
        const std::string_view unit = source.substr(next.offset, next.length);
        const bool is_unit =
            unit == "us" || unit == "ms" || unit == "s" || unit == "min" || unit == "h";
        if (is_unit && !next.first_on_line) {
            return tokens_.fail(say::space_before_unit(number.text, unit));
        }
    } else if (next.kind == TokenKind::comma) {
        const Token fraction = lexer.next(nullptr);
        if (fraction.kind == TokenKind::duration && fraction.offset == next.offset + 1) {
            return tokens_.fail(
                say::decimal_point(number.text, source.substr(fraction.offset, fraction.length)));
        }
    }
    if (number.text != "0" && number.text != "1") {
        return tokens_.fail(say::number_as_condition(tokens_.shown(), number.text));
    }
    expression_.constant(number.text == "1", number.where);
    tokens_.take();
    return true;
}

/// What stands behind a whole expression and shows that more was meant.
bool refuse_rest(TokenReader& tokens) {
    if (relation_of(tokens.token().kind) && !tokens.token().first_on_line) {
        return tokens.fail(say::comparison_without_brackets());
    }
    if (tokens.at(TokenKind::slash)) {
        Lexer lexer = tokens.ahead();
        if (lexer.next(nullptr).kind == TokenKind::slash) {
            return tokens.fail(say::remark_begins_otherwise());
        }
    }
    return true;
}

}  // namespace

bool parse_expression(TokenReader& tokens, NamedExpression& expression) {
    expression.clear();
    if (ExpressionParser(tokens, expression).parse_chain(0) && refuse_rest(tokens)) return true;
    expression.clear();
    return false;
}

bool parse_duration_token(TokenReader& tokens, std::optional<Time>& value) {
    if (!tokens.at(TokenKind::duration)) return tokens.fail_expecting(say::a_duration());
    value = parse_duration(tokens.text());
    if (!value) {
        tokens.diagnostics().error(code::duration_out_of_range, tokens.token().where,
                                   say::duration_out_of_range(tokens.shown()));
    }
    tokens.take();
    return true;
}

bool parse_sum(TokenReader& tokens, NamedSum& sum) {
    if (!parse_term(tokens, tokens.take_if(TokenKind::minus), sum)) return false;
    while (tokens.at(TokenKind::plus) || tokens.at(TokenKind::minus)) {
        const bool is_negative = tokens.at(TokenKind::minus);
        if (sum.size() >= longest_sum) {
            tokens.diagnostics().error(code::nested_too_deep, tokens.token().where,
                                       sum_too_long_message());
            return false;
        }
        tokens.take();
        if (!parse_term(tokens, is_negative, sum)) return false;
    }
    return true;
}

}  // namespace grafwire
