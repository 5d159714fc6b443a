#pragma once

#include <string>
#include <string_view>

#include "grafcet/lexer.h"
#include "grafcet/name_table.h"
#include "grafcet/syntax.h"
#include "text/diagnostics.h"

namespace grafwire {

/// Parses by recursive descent with one token of look-ahead. A method that meets an error reports
/// it and returns false; its caller resynchronises at the next step, transition, declaration or
/// graph, so that one file gives all its errors. Expressions are limited to `deepest_nesting`
/// levels, which bounds the recursion here and in everything that later walks an expression.
class SyntaxParser {
  public:
    static constexpr int deepest_nesting = 500;
    static constexpr std::int64_t largest_number = 1'000'000'000'000;
    static constexpr std::uint32_t longest_sum = 1'000'000;

    SyntaxParser(std::string_view source, Diagnostics& diagnostics);

    Syntax parse_file();
    /// One expression and nothing after it; it becomes the one assumption.
    Syntax parse_lone_expression();

  private:
    // The file (parse_syntax.cpp).
    void reserve();
    void parse_header();
    void parse_item();
    bool parse_declaration();
    bool parse_counter();
    bool parse_bound(std::int64_t& value);
    bool parse_assumption();
    void recover_in_file();

    // Blocks (parse_block.cpp).
    void parse_block();
    void parse_block_item();
    bool parse_step();
    bool parse_macro();
    bool parse_enclosure(NodeSyntax& node);
    bool parse_entry_or_exit();
    bool parse_transition();
    bool parse_transition_names(Range<>& names, bool is_preceding);
    bool parse_receptivity(TransitionSyntax& transition);
    bool parse_actions(Range<>& actions);
    bool parse_action(ActionSyntax& action);
    bool parse_stored(ActionSyntax& action, const Word* target);
    bool parse_order(ActionSyntax& action);
    bool parse_write(WriteSyntax& write, const Word* target);
    std::uint32_t begin_node(NodeKind kind, const Word& name);
    bool looks_like_transition() const;
    void recover_in_block();
    void report_missing_brace(const BlockSyntax& block);

    // Expressions (parse_expression.cpp).
    bool parse_expression(ExpressionSyntax& expression);
    bool parse_chain(int level);
    bool parse_unary();
    bool parse_prefixed(ExprKind kind);
    bool parse_called(ExprKind kind);
    bool parse_parenthesised();
    bool parse_time_condition();
    bool parse_delay(Time& delay);
    bool parse_comparison();
    bool parse_sum(Range<>& sum);
    bool parse_term(bool negative);
    bool parse_number(std::int64_t& value);
    bool parse_constant_or_variable();
    void add_node(ExprKind kind, std::uint32_t value, const Word& word);

    // Tokens and names (parse_syntax.cpp).
    bool at(TokenKind kind) const { return token_.kind == kind; }
    bool at_name() const {
        return at(TokenKind::word) || at(TokenKind::integer) || at(TokenKind::quoted);
    }
    bool at_declaration() const;
    bool at_file_item() const;
    bool at_block_item() const;
    void take() { token_ = lexer_.next(&diagnostics_); }
    bool take_if(TokenKind kind);
    bool expect(TokenKind kind, std::string_view expected);
    bool parse_name(Word& name, std::string_view what, bool may_be_integer);
    bool parse_names(Range<>& names, std::string_view what, bool may_be_integer);
    bool parse_more_names(Range<>& names, std::string_view what, bool may_be_integer);
    Word word_of(const Token& token) const { return {token.offset, token.length, token.where}; }
    std::string_view text_of(const Token& token) const {
        return source_.substr(token.offset, token.length);
    }
    std::string shown() const;
    bool fail(std::string message);

    std::string_view source_;
    Diagnostics& diagnostics_;
    Lexer lexer_;
    Token token_;
    Syntax syntax_;
    /// Tells a sum from a Boolean expression after `:=`.
    NameTable<VariableKind> declared_;
    std::uint32_t open_brace_line_ = 0;  ///< of the `{` of an order or enclosure being read, or 0
    int nesting_ = 0;
    int time_depth_ = 0;
};

}  // namespace grafwire
