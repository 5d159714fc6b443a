// The text language by recursive descent with one token of look-ahead. A method that meets an error
// reports it and returns false; its caller looks for the next part. What has been read of the part
// until then is told to the builder all the same where it declares a name: a step whose actions are
// not understood can still be used by transitions.

#include "grafcet/chart_parser.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/checking.h"
#include "grafcet/messages.h"
#include "text/nearest_name.h"

namespace grafwire {

namespace say = messages::grafcet;

namespace {

/// Tokens after which a line that may be a transition is no longer looked at.
constexpr int longest_look_ahead = 64;

}  // namespace

void ChartParser::parse_file() {
    reserve();
    if (at(TokenKind::kw_grafcet)) parse_header();
    while (!at(TokenKind::end)) parse_item();
}

/// Makes room for a chart with a transition per arrow and about as many steps, so that lists of
/// millions need not be moved as they grow. Room that stays empty is never touched and costs no
/// memory; the share of the length bounds it for files that are no GRAFCET.
void ChartParser::reserve() {
    constexpr std::size_t shortest_transition = 8;
    std::size_t arrows = 0;
    for (std::size_t at = source_.find('>'); at != source_.npos; at = source_.find('>', at + 1)) {
        ++arrows;
    }
    arrows = std::min(arrows, source_.size() / shortest_transition);
    builder_.reserve(arrows);
}

void ChartParser::parse_header() {
    take();
    Name read;
    if (!parse_name(read, say::name_of_grafcet, false)) return recover_in_file();
    const bool has_title = at(TokenKind::quoted);
    builder_.set_name(read.text, has_title ? text() : std::string_view());
    if (has_title) take();
}

/// A declaration, a graph or an expansion. What belongs inside a graph, or at the beginning of the
/// file, is named as such; the reader is told where it belongs rather than what was expected here.
void ChartParser::parse_item() {
    if (at(TokenKind::kw_graph) || at(TokenKind::kw_expansion)) return parse_block();
    bool is_good = true;
    if (at_declaration()) {
        if (has_blocks_) {
            fail(say::declaration_after_graphs(reserved_word(token().kind)));
        }
        is_good = parse_declaration();
    } else if (at(TokenKind::kw_grafcet)) {
        is_good = fail(say::grafcet_not_first());
        take();
    } else if (at(TokenKind::right_brace)) {
        is_good = fail(say::brace_closes_nothing());
        take();
    } else if (at_block_item()) {
        is_good = fail(say::stands_inside_graph(reserved_word(token().kind)));
        take();
    } else {
        is_good = fail_expecting(say::declaration_or_graph());
        take();
    }
    if (!is_good) recover_in_file();
}

/// `input a, b`
bool ChartParser::parse_declaration() {
    if (at(TokenKind::kw_counter)) return parse_counter();
    if (at(TokenKind::kw_assume)) return parse_assumption();
    const bool is_output = at(TokenKind::kw_output);
    const bool is_var = at(TokenKind::kw_var);
    const Message<>& what = is_output ? say::an_output : is_var ? say::a_var : say::an_input;
    take();
    do {
        Name read;
        if (!parse_name(read, what, false)) return false;
        if (is_output) {
            builder_.add_output(read);
        } else if (is_var) {
            builder_.add_var(read);
        } else {
            builder_.add_input(read);
        }
        is_counter_.add(read.text, false);
    } while (take_if(TokenKind::comma));
    if (at_name() && !token().first_on_line) {
        return fail_expecting(say::comma_between_names());
    }
    return true;
}

/// `counter n : 0..9`
bool ChartParser::parse_counter() {
    take();
    Name read;
    if (!parse_name(read, say::a_counter, false)) return false;
    is_counter_.add(read.text, true);
    std::int64_t low = 0;
    std::int64_t high = 0;
    const bool is_good = expect(TokenKind::colon, say::colon_and_range) && parse_bound(low) &&
                         expect(TokenKind::dot_dot, say::dots_of_range) && parse_bound(high);
    builder_.add_counter(read, low, high);
    if (is_good && at(TokenKind::comma)) {
        return fail(say::one_counter_each());
    }
    return is_good;
}

bool ChartParser::parse_bound(std::int64_t& value) {
    const bool is_negative = take_if(TokenKind::minus);
    if (!at(TokenKind::integer)) {
        return fail_expecting(say::number_for_range());
    }
    if (!parse_number(value)) return false;
    if (is_negative) value = -value;
    return true;
}

/// `assume /(left . right)`
bool ChartParser::parse_assumption() {
    take();
    const Location where = token().where;
    if (!parse_expression(*this, expression_)) return false;
    builder_.add_assumption(expression_, where);
    return true;
}

void ChartParser::recover_in_file() {
    while (!at(TokenKind::end) && !at_file_item()) take();
}

bool ChartParser::at_declaration() const {
    return at(TokenKind::kw_input) || at(TokenKind::kw_output) || at(TokenKind::kw_var) ||
           at(TokenKind::kw_counter) || at(TokenKind::kw_assume);
}

bool ChartParser::at_file_item() const {
    return at_declaration() || at(TokenKind::kw_graph) || at(TokenKind::kw_expansion) ||
           at(TokenKind::kw_grafcet);
}

bool ChartParser::at_block_item() const {
    return at(TokenKind::kw_step) || at(TokenKind::kw_initial) || at(TokenKind::kw_macro) ||
           at(TokenKind::kw_entry) || at(TokenKind::kw_exit);
}

/// `graph G1 { … }`, `expansion E { … }`. A header that is wrong is passed over up to its brace,
/// and the steps and transitions in it still count.
void ChartParser::parse_block() {
    const Location keyword = token().where;
    const bool is_expansion = at(TokenKind::kw_expansion);
    take();
    Name read;
    const Message<>& what = is_expansion ? say::name_of_expansion : say::name_of_graph;
    const bool has_header =
        parse_name(read, what, true) &&
        expect(TokenKind::left_brace, is_expansion ? say::brace_of_expansion : say::brace_of_graph);
    if (!has_header) {
        if (read.text.empty()) read.where = keyword;
        while (!at(TokenKind::end) && !at(TokenKind::left_brace) && !at_file_item() &&
               !at_block_item()) {
            take();
        }
        take_if(TokenKind::left_brace);
    }
    has_blocks_ = true;
    const BlockId id = is_expansion ? builder_.add_expansion(read) : builder_.add_graph(read);
    while (!at(TokenKind::end) && !at(TokenKind::right_brace) && !at(TokenKind::kw_graph) &&
           !at(TokenKind::kw_expansion) && !at(TokenKind::kw_grafcet)) {
        parse_block_item({id, is_expansion});
    }
    if (take_if(TokenKind::right_brace) || !has_header) return;
    const auto& end = is_expansion ? say::end_of_expansion : say::end_of_graph;
    diagnostics()
        .error(code::unexpected_token, token().where, end(quoted(read.text), shown()))
        .notes.push_back({read.where, say::begins_here()});
}

/// A step, a macro-step or a transition, which is what begins with a name or an arrow.
void ChartParser::parse_block_item(OpenBlock block) {
    open_brace_line_ = 0;
    bool is_good = true;
    if (at(TokenKind::kw_step) || at(TokenKind::kw_initial)) {
        is_good = parse_step(block.id);
    } else if (at(TokenKind::kw_macro)) {
        is_good = parse_macro(block.id);
    } else if (at(TokenKind::kw_entry) || at(TokenKind::kw_exit)) {
        is_good = parse_entry_or_exit(block);
    } else if (at_name() || at(TokenKind::left_parenthesis) || at(TokenKind::arrow)) {
        is_good = parse_transition(block.id);
    } else if (at_declaration()) {
        fail(say::declaration_in_graph(reserved_word(token().kind)));
        is_good = parse_declaration();
    } else {
        is_good = fail_expecting(say::step_or_transition());
        take();
    }
    if (!is_good) recover_in_block();
}

/// Skips to what may begin the next part of the block: a reserved word, a transition, or at least a
/// line that begins like one and does not continue the line before. A `}` closes the braces of an
/// order that were being read, if it stands on their line.
void ChartParser::recover_in_block() {
    bool is_continued = true;
    while (!at(TokenKind::end) && !at_file_item() && !at_block_item()) {
        if (at(TokenKind::left_brace)) {
            open_brace_line_ = token().where.line;
        } else if (at(TokenKind::right_brace)) {
            if (open_brace_line_ != token().where.line) return;
            open_brace_line_ = 0;
        } else if (token().first_on_line) {
            const bool begins_item = at_name() || at(TokenKind::left_parenthesis);
            if ((begins_item && !is_continued) || looks_like_transition()) return;
        }
        is_continued = !at_name() && !at(TokenKind::right_parenthesis) &&
                       !at(TokenKind::right_brace) && !at(TokenKind::right_bracket);
        take();
    }
}

/// Whether `[ (label) ] [ names ] ->` begins at the present token.
bool ChartParser::looks_like_transition() const {
    Lexer lexer = ahead();
    Token next = token();
    const auto is_name = [&next] {
        return next.kind == TokenKind::word || next.kind == TokenKind::integer ||
               next.kind == TokenKind::quoted;
    };
    if (next.kind == TokenKind::left_parenthesis) {
        next = lexer.next(nullptr);
        if (!is_name()) return false;
        next = lexer.next(nullptr);
        if (next.kind != TokenKind::right_parenthesis) return false;
        next = lexer.next(nullptr);
    }
    for (int i = 0; i < longest_look_ahead && is_name(); ++i) {
        next = lexer.next(nullptr);
        if (next.kind != TokenKind::comma) break;
        next = lexer.next(nullptr);
    }
    return next.kind == TokenKind::arrow;
}

/// `step 5 encloses G3{60} : H if a, set m`. The step is known to the builder once its name is
/// read.
bool ChartParser::parse_step(BlockId block) {
    const bool is_initial = take_if(TokenKind::kw_initial);
    if (!take_if(TokenKind::kw_step) && !is_initial) return false;
    Name read;
    if (!parse_name(read, say::name_of_step, true)) return false;
    const GrafcetBuilder::StepKey step = builder_.add_step(block, read, is_initial);
    std::optional<NamedEnclosure> enclosure;
    bool is_good = true;
    while (is_good && at(TokenKind::kw_encloses)) {
        if (enclosure) {
            diagnostics().error(code::encloses_twice, token().where,
                                encloses_twice_message(read.text));
        }
        is_good = parse_enclosure(enclosure);
    }
    if (enclosure) builder_.add_enclosure(step, enclosure->graph, enclosure->links);
    return is_good && (!take_if(TokenKind::colon) || parse_actions(step));
}

/// Gives `enclosure` a value where the whole of it has been read.
bool ChartParser::parse_enclosure(std::optional<NamedEnclosure>& enclosure) {
    take();
    NamedEnclosure read;
    if (!parse_name(read.graph, say::name_of_enclosed_graph, true)) return false;
    open_brace_line_ = token().where.line;
    if (!expect(TokenKind::left_brace, say::brace_of_links)) return false;
    if (at(TokenKind::right_brace)) {
        return fail(say::enclosure_without_links());
    }
    if (!parse_names(read.links, say::name_of_a_step, true) ||
        !expect(TokenKind::right_brace, say::comma_or_brace)) {
        return false;
    }
    open_brace_line_ = 0;
    enclosure = std::move(read);
    return true;
}

/// `macro M2 = E2`. Without its expansion it still is a step that transitions may name.
bool ChartParser::parse_macro(BlockId block) {
    take();
    Name read;
    if (!parse_name(read, say::name_of_macro_step, true)) return false;
    Name expansion;
    const bool is_good = expect(TokenKind::equal, say::equal_and_expansion) &&
                         parse_name(expansion, say::name_of_expansion, true);
    builder_.add_macro(block, read, is_good ? std::optional(expansion) : std::nullopt);
    return is_good;
}

/// One that stands in a graph is read as a step, after it has been reported.
bool ChartParser::parse_entry_or_exit(OpenBlock block) {
    const bool is_entry = at(TokenKind::kw_entry);
    if (!block.is_expansion) {
        diagnostics().error(code::expansion_entry_exit, token().where,
                            outside_of_expansion_message(is_entry));
    }
    take();
    Name read;
    const Message<>& what = is_entry ? say::name_of_entry : say::name_of_exit;
    if (!parse_name(read, what, true)) return false;
    const GrafcetBuilder::StepKey step = !block.is_expansion ? builder_.add_step(block.id, read)
                                         : is_entry          ? builder_.add_entry(block.id, read)
                                                             : builder_.add_exit(block.id, read);
    return !take_if(TokenKind::colon) || parse_actions(step);
}

/// `(start) 0 -> 1, 2 : dcy`. Without a condition that can be read it is told all the same, so that
/// its steps are looked up.
bool ChartParser::parse_transition(BlockId block) {
    NamedTransition& transition = transition_;
    transition.where = token().where;
    transition.label.reset();
    transition.condition.clear();
    transition.writes.clear();
    if (take_if(TokenKind::left_parenthesis)) {
        Name label;
        if (!parse_name(label, say::name_of_transition, true) ||
            !expect(TokenKind::right_parenthesis, say::parenthesis_of_label)) {
            return false;
        }
        transition.label = label;
    }
    if (!parse_side(transition.preceding, true) || !parse_side(transition.following, false)) {
        return false;
    }
    const bool is_good = parse_condition(transition);
    builder_.add_transition(block, transition);
    return is_good;
}

/// The steps before the arrow, or behind it. A line that begins with a word and has no arrow is
/// most often a mistyped `step`.
bool ChartParser::parse_side(std::vector<Name>& names, bool is_preceding) {
    names.clear();
    if (!is_preceding && (at(TokenKind::colon) || at(TokenKind::assign))) return true;
    if (is_preceding && take_if(TokenKind::arrow)) return true;
    const TokenKind first_kind = token().kind;
    const std::string_view first = text();
    if (!parse_names(names, say::name_of_a_step, true)) return false;
    if (!is_preceding || take_if(TokenKind::arrow)) return true;
    Localized message = say::expected(say::comma_or_arrow(), shown());
    if (first_kind == TokenKind::word) {
        const std::string_view nearest = nearest_name(
            first, {"step", "initial", "macro", "entry", "exit", "graph", "expansion"});
        if (!nearest.empty()) {
            message = say::did_you_mean_instead(message, nearest, quoted(first));
        }
    }
    return fail(std::move(message));
}

/// `: a . b do set m`, also written `:= …` and `: = …`.
bool ChartParser::parse_condition(NamedTransition& transition) {
    if (take_if(TokenKind::colon)) {
        take_if(TokenKind::equal);
    } else if (!expect(TokenKind::assign, say::comma_or_condition)) {
        return false;
    }
    if (!parse_expression(*this, transition.condition)) return false;
    if (!take_if(TokenKind::kw_do)) return true;
    do {
        NamedWrite write;
        if (!parse_write(write, nullptr)) return false;
        transition.writes.push_back(std::move(write));
    } while (take_if(TokenKind::comma));
    return true;
}

bool ChartParser::parse_actions(GrafcetBuilder::StepKey step) {
    do {
        if (!parse_action(step)) return false;
    } while (take_if(TokenKind::comma));
    return true;
}

/// What follows the name tells the kind of an action: `{` an order, `:=` an assignment, else the
/// name is an output.
bool ChartParser::parse_action(GrafcetBuilder::StepKey step) {
    const Location where = token().where;
    if (at(TokenKind::kw_set) || at(TokenKind::kw_reset)) return parse_stored(step, nullptr);
    const bool is_integer = at(TokenKind::integer);
    Name read;
    if (!parse_name(read, say::an_action, true)) return false;
    if (at(TokenKind::left_brace)) return parse_order(step, read);
    if (is_integer) {
        diagnostics().error(code::unexpected_token, where,
                            say::number_as_action(quoted(read.text)));
        return false;
    }
    if (at(TokenKind::assign)) return parse_stored(step, &read);
    expression_.clear();
    if (take_if(TokenKind::kw_if) && !parse_expression(*this, expression_)) return false;
    builder_.add_continuous(step, read, expression_, where);
    return true;
}

/// `target` is the name before `:=` if it has been read already.
bool ChartParser::parse_stored(GrafcetBuilder::StepKey step, const Name* target) {
    NamedWrite write;
    if (!parse_write(write, target)) return false;
    Trigger trigger = Trigger::activation;
    expression_.clear();
    if (take_if(TokenKind::kw_on) && !take_if(TokenKind::kw_activation)) {
        trigger = take_if(TokenKind::kw_deactivation) ? Trigger::deactivation : Trigger::event;
        if (trigger == Trigger::event && !parse_expression(*this, expression_)) return false;
    }
    builder_.add_stored(step, write, trigger, expression_);
    return true;
}

/// Reads from the `{` behind the name of the graph.
bool ChartParser::parse_order(GrafcetBuilder::StepKey step, Name graph) {
    open_brace_line_ = token().where.line;
    take();
    OrderKind kind = OrderKind::empty;
    std::vector<Name> steps;
    if (take_if(TokenKind::star)) {
        kind = OrderKind::freeze;
    } else if (at(TokenKind::word) && text() == "INIT") {
        kind = OrderKind::initial;
        take();
    } else if (!at(TokenKind::right_brace)) {
        kind = OrderKind::listed;
        if (!parse_names(steps, say::situation_of_order, true)) return false;
    }
    if (!expect(TokenKind::right_brace,
                kind == OrderKind::listed ? say::comma_or_brace : say::closing_brace)) {
        return false;
    }
    open_brace_line_ = 0;
    builder_.add_order(step, graph, kind, steps, graph.where);
    return true;
}

/// `target` is the name before `:=` if it has been read already.
bool ChartParser::parse_write(NamedWrite& write, const Name* target) {
    write.where = target != nullptr ? target->where : token().where;
    if (target == nullptr && (at(TokenKind::kw_set) || at(TokenKind::kw_reset))) {
        write.operation = at(TokenKind::kw_set) ? WriteOperation::set : WriteOperation::reset;
        take();
        return parse_name(write.target, say::written_name, false);
    }
    write.operation = WriteOperation::assign;
    if (target != nullptr) {
        write.target = *target;
    } else if (!parse_name(write.target, say::set_reset_or_assign, false)) {
        return false;
    }
    if (!expect(TokenKind::assign, say::assign_and_value)) return false;
    const bool* is_counter = is_counter_.find(write.target.text);
    const auto is_of_counters = [this] {
        const bool* found = is_counter_.find(text());
        return at(TokenKind::minus) || (found != nullptr && *found);
    };
    const bool is_sum = is_counter != nullptr ? *is_counter : is_of_counters();
    return is_sum ? parse_sum(*this, write.sum) : parse_expression(*this, write.value);
}

}  // namespace grafwire
