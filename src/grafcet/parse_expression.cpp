#include <fmt/format.h>

#include <array>

#include "grafcet/syntax_parser.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

// The chains of operators of equal rank, from the weakest to the strongest.
constexpr std::array<ExprKind, 3> chain_kinds = {ExprKind::disjunction, ExprKind::exclusive_or,
                                                 ExprKind::conjunction};

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

}  // namespace

bool SyntaxParser::parse_expression(ExpressionSyntax& expression) {
    const std::size_t first = syntax_.expression_nodes.size();
    const Location where = token_.where;
    nesting_ = 0;
    time_depth_ = 0;
    if (!parse_chain(0)) {
        syntax_.expression_nodes.resize(first);
        return false;
    }
    expression.first = static_cast<std::uint32_t>(first);
    expression.count = static_cast<std::uint32_t>(syntax_.expression_nodes.size() - first);
    expression.where = where;
    return true;
}

bool SyntaxParser::parse_chain(int level) {
    if (level == static_cast<int>(chain_kinds.size())) return parse_unary();
    Word word;
    word.where = token_.where;
    std::uint32_t operands = 1;
    if (!parse_chain(level + 1)) return false;
    while (is_chain_operator(level, token_.kind)) {
        take();
        if (!parse_chain(level + 1)) return false;
        ++operands;
    }
    if (operands > 1) add_node(chain_kinds[static_cast<std::size_t>(level)], operands, word);
    return true;
}

