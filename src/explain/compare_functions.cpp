// What a step should be made of, and what it is made of.
//
// The gates give one function F of X and the other variables: what X becomes. It sets where
// F = 1 with X = 0, and resets where F = 0 with X = 1. The equation gives another, CAX + /CDX.X.
// Where the two agree nothing is wrong, however it is wired; a latch that blocks its reset while it
// is being set has another CDX by its gates, but the same function. So what the netlist has for
// CDX is only determined where CAX is 0 (the rest is don't-care when it is written as a sum of
// products), and likewise CAX where CDX is 1. If they differ only where both are 1, it is a matter
// of priority. AUdur, forcing and enclosing act outside the memory; where they do, CAX and CDX are
// don't-care as well.
//
// An example: step 1 should have CAX1 = X0.a and CDX1 = X2, and its gates make
//
//     F = X0.a + X1./X3              set where X0.a, reset where X3 and not X0.a
//
// So CAX is right. Of CDX only what is there without CAX is known, between X3./(X0.a) and
// X3 + X0.a; the shortest sum in that interval is X3. The report says: in the netlist CDX1 = X3; it
// has no X2, it should not have X3.

#include "explain/compare_functions.h"

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

using Fault = Explanation::Fault;
using EquationPair = Explanation::EquationPair;

/// A sum that takes more is not written.
constexpr std::size_t most_products = 24;

/// What the gates depend on, in the order in which the walk met it.
void add_leaves(const Cone& cone, FunctionVariables& variables) {
    for (const NetId net : cone.leaf_order) variables.add(cone.leaves.at(net));
}

/// Which gates they are, for a fault that can only be told by its place.
void note_gates(const Cone& cone, FunctionComparison& comparison) {
    comparison.gates = cone.inner;
    for (const NetId net : cone.leaf_order) {
        comparison.reads.push_back(cone.leaves.at(net).name);
    }
}

/// Whether what the equations and the gates speak of can be brought together: not where the gates
/// look at a memory that the GRAFCET has no name for, or where they make something that the
/// equations name (an edge, say) out of their own delays, which no function shows.
bool is_readable(const FunctionVariables& variables, const std::optional<TruthTable>& got,
                 const Cone& cone, std::size_t from_equations) {
    if (!got) return false;
    bool lacks_some = false;
    for (std::size_t v = 0; v < from_equations; ++v) {
        lacks_some |= variables[v].is_made && variables[v].net == no_net;
    }
    return std::none_of(cone.leaf_order.begin(), cone.leaf_order.end(), [&](NetId net) {
        const FunctionVariable& leaf = cone.leaves.at(net);
        const bool is_used = got->depends_on(*variables.find(leaf.name));
        return is_used ? leaf.is_own : lacks_some;
    });
}

/// Whether gates of the style handshake are among them. These wait for gates of their neighbours,
/// and say more than CAX and CDX do.
bool is_of_handshake(const NetReader& reader, const Cone& cone) {
    return std::any_of(cone.inner.begin(), cone.inner.end(),
                       [&](NetId net) { return reader.netlist().names[net].ends_with("$give"); });
}

/// The right-hand side as it should be.
struct Wanted {
    std::string name;  ///< `CAX4`
    std::string text;
    const TruthTable& table;
};

/// The right-hand sides of two functions that are the same, with their operands.
EquationPair same_pair(const Wanted& wanted, const FunctionVariables& variables) {
    EquationPair pair{wanted.name, wanted.text, {}, true, {}, {}, {}};
    for (std::size_t v = 0; v < variables.size(); ++v) {
        if (wanted.table.depends_on(v)) {
            pair.operands.push_back({variables[v].name, Logic::unknown});
        }
    }
    return pair;
}

