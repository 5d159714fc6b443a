#include <fmt/format.h>

#include <array>

#include "grafcet/syntax_parser.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr int longest_look_ahead = 64;

std::uint32_t size_of(const auto& items) {
    return static_cast<std::uint32_t>(items.size());
}

}  // namespace

void SyntaxParser::parse_block() {
    BlockSyntax block;
    block.is_expansion = at(TokenKind::kw_expansion);
    block.nodes.first = size_of(syntax_.nodes);
    block.transitions.first = size_of(syntax_.transitions);
    const Location keyword = token_.where;
    take();
    const std::string_view what =
        block.is_expansion ? "the name of the expansion" : "the name of the graph";
    const bool has_header =
        parse_name(block.name, what, true) &&
        expect(TokenKind::left_brace, block.is_expansion ? "'{' and the steps of the expansion"
                                                         : "'{' and the steps of the graph");
    if (!has_header) {
        if (block.name.length == 0) block.name.where = keyword;
        while (!at(TokenKind::end) && !at(TokenKind::left_brace) && !at_file_item() &&
               !at_block_item())
            take();
        take_if(TokenKind::left_brace);
    }
    syntax_.blocks.push_back(block);
    while (!at(TokenKind::end) && !at(TokenKind::right_brace) && !at(TokenKind::kw_graph) &&
           !at(TokenKind::kw_expansion) && !at(TokenKind::kw_grafcet))
        parse_block_item();
    block.nodes.count = size_of(syntax_.nodes) - block.nodes.first;
    block.transitions.count = size_of(syntax_.transitions) - block.transitions.first;
    syntax_.blocks.back() = block;
    if (!take_if(TokenKind::right_brace) && has_header) report_missing_brace(block);
}

void SyntaxParser::report_missing_brace(const BlockSyntax& block) {
    Diagnostic& error =
        diagnostics_.error(Code::unexpected_token, token_.where,
                           fmt::format("expected '}}' at the end of {} {}, got {}",
                                       block.is_expansion ? "expansion" : "graph",
                                       in_quotes(syntax_.text(block.name)), shown()));
    error.notes.push_back({block.name.where, "it begins here"});
}

void SyntaxParser::parse_block_item() {
    open_brace_line_ = 0;
    bool is_good = true;
    if (at(TokenKind::kw_step) || at(TokenKind::kw_initial)) {
        is_good = parse_step();
    } else if (at(TokenKind::kw_macro)) {
        is_good = parse_macro();
    } else if (at(TokenKind::kw_entry) || at(TokenKind::kw_exit)) {
        is_good = parse_entry_or_exit();
    } else if (at_name() || at(TokenKind::left_parenthesis) || at(TokenKind::arrow)) {
        is_good = parse_transition();
    } else if (at_declaration()) {
        fail(
            fmt::format("declarations stand before the graphs; move this '{}' up, or close the "
                        "graph with '}}' before it",
                        reserved_word(token_.kind)));
        is_good = parse_declaration();
    } else {
        is_good = fail(fmt::format("expected a step, a transition or '}}', got {}", shown()));
        take();
    }
    if (!is_good) recover_in_block();
}

// Skips to what may begin the next part of the block: a reserved word, a transition, or at least a
// line that begins like one and does not continue the line before. A `}` closes the braces of an
// order that were being read, if it stands on their line.
void SyntaxParser::recover_in_block() {
    bool is_continued = true;
    while (!at(TokenKind::end) && !at_file_item() && !at_block_item()) {
        if (at(TokenKind::left_brace)) {
            open_brace_line_ = token_.where.line;
        } else if (at(TokenKind::right_brace)) {
            if (open_brace_line_ != token_.where.line) return;
            open_brace_line_ = 0;
        } else if (token_.first_on_line) {
            const bool begins_item = at_name() || at(TokenKind::left_parenthesis);
            if ((begins_item && !is_continued) || looks_like_transition()) return;
        }
        is_continued = !at_name() && !at(TokenKind::right_parenthesis) &&
                       !at(TokenKind::right_brace) && !at(TokenKind::right_bracket);
        take();
    }
}

// Whether `[ (label) ] [ names ] ->` begins at the present token.
bool SyntaxParser::looks_like_transition() const {
    Lexer ahead = lexer_;
    Token token = token_;
    const auto is_name = [&token] {
        return token.kind == TokenKind::word || token.kind == TokenKind::integer ||
               token.kind == TokenKind::quoted;
    };
    if (token.kind == TokenKind::left_parenthesis) {
        token = ahead.next(nullptr);
        if (!is_name()) return false;
        token = ahead.next(nullptr);
        if (token.kind != TokenKind::right_parenthesis) return false;
        token = ahead.next(nullptr);
    }
    for (int i = 0; i < longest_look_ahead && is_name(); ++i) {
        token = ahead.next(nullptr);
        if (token.kind != TokenKind::comma) break;
        token = ahead.next(nullptr);
    }
    return token.kind == TokenKind::arrow;
}

