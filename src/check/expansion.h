#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "check/exploration.h"
#include "check/partial_inputs.h"
#include "check/path.h"
#include "check/reference_case.h"
#include "check/running_delays.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "simulate/simulator.h"
#include "text/keep_going.h"

namespace grafwire {

/// A state of the reference together with the settled state of the netlist that came with it: at
/// the end of an instant, or of a scan.
struct ProductState {
    EvolutionState reference;
    SimulatorState netlist;
    PartialInputs inputs;
    RunningDelays delays;
    /// Everything that decides how the pair goes on, except what remains of its delays.
    std::string encoding;
};

/// An instant or scan after a product state, under inputs that both sides have looked at.
struct ExpandedCase {
    const RunningDelays::Ending& ending;
    const ReferenceOutcome& expected;
    PathStep step;
    /// What the netlist does; empty where the reference is not stable, and no netlist was run.
    NetlistOutcomes outcomes;
};

/// The two halves of a case, by an unassigned input that a netlist turns out to react to. Where one
/// input changes at a time, it has the same value before, if the assumptions let it.
std::vector<PathStep> halves_of(const Assumptions& assumptions, const PathStep& step,
                                const UnknownCause& cause, bool is_one_at_a_time);

/// The cases that leave a product state. It holds nothing from one state to the next, so several of
/// them, each with a netlist of its own, can work side by side.
class Expander {
  public:
    /// `grafcet` must outlive it.
    Expander(const Grafcet& grafcet, std::shared_ptr<ExploredNetlist> netlist,
             const ExplorationPlan& plan, KeepGoing keep_going);

    using Visit = std::function<bool(ExpandedCase&&)>;
    /// Gives every case of the next instant or scan, in an order that depends on the state alone
    /// (nullptr: before power-up), until `visit` says no. False where it was broken off before.
    bool expand(const ProductState* source, const Visit& visit);

    // The same in two parts.

    using VisitExpected =
        std::function<bool(const RunningDelays::Ending& ending, const ReferenceOutcome& expected)>;
    /// What the reference does in the cases, which takes little time.
    bool for_each_expected(const ProductState* source, const VisitExpected& visit);
    /// What the netlist does in one of those: the cases into which it is split.
    bool compare(const ProductState* source, const RunningDelays::Ending& ending,
                 const ReferenceOutcome& expected, const Visit& visit);

  private:
    struct Edge {
        const ProductState* source;
        const RunningDelays::Ending& ending;
    };

    bool is_one_at_a_time() const;
    bool explore_edge(const Edge& edge, const PartialInputs& inputs, const VisitExpected& visit);
    ReferenceOutcome run_reference(const Edge& edge, const PartialInputs& inputs) const;
    std::optional<PathStep> step_to(const Edge& edge, const PartialInputs& inputs) const;

    const Grafcet& grafcet_;
    std::shared_ptr<ExploredNetlist> netlist_;
    ExplorationPlan plan_;
    Evolution evolution_;
    ReferenceCases reference_;
    Assumptions assumptions_;
    bool is_broken_off_ = false;
};

}  // namespace grafwire