/// The right-hand sides of two functions that differ, and what one has that the other has not. The
/// netlist's is known to lie in an interval. `factor`: what is to be written before it, or empty.
EquationPair different_pair(const Wanted& wanted, const TruthTable& lower, const TruthTable& upper,
                            const FunctionVariables& variables, const std::string& factor) {
    EquationPair pair{wanted.name, wanted.text, {}, false, {}, {}, {}};
    const auto sum = irredundant_sum(lower, upper, variables.size(), most_products);
    std::uint32_t in_sum = 0;
    for (const Product& product : sum.value_or(std::vector<Product>())) {
        in_sum |= product.plain | product.negated;
    }
    for (std::size_t v = 0; v < variables.size(); ++v) {
        const bool in_wanted = wanted.table.depends_on(v);
        const bool in_got = (in_sum >> v & 1U) != 0;
        if (in_wanted || in_got) pair.operands.push_back({variables[v].name, Logic::unknown});
        if (!sum || in_wanted == in_got || variables[v].name == factor) continue;
        (in_wanted ? pair.missing : pair.extra).push_back(variables[v].name);
    }
    if (!sum) return pair;
    pair.got = sum_text(*sum, variables);
    if (factor.empty() || pair.got == "0") return pair;
    const std::string_view open = sum->size() > 1 ? ".(" : ".";
    const std::string_view close = sum->size() > 1 ? ")" : "";
    pair.got = pair.got == "1" ? factor : fmt::format("{}{}{}{}", factor, open, pair.got, close);
    return pair;
}

/// One step. The variables of the two sides come first: those of the equations, then what only the
/// gates read; then the functions over them, and the faults between the functions.
class StepComparison {
  public:
    StepComparison(const NetReader& reader, const Equations& equations, StepId step)
        : reader_(reader),
          grafcet_(reader.grafcet()),
          equations_(equations),
          pool_(equations.expressions),
          step_(step),
          name_(grafcet_.steps[step].name),
          own_(operand_name(grafcet_, {VariableKind::step, static_cast<std::uint32_t>(step)})),
          is_clocked_(reader.netlist().is_clocked()),
          table_(table_conditions(equations, step, pool_)),
          whole_(step_expression(equations, step, pool_)) {}

    FunctionComparison make() {
        const NetId net = reader_.ports().steps[index_of(step_)];
        Cone cone;
        if (net != no_net) cone = reader_.cone_of(net, true);
        note_gates(cone, result_);
        FunctionVariables& variables = result_.variables;
        variables.add({own_, net, false, false, false});
        for (const ExprId id : {table_.cax, table_.cdx, whole_}) {
            add_variables(grafcet_, pool_, id, is_clocked_, variables);
        }
        const std::size_t from_equations = variables.size();
        take_own_loop(cone);
        add_leaves(cone, variables);
        reader_.locate(variables);
        result_.expected = function_of(grafcet_, pool_, whole_, is_clocked_, variables);
        if (result_.expected && net != no_net) result_.got = reader_.function(cone, variables);
        if (is_of_handshake(reader_, cone) ||
            !is_readable(variables, result_.got, cone, from_equations)) {
            result_.got.reset();
            result_.fault = Fault::unread;
            add_plain("CAX", table_.cax);
            add_plain("CDX", table_.cdx);
            return std::move(result_);
        }
        compare();
        return std::move(result_);
    }

  private:
    /// A memory that is cut elsewhere than at the X, where it is the only one: its value is the X.
    void take_own_loop(Cone& cone) const {
        const bool has_own =
            std::any_of(cone.leaves.begin(), cone.leaves.end(),
                        [&](const auto& leaf) { return leaf.second.name == own_; });
        if (has_own || cone.loops.size() != 1) return;
        FunctionVariables alone;
        add_leaves(cone, alone);
        FunctionVariable& loop = cone.leaves.at(cone.loops[0]);
        if (alone.size() > TruthTable::most_variables) return;
        const TruthTable function = reader_.function(cone, alone);
        const std::size_t index = *alone.find(loop.name);
        // It holds 1 at 1, or it is the complement.
        const bool is_inverted =
            !(function.with(index, false) & ~function.with(index, true)).is(false);
        loop = {own_, loop.net, is_inverted, false, false};
    }

