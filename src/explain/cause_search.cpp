// The known causes of a difference, looked for one by one in what happened.
//
// Each has a signature: a structure of the GRAFCET (two steps that follow each other, tokens side
// by side), what the reference cleared, and what the nets did in the last instant. They are tried
// in an order in which the more special come first, and only where all equations are right; a
// netlist with a wrong equation needs no other cause. A race of inputs is the last: it is shown by
// experiment, in that the same inputs make no difference when they change one after the other, in
// every order.
//
// A signature is not a proof: it says that the known thing happened, at a place where it can do the
// harm that is seen. That is why the order counts. A loop of two steps, for instance, may also show
// a latch whose set and reset end together; naming the loop tells more, for it stands in the chart.

#include "explain/cause_search.h"

#include <algorithm>

#include "equations/wiring_hazards.h"
#include "evolution/run.h"
#include "explain/causal_chain.h"
#include "grafcet/write_grafcet.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

using Fault = Explanation::Fault;
using WrongStep = WitnessFacts::WrongStep;

/// Two gates are let go at the same moment if nothing of them has had time to answer.
constexpr int gate_delays_apart = 2;
/// Between inputs that are tried one after the other: long for gates, short for delays.
constexpr Time one_after_another = microsecond;

bool contains(std::span<const StepId> steps, StepId step) {
    return std::find(steps.begin(), steps.end(), step) != steps.end();
}

class CauseSearch {
  public:
    explicit CauseSearch(const WitnessFacts& facts)
        : facts_(facts),
          grafcet_(facts.grafcet),
          links_(transitions_by_step(facts.grafcet)),
          hazards_(facts.cdx == CdxForm::successor ? wiring_hazards(facts.grafcet)
                                                   : std::vector<WiringHazard>()) {}

    /// The first cause whose signature is met, in the order of `searches`, for any of the steps
    /// that are wrong; nothing where an equation is to blame.
    std::optional<Cause> find() const {
        if (facts_.has_wrong_output) return std::nullopt;
        for (const WrongStep& step : facts_.steps) {
            const Fault fault = step.comparison.fault;
            if (fault == Fault::equation || fault == Fault::order) return std::nullopt;
            if (fault == Fault::priority && step.is_decided) {
                return Cause{CauseKind::reset_priority, name_of(step.step), {}, {}};
            }
        }
        if (!facts_.witness.delays.changes.empty()) {
            const bool is_of_step = !facts_.steps.empty();
            return Cause{CauseKind::gate_race,
                         is_of_step ? name_of(facts_.steps.front().step) : std::string(),
                         {},
                         {}};
        }
        using Search = std::optional<Cause> (CauseSearch::*)(const WrongStep&) const;
        constexpr Search searches[] = {&CauseSearch::step_loop, &CauseSearch::two_tokens,
                                       &CauseSearch::long_pulse, &CauseSearch::fleeting_follower,
                                       &CauseSearch::set_and_reset};
        if (!facts_.netlist.is_clocked()) {
            for (const Search search : searches) {
                for (const WrongStep& step : facts_.steps) {
                    if (auto cause = (this->*search)(step)) return cause;
                }
            }
        }
        return input_race();
    }

  private:
    std::string name_of(StepId step) const { return "X" + grafcet_.steps[step].name; }
    std::vector<std::string> names_of(std::span<const StepId> steps, StepId besides) const {
        std::vector<std::string> names;
        for (const StepId step : steps) {
            if (step != besides) names.push_back(name_of(step));
        }
        return names;
    }
    bool is_active(const std::vector<Logic>& nets, StepId step) const {
        const NetId net = facts_.reader.ports().steps[index_of(step)];
        return net != no_net && nets[index_of(net)] == Logic::one;
    }
    /// Whether some steps are 1 together at a moment of the last instant.
    bool are_together(StepId step, std::span<const StepId> others) const {
        bool found = false;
        facts_.history.replay_end(facts_.witness.stimuli.end, [&](const auto& nets, Time) {
            found |= is_active(nets, step) &&
                     std::all_of(others.begin(), others.end(),
                                 [&](StepId other) { return is_active(nets, other); });
        });
        return found;
    }
    bool are_active_in_reference(std::span<const StepId> steps) const {
        const auto are_in = [&](const BitTable& situation) {
            return std::all_of(steps.begin(), steps.end(),
                               [&](StepId step) { return situation.test(index_of(step)); });
        };
        const auto& scans = facts_.reference.scans;
        return are_in(facts_.reference.before) ||
               std::any_of(scans.begin(), scans.end(),
                           [&](const auto& scan) { return are_in(scan.situation); });
    }
    /// The first change of a step to 1 in the last instant.
    std::optional<std::size_t> rise_of(StepId step) const {
        const NetId net = facts_.reader.ports().steps[index_of(step)];
        const std::vector<NetChange>& changes = facts_.history.changes;
        for (std::size_t i = facts_.history.first_of_end; i < changes.size(); ++i) {
            if (changes[i].net == net && changes[i].value == Logic::one) return i;
        }
        return std::nullopt;
    }

