// Expressions as a teacher writes them on a sheet: names without quotes, `·`, overlines, relations
// as signs. A line over a term that holds a line itself would have to be drawn at the right height
// and length by every viewer; so the inner complement keeps its line, and the outer one is written
// with `/` and parentheses: `/(a + b̅)`.

#include "draw/paper_notation.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "grafcet/expression_rank.h"

namespace grafwire {

namespace {

std::string_view sign_of(Relation relation) {
    switch (relation) {
        case Relation::not_equal:
            return "≠";
        case Relation::less_equal:
            return "≤";
        case Relation::greater_equal:
            return "≥";
        case Relation::equal:
        case Relation::less:
        case Relation::greater:
            return text_of(relation);
    }
    return "";
}

/// Terms and the signs between them. A line may end behind a sign.
struct Piece {
    TextRun run;
    bool may_end_line = false;
};

/// Recursive: expressions are nested a few hundred levels deep at most.
class PaperWriter {
  public:
    PaperWriter(const Grafcet& grafcet, NotSign sign) : grafcet_(grafcet), sign_(sign) {}

    std::vector<Piece> take() { return std::move(pieces_); }

    /// A condition of its own: 1 is underlined, so that nobody takes it for the name of something.
    void write_condition(ExprId id) {
        const Expressions& expressions = grafcet_.expressions;
        if (expressions.kind(id) == ExprKind::constant && expressions.constant_value(id)) {
            pieces_.push_back({{"1", TextRun::Rule::under}, false});
        } else {
            write(id, 0);
        }
    }

    void write_sum(const Sum& sum) {
        bool is_first = true;
        for (const SumTerm& term : sum) {
            if (is_first) {
                add(term.negative ? "−" : "");
            } else {
                add(term.negative ? " − " : " + ");
            }
            is_first = false;
            add(term.counter == SumTerm::no_counter ? std::to_string(term.value)
                                                    : grafcet_.counters.items()[term.counter].name);
        }
    }

  private:
    void add(std::string_view text) {
        if (!text.empty()) {
            pieces_.push_back(
                {{std::string(text), over_ ? TextRun::Rule::over : TextRun::Rule::plain}, false});
        }
    }

    void write(ExprId id, int depth) {
        const Expressions& expressions = grafcet_.expressions;
        switch (expressions.kind(id)) {
            case ExprKind::constant:
                return add(expressions.constant_value(id) ? "1" : "0");
            case ExprKind::variable:
                return add(variable_name(grafcet_, expressions.variable_of(id)));
            case ExprKind::negation:
                return write_negation(expressions.operands(id)[0], depth);
            case ExprKind::rise:
                return write_prefix("↑", expressions.operands(id)[0], depth);
            case ExprKind::fall:
                return write_prefix("↓", expressions.operands(id)[0], depth);
            case ExprKind::time_condition:
                return write_time(expressions.time_condition_of(id), depth);
            case ExprKind::comparison:
                return write_comparison(expressions.comparison_of(id));
            case ExprKind::conjunction:
                return write_chain(id, "·", depth);
            case ExprKind::exclusive_or:
                return write_chain(id, " ⊕ ", depth);
            case ExprKind::disjunction:
                return write_chain(id, " + ", depth);
        }
    }

    void write_in_parentheses(ExprId id, int depth) {
        add("(");
        write(id, depth + 1);
        add(")");
    }

    void write_prefix(std::string_view sign, ExprId operand, int depth) {
        add(sign);
        if (rank_of(grafcet_.expressions.kind(operand)) == Rank::unary) {
            write(operand, depth + 1);
        } else {
            write_in_parentheses(operand, depth);
        }
    }

    void write_negation(ExprId operand, int depth) {
        if (sign_ == NotSign::slash || over_ || holds_negation(operand)) {
            return write_prefix("/", operand, depth);
        }
        const std::size_t first = pieces_.size();
        over_ = true;
        write(operand, depth + 1);
        over_ = false;
        join(first);
    }

    /// One run, so that the line over it is one as well, and no line ends within.
    void join(std::size_t first) {
        for (std::size_t i = first + 1; i < pieces_.size(); ++i) {
            pieces_[first].run.text += pieces_[i].run.text;
        }
        pieces_[first].may_end_line = false;
        pieces_.resize(first + 1);
    }

