#pragma once

#include <string>
#include <vector>

#include "netlist/styles/chart_netlist.h"
#include "netlist/styles/handover_chart.h"

namespace grafwire {

using Nets = std::vector<NetId>;

/// Appends nets to a list.
void add_nets(Nets& nets, const Nets& more);
/// Each net once, in the order in which they came.
Nets distinct(const Nets& nets);

/// The nets of a wired chart, and the lists of them that gates take in. What it refers to must
/// outlive it.
class HandoverNets {
  public:
    struct OfStep {
        NetId x = no_net;
        NetId b = no_net;  ///< its complement, the other gate of the pair
        Nets writes;       ///< one per write of a hidden step: 0 while it writes
    };
    struct OfLink {
        Nets t;            ///< one per product: 0 while the token is being given
        Nets u;            ///< of the second follower, the third, …
        Nets r;            ///< of the second step before, the third, …
        NetId s = no_net;  ///< of a merge: resets the hidden step
    };
    /// The two gates of a stored output or var.
    struct OfStored {
        NetId value = no_net;
        NetId complement = no_net;
        Nets setting;
        Nets resetting;
    };
    /// Of a forcing order one a step, as in WiredForcing.
    struct OfForcing {
        Nets q;  ///< of the steps off
        Nets v;  ///< of the steps on
    };

    /// Names all of them. `variables`: the nets of the ports.
    HandoverNets(const Grafcet& grafcet, const Equations& equations, const HandoverChart& wired,
                 const VariableNets& variables, NetlistBuilder& builder);

    NetId start = no_net;       ///< 0 while Init is 1; no_net without modes
    NetId not_au_dur = no_net;  ///< 0 while AUdur is 1

    const OfStep& of(WiredStepId step) const { return steps_[index_of(step)]; }
    const OfLink& of(LinkId link) const { return links_[index_of(link)]; }
    const OfStored& of_stored(std::size_t equation) const { return stored_[equation]; }
    const OfForcing& of_forcing(std::size_t forcing) const { return forcings_[forcing]; }
    /// What the gates of a link are named after.
    std::string owner_of(const Link& link) const;

    /// G: 1 once whatever brought the token into the step is over.
    Nets arrived(WiredStepId step) const;
    /// H: 1 once the X of a step that was left has fallen.
    Nets gone(WiredStepId step) const;
    /// The literal /X.
    Nets left(WiredStepId step) const;
    /// A stored variable is read once nobody is writing it.
    Nets stored_literal(const WiredLiteral& literal) const;
    /// Of a hidden step that writes: 1 once that is done.
    Nets written(WiredStepId step) const;
    /// Of a forcing step: 1 once its orders have been obeyed.
    Nets completed(WiredStepId step) const;
    /// What is 0 while a forcing order sets a step, and while it resets it: for its X, and its B.
    Nets switching_on(WiredStepId step, std::size_t forcing) const;
    Nets switching_off(WiredStepId step, std::size_t forcing) const;
    /// Of an enclosed graph: the X of the step that encloses it.
    Nets enclosing_lines(GraphId graph) const;
    /// What keeps T from beginning: the steps that freeze the graph.
    Nets freezing_lines(const Link& link) const;
    /// What keeps T and U from beginning: Init, AUdur, orders, the absence of an enclosing step.
    Nets lines_of_transitions(const Link& link) const;
    /// What sets the X of a step that the link leads to.
    Nets setting(WiredStepId step, LinkId by) const;
    /// What resets a step that the link leads away from.
    Nets resetting(WiredStepId step, LinkId by) const;

  private:
    void name_stored(NetlistBuilder& builder);
    void name_steps(NetlistBuilder& builder);
    void name_links(NetlistBuilder& builder);
    void name_forcings(NetlistBuilder& builder);
    /// `switched`: the steps that the order switches on, or off, and the gates that do it.
    Nets switching(WiredStepId step, std::size_t forcing, const std::vector<WiredStepId>& switched,
                   const Nets& gates) const;
    GraphId graph_of(const Link& link) const { return grafcet_.transitions[link.transition].graph; }

    const Grafcet& grafcet_;
    const Equations& equations_;
    const HandoverChart& wired_;
    const VariableNets& variables_;
    std::vector<OfStep> steps_;        ///< per wired step
    std::vector<OfLink> links_;        ///< per link
    std::vector<OfStored> stored_;     ///< per equation in Equations::stored
    std::vector<OfForcing> forcings_;  ///< per forcing
};

}  // namespace grafwire