std::uint32_t SyntaxParser::begin_node(NodeKind kind, const Word& name) {
    NodeSyntax node;
    node.kind = kind;
    node.name = name;
    node.block = size_of(syntax_.blocks) - 1;
    node.actions.first = size_of(syntax_.actions);
    syntax_.nodes.push_back(node);
    return size_of(syntax_.nodes) - 1;
}

bool SyntaxParser::parse_step() {
    const bool is_initial = take_if(TokenKind::kw_initial);
    if (!take_if(TokenKind::kw_step) && !is_initial) return false;
    Word name;
    if (!parse_name(name, "the name of the step", true)) return false;
    NodeSyntax& node = syntax_.nodes[begin_node(NodeKind::step, name)];
    node.initial = is_initial;
    while (at(TokenKind::kw_encloses))
        if (!parse_enclosure(node)) return false;
    return !take_if(TokenKind::colon) || parse_actions(node.actions);
}

bool SyntaxParser::parse_enclosure(NodeSyntax& node) {
    if (node.extra != none) {
        diagnostics_.error(
            Code::encloses_twice, token_.where,
            fmt::format("step {} encloses a graph already; a step encloses one graph at most",
                        in_quotes(syntax_.text(node.name))));
    }
    take();
    EnclosureSyntax enclosure;
    if (!parse_name(enclosure.graph, "the name of the enclosed graph", true)) return false;
    open_brace_line_ = token_.where.line;
    if (!expect(TokenKind::left_brace, "'{' and the steps to activate, as in G3{60}")) return false;
    if (at(TokenKind::right_brace))
        return fail("an enclosing step names the steps that are activated with it, as in G3{60}");
    if (!parse_names(enclosure.links, "the name of a step", true) ||
        !expect(TokenKind::right_brace, "',' or '}'"))
        return false;
    open_brace_line_ = 0;
    node.extra = size_of(syntax_.enclosures);
    syntax_.enclosures.push_back(enclosure);
    return true;
}

bool SyntaxParser::parse_macro() {
    take();
    Word name;
    if (!parse_name(name, "the name of the macro-step", true)) return false;
    const std::uint32_t index = begin_node(NodeKind::macro, name);
    if (!expect(TokenKind::equal, "'=' and the name of the expansion")) return false;
    Word expansion;
    if (!parse_name(expansion, "the name of the expansion", true)) return false;
    syntax_.nodes[index].extra = size_of(syntax_.words);
    syntax_.words.push_back(expansion);
    return true;
}

bool SyntaxParser::parse_entry_or_exit() {
    const bool is_entry = at(TokenKind::kw_entry);
    if (!syntax_.blocks.back().is_expansion) {
        diagnostics_.error(Code::expansion_entry_exit, token_.where,
                           fmt::format("'{}' stands in an expansion only; in a graph write 'step'",
                                       reserved_word(token_.kind)));
    }
    take();
    Word name;
    const std::string_view what =
        is_entry ? "the name of the entry step" : "the name of the exit step";
    if (!parse_name(name, what, true)) return false;
    NodeSyntax& node = syntax_.nodes[begin_node(is_entry ? NodeKind::entry : NodeKind::exit, name)];
    return !take_if(TokenKind::colon) || parse_actions(node.actions);
}

bool SyntaxParser::parse_transition() {
    TransitionSyntax transition;
    transition.where = token_.where;
    transition.writes.first = size_of(syntax_.writes);
    if (take_if(TokenKind::left_parenthesis)) {
        transition.labelled = true;
        if (!parse_name(transition.label, "the name of the transition", true) ||
            !expect(TokenKind::right_parenthesis, "')' after the name of the transition"))
            return false;
    }
    if (!parse_transition_names(transition.preceding, true) ||
        !parse_transition_names(transition.following, false))
        return false;
    const bool is_good = parse_receptivity(transition);
    syntax_.transitions.push_back(transition);
    return is_good;
}

bool SyntaxParser::parse_transition_names(Range<>& names, bool is_preceding) {
    names.first = size_of(syntax_.words);
    if (!is_preceding && (at(TokenKind::colon) || at(TokenKind::assign))) return true;
    if (is_preceding && take_if(TokenKind::arrow)) return true;
    const Token first = token_;
    if (!parse_names(names, "the name of a step", true)) return false;
    if (!is_preceding || take_if(TokenKind::arrow)) return true;
    std::string message = fmt::format("expected ',' or '->', got {}", shown());
    if (first.kind == TokenKind::word) {
        const std::string_view nearest = nearest_name(
            text_of(first), {"step", "initial", "macro", "entry", "exit", "graph", "expansion"});
        if (!nearest.empty())
            message += fmt::format("; did you mean '{}' instead of {}?", nearest,
                                   in_quotes(text_of(first)));
    }
    return fail(std::move(message));
}