    /// Two steps that follow each other, the wrong one among them: the reference clears one of the
    /// transitions between them, and both X are 1 together for a moment. In the successor form each
    /// X resets the other then.
    std::optional<Cause> step_loop(const WrongStep& wrong) const {
        for (const WiringHazard& hazard : hazards_) {
            if (hazard.kind != WiringHazard::Kind::step_loop) continue;
            const auto after = grafcet_.following(grafcet_.transitions[hazard.out]);
            if (hazard.step != wrong.step && !contains(after, wrong.step)) continue;
            const bool takes_part =
                facts_.reference.clears(hazard.out) || facts_.reference.clears(hazard.back);
            if (!takes_part || !are_together(hazard.step, after)) continue;
            return Cause{CauseKind::two_step_loop,
                         name_of(hazard.step),
                         names_of(after, hazard.out == hazard.back ? StepId{none} : hazard.step),
                         {}};
        }
        return std::nullopt;
    }

    /// It should be active, and all that follow it by a transition that is not cleared are.
    std::optional<Cause> two_tokens(const WrongStep& wrong) const {
        if (facts_.cdx != CdxForm::successor || !wrong.expected) return std::nullopt;
        for (const TransitionId out : links_.out_of_step(wrong.step)) {
            const auto after = grafcet_.following(grafcet_.transitions[out]);
            const bool is_other = !after.empty() && !contains(after, wrong.step);
            if (!is_other || facts_.reference.clears(out)) continue;
            // A token that the reference has there too.
            if (!are_active_in_reference(after) || !are_together(wrong.step, after)) continue;
            return Cause{CauseKind::two_tokens,
                         name_of(wrong.step),
                         names_of(after, wrong.step),
                         {grafcet_.transitions[out].name}};
        }
        return std::nullopt;
    }

    /// The edges in an expression, nested ones too.
    void collect_edges(ExprId id, std::vector<ExprId>& edges) const {
        const ExprKind kind = grafcet_.expressions.kind(id);
        if (kind == ExprKind::rise || kind == ExprKind::fall) edges.push_back(id);
        for (const ExprId operand : grafcet_.expressions.operands(id)) {
            collect_edges(operand, edges);
        }
    }
    /// The nets of the inputs and X that an expression reads.
    void collect_variables(ExprId id, std::vector<NetId>& nets) const {
        const Expressions& pool = grafcet_.expressions;
        if (pool.kind(id) == ExprKind::variable) {
            const Variable variable = pool.variable_of(id);
            const PortMap& ports = facts_.reader.ports();
            if (variable.kind == VariableKind::input) nets.push_back(ports.inputs[variable.index]);
            if (variable.kind == VariableKind::control) {
                nets.push_back(ports.inputs[grafcet_.inputs.size() + variable.index]);
            }
            if (variable.kind == VariableKind::step) nets.push_back(ports.steps[variable.index]);
        }
        for (const ExprId operand : pool.operands(id)) collect_variables(operand, nets);
    }

