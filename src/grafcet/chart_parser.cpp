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

void ChartParser::parse_file() {
    reserve();
    recognise();
    begin_part();
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
    recognise();
    begin_part();
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
    } else if (at(TokenKind::slash)) {
        is_good = fail(say::remark_begins_otherwise());
        take();
    } else if (at_block_item()) {
        is_good = fail(say::stands_inside_graph(reserved_word(token().kind)));
        take();
    } else if (at(TokenKind::left_parenthesis)) {
        is_good = refuse_parenthesis();
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
    if (at(TokenKind::kw_define)) return parse_define();
    if (at(TokenKind::kw_time)) return parse_time();
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
        declare_variable(read);
    } while (take_if(TokenKind::comma));
    if (at_name() && !token().first_on_line) {
        return fail_expecting(say::comma_between_names());
    }
    return true;
}

/// A declared name that is also the word for an operator is read as the name.
void ChartParser::declare_variable(const Name& read) {
    declare(read);
    const TokenKind keyword = keyword_in_context(read.text);
    if (keyword == TokenKind::kw_and || keyword == TokenKind::kw_or ||
        keyword == TokenKind::kw_not || keyword == TokenKind::kw_xor) {
        diagnostics().warning(code::name_is_operator, read.where,
                              say::word_is_operator(quoted(read.text), reserved_word(keyword)));
    }
}

/// `define ready = v0 . h0`
bool ChartParser::parse_define() {
    take();
    Name read;
    if (!parse_name(read, say::name_of_condition, false)) return false;
    declare_variable(read);
    expression_.clear();
    const bool is_good =
        expect(TokenKind::equal, say::equal_and_condition) && parse_expression(*this, expression_);
    builder_.add_definition(read, expression_);
    return is_good;
}

/// `time T3 = 300ms`
bool ChartParser::parse_time() {
    take();
    Name read;
    if (!parse_name(read, say::name_of_duration, false)) return false;
    declare(read, true);
    std::optional<Time> value;
    bool is_good = expect(TokenKind::equal, say::equal_and_duration);
    if (is_good) is_good = parse_duration_token(*this, value);
    builder_.add_time(read, value.value_or(0));
    return is_good;
}

/// `counter n : 0..9`
bool ChartParser::parse_counter() {
    take();
    Name read;
    if (!parse_name(read, say::a_counter, false)) return false;
    is_counter_.add(read.text, true);
    declare_variable(read);
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
    while (!at(TokenKind::end)) {
        if (token().first_on_line) recognise();
        if (at_file_item()) return;
        take();
    }
}

/// At the beginning of a part: reads a word as a keyword where it may be one and no name may stand.
/// A name begins a transition, in which a comma or an arrow follows; after a keyword comes a name,
/// after `assume` a condition.
void ChartParser::recognise() {
    if (!at(TokenKind::word)) return;
    const TokenKind keyword = this->keyword();
    Lexer lexer = ahead();
    const TokenKind next = keyword == TokenKind::end ? TokenKind::end : lexer.next(nullptr).kind;
    const bool has_name = is_name(next) || next == TokenKind::digits_and_letters;
    bool is_keyword = has_name;
    switch (keyword) {
        case TokenKind::kw_assume:
            is_keyword = next != TokenKind::comma && next != TokenKind::arrow;
            break;
        case TokenKind::kw_initial:
            is_keyword = has_name || next == TokenKind::kw_step;
            break;
        case TokenKind::kw_grafcet:
        case TokenKind::kw_input:
        case TokenKind::kw_output:
        case TokenKind::kw_var:
        case TokenKind::kw_counter:
        case TokenKind::kw_define:
        case TokenKind::kw_time:
        case TokenKind::kw_graph:
        case TokenKind::kw_expansion:
        case TokenKind::kw_step:
        case TokenKind::kw_macro:
        case TokenKind::kw_entry:
        case TokenKind::kw_exit:
            break;
        default:
            return;
    }
    if (is_keyword) read_as(keyword);
}

bool ChartParser::at_declaration() const {
    return at(TokenKind::kw_input) || at(TokenKind::kw_output) || at(TokenKind::kw_var) ||
           at(TokenKind::kw_counter) || at(TokenKind::kw_assume) || at(TokenKind::kw_define) ||
           at(TokenKind::kw_time);
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
        while (!at(TokenKind::end) && !at(TokenKind::left_brace)) {
            if (token().first_on_line) recognise();
            if (at_file_item() || at_block_item()) break;
            take();
        }
        take_if(TokenKind::left_brace);
    }
    has_blocks_ = true;
    const BlockId id = is_expansion ? builder_.add_expansion(read) : builder_.add_graph(read);
    while (!at(TokenKind::end) && !at(TokenKind::right_brace)) {
        recognise();
        if (at(TokenKind::kw_graph) || at(TokenKind::kw_expansion) || at(TokenKind::kw_grafcet)) {
            break;
        }
        parse_block_item({id, is_expansion});
    }
    begin_part();
    if (take_if(TokenKind::right_brace) || !has_header) return;
    const auto& end = is_expansion ? say::end_of_expansion : say::end_of_graph;
    diagnostics()
        .error(code::unexpected_token, token().where, end(quoted(read.text), shown()))
        .notes.push_back({read.where, say::begins_here()});
}