    /// An equation beside which nothing of the netlist can be put.
    void add_plain(std::string_view role, ExprId id) {
        EquationPair pair;
        pair.name = std::string(role) + name_;
        pair.expected = write_expression(grafcet_, pool_, id);
        FunctionVariables operands;
        add_variables(grafcet_, pool_, id, is_clocked_, operands);
        for (std::size_t v = 0; v < operands.size(); ++v) {
            pair.operands.push_back({operands[v].name, Logic::unknown});
        }
        result_.equations.push_back(std::move(pair));
    }

    /// Sorts the rows of the truth tables: where the gates are wrong, whether anything outside CAX
    /// and CDX acts there, and which of the two is to blame.
    void compare() {
        const FunctionVariables& variables = result_.variables;
        const TruthTable& got = *result_.got;
        const TruthTable& expected = *result_.expected;
        const TruthTable cax = *function_of(grafcet_, pool_, table_.cax, is_clocked_, variables);
        const TruthTable cdx = *function_of(grafcet_, pool_, table_.cdx, is_clocked_, variables);
        result_.cax = cax;
        result_.cdx = cdx;
        const TruthTable care = ~acts_outside();
        const TruthTable wrong = got ^ expected;
        const TruthTable set = got.with(0, false);
        const TruthTable reset = ~got.with(0, true);
        const TruthTable both = cax & cdx;
        // Whether X becomes 0 wherever both are 1.
        const bool reset_wins = (got & care & both).is(false);
        if (!wrong.is(false)) {
            result_.fault = (wrong & care).is(false)                         ? Fault::order
                            : (wrong & care & ~both).is(false) && reset_wins ? Fault::priority
                                                                             : Fault::equation;
        }
        const bool is_equation = result_.fault == Fault::equation;
        const TruthTable should_set = cax.with(0, false);
        const TruthTable should_reset = cdx.with(0, true);
        const TruthTable wrong_set = (set ^ should_set) & care;
        const TruthTable wrong_reset = (reset ^ should_reset) & care & ~should_set;
        // Of CAX only that part is certain in which CDX is 0, unless nothing else is wrong.
        const bool has_certain = !(wrong_set & ~should_reset).is(false) || !wrong_reset.is(false);
        // Gates that remember nothing have one function for both.
        const bool has_memory = !(set ^ ~reset).is(false);
        const TruthTable open_set = has_certain && has_memory ? reset | ~care : ~care;
        const TruthTable open_reset = has_memory ? set | ~care : ~care;
        const bool same_set =
            !is_equation || (has_certain ? wrong_set & ~should_reset : wrong_set).is(false);
        const bool same_reset = !is_equation || wrong_reset.is(false);
        const std::string factor = cdx.depends_on(0) ? own_ : std::string();
        const Wanted wanted_cax{"CAX" + name_, write_expression(grafcet_, pool_, table_.cax),
                                should_set};
        const Wanted wanted_cdx{"CDX" + name_, write_expression(grafcet_, pool_, table_.cdx),
                                should_reset};
        add(same_set ? same_pair(wanted_cax, variables)
                     : different_pair(wanted_cax, set & care, set | open_set, variables, {}));
        add(same_reset
                ? same_pair(wanted_cdx, variables)
                : different_pair(wanted_cdx, reset & care, reset | open_reset, variables, factor));
        if (result_.fault == Fault::order) {
            add(different_pair({own_, write_expression(grafcet_, pool_, whole_), expected}, got,
                               got, variables, {}));
        }
    }
    /// Where AUdur, orders or the enclosing step act on X past CAX and CDX.
    TruthTable acts_outside() const {
        const FunctionVariables& variables = result_.variables;
        const StepEquation& parts = equations_.steps[step_];
        TruthTable acts(variables.size(), false);
        for (const ExprId part : {parts.forced_off, parts.forced_on, parts.link}) {
            if (part != no_expr)
                acts |= *function_of(grafcet_, pool_, part, is_clocked_, variables);
        }
        if (parts.enclosing != no_expr) {
            acts |= ~*function_of(grafcet_, pool_, parts.enclosing, is_clocked_, variables);
        }
        const auto au_dur = variables.find("AUdur");
        if (equations_.options.modes && au_dur) {
            acts |= TruthTable::variable(variables.size(), *au_dur);
        }
        return acts;
    }
    void add(EquationPair pair) { result_.equations.push_back(std::move(pair)); }