    /// The edge came, a step before the transition became active in the same instant, and then the
    /// transition was cleared after all, because of what the edge is of.
    std::optional<Cause> long_pulse(const WrongStep& wrong) const {
        const auto rise = rise_of(wrong.step);
        if (!rise) return std::nullopt;
        const auto chain = causal_chain(facts_.netlist, facts_.delays, facts_.history, {*rise});
        const auto is_in_chain = [&](NetId net) {
            return std::any_of(chain.begin(), chain.end(), [&](const CausalLink& link) {
                return facts_.history.changes[link.change].net == net;
            });
        };
        for (const TransitionId into : links_.into_step(wrong.step)) {
            if (facts_.reference.clears(into)) continue;
            std::vector<ExprId> edges;
            collect_edges(grafcet_.transitions[into].condition, edges);
            for (const ExprId edge : edges) {
                std::vector<NetId> nets;
                collect_variables(edge, nets);
                if (std::none_of(nets.begin(), nets.end(), is_in_chain)) continue;
                for (const StepId before : grafcet_.preceding(grafcet_.transitions[into])) {
                    const auto passage = activation_of(before);
                    const auto earlier = rise_of(before);
                    if (!passage || !earlier || *earlier > *rise) continue;
                    return Cause{
                        CauseKind::long_pulse,
                        name_of(before),
                        {write_expression(grafcet_, grafcet_.expressions, edge)},
                        {grafcet_.transitions[*passage].name, grafcet_.transitions[into].name}};
                }
            }
        }
        return std::nullopt;
    }
    /// A transition into a step that the reference clears.
    std::optional<TransitionId> activation_of(StepId step) const {
        for (const TransitionId into : links_.into_step(step)) {
            if (facts_.reference.clears(into)) return into;
        }
        return std::nullopt;
    }

    /// It stays active: what follows it was there only while the step was still being set.
    std::optional<Cause> fleeting_follower(const WrongStep& wrong) const {
        const FunctionComparison& functions = wrong.comparison;
        if (facts_.cdx != CdxForm::successor || wrong.expected || !functions.cax) {
            return std::nullopt;
        }
        for (const TransitionId out : links_.out_of_step(wrong.step)) {
            const auto after = grafcet_.following(grafcet_.transitions[out]);
            if (after.empty() || !facts_.reference.clears(out)) continue;
            bool was_there = false;
            bool was_alone = false;
            facts_.history.replay_end(facts_.witness.stimuli.end, [&](const auto& nets, Time) {
                const bool is_there = is_active(nets, wrong.step) &&
                                      std::all_of(after.begin(), after.end(), [&](StepId step) {
                                          return is_active(nets, step);
                                      });
                if (!is_there) return;
                const auto row = row_of(functions.variables, {&*functions.cax}, nets);
                was_there = true;
                was_alone |= !row || !functions.cax->at(*row);
            });
            if (!was_there || was_alone) continue;
            return Cause{
                CauseKind::fleeting_follower, name_of(wrong.step), names_of(after, wrong.step), {}};
        }
        return std::nullopt;
    }

    /// CAX and CDX are 1 at a moment, so that both gates of the latch are 1 (of NOR gates 0), and
    /// both 0 hardly later.
    std::optional<Cause> set_and_reset(const WrongStep& wrong) const {
        const FunctionComparison& functions = wrong.comparison;
        const NetId half = facts_.reader.ports().steps[index_of(wrong.step)];
        const NetId other = facts_.reader.other_half(wrong.step);
        if (!functions.cax || !functions.cdx || other == no_net) return std::nullopt;
        const Time longest = longest_delay();
        std::optional<Time> ended;  // the moment at which they were last no longer both 1
        bool are_both = false;
        bool are_alike = false;
        bool found = false;
        facts_.history.replay_end(facts_.witness.stimuli.end, [&](const auto& nets, Time at) {
            const auto row = row_of(functions.variables, {&*functions.cax, &*functions.cdx}, nets);
            if (!row) return;
            const bool is_set = functions.cax->at(*row);
            const bool is_reset = functions.cdx->at(*row);
            if (are_both && !(is_set && is_reset)) ended = at;
            are_both = is_set && is_reset;
            are_alike |= (are_both || ended) && nets[index_of(half)] == nets[index_of(other)];
            const bool is_let_go = ended && !is_set && !is_reset;
            found |= is_let_go && at - *ended <= gate_delays_apart * longest;
        });
        if (!found || !are_alike) return std::nullopt;
        return Cause{CauseKind::set_and_reset, name_of(wrong.step), {}, {}};
    }
    Time longest_delay() const {
        Time longest = 0;
        for (const std::vector<Time>* list : {&facts_.delays.rise, &facts_.delays.fall}) {
            for (const Time delay : *list) longest = std::max(longest, delay);
        }
        return longest;
    }

