#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grafcet/expression.h"
#include "text/source.h"
#include "text/table.h"

namespace grafwire {

// The model of a GRAFCET (IEC 60848:2013) after every name has been resolved and every rule of the
// language checked. Everything later in the pipeline starts from this value.
//
// Order. Steps stand in table order: graph by graph as written, and within a graph as written, the
// steps of an expansion in the place where its macro-step is declared. Transitions likewise graph
// by graph; those of an expansion come after those of the block its macro-step stands in. So the
// steps of a graph, and those of a macro-step, are one unbroken range.

enum class InputId : std::uint32_t {};
enum class OutputId : std::uint32_t {};
enum class VarId : std::uint32_t {};
enum class CounterId : std::uint32_t {};
enum class GraphId : std::uint32_t {};
enum class BlockId : std::uint32_t {};
enum class StepId : std::uint32_t {};
enum class MacroId : std::uint32_t {};
enum class TransitionId : std::uint32_t {};
enum class EnclosureId : std::uint32_t {};
enum class OrderId : std::uint32_t {};
enum class SumId : std::uint32_t {};

struct Input {
    std::string name;
    Location where;
};

struct Output {
    std::string name;
    bool stored = false;  ///< driven by stored actions; else by continuous ones (or by none)
    Location where;
};

/// An internal variable. Stored actions change it; or steps hold it by continuous actions, as a bit
/// that has no memory: then it is the OR of the conditions under which they are active, and
/// expressions that read it hold that value in its place.
struct Var {
    std::string name;
    Location where;
    ExprId held = no_expr;  ///< what it is where steps hold it

    bool is_held() const { return held != no_expr; }
};

/// A counter holds low..high inclusive and starts at low.
struct Counter {
    std::string name;
    std::int64_t low = 0;
    std::int64_t high = 0;
    Location where;
};

/// What the plant guarantees: never 0. Over inputs and control inputs only.
struct Assumption {
    ExprId expression = no_expr;
    Location where;
};

enum class StepRole : std::uint8_t { ordinary, entry, exit };

struct Step {
    std::string name;  ///< without the X of its variable
    GraphId graph{};
    BlockId block{};
    StepRole role = StepRole::ordinary;
    bool initial = false;
    EnclosureId enclosure = none;  ///< what the step encloses
    Range<> actions;               ///< of Grafcet::actions
    Location where;
};

struct Macro {
    std::string name;
    GraphId graph{};
    BlockId block{};      ///< the block the macro-step stands in
    BlockId expansion{};  ///< the block that expands it
    StepId entry{};
    StepId exit{};
    Range<StepId> steps;  ///< those of its expansion, nested expansions included
    Location where;
};

/// A `graph` or an `expansion` as written.
struct Block {
    /// A step or a macro-step of the block.
    struct Node {
        bool is_macro = false;
        std::uint32_t index = 0;
        bool operator==(const Node&) const = default;
    };
    std::string name;
    bool is_expansion = false;
    GraphId graph{};                        ///< the graph it is, or belongs to
    std::vector<Node> nodes;                ///< in the order written
    std::vector<TransitionId> transitions;  ///< in the order written
    Location where;
};

struct Graph {
    std::string name;
    BlockId block{};
    Range<StepId> steps;
    Range<TransitionId> transitions;
    EnclosureId enclosed_by = none;
};

/// `step 50 encloses G3{60}`.
struct Enclosure {
    StepId step{};
    GraphId graph{};
    std::vector<StepId> links;  ///< the activation links, in the order written
    Location where;
};

enum class WriteOperation : std::uint8_t { set, reset, assign };

/// What a stored action does to a stored output, a var or a counter.
struct Write {
    Variable target;  ///< output, var or counter
    WriteOperation operation = WriteOperation::set;
    ExprId value = no_expr;  ///< of `:=` to an output or var
    SumId sum = none;        ///< of `:=` to a counter
};

/// `held`: a continuous action on a var.
enum class ActionKind : std::uint8_t { continuous, stored, order, held };
enum class Trigger : std::uint8_t { activation, deactivation, event };

/// An action associated with a step.
struct Action {
    ActionKind kind = ActionKind::continuous;
    Trigger trigger = Trigger::activation;  ///< of a stored action
    StepId step{};
    OutputId output{};  ///< of a continuous action
    VarId var{};        ///< of an action that holds one
    ExprId expression =
        no_expr;  ///< continuous: its condition or no_expr; stored on event: the event
    Write write;  ///< of a stored action
    OrderId order = none;
    Location where;
};

enum class OrderKind : std::uint8_t { empty, freeze, initial, listed };

/// A forcing order (`G1{}`, `G1{INIT}`, `G1{10}`) or a freezing order (`G1{*}`).
struct Order {
    StepId step{};    ///< the step that gives the order
    GraphId graph{};  ///< the graph it applies to
    OrderKind kind = OrderKind::empty;
    std::vector<StepId> steps;  ///< listed: in the order written; else empty
    Location where;
};

/// A stored action on clearing of a transition.
struct ClearingAction {
    TransitionId transition{};
    Write write;
    Location where;
};

struct Transition {
    std::string name;       ///< the label, or the rank of the transition in the file
    bool labelled = false;  ///< false: the name is the rank
    GraphId graph{};
    BlockId block{};
    ExprId condition = no_expr;
    Range<> preceding;  ///< of Grafcet::links
    Range<> following;  ///< of Grafcet::links
    Range<> clearing;   ///< of Grafcet::clearing_actions
    Location where;
};

struct Grafcet {
    std::string name = "grafcet";
    std::string title;

