// The canonical layout of a chart: declarations first, one a line, then block by block in the order
// of the model, with two blanks of indentation. Nothing of the layout of the text that was read is
// kept, so that two charts with the same model give the same text, and a difference of texts is a
// difference of charts.

#include "grafcet/write_grafcet.h"

#include <fmt/format.h>

#include <cassert>

#include "text/utf8.h"

namespace grafwire {

namespace {

constexpr std::size_t line_width = 100;

/// `{10, 20}`. A step called INIT is quoted: without quotes the word means the initial situation.
void append_steps_in_braces(std::string& out, const Grafcet& grafcet,
                            const std::vector<StepId>& steps) {
    std::string_view separator = "{";
    for (const StepId step : steps) {
        out += separator;
        const std::string& text = grafcet.steps[step].name;
        if (text == "INIT") {
            out += "\"INIT\"";
        } else {
            append_name(out, text);
        }
        separator = ", ";
    }
    out += '}';
}

/// The chart, part by part.
class GrafcetWriter {
  public:
    explicit GrafcetWriter(const Grafcet& grafcet)
        : grafcet_(grafcet), macro_of_block_(grafcet.blocks.size(), none) {
        for (std::size_t i = 0; i < grafcet.macros.size(); ++i) {
            macro_of_block_[index_of(grafcet.macros.items()[i].expansion)] =
                static_cast<std::uint32_t>(i);
        }
    }

    std::string write() {
        write_header();
        write_declarations();
        for (const Block& block : grafcet_.blocks) write_block(block);
        return std::move(out_);
    }

  private:
    void name(std::string_view text) { append_name(out_, text); }
    void variable(std::string_view text) { append_variable_name(out_, text); }
    void expression(ExprId id) { out_ += write_expression(grafcet_, grafcet_.expressions, id); }
    void separate() {
        if (!out_.empty()) out_ += '\n';
    }

    /// Without a header a chart is called `grafcet`.
    void write_header() {
        if (grafcet_.name == "grafcet" && grafcet_.title.empty()) return;
        out_ += "grafcet ";
        variable(grafcet_.name);
        if (!grafcet_.title.empty()) out_ += fmt::format(" \"{}\"", grafcet_.title);
        out_ += '\n';
    }

    void write_declarations() {
        if (grafcet_.inputs.empty() && grafcet_.outputs.empty() && grafcet_.vars.empty() &&
            grafcet_.counters.empty() && grafcet_.assumptions.empty()) {
            return;
        }
        separate();
        write_names("input", grafcet_.inputs);
        write_names("output", grafcet_.outputs);
        write_names("var", grafcet_.vars);
        for (const Counter& counter : grafcet_.counters) {
            out_ += "counter ";
            variable(counter.name);
            out_ += fmt::format(" : {}..{}\n", counter.low, counter.high);
        }
        for (const Assumption& assumption : grafcet_.assumptions) {
            out_ += "assume ";
            expression(assumption.expression);
            out_ += '\n';
        }
    }

    /// `input a, b, c`, over as many lines as it takes.
    void write_names(std::string_view keyword, const auto& items) {
        if (items.empty()) return;
        out_ += keyword;
        std::size_t width = keyword.size();
        bool is_first = true;
        for (const auto& item : items) {
            std::string text;
            append_variable_name(text, item.name);
            const std::size_t text_width = count_code_points(text) + 2;
            if (!is_first) out_ += ',';
            if (!is_first && width + text_width > line_width) {
                out_ += '\n';
                out_.append(keyword.size(), ' ');
                width = keyword.size();
            }
            out_ += ' ' + text;
            width += text_width;
            is_first = false;
        }
        out_ += '\n';
    }

    /// Steps and macro-steps, a blank line, transitions.
    void write_block(const Block& block) {
        separate();
        out_ += block.is_expansion ? "expansion " : "graph ";
        name(block.name);
        out_ += " {\n";
        for (const Block::Node& node : block.nodes) {
            out_ += "  ";
            if (node.is_macro) {
                write_macro(grafcet_.macros.items()[node.index]);
            } else {
                write_step(grafcet_.steps.items()[node.index]);
            }
            out_ += '\n';
        }
        if (!block.nodes.empty() && !block.transitions.empty()) out_ += '\n';
        for (const TransitionId transition : block.transitions) {
            out_ += "  ";
            write_transition(grafcet_.transitions[transition]);
            out_ += '\n';
        }
        out_ += "}\n";
    }

