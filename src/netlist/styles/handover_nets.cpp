// The lists G, H and the like are no gates: what waits for an arrival, for a step to have gone, for
// an order to have been obeyed takes in the very gates that say so.

#include "netlist/styles/handover_nets.h"

#include <algorithm>

namespace grafwire {

void add_nets(Nets& nets, const Nets& more) {
    nets.insert(nets.end(), more.begin(), more.end());
}

Nets distinct(const Nets& nets) {
    Nets result;
    for (const NetId net : nets) {
        if (std::find(result.begin(), result.end(), net) == result.end()) result.push_back(net);
    }
    return result;
}

HandoverNets::HandoverNets(const Grafcet& grafcet, const Equations& equations,
                           const HandoverChart& wired, const VariableNets& variables,
                           NetlistBuilder& builder)
    : grafcet_(grafcet), equations_(equations), wired_(wired), variables_(variables) {
    name_stored(builder);
    name_steps(builder);
    name_links(builder);
    name_forcings(builder);
}

void HandoverNets::name_stored(NetlistBuilder& builder) {
    for (const StoredEquation& stored : equations_.stored) {
        const bool is_output = stored.target.kind == VariableKind::output;
        OfStored nets;
        nets.value = (is_output ? variables_.outputs : variables_.vars)[stored.target.index];
        const std::string name(builder.name_of(nets.value));
        if (!stored.writes.empty()) {
            nets.complement = builder.add_inner_net(name, "q");
            builder.set_initial(nets.value, false);
            builder.set_initial(nets.complement, true);
        }
        stored_.push_back(std::move(nets));
    }
}

void HandoverNets::name_steps(NetlistBuilder& builder) {
    for (std::size_t i = 0; i < wired_.steps.size(); ++i) {
        const WiredStep& step = wired_.steps[wired_.steps.id_at(i)];
        const std::string owner = step.is_hidden() ? "T" + grafcet_.transitions[step.via].name
                                                   : "X" + grafcet_.steps[step.home].name;
        OfStep nets;
        nets.x = step.role.empty() ? variables_.steps[index_of(step.home)]
                                   : builder.add_inner_net(owner, step.role);
        const std::string name(builder.name_of(nets.x));
        nets.b = builder.add_inner_net(name, "q");
        for (const auto& [number, value] : step.writes) {
            const NetId write =
                builder.add_inner_net(name, "write" + std::to_string(nets.writes.size()));
            nets.writes.push_back(write);
            OfStored& stored = stored_[number];
            (value ? stored.setting : stored.resetting).push_back(write);
        }
        steps_.push_back(nets);
        if (equations_.options.modes) continue;
        builder.set_initial(nets.x, step.starts);
        builder.set_initial(nets.b, !step.starts);
    }
}

std::string HandoverNets::owner_of(const Link& link) const {
    const std::string name = "T" + grafcet_.transitions[link.transition].name;
    return link.role.empty() ? name : name + "$" + link.role;
}

void HandoverNets::name_links(NetlistBuilder& builder) {
    for (const Link& link : wired_.links) {
        const std::string owner = owner_of(link);
        OfLink nets;
        const auto numbered = [](const char* role, std::size_t number) {
            return role + std::to_string(number);
        };
        for (std::size_t i = 0; i < link.products.size(); ++i) {
            const bool is_only = link.products.size() == 1;
            nets.t.push_back(builder.add_inner_net(owner, is_only ? "give" : numbered("give", i)));
        }
        for (std::size_t i = 1; i < link.following.size(); ++i) {
            nets.u.push_back(builder.add_inner_net(owner, numbered("fork", i)));
        }
        for (std::size_t i = 1; i < link.preceding.size(); ++i) {
            nets.r.push_back(builder.add_inner_net(owner, numbered("join", i)));
        }
        if (link.is_merge) nets.s = builder.add_inner_net(owner, "merged");
        links_.push_back(std::move(nets));
    }
}

void HandoverNets::name_forcings(NetlistBuilder& builder) {
    std::size_t number = 0;
    for (const WiredForcing& forcing : wired_.forcings) {
        const std::string owner(builder.name_of(of(forcing.step).x));
        const auto add_net = [&](const char* role) {
            return builder.add_inner_net(owner, role + std::to_string(number++));
        };
        OfForcing& nets = forcings_.emplace_back();
        if (!forcing.has_completion) continue;
        for (std::size_t i = 0; i < forcing.off.size(); ++i) nets.q.push_back(add_net("off"));
        for (std::size_t i = 0; i < forcing.on.size(); ++i) nets.v.push_back(add_net("on"));
    }
}

Nets HandoverNets::arrived(WiredStepId step) const {
    Nets result;
    for (const LinkId id : wired_.steps[step].into) {
        const Link& link = wired_.links[id];
        const OfLink& nets = of(id);
        if (link.is_merge) {
            add_nets(result, {of(link.preceding[0]).b, nets.s, nets.t[0]});
        } else if (link.following.size() > 1) {
            result.push_back(nets.u.back());
            if (step != link.following.back()) result.push_back(of(link.preceding[0]).b);
        } else {
            add_nets(result, nets.t);
            add_nets(result, nets.r);
            for (std::size_t i = 1; i < link.preceding.size(); ++i) {
                result.push_back(of(link.preceding[i]).b);
            }
        }
    }
    return result;
}

Nets HandoverNets::gone(WiredStepId step) const {
    Nets result;
    for (const LinkId id : wired_.steps[step].out_of) {
        const Link& link = wired_.links[id];
        const OfLink& nets = of(id);
        if (link.is_merge) {
            result.push_back(nets.s);
        } else if (link.following.size() > 1) {
            result.push_back(nets.u.back());
        } else if (link.preceding[0] == step) {
            add_nets(result, nets.t);
        } else {
            const auto at = std::find(link.preceding.begin(), link.preceding.end(), step);
            result.push_back(nets.r[static_cast<std::size_t>(at - link.preceding.begin()) - 1]);
        }
    }
    return result;
}

Nets HandoverNets::left(WiredStepId step) const {
    Nets result{of(step).b};
    add_nets(result, gone(step));
    for (const LinkId id : wired_.steps[step].out_of) {
        for (const WiredStepId next : wired_.links[id].following) {
            const WiredStep& hidden = wired_.steps[next];
            if (!hidden.is_hidden() || hidden.outlasts_au_dur) continue;
            result.push_back(of(next).b);
            add_nets(result, gone(next));
        }
    }
    return result;
}

Nets HandoverNets::stored_literal(const WiredLiteral& literal) const {
    const OfStored& nets = stored_[literal.index];
    Nets result{literal.negated ? nets.complement : nets.value};
    for (std::size_t i = 0; i < wired_.steps.size(); ++i) {
        const WiredStepId id = wired_.steps.id_at(i);
        for (const auto& [number, value] : wired_.steps[id].writes) {
            if (number != literal.index) continue;
            result.push_back(of(id).b);
            add_nets(result, gone(id));
        }
    }
    return result;
}

Nets HandoverNets::written(WiredStepId step) const {
    Nets result;
    const auto& writes = wired_.steps[step].writes;
    for (std::size_t i = 0; i < writes.size(); ++i) {
        const OfStored& nets = stored_[writes[i].first];
        add_nets(result, {of(step).writes[i], writes[i].second ? nets.value : nets.complement});
    }
    return result;
}

Nets HandoverNets::completed(WiredStepId step) const {
    Nets result;
    for (std::size_t i = 0; i < wired_.forcings.size(); ++i) {
        const WiredForcing& forcing = wired_.forcings[i];
        if (forcing.step != step || !forcing.has_completion) continue;
        for (std::size_t j = 0; j < forcing.off.size(); ++j) {
            add_nets(result, {of(forcing.off[j]).b, forcings_[i].q[j]});
        }
        for (std::size_t j = 0; j < forcing.on.size(); ++j) {
            add_nets(result, {of(forcing.on[j]).x, forcings_[i].v[j]});
        }
        for (std::size_t l = 0; l < wired_.links.size(); ++l) {
            const LinkId link = wired_.links.id_at(l);
            if (graph_of(wired_.links[link]) != forcing.graph) continue;
            add_nets(result, of(link).t);
            add_nets(result, of(link).u);
            add_nets(result, of(link).r);
            if (of(link).s != no_net) result.push_back(of(link).s);
        }
    }
    return result;
}

Nets HandoverNets::switching(WiredStepId step, std::size_t forcing,
                             const std::vector<WiredStepId>& switched, const Nets& gates) const {
    const auto at = std::find(switched.begin(), switched.end(), step);
    if (at == switched.end()) return {};
    const WiredForcing& item = wired_.forcings[forcing];
    if (!item.has_completion) return {of(item.step).b};
    return {gates[static_cast<std::size_t>(at - switched.begin())]};
}

Nets HandoverNets::switching_on(WiredStepId step, std::size_t forcing) const {
    return switching(step, forcing, wired_.forcings[forcing].on, forcings_[forcing].v);
}

Nets HandoverNets::switching_off(WiredStepId step, std::size_t forcing) const {
    return switching(step, forcing, wired_.forcings[forcing].off, forcings_[forcing].q);
}

Nets HandoverNets::enclosing_lines(GraphId graph) const {
    const EnclosureId enclosure = grafcet_.graphs[graph].enclosed_by;
    if (enclosure == none) return {};
    return {of(wired_.parts[grafcet_.enclosures[enclosure].step][0]).x};
}

Nets HandoverNets::lines_of_transitions(const Link& link) const {
    Nets result;
    if (start != no_net) result = {start, not_au_dur};
    add_nets(result, enclosing_lines(graph_of(link)));
    for (const WiredForcing& forcing : wired_.forcings) {
        if (forcing.graph != graph_of(link)) continue;
        add_nets(result, left(forcing.step));
    }
    return result;
}

Nets HandoverNets::freezing_lines(const Link& link) const {
    Nets result;
    if (link.is_hidden) return result;
    for (const Order& order : grafcet_.orders) {
        if (order.kind != OrderKind::freeze || order.graph != graph_of(link)) continue;
        for (const WiredStepId part : wired_.parts[order.step]) add_nets(result, left(part));
    }
    return result;
}

Nets HandoverNets::setting(WiredStepId step, LinkId by) const {
    const Link& link = wired_.links[by];
    const auto at = std::find(link.following.begin(), link.following.end(), step);
    const auto place = static_cast<std::size_t>(at - link.following.begin());
    return place == 0 ? of(by).t : Nets{of(by).u[place - 1]};
}

Nets HandoverNets::resetting(WiredStepId step, LinkId by) const {
    const Link& link = wired_.links[by];
    if (link.is_merge) return {of(by).s};
    if (link.following.empty()) return of(by).t;
    if (link.following.size() > 1) return {of(link.following.back()).b};
    const auto at = std::find(link.preceding.begin(), link.preceding.end(), step);
    const auto place = static_cast<std::size_t>(at - link.preceding.begin());
    return {place == 0 ? of(link.following[0]).b : of(by).r[place - 1]};
}

}  // namespace grafwire