bool SyntaxParser::parse_receptivity(TransitionSyntax& transition) {
    if (take_if(TokenKind::colon))
        take_if(TokenKind::equal);
    else if (!expect(TokenKind::assign, "',' or ':' and the transition condition"))
        return false;
    if (!parse_expression(transition.condition)) return false;
    if (!take_if(TokenKind::kw_do)) return true;
    bool is_good = true;
    do {
        WriteSyntax write;
        is_good = parse_write(write, nullptr);
        if (is_good) syntax_.writes.push_back(write);
    } while (is_good && take_if(TokenKind::comma));
    transition.writes.count = size_of(syntax_.writes) - transition.writes.first;
    return is_good;
}

bool SyntaxParser::parse_actions(Range<>& actions) {
    actions.first = size_of(syntax_.actions);
    bool is_good = true;
    do {
        ActionSyntax action;
        action.where = token_.where;
        is_good = parse_action(action);
        if (is_good) syntax_.actions.push_back(action);
    } while (is_good && take_if(TokenKind::comma));
    actions.count = size_of(syntax_.actions) - actions.first;
    return is_good;
}

bool SyntaxParser::parse_action(ActionSyntax& action) {
    if (at(TokenKind::kw_set) || at(TokenKind::kw_reset)) return parse_stored(action, nullptr);
    const bool is_integer = at(TokenKind::integer);
    if (!parse_name(action.name, "an action", true)) return false;
    if (at(TokenKind::left_brace)) return parse_order(action);
    if (is_integer) {
        diagnostics_.error(Code::unexpected_token, action.name.where,
                           fmt::format("expected an action, got {}; an output of that name is "
                                       "written between quotation marks",
                                       in_quotes(syntax_.text(action.name))));
        return false;
    }
    if (at(TokenKind::assign)) return parse_stored(action, &action.name);
    action.kind = ActionKind::continuous;
    return !take_if(TokenKind::kw_if) || parse_expression(action.expression);
}

bool SyntaxParser::parse_stored(ActionSyntax& action, const Word* target) {
    action.kind = ActionKind::stored;
    action.write = size_of(syntax_.writes);
    WriteSyntax write;
    if (!parse_write(write, target)) return false;
    write.where = action.where;
    syntax_.writes.push_back(write);
    if (!take_if(TokenKind::kw_on)) return true;
    if (take_if(TokenKind::kw_activation)) return true;
    if (take_if(TokenKind::kw_deactivation)) {
        action.trigger = Trigger::deactivation;
        return true;
    }
    action.trigger = Trigger::event;
    return parse_expression(action.expression);
}

// Reads from the `{` after the name of the graph.
bool SyntaxParser::parse_order(ActionSyntax& action) {
    action.kind = ActionKind::order;
    open_brace_line_ = token_.where.line;
    take();
    action.steps.first = size_of(syntax_.words);
    if (take_if(TokenKind::star)) {
        action.order = OrderKind::freeze;
    } else if (at(TokenKind::word) && text_of(token_) == "INIT") {
        action.order = OrderKind::initial;
        take();
    } else if (!at(TokenKind::right_brace)) {
        action.order = OrderKind::listed;
        if (!parse_names(action.steps, "the name of a step, '*', INIT or '}'", true)) return false;
    }
    if (!expect(TokenKind::right_brace, action.order == OrderKind::listed ? "',' or '}'" : "'}'"))
        return false;
    open_brace_line_ = 0;
    return true;
}

// `target` is the name before `:=` if it has been read already.
bool SyntaxParser::parse_write(WriteSyntax& write, const Word* target) {
    write.where = token_.where;
    if (target == nullptr && (at(TokenKind::kw_set) || at(TokenKind::kw_reset))) {
        write.operation = at(TokenKind::kw_set) ? WriteOperation::set : WriteOperation::reset;
        take();
        return parse_name(write.target, "the name of an output or var", false);
    }
    write.operation = WriteOperation::assign;
    if (target != nullptr)
        write.target = *target;
    else if (!parse_name(write.target, "'set', 'reset' or a name and ':='", false))
        return false;
    if (!expect(TokenKind::assign, "':=' and the value")) return false;
    const VariableKind* declared = declared_.find(syntax_.text(write.target));
    const auto is_counter = [this](std::string_view name) {
        const VariableKind* found = declared_.find(name);
        return found != nullptr && *found == VariableKind::counter;
    };
    write.is_sum = declared != nullptr ? *declared == VariableKind::counter
                                       : at(TokenKind::minus) || is_counter(text_of(token_));
    return write.is_sum ? parse_sum(write.sum) : parse_expression(write.value);
}

}  // namespace grafwire