    void write_macro(const Macro& macro) {
        out_ += "macro ";
        name(macro.name);
        out_ += " = ";
        name(grafcet_.blocks[macro.expansion].name);
    }

    /// `initial 0 : H, set m on deactivation`
    void write_step(const Step& step) {
        switch (step.role) {
            case StepRole::entry:
                out_ += "entry ";
                break;
            case StepRole::exit:
                out_ += "exit ";
                break;
            case StepRole::ordinary:
                out_ += step.initial ? "initial " : "step ";
                break;
        }
        name(step.name);
        if (step.enclosure != none) {
            const Enclosure& enclosure = grafcet_.enclosures[step.enclosure];
            out_ += " encloses ";
            name(grafcet_.graphs[enclosure.graph].name);
            append_steps_in_braces(out_, grafcet_, enclosure.links);
        }
        std::string_view separator = " : ";
        for (const Action& action : grafcet_.actions_of(step)) {
            out_ += separator;
            write_action(action);
            separator = ", ";
        }
    }

    void write_action(const Action& action) {
        switch (action.kind) {
            case ActionKind::continuous:
            case ActionKind::held:
                variable(action.kind == ActionKind::held ? grafcet_.vars[action.var].name
                                                         : grafcet_.outputs[action.output].name);
                if (action.expression == no_expr) break;
                out_ += " if ";
                expression(action.expression);
                break;
            case ActionKind::order:
                out_ += write_order(grafcet_, grafcet_.orders[action.order]);
                break;
            case ActionKind::stored:
                out_ += write_write(grafcet_, action.write);
                if (action.trigger == Trigger::deactivation) out_ += " on deactivation";
                if (action.trigger != Trigger::event) break;
                out_ += " on ";
                expression(action.expression);
                break;
        }
    }

    /// `(start) 0 -> 1, 2 : dcy do n := n + 1`
    void write_transition(const Transition& transition) {
        if (transition.labelled) {
            out_ += '(';
            name(transition.name);
            out_ += ") ";
        }
        if (write_side(grafcet_.preceding(transition), transition.block, true)) out_ += ' ';
        out_ += "->";
        if (transition.following.count != 0) out_ += ' ';
        write_side(grafcet_.following(transition), transition.block, false);
        out_ += " : ";
        expression(transition.condition);
        std::string_view separator = " do ";
        for (const ClearingAction& action : grafcet_.clearing_actions_of(transition)) {
            out_ += separator;
            out_ += write_write(grafcet_, action.write);
            separator = ", ";
        }
    }

    /// A step of another block is the entry or exit of a macro-step, which is written in its place.
    bool write_side(std::span<const StepId> steps, BlockId block, bool is_preceding) {
        std::string_view separator;
        for (const StepId id : steps) {
            out_ += separator;
            const Step& step = grafcet_.steps[id];
            if (step.block == block) {
                name(step.name);
            } else {
                const std::uint32_t macro = macro_of_block_[index_of(step.block)];
                assert(macro != none);
                assert(id == (is_preceding ? grafcet_.macros.items()[macro].exit
                                           : grafcet_.macros.items()[macro].entry));
                static_cast<void>(is_preceding);
                name(grafcet_.macros.items()[macro].name);
            }
            separator = ", ";
        }
        return !steps.empty();
    }

    const Grafcet& grafcet_;
    std::vector<std::uint32_t> macro_of_block_;
    std::string out_;
};

}  // namespace

std::string write_order(const Grafcet& grafcet, const Order& order) {
    std::string text;
    append_name(text, grafcet.graphs[order.graph].name);
    switch (order.kind) {
        case OrderKind::empty:
            return text + "{}";
        case OrderKind::freeze:
            return text + "{*}";
        case OrderKind::initial:
            return text + "{INIT}";
        case OrderKind::listed:
            break;
    }
    append_steps_in_braces(text, grafcet, order.steps);
    return text;
}

std::string write_write(const Grafcet& grafcet, const Write& write) {
    std::string text;
    if (write.operation == WriteOperation::set) text += "set ";
    if (write.operation == WriteOperation::reset) text += "reset ";
    append_variable_name(text, variable_name(grafcet, write.target));
    if (write.operation != WriteOperation::assign) return text;
    text += " := ";
    if (write.sum != none) {
        append_sum(text, grafcet, grafcet.sums[write.sum]);
    } else {
        text += write_expression(grafcet, grafcet.expressions, write.value);
    }
    return text;
}

std::string write_grafcet(const Grafcet& grafcet) {
    return GrafcetWriter(grafcet).write();
}

}  // namespace grafwire
