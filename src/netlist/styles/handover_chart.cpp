// From a GRAFCET to a chart that can be wired with hand-overs.
//
// In the wired chart a step is reset by its follower (style_handshake.cpp). For that no step may be
// active together with its follower, every circle needs at least three steps, and a transition has
// several steps on one side at most. Where the GRAFCET is not so, a hidden step is put between the
// two halves of a transition: it is active during an evolution only, never in a stable situation.
//
//   several to several, several to none      P -c-> hidden -1-> F
//   a loop of two steps                      one of its transitions, likewise
//   a transition that writes                 likewise; it is written in the hidden step
//   a step that may be entered while it is   every transition into it, and the second half is a
//   active, or active with its neighbour     merge
//   an edge                                  the step before it in two parts, 7 -/a-> 7 armed, the
//                                            second of which is left on a; X7 is their OR
//   a source on an edge                      a ring of hidden steps: armed -a-> (hidden, F),
//                                            hidden -1-> waiting -/a-> armed

#include "netlist/styles/handover_chart.h"

#include <algorithm>
#include <utility>

#include "netlist/styles/messages.h"

namespace grafwire {

namespace {

class Wiring {
  public:
    Wiring(const HandshakeFacts& facts, Diagnostics& diagnostics)
        : facts_(facts), diagnostics_(diagnostics) {}

    HandoverChart make() {
        add_steps();
        add_armed_parts();
        for (std::size_t i = 0; i < facts_.grafcet.transitions.size(); ++i) {
            add_transition(facts_.grafcet.transitions.id_at(i));
        }
        for (const auto& [step, edge] : facts_.edge_of) add_arming(step, edge);
        add_merges();
        split_links();
        connect();
        find_forcings();
        find_conditions();
        return std::move(chart_);
    }

  private:
    void refuse(Location where, Localized message) {
        diagnostics_.error(code::unsupported_by_style, where, std::move(message));
    }

    void add_steps();
    void add_armed_parts();
    void add_transition(TransitionId id);
    void add_source(TransitionId id);
    void add_arming(StepId step, const InputEdge& edge);
    LinkId add_link(Link link) { return chart_.links.add(std::move(link)); }
    LinkId add_hidden_link(TransitionId id, std::string role, std::vector<WiredStepId> preceding,
                           std::vector<WiredStepId> following, std::vector<WiredProduct> products);
    std::vector<WiredProduct> wired(const std::vector<Product>& products) const;
    void expand(const Product& product, std::size_t at, WiredProduct so_far,
                std::vector<WiredProduct>& result) const;
    void find_timer(Link& link) const;

    void add_writes(LinkId id);
    void add_merges();
    void split_links();
    bool is_in_loop_of_two(const Link& link, const std::vector<std::vector<LinkId>>& out_of) const;
    WiredStepId insert_step(LinkId id);

    void connect();
    void find_forcings();
    void find_conditions();