    /// Delays that end at the last instant, by the names of their conditions.
    std::vector<std::string> ended_delays() const {
        std::vector<std::string> names;
        const auto drivers = drivers_of(facts_.netlist);
        const std::vector<NetChange>& changes = facts_.history.changes;
        const auto& conditions = grafcet_.expressions.time_conditions();
        for (std::size_t i = facts_.history.first_of_end; i < changes.size(); ++i) {
            if (changes[i].at != facts_.witness.stimuli.end) break;
            const CellId driver = drivers[changes[i].net];
            if (driver == no_cell) continue;
            const Cell& cell = facts_.netlist.cells[driver];
            if (cell.type != CellType::timer) continue;
            const std::uint32_t ordinal = facts_.netlist.timings[cell.timing].ordinal;
            if (ordinal < conditions.size()) {
                names.push_back(
                    write_expression(grafcet_, grafcet_.expressions, conditions[ordinal]));
            }
        }
        return names;
    }

    using Assignments = std::vector<Stimuli::Assignment>;

    /// No difference shows where the changes of the last instant come one after the other.
    std::optional<Cause> input_race() const {
        const Stimuli& stimuli = facts_.witness.stimuli;
        const bool has_last = !stimuli.changes.empty() && stimuli.changes.back().at == stimuli.end;
        if (facts_.witness.scan_period != 0 || !has_last) return std::nullopt;
        Assignments inputs = stimuli.changes.back().assignments;
        StimuliPlayer before(stimuli, grafcet_.all_input_count());
        before.advance(stimuli.end - 1);
        std::erase_if(inputs, [&](const auto& set) {
            return (before.inputs()[set.input] != 0) == set.value;
        });
        Cause cause{CauseKind::input_race, {}, ended_delays(), {}};
        if (inputs.empty() || inputs.size() + cause.others.size() < 2) return std::nullopt;
        if (differs_in_some_order(inputs)) return std::nullopt;
        for (const auto& set : those_that_race(inputs)) {
            cause.others.emplace_back(input_name(grafcet_, set.input));
        }
        return cause;
    }
    /// All orders of a few inputs; of many, one and its reverse.
    bool differs_in_some_order(const Assignments& inputs) const {
        constexpr std::size_t most_permuted = 4;
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < inputs.size(); ++i) order.push_back(i);
        const auto next = [&] {
            if (inputs.size() <= most_permuted) {
                return std::next_permutation(order.begin(), order.end());
            }
            std::reverse(order.begin(), order.end());
            return order.front() != 0;
        };
        do {
            std::vector<Assignments> groups;
            for (const std::size_t i : order) groups.push_back({inputs[i]});
            if (differs(groups, one_after_another)) return true;
        } while (next());
        return false;
    }
    /// Leaves out one input after the other as long as the difference still shows where that one
    /// changes later or earlier than the others.
    Assignments those_that_race(Assignments together) const {
        std::vector<Assignments> before;
        std::vector<Assignments> after;
        for (std::size_t i = 0; i < together.size();) {
            Assignments others = together;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            const auto with = [&](const std::vector<Assignments>& first,
                                  const std::vector<Assignments>& last) {
                std::vector<Assignments> groups = first;
                groups.push_back(others);
                groups.insert(groups.end(), last.begin(), last.end());
                return differs(groups, 0);
            };
            std::vector<Assignments> longer_before = before;
            longer_before.push_back({together[i]});
            std::vector<Assignments> longer_after = after;
            longer_after.insert(longer_after.begin(), {together[i]});
            if (!others.empty() && with(before, longer_after)) {
                after = std::move(longer_after);
            } else if (!others.empty() && with(longer_before, after)) {
                before = std::move(longer_before);
            } else {
                ++i;
                continue;
            }
            together = std::move(others);
        }
        return together;
    }
    /// Whether the two sides part where the last changes come in these groups, the first of them so
    /// much later than they did.
    bool differs(const std::vector<Assignments>& groups, Time later) const {
        Stimuli stimuli = facts_.witness.stimuli;
        stimuli.changes.pop_back();
        stimuli.end += later;
        for (const Assignments& group : groups) {
            stimuli.changes.push_back({stimuli.end, group, {}});
            stimuli.end += one_after_another;
        }
        const RunResult expected = run_until_stable(grafcet_, stimuli);
        const SimulateResult got =
            simulate(grafcet_, facts_.netlist, facts_.delays, stimuli, SimulateOptions());
        // Where the reference does not get through, nothing is shown.
        return expected.unstable_at ||
               first_difference(grafcet_, stimuli, expected, got.trace, got.unsettled_at);
    }

    const WitnessFacts& facts_;
    const Grafcet& grafcet_;
    StepTransitions links_;
    std::vector<WiringHazard> hazards_;
};

}  // namespace

std::optional<Cause> cause_of(const WitnessFacts& facts) {
    return CauseSearch(facts).find();
}

}  // namespace grafwire
