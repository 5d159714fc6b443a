// Receptivities are found in the text by their tokens: from behind the colon of their transition up
// to `do` or the next part. What is added goes behind them, so that names and comments stay.

#include "grafcet/add_conditions.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "grafcet/chart_parser.h"
#include "grafcet/lexer.h"

namespace grafwire {

namespace {

/// Of a receptivity in the text, the bytes from its beginning to its end.
struct WrittenCondition {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool is_one_token = false;
};

std::size_t begin_of(const Token& token) {
    return token.offset - (token.kind == TokenKind::quoted ? 1U : 0U);
}
std::size_t end_of(const Token& token) {
    return token.offset + token.length + (token.kind == TokenKind::quoted ? 1U : 0U);
}

WrittenCondition find_condition(const std::vector<ReadToken>& tokens, Location transition) {
    auto token = std::find_if(tokens.begin(), tokens.end(), [&](const ReadToken& item) {
        const Location where = item.token.where;
        return where.line == transition.line && where.column == transition.column;
    });
    const auto is_colon = [](const ReadToken& item) {
        return item.token.kind == TokenKind::colon || item.token.kind == TokenKind::assign;
    };
    token = std::find_if(token, tokens.end(), is_colon);
    assert(token != tokens.end());
    ++token;
    if (token->token.kind == TokenKind::equal) ++token;
    const auto end = std::find_if(token, tokens.end(), [](const ReadToken& item) {
        return item.begins_part || item.token.kind == TokenKind::kw_do;
    });
    return {begin_of(token->token), end_of((end - 1)->token), end - token == 1};
}

bool is_true(const Expressions& pool, ExprId id) {
    return pool.kind(id) == ExprKind::constant && pool.constant_value(id);
}

bool is_sum(const Expressions& pool, ExprId id) {
    return pool.kind(id) == ExprKind::disjunction || pool.kind(id) == ExprKind::exclusive_or;
}

/// What a receptivity becomes. A 1 that says nothing beside other conditions goes.
std::string extended(std::string written, bool is_one_token, const Expressions& pool, ExprId id,
                     const std::vector<const AddedCondition*>& added) {
    const bool goes = is_one_token && is_true(pool, id);
    if (!is_one_token && is_sum(pool, id)) written = "(" + written + ")";
    if (goes && added.size() == 1) return added[0]->text;
    std::string text = goes ? std::string() : std::move(written);
    for (const AddedCondition* condition : added) {
        if (!text.empty()) text += " . ";
        text += condition->is_product_term ? condition->text : "(" + condition->text + ")";
    }
    return text;
}

}  // namespace

std::string with_added_conditions(const SourceFile& source, const Grafcet& grafcet,
                                  const std::vector<AddedCondition>& conditions) {
    std::vector<ReadToken> tokens;
    Diagnostics said_before;
    parse_keeping_tokens(source, tokens, said_before);
    struct Change {
        WrittenCondition place;
        std::string text;
    };
    std::vector<Change> changes;
    for (std::size_t i = 0; i < grafcet.transitions.size(); ++i) {
        const TransitionId id = grafcet.transitions.id_at(i);
        std::vector<const AddedCondition*> added;
        for (const AddedCondition& condition : conditions) {
            if (condition.transition == id) added.push_back(&condition);
        }
        if (added.empty()) continue;
        const Transition& transition = grafcet.transitions[id];
        const WrittenCondition place = find_condition(tokens, transition.where);
        changes.push_back({place, extended(source.text.substr(place.begin, place.end - place.begin),
                                           place.is_one_token, grafcet.expressions,
                                           transition.condition, added)});
    }
    std::sort(changes.begin(), changes.end(),
              [](const Change& a, const Change& b) { return a.place.begin > b.place.begin; });
    std::string text = source.text;
    for (const Change& change : changes) {
        text.replace(change.place.begin, change.place.end - change.place.begin, change.text);
    }
    return text;
}

}  // namespace grafwire
