#pragma once

#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafcet/expression.h"
#include "grafcet/grafcet.h"
#include "text/diagnostics.h"
#include "text/source.h"

namespace grafwire {

struct Draft;  // what has been added so far

// What a reader of charts says of an expression: the variables are names, which GrafcetBuilder
// looks up once the whole chart is known.

/// A name and where it stands. The text is copied by the call of GrafcetBuilder that takes it.
struct Name {
    std::string_view text;
    Location where;
};

/// A term of a sum: a counter, or a whole number.
struct NamedTerm {
    bool negative = false;
    std::optional<Name> counter;
    std::int64_t number = 0;  ///< without a counter
    Location where = {};      ///< of a number
};
using NamedSum = std::vector<NamedTerm>;

/// A delay of a time condition: a duration, or the name of one.
struct Delay {
    Delay(Time duration = 0) : time(duration) {}
    Delay(Name of_duration) : name(of_duration) {}

    Time time = 0;
    std::optional<Name> name;
};

/// A Boolean expression in postfix order, the order in which a parser finishes its parts: operands
/// stand before their operator. `a . /b` is made by
///
///     expression.variable({"a"}).variable({"b"}).join(ExprKind::negation, 1)
///               .join(ExprKind::conjunction, 2);
class NamedExpression {
  public:
    NamedExpression& constant(bool value, Location where = {}) {
        return add({ExprKind::constant, value ? 1U : 0U, {{}, where}}, 0);
    }
    NamedExpression& variable(Name name) { return add({ExprKind::variable, 0, name}, 0); }
    NamedExpression& comparison(NamedSum left, Relation relation, NamedSum right,
                                Location where = {}) {
        comparisons_.push_back({std::move(left), relation, std::move(right)});
        const auto place = static_cast<std::uint32_t>(comparisons_.size() - 1);
        return add({ExprKind::comparison, place, {{}, where}}, 0);
    }
    /// Makes one expression of the last ones: a negation or an edge of one, a conjunction,
    /// disjunction or exclusive or of two or more.
    NamedExpression& join(ExprKind kind, std::uint32_t operands, Location where = {}) {
        assert(kind == ExprKind::negation || kind == ExprKind::rise || kind == ExprKind::fall
                   ? operands == 1
                   : operands >= 2);
        return add({kind, operands, {{}, where}}, operands);
    }
    /// `on_delay/operand/off_delay` of the last expression.
    NamedExpression& time_condition(Delay on_delay, Delay off_delay, Location where = {}) {
        times_.push_back({on_delay, off_delay});
        const auto place = static_cast<std::uint32_t>(times_.size() - 1);
        return add({ExprKind::time_condition, place, {{}, where}}, 1);
    }

    /// Without anything: there is no expression.
    bool is_empty() const { return nodes_.empty(); }
    /// Whether everything has been joined into one expression.
    bool is_whole() const { return open_ == 1; }
    void clear() {
        nodes_.clear();
        times_.clear();
        comparisons_.clear();
        open_ = 0;
    }

    struct Node {
        ExprKind kind = ExprKind::constant;
        /// Of a constant its value; of a time condition or a comparison its place in times() or
        /// comparisons(); of the other operators the number of operands.
        std::uint32_t value = 0;
        Name name;  ///< of a variable; else only the place
    };
    struct NamedTimeCondition {
        Delay on_delay;
        Delay off_delay;
    };
    struct NamedComparison {
        NamedSum left;
        Relation relation = Relation::equal;
        NamedSum right;
    };
    const std::vector<Node>& nodes() const { return nodes_; }
    const std::vector<NamedTimeCondition>& times() const { return times_; }
    const std::vector<NamedComparison>& comparisons() const { return comparisons_; }

  private:
    NamedExpression& add(Node node, std::size_t operands) {
        assert(open_ >= operands);
        open_ -= operands;
        ++open_;
        nodes_.push_back(node);
        return *this;
    }