    const HandshakeFacts& facts_;
    Diagnostics& diagnostics_;
    HandoverChart chart_;
};

void Wiring::add_steps() {
    for (std::size_t i = 0; i < facts_.grafcet.steps.size(); ++i) {
        const StepId id = facts_.grafcet.steps.id_at(i);
        WiredStep step;
        step.home = id;
        step.starts = facts_.grafcet.steps[id].initial;
        chart_.parts.add({chart_.steps.add(std::move(step))});
    }
    // Init activates the initial steps, and what these force follows at once.
    for (const Order& order : facts_.grafcet.orders) {
        if (order.kind == OrderKind::freeze || !facts_.grafcet.steps[order.step].initial) continue;
        for (const StepId forced : facts_.grafcet.graphs[order.graph].steps) {
            chart_.steps[chart_.parts[forced][0]].starts = facts_.is_forced_on(order, forced);
        }
    }
}

void Wiring::add_armed_parts() {
    for (const auto& [id, edge] : facts_.edge_of) {
        chart_.steps[chart_.parts[id][0]].role = "unarmed";
        WiredStep armed;
        armed.home = id;
        armed.role = "armed";
        chart_.parts[id].push_back(chart_.steps.add(std::move(armed)));
    }
}

// Links.

void Wiring::expand(const Product& product, std::size_t at, WiredProduct so_far,
                    std::vector<WiredProduct>& result) const {
    if (at == product.size()) {
        std::sort(so_far.begin(), so_far.end());
        if (std::find(result.begin(), result.end(), so_far) == result.end()) {
            result.push_back(std::move(so_far));
        }
        return;
    }
    const Literal& literal = product[at];
    if (facts_.pool.kind(literal.atom) == ExprKind::time_condition) {
        so_far.push_back(
            {WiredLiteral::Kind::time, static_cast<std::uint32_t>(literal.atom), literal.negated});
        expand(product, at + 1, std::move(so_far), result);
        return;
    }
    const Variable variable = facts_.pool.variable_of(literal.atom);
    if (variable.kind == VariableKind::output || variable.kind == VariableKind::var) {
        std::uint32_t number = 0;
        while (facts_.equations.stored[number].target != variable) ++number;
        so_far.push_back({WiredLiteral::Kind::stored, number, literal.negated});
        expand(product, at + 1, std::move(so_far), result);
        return;
    }
    if (variable.kind != VariableKind::step) {
        const auto first = static_cast<std::uint32_t>(
            variable.kind == VariableKind::control ? facts_.grafcet.inputs.size() : 0);
        so_far.push_back({WiredLiteral::Kind::input, first + variable.index, literal.negated});
        expand(product, at + 1, std::move(so_far), result);
        return;
    }
    const std::vector<WiredStepId>& parts =
        chart_.parts[facts_.grafcet.steps.id_at(variable.index)];
    for (const WiredStepId part : parts) {
        WiredProduct with = so_far;
        if (literal.negated) {
            for (const WiredStepId each : parts) {
                with.push_back({WiredLiteral::Kind::step, static_cast<std::uint32_t>(each), true});
            }
        } else {
            with.push_back({WiredLiteral::Kind::step, static_cast<std::uint32_t>(part), false});
        }
        expand(product, at + 1, std::move(with), result);
        if (literal.negated) return;
    }
}

std::vector<WiredProduct> Wiring::wired(const std::vector<Product>& products) const {
    std::vector<WiredProduct> result;
    for (const Product& product : products) expand(product, 0, {}, result);
    return result;
}

/// The time condition on a step before the link that all of its products hold.
void Wiring::find_timer(Link& link) const {
    for (std::uint32_t i = 0; i < link.preceding.size(); ++i) {
        for (const WiredLiteral& literal : link.products[0]) {
            if (literal.kind != WiredLiteral::Kind::time || literal.negated) continue;
            const ExprId operand =
                facts_.pool.time_condition_of(static_cast<ExprId>(literal.index)).operand;
            if (facts_.pool.kind(operand) != ExprKind::variable) continue;
            const Variable variable = facts_.pool.variable_of(operand);
            const bool is_own = variable.kind == VariableKind::step &&
                                chart_.parts[facts_.grafcet.steps.id_at(variable.index)] ==
                                    std::vector{link.preceding[i]};
            const bool in_all = std::all_of(
                link.products.begin(), link.products.end(), [&](const WiredProduct& product) {
                    return std::find(product.begin(), product.end(), literal) != product.end();
                });
            if (!is_own || !in_all) continue;
            link.timed_step = i;
            link.timer = static_cast<ExprId>(literal.index);
            return;
        }
    }
}

/// Of the products those with the edge, in which its level takes its place.
std::vector<Product> at_level(const std::vector<Product>& products, ExprId edge, Literal level) {
    std::vector<Product> result;
    for (Product product : products) {
        const auto at = std::find(product.begin(), product.end(), Literal{edge, false});
        if (at == product.end()) continue;
        product.erase(at);
        if (auto both = product_of(product, {level})) result.push_back(std::move(*both));
    }
    return result;
}

std::vector<Product> without(const std::vector<Product>& products, ExprId edge) {
    std::vector<Product> result;
    for (const Product& product : products) {
        if (std::find(product.begin(), product.end(), Literal{edge, false}) == product.end()) {
            result.push_back(product);
        }
    }
    return result;
}

void Wiring::add_transition(TransitionId id) {
    const std::vector<Product>& products = facts_.receptivities[index_of(id)];
    if (products.empty()) return;
    if (facts_.grafcet.preceding(facts_.item(id)).empty()) return add_source(id);
    Link link;
    link.transition = id;
    for (const StepId step : facts_.grafcet.preceding(facts_.item(id))) {
        link.preceding.push_back(chart_.parts[step][0]);
    }
    for (const StepId step : facts_.grafcet.following(facts_.item(id))) {
        link.following.push_back(chart_.parts[step][0]);
    }
    for (const StepId step : facts_.grafcet.following(facts_.item(id))) {
        if (facts_.grafcet.steps[step].enclosure == none) continue;
        for (const StepId linked :
             facts_.grafcet.enclosures[facts_.grafcet.steps[step].enclosure].links) {
            link.following.push_back(chart_.parts[linked][0]);
        }
    }
    if (link.preceding == link.following) return;  // what is cleared is activated again at once
    const auto edge = facts_.edge_of.find(facts_.grafcet.preceding(facts_.item(id))[0]);
    if (link.preceding.size() != 1 || edge == facts_.edge_of.end()) {
        link.products = wired(products);
        find_timer(link);
        add_writes(add_link(std::move(link)));
        return;
    }
    // From the armed part by every product, from the other by those without the edge.
    const StepId from = edge->first;
    std::vector<Product> armed = at_level(products, edge->second.atom, edge->second.level);
    const std::vector<Product> plain = without(products, edge->second.atom);
    armed.insert(armed.end(), plain.begin(), plain.end());
    if (!plain.empty()) {
        Link early = link;
        early.role = "unarmed";
        early.products = wired(plain);
        add_writes(add_link(std::move(early)));
    }
    link.preceding = {chart_.parts[from][1]};
    link.products = wired(armed);
    if (!link.products.empty()) add_writes(add_link(std::move(link)));
}

/// The ring that stands for a source on an edge. It starts behind the edge, so that one that came
/// while Init or AUdur was 1 is lost, as it is in the reference.
void Wiring::add_source(TransitionId id) {
    std::vector<Product> levels;
    std::optional<InputEdge> edge;
    for (const Product& product : facts_.receptivities[index_of(id)]) {
        if (product.size() == 1) edge = facts_.edge_in(product[0].atom);
    }
    if (!edge || facts_.receptivities[index_of(id)].size() != 1) {
        return refuse(facts_.item(id).where,
                      messages::netlist_styles::source_on_level(facts_.item(id).name));
    }
    const StepId home = facts_.grafcet.following(facts_.item(id))[0];
    const auto hidden = [&](std::string role, bool starts) {
        WiredStep step;
        step.home = home;
        step.via = id;
        step.role = std::move(role);
        step.starts = step.outlasts_au_dur = starts;
        return chart_.steps.add(std::move(step));
    };
    const WiredStepId armed = hidden("armed", false);
    const WiredStepId via = hidden("via", false);
    const WiredStepId waiting = hidden("waiting", true);
    const Literal level = edge->level;
    Link give;
    give.transition = id;
    give.preceding = {armed};
    give.following = {via};
    give.products = wired({{level}});
    for (const StepId step : facts_.grafcet.following(facts_.item(id))) {
        give.following.push_back(chart_.parts[step][0]);
    }
    add_link(std::move(give));
    add_hidden_link(id, "via", {via}, {waiting}, {WiredProduct()});
    add_hidden_link(id, "arm", {waiting}, {armed}, wired({{{level.atom, !level.negated}}}));
}

/// The two parts of a step that is left on an edge: before and after the complement of its level
/// has been seen. What takes the level and lets it pass goes back.
void Wiring::add_arming(StepId step, const InputEdge& edge) {
    const WiredStepId plain = chart_.parts[step][0];
    const WiredStepId armed = chart_.parts[step][1];
    std::vector<Product> ways_out;
    TransitionId name = none;
    for (const TransitionId out : facts_.transitions.out_of_step(step)) {
        const std::vector<Product>& products = facts_.receptivities[index_of(out)];
        const std::vector<Product> levels = at_level(products, edge.atom, edge.level);
        if (!levels.empty() && name == none) name = out;
        const std::vector<Product> others = without(products, edge.atom);
        ways_out.insert(ways_out.end(), levels.begin(), levels.end());
        ways_out.insert(ways_out.end(), others.begin(), others.end());
    }
    if (name == none) return;
    const Literal before{edge.level.atom, !edge.level.negated};
    add_hidden_link(name, "arm", {plain}, {armed}, wired({{before}}));
    ways_out.push_back({before});
    const auto passes = complement_of(ways_out);
    if (!passes)
        return refuse(facts_.item(name).where,
                      messages::netlist_styles::too_many_products(facts_.item(name).name));
    if (passes->empty()) return;
    add_hidden_link(name, "disarm", {armed}, {plain}, wired(*passes));
}

LinkId Wiring::add_hidden_link(TransitionId id, std::string role,
                               std::vector<WiredStepId> preceding,
                               std::vector<WiredStepId> following,
                               std::vector<WiredProduct> products) {
    Link link;
    link.transition = id;
    link.role = std::move(role);
    link.preceding = std::move(preceding);
    link.following = std::move(following);
    link.products = std::move(products);
    link.is_hidden = true;
    return add_link(std::move(link));
}

// Hidden steps.

bool Wiring::is_in_loop_of_two(const Link& link,
                               const std::vector<std::vector<LinkId>>& out_of) const {
    for (const WiredStepId after : link.following) {
        for (const LinkId back : out_of[index_of(after)]) {
            for (const WiredStepId step : chart_.links[back].following) {
                if (std::find(link.preceding.begin(), link.preceding.end(), step) !=
                    link.preceding.end()) {
                    return true;
                }
            }
        }
    }
    return false;
}

/// Puts a hidden step between the two halves of a link; the link itself becomes the first.
WiredStepId Wiring::insert_step(LinkId id) {
    Link& first = chart_.links[id];
    WiredStep step;
    step.home =
        chart_.steps[first.following.empty() ? first.preceding[0] : first.following[0]].home;
    step.via = first.transition;
    step.role = first.role.empty() ? "via" : first.role + "$via";
    const WiredStepId hidden = chart_.steps.add(step);
    const std::vector<WiredStepId> following = std::move(first.following);
    first.following = {hidden};
    add_hidden_link(step.via, step.role, {hidden}, following, {WiredProduct()});
    return hidden;
}

/// The hidden step in which a transition writes what it has to.
void Wiring::add_writes(LinkId id) {
    const auto& writes = facts_.writes[chart_.links[id].transition];
    if (writes.empty()) return;
    const WiredStepId hidden = insert_step(id);
    chart_.steps[hidden].writes.assign(writes.begin(), writes.end());
}

void Wiring::add_merges() {
    for (std::size_t i = 0; i < facts_.grafcet.steps.size(); ++i) {
        const StepId id = facts_.grafcet.steps.id_at(i);
        if (!facts_.needs_merge(id)) continue;
        const WiredStepId entered = chart_.parts[id][0];
        for (std::size_t l = chart_.links.size(); l-- != 0;) {
            Link& link = chart_.links[chart_.links.id_at(l)];
            const auto at = std::find(link.following.begin(), link.following.end(), entered);
            if (at == link.following.end()) continue;
            WiredStep step;
            step.home = id;
            step.via = link.transition;
            step.role = (link.role.empty() ? "to" : link.role + "$to") +
                        std::to_string(at - link.following.begin());
            const WiredStepId hidden = chart_.steps.add(step);
            *at = hidden;
            const LinkId merge =
                add_hidden_link(step.via, step.role, {hidden}, {entered}, {WiredProduct()});
            chart_.links[merge].is_merge = true;
        }
    }
}

void Wiring::split_links() {
    const std::size_t count = chart_.links.size();
    std::vector<std::vector<LinkId>> out_of(chart_.steps.size());
    for (std::size_t i = 0; i < count; ++i) {
        for (const WiredStepId step : chart_.links[chart_.links.id_at(i)].preceding) {
            out_of[index_of(step)].push_back(chart_.links.id_at(i));
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        const LinkId id = chart_.links.id_at(i);
        const auto [several_before, followers] =
            std::pair(chart_.links[id].preceding.size() > 1, chart_.links[id].following.size());
        if ((several_before && followers != 1) || is_in_loop_of_two(chart_.links[id], out_of)) {
            insert_step(id);
        }
    }
}

void Wiring::connect() {
    for (std::size_t i = 0; i < chart_.links.size(); ++i) {
        const LinkId id = chart_.links.id_at(i);
        for (const WiredStepId step : chart_.links[id].preceding) {
            chart_.steps[step].out_of.push_back(id);
        }
        for (const WiredStepId step : chart_.links[id].following) {
            chart_.steps[step].into.push_back(id);
        }
    }
}

/// What every forcing order switches on, and off: the hidden steps of the graph go with it.
void Wiring::find_forcings() {
    for (const Order& order : facts_.grafcet.orders) {
        if (order.kind == OrderKind::freeze) continue;
        for (const WiredStepId from : chart_.parts[order.step]) {
            WiredForcing forcing{from, order.graph, {}, {}, facts_.may_pass(order.step)};
            for (std::size_t i = 0; i < chart_.steps.size(); ++i) {
                const WiredStepId id = chart_.steps.id_at(i);
                const WiredStep& step = chart_.steps[id];
                if (facts_.grafcet.steps[step.home].graph != order.graph) continue;
                const bool is_first = chart_.parts[step.home][0] == id;
                const bool is_on =
                    step.outlasts_au_dur || (is_first && facts_.is_forced_on(order, step.home));
                (is_on ? forcing.on : forcing.off).push_back(id);
            }
            chart_.forcings.push_back(std::move(forcing));
        }
    }
}

/// What the time conditions are conditions of.
void Wiring::find_conditions() {
    for (const Link& link : chart_.links) {
        for (const WiredProduct& product : link.products) {
            for (const WiredLiteral& literal : product) {
                if (literal.kind != WiredLiteral::Kind::time) continue;
                const auto time = static_cast<ExprId>(literal.index);
                const auto condition =
                    products_of(facts_.pool, facts_.pool.time_condition_of(time).operand);
                chart_.conditions[time] = wired(*condition)[0];
            }
        }
    }
}

}  // namespace

HandoverChart handover_chart(const HandshakeFacts& facts, Diagnostics& diagnostics) {
    return Wiring(facts, diagnostics).make();
}

}  // namespace grafwire