    bool holds_negation(ExprId id) const {
        const Expressions& expressions = grafcet_.expressions;
        if (expressions.kind(id) == ExprKind::negation) return true;
        if (expressions.kind(id) == ExprKind::time_condition) {
            return holds_negation(expressions.time_condition_of(id).operand);
        }
        for (const ExprId operand : expressions.operands(id)) {
            if (holds_negation(operand)) return true;
        }
        return false;
    }

    void write_chain(ExprId id, std::string_view sign, int depth) {
        const Rank rank = rank_of(grafcet_.expressions.kind(id));
        bool is_first = true;
        for (const ExprId operand : grafcet_.expressions.operands(id)) {
            if (!is_first) {
                add(sign);
                pieces_.back().may_end_line = depth == 0 || (depth == 1 && rank == Rank::product);
            }
            if (rank_of(grafcet_.expressions.kind(operand)) <= rank) {
                write_in_parentheses(operand, depth);
            } else {
                write(operand, depth + 1);
            }
            is_first = false;
        }
    }

    void write_time(const TimeCondition& time, int depth) {
        add(format_duration(time.on_delay) + "/");
        const ExprKind kind = grafcet_.expressions.kind(time.operand);
        if (rank_of(kind) != Rank::unary || kind == ExprKind::time_condition) {
            write_in_parentheses(time.operand, depth);
        } else {
            write(time.operand, depth + 1);
        }
        if (time.off_delay != 0) add("/" + format_duration(time.off_delay));
    }

    void write_comparison(const Comparison& comparison) {
        add("[");
        write_sum(comparison.left);
        add(fmt::format(" {} ", sign_of(comparison.relation)));
        write_sum(comparison.right);
        add("]");
    }

    const Grafcet& grafcet_;
    NotSign sign_;
    bool over_ = false;  ///< within an overline
    std::vector<Piece> pieces_;
};

/// Runs of one style become one.
void append_run(Text& text, const TextRun& run) {
    if (!text.empty() && text.back().rule == run.rule && run.rule == TextRun::Rule::plain) {
        text.back().text += run.text;
    } else {
        text.push_back(run);
    }
}

Text joined(const std::vector<Piece>& pieces) {
    Text text;
    for (const Piece& piece : pieces) append_run(text, piece.run);
    return text;
}

}  // namespace

std::vector<Text> condition_on_paper(const Grafcet& grafcet, ExprId id, NotSign sign,
                                     double width) {
    PaperWriter writer(grafcet, sign);
    writer.write_condition(id);
    const std::vector<Piece> pieces = writer.take();
    std::vector<Text> lines(1);
    for (std::size_t first = 0; first < pieces.size();) {
        // What stands together up to the next place where a line may end.
        Text term;
        std::size_t next = first;
        do append_run(term, pieces[next].run);
        while (!pieces[next++].may_end_line && next < pieces.size());
        if (!lines.back().empty() && width_of(lines.back()) + width_of(term) > width) {
            lines.emplace_back();
        }
        for (const TextRun& run : term) append_run(lines.back(), run);
        first = next;
    }
    return lines;
}

Text condition_on_paper(const Grafcet& grafcet, ExprId id, NotSign sign) {
    PaperWriter writer(grafcet, sign);
    writer.write_condition(id);
    return joined(writer.take());
}

Text write_on_paper(const Grafcet& grafcet, const Write& write, NotSign sign) {
    Text text = plain_text(variable_name(grafcet, write.target) + " := ");
    if (write.operation == WriteOperation::set) {
        append_run(text, {"1"});
    } else if (write.operation == WriteOperation::reset) {
        append_run(text, {"0"});
    } else if (write.sum != none) {
        PaperWriter writer(grafcet, sign);
        writer.write_sum(grafcet.sums[write.sum]);
        for (const Piece& piece : writer.take()) append_run(text, piece.run);
    } else {
        for (const TextRun& run : condition_on_paper(grafcet, write.value, sign)) {
            append_run(text, {run.text,
                              run.rule == TextRun::Rule::under ? TextRun::Rule::plain : run.rule});
        }
    }
    return text;
}

std::string order_on_paper(const Grafcet& grafcet, const Order& order) {
    std::string situation;
    switch (order.kind) {
        case OrderKind::empty:
            break;
        case OrderKind::freeze:
            situation = "*";
            break;
        case OrderKind::initial:
            situation = "INIT";
            break;
        case OrderKind::listed:
            for (const StepId step : order.steps) {
                if (!situation.empty()) situation += ',';
                situation += grafcet.steps[step].name;
            }
            break;
    }
    return fmt::format("{}{{{}}}", grafcet.graphs[order.graph].name, situation);
}

}  // namespace grafwire