    std::vector<Node> nodes_;
    std::vector<NamedTimeCondition> times_;
    std::vector<NamedComparison> comparisons_;
    std::size_t open_ = 0;  ///< expressions that nothing has joined yet
};

/// What a stored action writes: `set m`, `reset m`, `m := a . b`, `c := c + 1`.
struct NamedWrite {
    WriteOperation operation = WriteOperation::set;
    Name target;
    NamedExpression value;  ///< of an assignment to an output or var
    NamedSum sum;           ///< of an assignment to a counter
    Location where;
};

/// A transition. Each side names steps and macro-steps of its own block.
struct NamedTransition {
    std::optional<Name> label;
    std::vector<Name> preceding;
    std::vector<Name> following;
    NamedExpression condition;
    std::vector<NamedWrite> writes;  ///< run when it is cleared
    Location where;
};

/// The one way to make a Grafcet. A reader of any notation says what stands in the chart, part by
/// part and by name; names may be used before they are declared. finish() then looks up all names,
/// checks every rule of the language and gives the model, or says all that is wrong, each message
/// with the place that the reader gave.
///
/// What a reader could not make sense of, and has reported itself, it leaves out: an empty name, a
/// transition without a condition. That is no error of its own then.
///
/// The order of steps and transitions of a block is that in which they are added; of blocks and
/// declarations, too.
class GrafcetBuilder {
  public:
    /// Errors and warnings go to `diagnostics`, and so do those of the reader.
    explicit GrafcetBuilder(Diagnostics& diagnostics);
    GrafcetBuilder(const GrafcetBuilder&) = delete;
    GrafcetBuilder& operator=(const GrafcetBuilder&) = delete;
    ~GrafcetBuilder();

    /// Makes room for so many transitions and about as many steps.
    void reserve(std::size_t transitions);

    void set_name(std::string_view name, std::string_view title = {});

    void add_input(Name name);
    void add_output(Name name);
    void add_var(Name name);
    /// Holds low..high inclusive.
    void add_counter(Name name, std::int64_t low, std::int64_t high);
    void add_assumption(const NamedExpression& expression, Location where);
    /// A name for a condition: whoever reads it reads the condition.
    void add_definition(Name name, const NamedExpression& condition);
    /// A name for a duration, which stands in time conditions.
    void add_time(Name name, Time duration);

    BlockId add_graph(Name name);
    BlockId add_expansion(Name name);

    /// A step, as the builder numbers them: in the order added.
    enum class StepKey : std::uint32_t {};
    StepKey add_step(BlockId block, Name name, bool initial = false);
    StepKey add_entry(BlockId expansion, Name name);
    StepKey add_exit(BlockId expansion, Name name);
    void add_macro(BlockId block, Name name, std::optional<Name> expansion);

    /// On an output, or on a var, which it holds. `where` is the place of the whole action,
    /// `condition` empty for one without a condition.
    void add_continuous(StepKey step, Name output, const NamedExpression& condition,
                        Location where);
    /// `event` belongs to the trigger of that name.
    void add_stored(StepKey step, const NamedWrite& write, Trigger trigger,
                    const NamedExpression& event = {});
    /// A forcing order, or freezing; `steps` are those of OrderKind::listed.
    void add_order(StepKey step, Name graph, OrderKind kind, std::span<const Name> steps,
                   Location where);
    /// The step encloses a graph; `links` are activated with it.
    void add_enclosure(StepKey step, Name graph, std::span<const Name> links);

    void add_transition(BlockId block, const NamedTransition& transition);

    /// The chart, if nothing has been reported since the builder was made. Messages are put in the
    /// order of their places. The builder is empty afterwards.
    std::optional<Grafcet> finish();

  private:
    StepKey add_node(BlockId block, Name name, StepRole role, bool initial);

    Diagnostics& diagnostics_;
    std::size_t errors_before_;
    std::unique_ptr<Draft> draft_;
};

/// The first invariant of the model (grafcet.h) that a chart does not keep, in words; empty where
/// it keeps them all. finish() gives no chart with a fault.
std::string fault_of(const Grafcet& grafcet);

/// Adds an assumption, which is over inputs and control inputs, to a chart. What is wrong with it
/// goes to `diagnostics`; while these hold errors nothing is added.
void add_assumption(Grafcet& grafcet, const NamedExpression& expression, Location where,
                    Diagnostics& diagnostics);

}  // namespace grafwire
