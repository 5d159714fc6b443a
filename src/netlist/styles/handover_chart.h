#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "netlist/styles/handshake_facts.h"
#include "text/diagnostics.h"

namespace grafwire {

/// A step of the wired chart: one of the GRAFCET, a part of one, or a hidden one between two.
enum class WiredStepId : std::uint32_t {};
/// A transition of the wired chart.
enum class LinkId : std::uint32_t {};

/// What a receptivity of the wired chart reads.
struct WiredLiteral {
    enum class Kind : std::uint8_t { input, step, time, stored };
    Kind kind = Kind::input;
    std::uint32_t index = 0;  ///< of the input (controls included), the wired step, the equation in
                              ///< Equations::stored; the ExprId of a time condition
    bool negated = false;
    auto operator<=>(const WiredLiteral&) const = default;
};

/// AND of the literals; 1 where there is none.
using WiredProduct = std::vector<WiredLiteral>;

struct WiredStep {
    StepId home{};            ///< the step itself; of a hidden one a step beside it
    TransitionId via = none;  ///< the transition that a hidden one stands on
    std::string role;         ///< of a hidden one or a part: names its net, `T3$via`, `X7$armed`
    bool starts = false;      ///< active while Init is 1
    bool outlasts_au_dur = false;  ///< AUdur does to it what Init does
    /// What a hidden one writes before it is left: numbers in Equations::stored, and values.
    std::vector<std::pair<std::uint32_t, bool>> writes;
    std::vector<LinkId> into;
    std::vector<LinkId> out_of;

    bool is_hidden() const { return via != none; }
};

/// One step to one, one to several, several to one, or one to none.
struct Link {
    TransitionId transition{};
    std::string role;  ///< beside the transition itself: names its gates, `T3$via$fire`
    std::vector<WiredStepId> preceding;
    std::vector<WiredStepId> following;
    std::vector<WiredProduct> products;
    /// A time condition on the activity of preceding[timed_step] that every product holds: `timer`
    /// is its ExprId.
    std::uint32_t timed_step = none;
    ExprId timer = no_expr;
    bool is_hidden = false;  ///< the second half of a hand-over, which no freezing order stops
    /// The follower may be active already: the step before it is a hidden one, left either way.
    bool is_merge = false;
};

/// A forcing order as it is obeyed.
struct WiredForcing {
    WiredStepId step{};
    GraphId graph{};
    std::vector<WiredStepId> on;
    std::vector<WiredStepId> off;  ///< all others of the graph, hidden ones included
    /// The step may be left as soon as it is entered, and has to wait until all is done.
    bool has_completion = true;
};

/// The chart as the handshake style wires it, with hidden steps where a transition would otherwise
/// have none of the shapes for which there are gates.
struct HandoverChart {
    Table<WiredStepId, WiredStep> steps;  ///< those of the GRAFCET first, in table order
    Table<LinkId, Link> links;
    /// Per step of the GRAFCET the wired steps of which one is active while it is.
    Table<StepId, std::vector<WiredStepId>> parts;
    std::vector<WiredForcing> forcings;
    /// Of the time conditions that receptivities read: what they are conditions of.
    std::map<ExprId, WiredProduct> conditions;
};

/// The wired chart of one that nothing has been reported of. What turns out only now that it cannot
/// be wired is reported, and the chart is of no use then.
HandoverChart handover_chart(const HandshakeFacts& facts, Diagnostics& diagnostics);

}  // namespace grafwire