/// A step, a macro-step or a transition, which is what begins with a name or an arrow.
void ChartParser::parse_block_item(OpenBlock block) {
    begin_part();
    open_brace_line_ = 0;
    bool is_good = true;
    if (at(TokenKind::kw_step) || at(TokenKind::kw_initial)) {
        is_good = parse_step(block.id);
    } else if (at(TokenKind::kw_macro)) {
        is_good = parse_macro(block.id);
    } else if (at(TokenKind::kw_entry) || at(TokenKind::kw_exit)) {
        is_good = parse_entry_or_exit(block);
    } else if (at(TokenKind::left_parenthesis) && !token().first_on_line &&
               previous_kind() != TokenKind::left_brace &&
               previous_kind() != TokenKind::right_brace) {
        is_good = refuse_parenthesis();
    } else if (at_name() || at(TokenKind::left_parenthesis) || at(TokenKind::arrow)) {
        is_good = parse_transition(block.id);
    } else if (at_declaration()) {
        fail(say::declaration_in_graph(reserved_word(token().kind)));
        is_good = parse_declaration();
    } else {
        is_good = at(TokenKind::slash) ? fail(say::remark_begins_otherwise())
                                       : fail_expecting(say::step_or_transition());
        take();
    }
    if (!is_good) recover_in_block();
}

/// A parenthesis behind a complete part. What stands in it is left out, so that the next part is
/// read as it is written.
bool ChartParser::refuse_parenthesis() {
    fail(say::parenthesis_out_of_place());
    int depth = 0;
    do {
        if (at(TokenKind::left_parenthesis)) ++depth;
        if (at(TokenKind::right_parenthesis)) --depth;
        take();
    } while (depth > 0 && !at(TokenKind::end) && !token().first_on_line);
    return true;
}

/// Skips to what may begin the next part of the block: a reserved word, a transition, or at least a
/// line that begins like one and does not continue the line before. A `}` closes the braces of an
/// order that were being read, if it stands on their line.
void ChartParser::recover_in_block() {
    bool is_continued = true;
    while (!at(TokenKind::end)) {
        if (token().first_on_line) recognise();
        if (at_file_item() || at_block_item()) return;
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

/// `step 5 encloses G3{60} : H if a, set m`. The step is known to the builder once its name is
/// read.
bool ChartParser::parse_step(BlockId block) {
    bool is_initial = take_if(TokenKind::kw_initial);
    if (!take_keyword(TokenKind::kw_step) && !is_initial) return false;
    if (at(TokenKind::word) && keyword() == TokenKind::kw_initial) {  // `étape initiale 0`
        Lexer lexer = ahead();
        if (is_name(lexer.next(nullptr).kind)) is_initial = take_keyword(TokenKind::kw_initial);
    }
    Name read;
    if (!parse_name(read, say::name_of_step, true)) return false;
    const GrafcetBuilder::StepKey step = builder_.add_step(block, read, is_initial);
    std::optional<NamedEnclosure> enclosure;
    bool is_good = true;
    while (is_good && (at(TokenKind::kw_encloses) || keyword() == TokenKind::kw_encloses)) {
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
    take_keyword(TokenKind::kw_encloses);
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
    } else if (!take_if(TokenKind::assign)) {
        const bool is_elsewhere = token().first_on_line || at(TokenKind::end);
        return fail_at(is_elsewhere ? previous_end() : token().where,
                       say::expected(say::comma_or_condition(), shown()));
    }
    if (!parse_expression(*this, transition.condition)) return false;
    if (!take_keyword(TokenKind::kw_do)) return true;
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
    if (at(TokenKind::left_bracket)) return fail(say::action_in_brackets());
    const bool is_integer = at(TokenKind::integer);
    Name read;
    if (!parse_name(read, say::an_action, true)) return false;
    if (refuse_action(read)) return false;
    if (at(TokenKind::left_brace)) return parse_order(step, read);
    if (is_integer) {
        diagnostics().error(code::unexpected_token, where,
                            say::number_as_action(quoted(read.text)));
        return false;
    }
    if (at(TokenKind::assign)) return parse_stored(step, &read);
    expression_.clear();
    if (take_keyword(TokenKind::kw_if) && !parse_expression(*this, expression_)) return false;
    builder_.add_continuous(step, read, expression_, where);
    return true;
}

/// Actions as other notations write them, behind their first name: `F/G1:{1}`, `V = 1`, `S V`.
/// False where it is none of these.
bool ChartParser::refuse_action(const Name& read) {
    if (at(TokenKind::equal)) {
        fail(say::action_with_value(read.text));
        return true;
    }
    if (at(TokenKind::slash) && (read.text == "F" || read.text == "f")) {
        take();
        fail_at(read.where, say::order_written(at_name() ? name().text : "G1"));
        return true;
    }
    const bool is_set = read.text == "S" || read.text == "s";
    const bool is_reset = read.text == "R" || read.text == "r";
    if ((is_set || is_reset) && at_name() && !token().first_on_line &&
        keyword() == TokenKind::end) {
        fail_at(read.where, say::qualifier_written(is_set ? "set" : "reset", name().text));
        return true;
    }
    return false;
}

/// `target` is the name before `:=` if it has been read already.
bool ChartParser::parse_stored(GrafcetBuilder::StepKey step, const Name* target) {
    NamedWrite write;
    if (!parse_write(write, target)) return false;
    Trigger trigger = Trigger::activation;
    expression_.clear();
    if (take_keyword(TokenKind::kw_on) && !take_keyword(TokenKind::kw_activation)) {
        trigger = take_keyword(TokenKind::kw_deactivation) ? Trigger::deactivation : Trigger::event;
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
