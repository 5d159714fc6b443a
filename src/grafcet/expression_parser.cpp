// Expressions by recursive descent: chains of operators of equal rank, from the weakest to the
// strongest, then what binds to the operand behind it. A node is added once its parts are,
// which is the postfix order of NamedExpression. Nesting is bounded (deepest_nesting), and with it
// the recursion here and in everything that later walks an expression.

#include <fmt/format.h>

#include <array>
#include <optional>

#include "grafcet/chart_parser.h"
#include "grafcet/checking.h"
#include "grafcet/messages.h"

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
    } else if (tokens.at(TokenKind::word) || tokens.at(TokenKind::quoted)) {
        term.counter = tokens.name();
        tokens.take();
    } else {
        return tokens.fail_expecting(say::counter_or_number());
    }
    sum.push_back(term);
    return true;
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
    bool parse_delay(Time& delay);
    bool parse_comparison();
    bool parse_constant_or_variable();

    TokenReader& tokens_;
    NamedExpression& expression_;
    int nesting_ = 0;
};

/// `a + b + c` is one node with three operands, not two with two.
bool ExpressionParser::parse_chain(int level) {
    if (level == static_cast<int>(chain_kinds.size())) return parse_unary();
    const Location where = tokens_.token().where;
    std::uint32_t operands = 1;
    if (!parse_chain(level + 1)) return false;
    while (is_chain_operator(level, tokens_.token().kind)) {
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
    switch (tokens_.token().kind) {
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
            is_good = parse_constant_or_variable();
            break;
    }
    --nesting_;
    return is_good;
}

/// `/e`, `↑e`, `↓e`: what binds to the sign, so that `/a.b` is (/a).b.
bool ExpressionParser::parse_prefixed(ExprKind kind) {
    const Location where = tokens_.token().where;
    tokens_.take();
    if (!parse_unary()) return false;
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
    tokens_.take();
    return parse_chain(0) &&
           tokens_.expect(TokenKind::right_parenthesis, say::operator_or_parenthesis);
}

/// `1s/e`, `1s/e/2s`. An off-delay belongs to the innermost time condition before it.
bool ExpressionParser::parse_time_condition() {
    const Location where = tokens_.token().where;
    Time on_delay = 0;
    Time off_delay = 0;
    if (!parse_delay(on_delay) || !tokens_.expect(TokenKind::slash, say::slash_after_duration)) {
        return false;
    }
    if (!parse_unary()) return false;
    if (tokens_.take_if(TokenKind::slash) && !parse_delay(off_delay)) return false;
    expression_.time_condition(on_delay, off_delay, where);
    return true;
}

/// A delay that is out of range is reported and read as 0: the expression is whole then.
bool ExpressionParser::parse_delay(Time& delay) {
    if (!tokens_.at(TokenKind::duration)) {
        return tokens_.fail_expecting(say::duration_after_slash());
    }
    const auto value = parse_duration(tokens_.text());
    if (!value) {
        tokens_.diagnostics().error(code::duration_out_of_range, tokens_.token().where,
                                    say::duration_out_of_range(tokens_.shown()));
    }
    delay = value.value_or(0);
    tokens_.take();
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
bool ExpressionParser::parse_constant_or_variable() {
    const Name name = tokens_.name();
    if ((tokens_.at(TokenKind::word) || tokens_.at(TokenKind::quoted)) && !name.text.empty()) {
        expression_.variable(name);
    } else if (tokens_.at(TokenKind::integer) && (name.text == "0" || name.text == "1")) {
        expression_.constant(name.text == "1", name.where);
    } else if (tokens_.at(TokenKind::integer)) {
        return tokens_.fail(say::number_as_condition(tokens_.shown()));
    } else {
        return tokens_.fail_expecting(say::a_condition());
    }
    tokens_.take();
    return true;
}

}  // namespace

bool parse_expression(TokenReader& tokens, NamedExpression& expression) {
    expression.clear();
    if (ExpressionParser(tokens, expression).parse_chain(0)) return true;
    expression.clear();
    return false;
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
