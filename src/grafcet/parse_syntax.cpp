#include <fmt/format.h>

#include <algorithm>

#include "grafcet/syntax_parser.h"
#include "text/utf8.h"

namespace grafwire {

SyntaxParser::SyntaxParser(std::string_view source, Diagnostics& diagnostics)
    : source_(source), diagnostics_(diagnostics), lexer_(source) {
    syntax_.source = source;
    take();
}

Syntax SyntaxParser::parse_file() {
    reserve();
    if (at(TokenKind::kw_grafcet)) parse_header();
    while (!at(TokenKind::end)) parse_item();
    return std::move(syntax_);
}

Syntax SyntaxParser::parse_lone_expression() {
    ExpressionSyntax expression;
    if (parse_expression(expression)) {
        if (at(TokenKind::end))
            syntax_.assumptions.push_back(expression);
        else
            fail(fmt::format("expected an operator or the end of the expression, got {}", shown()));
    }
    return std::move(syntax_);
}

// Makes room for a chart with a transition per arrow and about as many steps, so that lists of
// millions need not be moved as they grow. Room that stays empty is never touched and costs no
// memory; the share of the length bounds it for files that are no GRAFCET.
void SyntaxParser::reserve() {
    constexpr std::size_t shortest_transition = 8;
    std::size_t arrows = 0;
    for (std::size_t at = source_.find('>'); at != source_.npos; at = source_.find('>', at + 1))
        ++arrows;
    arrows = std::min(arrows, source_.size() / shortest_transition);
    syntax_.nodes.reserve(arrows);
    syntax_.transitions.reserve(arrows);
    syntax_.words.reserve(2 * arrows);
    syntax_.expression_nodes.reserve(2 * arrows);
}

void SyntaxParser::parse_header() {
    take();
    if (!parse_name(syntax_.name, "the name of the GRAFCET", false)) return recover_in_file();
    syntax_.has_name = true;
    if (!at(TokenKind::quoted)) return;
    syntax_.title = word_of(token_);
    take();
}

void SyntaxParser::parse_item() {
    if (at(TokenKind::kw_graph) || at(TokenKind::kw_expansion)) return parse_block();
    bool is_good = true;
    if (at_declaration()) {
        if (!syntax_.blocks.empty())
            fail(fmt::format("declarations stand before the graphs; move this '{}' up",
                             reserved_word(token_.kind)));
        is_good = parse_declaration();
    } else if (at(TokenKind::kw_grafcet)) {
        is_good = fail("'grafcet' stands once, at the beginning of the file");
        take();
    } else if (at(TokenKind::right_brace)) {
        is_good = fail("this '}' closes nothing; remove it");
        take();
    } else if (at_block_item()) {
        is_good =
            fail(fmt::format("'{}' stands inside a graph or an expansion, as in "
                             "graph G1 {{ … }}",
                             reserved_word(token_.kind)));
        take();
    } else {
        is_good = fail(fmt::format("expected a declaration or a graph, got {}", shown()));
        take();
    }
    if (!is_good) recover_in_file();
}

bool SyntaxParser::parse_declaration() {
    if (at(TokenKind::kw_counter)) return parse_counter();
    if (at(TokenKind::kw_assume)) return parse_assumption();
    DeclarationSyntax declaration;
    std::string_view what = "an input";
    if (at(TokenKind::kw_output)) {
        declaration.kind = VariableKind::output;
        what = "an output";
    } else if (at(TokenKind::kw_var)) {
        declaration.kind = VariableKind::var;
        what = "a var";
    }
    take();
    do {
        if (!parse_name(declaration.name, what, false)) return false;
        syntax_.declarations.push_back(declaration);
        declared_.add(syntax_.text(declaration.name), declaration.kind);
    } while (take_if(TokenKind::comma));
    if (at_name() && !token_.first_on_line)
        return fail(fmt::format("expected ',' between the names, got {}", shown()));
    return true;
}

bool SyntaxParser::parse_counter() {
    take();
    DeclarationSyntax declaration;
    declaration.kind = VariableKind::counter;
    if (!parse_name(declaration.name, "a counter", false)) return false;
    const std::size_t index = syntax_.declarations.size();
    syntax_.declarations.push_back(declaration);
    declared_.add(syntax_.text(declaration.name), declaration.kind);
    const bool is_good =
        expect(TokenKind::colon, "':' and the range, as in counter c : 0..9") &&
        parse_bound(syntax_.declarations[index].low) &&
        expect(TokenKind::dot_dot, "'..' between the lowest and the highest value") &&
        parse_bound(syntax_.declarations[index].high);
    if (is_good && at(TokenKind::comma))
        return fail("each counter has a declaration of its own; write 'counter' again");
    return is_good;
}

bool SyntaxParser::parse_bound(std::int64_t& value) {
    const bool is_negative = take_if(TokenKind::minus);
    if (!at(TokenKind::integer))
        return fail(fmt::format("expected a number for the range of the counter, got {}", shown()));
    if (!parse_number(value)) return false;
    if (is_negative) value = -value;
    return true;
}

bool SyntaxParser::parse_assumption() {
    take();
    ExpressionSyntax expression;
    if (!parse_expression(expression)) return false;
    syntax_.assumptions.push_back(expression);
    return true;
}

void SyntaxParser::recover_in_file() {
    while (!at(TokenKind::end) && !at_file_item()) take();
}

bool SyntaxParser::at_declaration() const {
    return at(TokenKind::kw_input) || at(TokenKind::kw_output) || at(TokenKind::kw_var) ||
           at(TokenKind::kw_counter) || at(TokenKind::kw_assume);
}

bool SyntaxParser::at_file_item() const {
    return at_declaration() || at(TokenKind::kw_graph) || at(TokenKind::kw_expansion) ||
           at(TokenKind::kw_grafcet);
}

bool SyntaxParser::at_block_item() const {
    return at(TokenKind::kw_step) || at(TokenKind::kw_initial) || at(TokenKind::kw_macro) ||
           at(TokenKind::kw_entry) || at(TokenKind::kw_exit);
}

bool SyntaxParser::take_if(TokenKind kind) {
    if (!at(kind)) return false;
    take();
    return true;
}

bool SyntaxParser::expect(TokenKind kind, std::string_view expected) {
    if (take_if(kind)) return true;
    return fail(fmt::format("expected {}, got {}", expected, shown()));
}

bool SyntaxParser::parse_name(Word& name, std::string_view what, bool may_be_integer) {
    const bool is_name =
        at(TokenKind::word) || at(TokenKind::quoted) || (may_be_integer && at(TokenKind::integer));
    if (is_name && token_.length != 0) {
        name = word_of(token_);
        take();
        return true;
    }
    if (is_name) {
        fail(fmt::format("expected {}, got an empty name", what));
        take();
        return false;
    }
    const std::string_view text = text_of(token_);
    if (!reserved_word(token_.kind).empty())
        return fail(
            fmt::format("expected {}, got '{}', a reserved word; to use it as a name write \"{}\"",
                        what, text, text));
    if (at(TokenKind::integer) || at(TokenKind::duration))
        return fail(
            fmt::format("expected {}, got {}; to use it as a name put it between quotation "
                        "marks",
                        what, shown()));
    return fail(fmt::format("expected {}, got {}", what, shown()));
}

bool SyntaxParser::parse_names(Range<>& names, std::string_view what, bool may_be_integer) {
    names.first = static_cast<std::uint32_t>(syntax_.words.size());
    names.count = 0;
    return parse_more_names(names, what, may_be_integer);
}

bool SyntaxParser::parse_more_names(Range<>& names, std::string_view what, bool may_be_integer) {
    do {
        Word word;
        if (!parse_name(word, what, may_be_integer)) return false;
        syntax_.words.push_back(word);
        ++names.count;
    } while (take_if(TokenKind::comma));
    return true;
}

std::string SyntaxParser::shown() const {
    return token_in_message(source_, token_);
}

bool SyntaxParser::fail(std::string message) {
    diagnostics_.error(Code::unexpected_token, token_.where, std::move(message));
    return false;
}

}  // namespace grafwire