    const NetReader& reader_;
    const Grafcet& grafcet_;
    const Equations& equations_;
    Expressions pool_;  ///< the equations' and what is built of them here
    StepId step_;
    std::string name_;
    std::string own_;  ///< its X
    bool is_clocked_;
    TableConditions table_;
    ExprId whole_;
    FunctionComparison result_;
};

}  // namespace

Logic value_of(const FunctionVariable& variable, const std::vector<Logic>& nets) {
    if (variable.net == no_net) return Logic::unknown;
    const Logic value = nets[index_of(variable.net)];
    if (!variable.is_inverted || value == Logic::unknown) return value;
    return value == Logic::one ? Logic::zero : Logic::one;
}

std::optional<std::size_t> row_of(const FunctionVariables& variables,
                                  const std::vector<const TruthTable*>& tables,
                                  const std::vector<Logic>& nets) {
    std::size_t row = 0;
    for (std::size_t v = 0; v < variables.size(); ++v) {
        const Logic value = value_of(variables[v], nets);
        if (value == Logic::one) row |= std::size_t{1} << v;
        if (value != Logic::unknown) continue;
        for (const TruthTable* table : tables) {
            if (table->depends_on(v)) return std::nullopt;
        }
    }
    return row;
}

FunctionComparison compare_step(const NetReader& reader, const Equations& equations, StepId step) {
    return StepComparison(reader, equations, step).make();
}

FunctionComparison compare_output(const NetReader& reader, const Equations& equations,
                                  OutputId output) {
    FunctionComparison result;
    const NetId net = reader.ports().outputs[index_of(output)];
    if (net == no_net) return result;
    const Grafcet& grafcet = reader.grafcet();
    const Expressions& pool = equations.expressions;
    const bool is_stored = grafcet.outputs[output].stored;
    const Cone cone = reader.cone_of(net, is_stored);
    note_gates(cone, result);
    const auto equation = std::find_if(equations.outputs.begin(), equations.outputs.end(),
                                       [&](const OutputEquation& e) { return e.output == output; });
    if (is_stored || equation == equations.outputs.end()) {
        add_leaves(cone, result.variables);
        result.fault = Fault::unread;
        return result;
    }
    const bool is_clocked = reader.netlist().is_clocked();
    add_variables(grafcet, pool, equation->value, is_clocked, result.variables);
    const std::size_t from_equations = result.variables.size();
    add_leaves(cone, result.variables);
    reader.locate(result.variables);
    result.expected = function_of(grafcet, pool, equation->value, is_clocked, result.variables);
    if (result.expected) result.got = reader.function(cone, result.variables);
    const bool can_compare = is_readable(result.variables, result.got, cone, from_equations);
    const std::string text = write_expression(grafcet, pool, equation->value);
    const std::string& name = grafcet.outputs[output].name;
    if (!can_compare) {
        result.got.reset();
        result.fault = Fault::unread;
        EquationPair pair;
        pair.name = name;
        pair.expected = text;
        for (std::size_t v = 0; v < from_equations; ++v) {
            pair.operands.push_back({result.variables[v].name, Logic::unknown});
        }
        result.equations.push_back(std::move(pair));
        return result;
    }
    const bool is_same = *result.got == *result.expected;
    if (!is_same) result.fault = Fault::equation;
    const Wanted wanted{name, text, *result.expected};
    result.equations.push_back(
        is_same ? same_pair(wanted, result.variables)
                : different_pair(wanted, *result.got, *result.got, result.variables, {}));
    return result;
}

}  // namespace grafwire
