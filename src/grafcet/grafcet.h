#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "grafcet/expression.h"
#include "text/location.h"
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

struct Input {
    std::string name;
    Location where;
};

struct Output {
    std::string name;
    bool stored = false;  ///< driven by stored actions; else by continuous ones (or by none)
    Location where;
};

struct Var {
    std::string name;
    Location where;
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

inline constexpr std::uint32_t none = 0xffffffffU;

struct Step {
    std::string name;  ///< without the X of its variable
    GraphId graph{};
    BlockId block{};
    StepRole role = StepRole::ordinary;
    bool initial = false;
    std::uint32_t enclosure = none;  ///< index into Grafcet::enclosures of what the step encloses
    std::uint32_t first_action = 0;  ///< the step's actions: a range of Grafcet::actions
    std::uint32_t action_count = 0;
    Location where;
};

struct Macro {
    std::string name;
    GraphId graph{};
    BlockId block{};      ///< the block the macro-step stands in
    BlockId expansion{};  ///< the block that expands it
    StepId entry{};
    StepId exit{};
    std::uint32_t first_step = 0;  ///< its steps, nested expansions included: a range of steps
    std::uint32_t step_count = 0;
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
    std::uint32_t first_step = 0;
    std::uint32_t step_count = 0;
    std::uint32_t first_transition = 0;
    std::uint32_t transition_count = 0;
    std::uint32_t enclosed_by = none;  ///< index into Grafcet::enclosures
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
    ExprId value = no_expr;    ///< of `:=` to an output or var
    std::uint32_t sum = none;  ///< of `:=` to a counter: index into Grafcet::sums
};

enum class ActionKind : std::uint8_t { continuous, stored, order };
enum class Trigger : std::uint8_t { activation, deactivation, event };

/// An action associated with a step.
struct Action {
    ActionKind kind = ActionKind::continuous;
    Trigger trigger = Trigger::activation;  ///< of a stored action
    StepId step{};
    OutputId output{};  ///< of a continuous action
    ExprId expression =
        no_expr;  ///< continuous: its condition or no_expr; stored on event: the event
    Write write;  ///< of a stored action
    std::uint32_t order = none;  ///< of an order: index into Grafcet::orders
    Location where;
};

enum class OrderKind : std::uint8_t { empty, freeze, initial, listed };

/// A forcing order (`G1{}`, `G1{INIT}`, `G1{10}`) or a freezing order (`G1{*}`).
struct Order {
    StepId step{};    ///< the step that gives the order
    GraphId graph{};  ///< the graph it bears on
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
    ExprId receptivity = no_expr;
    std::uint32_t first_preceding = 0;  ///< ranges of Grafcet::links
    std::uint32_t preceding_count = 0;
    std::uint32_t first_following = 0;
    std::uint32_t following_count = 0;
    std::uint32_t first_clearing = 0;  ///< a range of Grafcet::clearing_actions
    std::uint32_t clearing_count = 0;
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
    std::vector<Order> orders;                     ///< in the order of their steps, then as written
    std::vector<ClearingAction> clearing_actions;  ///< in the order of the transitions
    std::vector<Enclosure> enclosures;             ///< in the order of their steps
    std::vector<Sum> sums;
    Expressions expressions;

    /// The steps before a transition; those of a macro-step are replaced by its exit step.
    std::span<const StepId> preceding(const Transition& transition) const {
        return {links.data() + transition.first_preceding, transition.preceding_count};
    }
    /// The steps after a transition; those of a macro-step are replaced by its entry step.
    std::span<const StepId> following(const Transition& transition) const {
        return {links.data() + transition.first_following, transition.following_count};
    }
    std::span<const Action> actions_of(const Step& step) const {
        return {actions.data() + step.first_action, step.action_count};
    }
    std::span<const ClearingAction> clearing_actions_of(const Transition& transition) const {
        return {clearing_actions.data() + transition.first_clearing, transition.clearing_count};
    }
    /// The number of inputs with the control inputs, which follow the declared ones wherever inputs
    /// are numbered together (ports, stimuli, traces).
    std::size_t all_input_count() const { return inputs.size() + control_input_count; }
};

/// The name of a variable as one writes it: `a`, `Init`, `X5`, `XG1`. Never quoted.
std::string variable_name(const Grafcet& grafcet, Variable variable);

/// The name of input number `index`, declared inputs first, then Init, AUdur, AUdoux.
std::string_view input_name(const Grafcet& grafcet, std::size_t index);

}  // namespace grafwire