bool SyntaxParser::parse_unary() {
    if (++nesting_ > deepest_nesting) {
        diagnostics_.error(Code::nested_too_deep, token_.where,
                           fmt::format("this expression is nested more than {} levels deep; give "
                                       "parts of it to vars of their own",
                                       deepest_nesting));
        return false;
    }
    bool is_good = false;
    switch (token_.kind) {
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

bool SyntaxParser::parse_prefixed(ExprKind kind) {
    const Word word = word_of(token_);
    take();
    if (!parse_unary()) return false;
    add_node(kind, 1, word);
    return true;
}

bool SyntaxParser::parse_called(ExprKind kind) {
    const Word word = word_of(token_);
    const std::string expected = fmt::format("'(' after '{}'", reserved_word(token_.kind));
    take();
    if (!at(TokenKind::left_parenthesis))
        return fail(fmt::format("expected {}, got {}", expected, shown()));
    if (!parse_parenthesised()) return false;
    add_node(kind, 1, word);
    return true;
}

bool SyntaxParser::parse_parenthesised() {
    take();
    return parse_chain(0) && expect(TokenKind::right_parenthesis, "an operator or ')'");
}

bool SyntaxParser::parse_time_condition() {
    const Word word = word_of(token_);
    TimeSyntax time;
    if (!parse_delay(time.on_delay) ||
        !expect(TokenKind::slash, "'/' after the duration, as in 5s/X13"))
        return false;
    ++time_depth_;
    const bool is_good = parse_unary();
    --time_depth_;
    if (!is_good) return false;
    if (take_if(TokenKind::slash) && !parse_delay(time.off_delay)) return false;
    add_node(ExprKind::time_condition, static_cast<std::uint32_t>(syntax_.times.size()), word);
    syntax_.times.push_back(time);
    return true;
}

bool SyntaxParser::parse_delay(Time& delay) {
    if (!at(TokenKind::duration))
        return fail(
            fmt::format("expected a duration after '/', as in 1s/X5/2s, or an operator "
                        "before it, got {}",
                        shown()));
    const auto value = parse_duration(text_of(token_));
    if (!value) {
        diagnostics_.error(
            Code::duration_out_of_range, token_.where,
            fmt::format("the duration {} is too long or too fine; durations go up to 106 days in "
                        "whole picoseconds",
                        shown()));
    }
    delay = value.value_or(0);
    take();
    return true;
}

bool SyntaxParser::parse_comparison() {
    const Word word = word_of(token_);
    take();
    ComparisonSyntax comparison;
    if (!parse_sum(comparison.left)) return false;
    switch (token_.kind) {
        case TokenKind::equal:
            comparison.relation = Relation::equal;
            break;
        case TokenKind::not_equal:
            comparison.relation = Relation::not_equal;
            break;
        case TokenKind::less:
            comparison.relation = Relation::less;
            break;
        case TokenKind::less_equal:
            comparison.relation = Relation::less_equal;
            break;
        case TokenKind::greater:
            comparison.relation = Relation::greater;
            break;
        case TokenKind::greater_equal:
            comparison.relation = Relation::greater_equal;
            break;
        default:
            return fail(
                fmt::format("expected one of = <> < <= > >= in the comparison, got {}", shown()));
    }
    take();
    if (!parse_sum(comparison.right) ||
        !expect(TokenKind::right_bracket, "']' at the end of the comparison"))
        return false;
    add_node(ExprKind::comparison, static_cast<std::uint32_t>(syntax_.comparisons.size()), word);
    syntax_.comparisons.push_back(comparison);
    return true;
}

bool SyntaxParser::parse_sum(Range<>& sum) {
    sum.first = static_cast<std::uint32_t>(syntax_.terms.size());
    if (!parse_term(take_if(TokenKind::minus))) return false;
    while (at(TokenKind::plus) || at(TokenKind::minus)) {
        const bool is_negative = at(TokenKind::minus);
        if (syntax_.terms.size() - sum.first >= longest_sum) {
            diagnostics_.error(Code::nested_too_deep, token_.where,
                               fmt::format("a sum has {} terms at most", longest_sum));
            return false;
        }
        take();
        if (!parse_term(is_negative)) return false;
    }
    sum.count = static_cast<std::uint32_t>(syntax_.terms.size()) - sum.first;
    return true;
}

bool SyntaxParser::parse_term(bool negative) {
    TermSyntax term;
    term.negative = negative;
    term.word = word_of(token_);
    if (at(TokenKind::integer)) {
        if (!parse_number(term.value)) return false;
    } else if (at(TokenKind::word) || at(TokenKind::quoted)) {
        term.is_name = true;
        take();
    } else {
        return fail(fmt::format("expected a counter or a number, got {}", shown()));
    }
    syntax_.terms.push_back(term);
    return true;
}

// Expects a token of digits. A number that is too large is reported and read as 0.
bool SyntaxParser::parse_number(std::int64_t& value) {
    value = 0;
    for (const char digit : text_of(token_)) {
        value = value * 10 + (digit - '0');
        if (value <= largest_number) continue;
        diagnostics_.error(Code::number_too_large, token_.where,
                           fmt::format("the number {} is too large; numbers go up to {}", shown(),
                                       largest_number));
        value = 0;
        break;
    }
    take();
    return true;
}

bool SyntaxParser::parse_constant_or_variable() {
    const Word word = word_of(token_);
    const std::string_view text = text_of(token_);
    if ((at(TokenKind::word) || at(TokenKind::quoted)) && !text.empty()) {
        add_node(ExprKind::variable, 0, word);
    } else if (at(TokenKind::integer) && (text == "0" || text == "1")) {
        add_node(ExprKind::constant, text == "1" ? 1 : 0, word);
    } else if (at(TokenKind::integer)) {
        return fail(fmt::format(
            "the number {} is no condition: the variable of a step 5 is X5, and counters are "
            "compared in brackets, as in [c = 5]",
            shown()));
    } else {
        return fail(fmt::format("expected a condition, got {}", shown()));
    }
    take();
    return true;
}

void SyntaxParser::add_node(ExprKind kind, std::uint32_t value, const Word& word) {
    ExpressionNode node;
    node.kind = kind;
    node.inside_time = time_depth_ > 0;
    node.value = value;
    node.word = word;
    syntax_.expression_nodes.push_back(node);
}

}  // namespace grafwire