    Table<InputId, Input> inputs;
    Table<OutputId, Output> outputs;
    Table<VarId, Var> vars;
    Table<CounterId, Counter> counters;
    std::vector<Assumption> assumptions;

    Table<GraphId, Graph> graphs;
    Table<BlockId, Block> blocks;  ///< in the order written
    Table<MacroId, Macro> macros;
    Table<StepId, Step> steps;
    Table<TransitionId, Transition> transitions;
    std::vector<StepId> links;

    std::vector<Action> actions;                   ///< in the order of their steps, then as written
    Table<OrderId, Order> orders;                  ///< in the order of their steps, then as written
    std::vector<ClearingAction> clearing_actions;  ///< in the order of the transitions
    Table<EnclosureId, Enclosure> enclosures;      ///< in the order of their steps
    Table<SumId, Sum> sums;
    Expressions expressions;

    /// The steps before a transition; those of a macro-step are replaced by its exit step.
    std::span<const StepId> preceding(const Transition& transition) const {
        return {links.data() + transition.preceding.first, transition.preceding.count};
    }
    /// The steps after a transition; those of a macro-step are replaced by its entry step.
    std::span<const StepId> following(const Transition& transition) const {
        return {links.data() + transition.following.first, transition.following.count};
    }
    std::span<const Action> actions_of(const Step& step) const {
        return {actions.data() + step.actions.first, step.actions.count};
    }
    std::span<const ClearingAction> clearing_actions_of(const Transition& transition) const {
        return {clearing_actions.data() + transition.clearing.first, transition.clearing.count};
    }
    /// The number of inputs with the control inputs, which follow the declared ones wherever inputs
    /// are numbered together (ports, stimuli, traces).
    std::size_t all_input_count() const { return inputs.size() + control_input_count; }
};

/// The name of a variable as one writes it: `a`, `Init`, `X5`, `XG1`. Never quoted.
std::string variable_name(const Grafcet& grafcet, Variable variable);

/// The name of input number `index`, declared inputs first, then Init, AUdur, AUdoux.
std::string_view input_name(const Grafcet& grafcet, std::size_t index);

/// What a chart gives a name, in the order in which a ladder diagram and a sequential function
/// chart declare it: inputs, Init, AUdur, AUdoux, outputs, steps (`X5`), vars, counters.
/// Identifiers made of these names in this order are the same everywhere.
std::vector<std::string> declared_names(const Grafcet& grafcet);

/// The enclosures with the outermost first, those of one depth in the order of the file: the order
/// in which they act.
std::vector<EnclosureId> enclosures_inwards(const Grafcet& grafcet);

/// Per graph, how deep it is in the hierarchy of forcing orders: 0 where nothing forces it, else
/// one more than the deepest of the graphs whose steps do. Freezing orders do not count. All orders
/// of a scan are read before any is obeyed (one pass, Cordier, section 5.6): a program that obeys
/// them one by one takes the deepest graphs first.
std::vector<std::size_t> forcing_depths(const Grafcet& grafcet);

/// The numbers low..high inclusive.
struct IntegerRange {
    std::int64_t low = 0;
    std::int64_t high = 0;
};
/// The smallest and the largest value that any partial sum can take on the way, the terms taken in
/// order; empty where that is beyond 64 bits. For languages whose integers are narrower.
std::optional<IntegerRange> range_of(const Grafcet& grafcet, const Sum& sum);
/// The smallest and the largest value of the whole sum; of one that range_of is not empty for.
IntegerRange value_range(const Grafcet& grafcet, const Sum& sum);

}  // namespace grafwire
