// From a net of steps and transitions to lines, branches and links back up.
//
// Layered drawing (Sugiyama, Tagawa and Toda, 1981) knows ranks and crossings, but not that a
// selection has one line below its step and comes together over one below; a GRAFCET drawn that way
// has to be read twice. Charts that people write are nested, or nearly so: so the nesting is looked
// for, as compilers look for it in programs.
//
// 1. A depth-first search from the initial steps, in the order of the file, finds the links that
//    lead back up. All links that return to an initial step do: it stands on top.
// 2. The node at which the branches of a node come together is its immediate postdominator, found
//    by walking up a tree (Cooper, Harvey and Kennedy, "A Simple, Fast Dominance Algorithm", 2001;
//    without circles one pass is enough). A link back up counts as a link to a node of its own, one
//    for each step that it leads to, so branches that return to one step come together first. Of
//    the branches of a node only those count that lead back furthest up: a branch that only returns
//    within its surroundings leaves the line, and would hide where the others meet.
// 3. What is reached a second time in another way than by branches that come together is not drawn
//    a second time: the link is cut and carries the name of where it leads.
//
// The cost is proportional to the links, but for sets of branches, where each branch is compared
// with the places that it must pass.

#include "draw/chart_flow.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace grafwire {

namespace {

/// Branches nested deeper are cut: a picture of them could not be read, and lines are laid out by
/// functions that call themselves.
constexpr int deepest = 200;

class FlowNodes {
  public:
    FlowNodes(const Grafcet& grafcet, BlockId block_id) : grafcet_(grafcet), block_id_(block_id) {
        const Block& block = grafcet.blocks[block_id];
        for (const Block::Node& node : block.nodes) {
            FlowNode added;
            added.kind = node.is_macro ? FlowNode::Kind::macro : FlowNode::Kind::step;
            added.index = node.index;
            added.is_initial = !node.is_macro && grafcet.steps[StepId{node.index}].initial;
            place(node.is_macro, node.index);
            nodes_.push_back(std::move(added));
        }
        for (const TransitionId transition : block.transitions) add(transition);
    }

    std::vector<FlowNode> take() { return std::move(nodes_); }

  private:
    void place(bool is_macro, std::uint32_t index) {
        (is_macro ? macros_ : steps_)[index] = static_cast<std::uint32_t>(nodes_.size());
    }

    void add(TransitionId id) {
        const Transition& transition = grafcet_.transitions[id];
        const auto number = static_cast<std::uint32_t>(nodes_.size());
        FlowNode added;
        added.kind = FlowNode::Kind::transition;
        added.index = static_cast<std::uint32_t>(id);
        for (const StepId step : grafcet_.following(transition)) {
            added.next.push_back(node_of(step, true));
        }
        for (const StepId step : grafcet_.preceding(transition)) {
            nodes_[node_of(step, false)].next.push_back(number);
        }
        nodes_.push_back(std::move(added));
    }

    /// The entry and exit steps of expansions stand for their macro-steps, which may be nested.
    std::uint32_t node_of(StepId step, bool by_entry) const {
        if (const auto found = steps_.find(static_cast<std::uint32_t>(step));
            found != steps_.end()) {
            return found->second;
        }
        for (std::uint32_t i = 0; i < grafcet_.macros.size(); ++i) {
            const Macro& macro = grafcet_.macros[MacroId{i}];
            if (macro.block == block_id_ && (by_entry ? macro.entry : macro.exit) == step) {
                return macros_.at(i);
            }
        }
        return 0;  // does not happen: the model only links nodes of one block
    }

    const Grafcet& grafcet_;
    BlockId block_id_;
    std::map<std::uint32_t, std::uint32_t> steps_, macros_;
    std::vector<FlowNode> nodes_;
};

/// Where a link leads, as a number: a node; the place from which links return to a node; the end,
/// which all ways have in common; or a node whose name is written.
class Destinations {
  public:
    explicit Destinations(std::size_t count) : count_(static_cast<std::uint32_t>(count)) {}

    bool is_node(std::uint32_t d) const { return d < count_; }
    bool is_return(std::uint32_t d) const { return d >= count_ && d < 2 * count_; }
    bool is_named(std::uint32_t d) const { return d > 2 * count_; }
    std::uint32_t return_to(std::uint32_t node) const { return count_ + node; }
    std::uint32_t end() const { return 2 * count_; }
    std::uint32_t named(std::uint32_t node) const { return 2 * count_ + 1 + node; }
    /// The node that a return, or a name, leads to.
    std::uint32_t node_of(std::uint32_t d) const { return (d - (is_named(d) ? 1 : 0)) % count_; }

  private:
    std::uint32_t count_;
};

/// Steps 1 and 2: which links lead back up, how far up a node leads, and where its branches meet.
class FlowOrder {
  public:
    explicit FlowOrder(const std::vector<FlowNode>& nodes)
        : nodes_(nodes), destinations_(nodes.size()) {
        number_.assign(nodes.size(), unseen);
        links_.resize(nodes.size());
        rank_.assign(nodes.size(), nowhere);
        meeting_.assign(2 * nodes.size() + 1, destinations_.end());
        depth_.assign(2 * nodes.size() + 1, 1);
        depth_[destinations_.end()] = 0;
        find_circles();
        find_roots();
        for (const std::uint32_t root : roots_) search(root);
        for (std::uint32_t node = 0; node < nodes.size(); ++node) {
            if (number_[node] != unseen) continue;
            roots_.push_back(node);
            search(node);
        }
    }

    const Destinations& destinations() const { return destinations_; }
    const std::vector<std::uint32_t>& roots() const { return roots_; }
    const std::vector<std::uint32_t>& links(std::uint32_t node) const { return links_[node]; }

    /// The links of a node that count: where some lead on, those that lead back at once do not. (A
    /// transition that gives a token back, beside the step that it goes on to.)
    std::vector<std::uint32_t> leading_on(std::uint32_t node) const {
        std::vector<std::uint32_t> on;
        for (const std::uint32_t link : links_[node]) {
            if (destinations_.is_node(link)) on.push_back(link);
        }
        return on.empty() ? links_[node] : on;
    }

    /// The smallest number of a node that is returned to from here on; initial steps count as 0.
    std::uint32_t rank(std::uint32_t node) const { return rank_[node]; }
    std::uint32_t rank_of_link(std::uint32_t destination) const {
        if (destinations_.is_node(destination)) return rank_[destination];
        if (!destinations_.is_return(destination)) return nowhere;
        const std::uint32_t target = destinations_.node_of(destination);
        return nodes_[target].is_initial ? 0 : number_[target];
    }

    /// What every way from there passes, the nearest first, without the end.
    std::vector<std::uint32_t> must_pass(std::uint32_t destination) const {
        std::vector<std::uint32_t> passed;
        if (destinations_.is_named(destination)) return passed;
        for (; destination != destinations_.end(); destination = meeting_[destination]) {
            passed.push_back(destination);
        }
        return passed;
    }

    /// The nearest place that every way from a and from b passes, or the end.
    std::uint32_t meet(std::uint32_t a, std::uint32_t b) const {
        if (destinations_.is_named(a) || destinations_.is_named(b)) return destinations_.end();
        while (a != b) (depth_[a] >= depth_[b] ? a : b) = meeting_[depth_[a] >= depth_[b] ? a : b];
        return a;
    }

  private:
    static constexpr std::uint32_t unseen = 0xffffffffU;
    static constexpr std::uint32_t nowhere = 0xffffffffU;

    /// Two nodes are on one circle of links where they have the same number.
    void find_circles() {
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(nodes_.size());
        for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
            for (const std::uint32_t next : nodes_[node].next) boost::add_edge(node, next, graph);
        }
        circle_.resize(nodes_.size());
        boost::strong_components(
            graph, boost::make_iterator_property_map(circle_.begin(),
                                                     boost::get(boost::vertex_index, graph)));
    }

    void find_roots() {
        std::vector<bool> is_reached(nodes_.size());
        for (const FlowNode& node : nodes_) {
            for (const std::uint32_t next : node.next) is_reached[next] = true;
        }
        for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
            if (nodes_[node].is_initial) roots_.push_back(node);
        }
        for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
            if (!nodes_[node].is_initial && !is_reached[node]) roots_.push_back(node);
        }
    }

    /// Depth-first, without calls within calls: charts are long.
    void search(std::uint32_t root) {
        if (number_[root] != unseen) return;
        struct Visit {
            std::uint32_t node;
            std::size_t next;
        };
        std::vector<Visit> path;
        on_path_.resize(nodes_.size());
        const auto enter = [&](std::uint32_t node) {
            number_[node] = ++last_number_;
            on_path_[node] = true;
            path.push_back({node, 0});
        };
        enter(root);
        while (!path.empty()) {
            Visit& visit = path.back();
            const std::uint32_t node = visit.node;
            if (visit.next == nodes_[node].next.size()) {
                finish(node);
                on_path_[node] = false;
                path.pop_back();
                continue;
            }
            const std::uint32_t next = nodes_[node].next[visit.next++];
            const bool leads_up =
                on_path_[next] || (nodes_[next].is_initial && circle_[next] == circle_[node]);
            if (!leads_up) {
                links_[node].push_back(next);
                if (number_[next] == unseen) enter(next);
            } else if (nodes_[next].kind == FlowNode::Kind::transition) {
                // Several links that come together over a transition do so once, on their way down.
                links_[node].push_back(destinations_.named(next));
            } else {
                links_[node].push_back(destinations_.return_to(next));
            }
        }
    }

    /// All that the node leads to has been finished, since nothing leads in a circle.
    void finish(std::uint32_t node) {
        const std::vector<std::uint32_t> on = leading_on(node);
        for (const std::uint32_t link : on) rank_[node] = std::min(rank_[node], rank_of_link(link));
        std::optional<std::uint32_t> meeting;
        for (const std::uint32_t link : on) {
            if (rank_of_link(link) != rank_[node]) continue;
            if (destinations_.is_named(link)) {
                meeting = destinations_.end();
            } else {
                meeting = meeting ? meet(*meeting, link) : link;
            }
        }
        meeting_[node] = meeting.value_or(destinations_.end());
        depth_[node] = depth_[meeting_[node]] + 1;
    }

    const std::vector<FlowNode>& nodes_;
    Destinations destinations_;
    std::vector<std::uint32_t> roots_;
    std::vector<std::vector<std::uint32_t>> links_;  ///< destinations
    std::vector<std::uint32_t> number_;              ///< in the order of the search
    std::vector<std::uint32_t> rank_;
    std::vector<std::uint32_t> meeting_;  ///< immediate postdominator, of nodes and returns
    std::vector<std::uint32_t> depth_;    ///< in the tree of these
    std::vector<std::uint32_t> circle_;
    std::vector<bool> on_path_;
    std::uint32_t last_number_ = 0;
};

/// Step 3: sequences and branches.
class FlowSequences {
  public:
    explicit FlowSequences(std::vector<FlowNode>& nodes)
        : nodes_(nodes), order_(nodes), to_(order_.destinations()) {
        is_placed_.resize(nodes.size());
        is_awaited_.resize(nodes.size());
    }

    std::vector<FlowSequence> make() {
        std::vector<FlowSequence> sequences = branches(order_.roots(), to_.end(), none, 0);
        for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
            if (!is_placed_[node]) sequences.push_back(sequence(node, to_.end(), none, 0));
        }
        return sequences;
    }

  private:
    /// From a destination down to `stop`; `from` is the node whose link leads there.
    FlowSequence sequence(std::uint32_t at, std::uint32_t stop, std::uint32_t from, int depth) {
        FlowSequence made;
        while (true) {
            if (ends(made, at, stop, from, depth)) return made;
            is_placed_[at] = true;
            made.pieces.push_back({at, {}, {}, {}});
            from = at;
            const std::vector<std::uint32_t>& links = order_.links(at);
            if (links.empty()) return made;
            if (links.size() == 1) {
                at = links.front();
                continue;
            }
            const std::vector<std::uint32_t> main = main_links(at);
            if (main.size() == 1) {
                add_side_branches(made.pieces.back(), links, main.front(), depth);
                at = main.front();
                continue;
            }
            std::uint32_t meeting = main.front();
            for (const std::uint32_t link : main) meeting = order_.meet(meeting, link);
            FlowPiece fork;
            if (meeting == to_.end()) {
                fork.branches = branches(links, stop, from, depth + 1);
                made.pieces.push_back(std::move(fork));
                return made;
            }
            fork.branches = branches_to(links, meeting, from, depth + 1);
            made.pieces.push_back(std::move(fork));
            at = meeting;
            from = none;
        }
    }

    /// Whether the sequence ends where it is; if so, its end is entered.
    bool ends(FlowSequence& made, std::uint32_t at, std::uint32_t stop, std::uint32_t from,
              int depth) {
        using End = FlowSequence::End;
        if (at == stop && stop != to_.end()) {
            made.end = End::into;
        } else if (at == to_.end()) {
            made.end = End::stops;
        } else if (to_.is_return(at)) {
            made.end = End::up;
            made.target = to_.node_of(at);
        } else if (to_.is_named(at) || is_placed_[at] || is_awaited_[at] || depth > deepest) {
            made.end = End::named;
            made.target = to_.is_named(at) ? to_.node_of(at) : at;
            if (from != none) nodes_[made.target].named.push_back(from);
        } else {
            return false;
        }
        return true;
    }

    /// The links of a node that lead back as far up as any.
    std::vector<std::uint32_t> main_links(std::uint32_t node) const {
        std::vector<std::uint32_t> main;
        for (const std::uint32_t link : order_.leading_on(node)) {
            if (order_.rank_of_link(link) == order_.rank(node) && !to_.is_named(link)) {
                main.push_back(link);
            }
        }
        if (main.empty()) main.push_back(order_.links(node).front());
        return main;
    }

    void add_side_branches(FlowPiece& piece, const std::vector<std::uint32_t>& links,
                           std::uint32_t main, int depth) {
        // What the line passes itself must not be taken by a branch beside it.
        if (to_.is_node(main)) is_awaited_[main] = true;
        bool is_before = true;
        for (const std::uint32_t link : links) {
            if (link == main) {
                is_before = false;
                continue;
            }
            (is_before ? piece.before : piece.after)
                .push_back(sequence(link, to_.end(), piece.node, depth + 1));
        }
        if (to_.is_node(main)) is_awaited_[main] = false;
    }

    std::vector<FlowSequence> branches_to(const std::vector<std::uint32_t>& links,
                                          std::uint32_t stop, std::uint32_t from, int depth) {
        const bool is_node = to_.is_node(stop);
        const bool was_awaited = is_node && is_awaited_[stop];
        if (is_node) is_awaited_[stop] = true;
        std::vector<FlowSequence> made = branches(links, stop, from, depth);
        if (is_node) is_awaited_[stop] = was_awaited;
        return made;
    }

    /// Branches side by side down to `stop`. Some may come together before: they become one, which
    /// begins with branches itself.
    std::vector<FlowSequence> branches(std::vector<std::uint32_t> links, std::uint32_t stop,
                                       std::uint32_t from, int depth) {
        std::vector<FlowSequence> made(links.size());
        std::vector<bool> is_made(links.size());
        std::vector<bool> is_empty(links.size());
        for (auto group = sharing_branches(links, is_made, stop); group;
             group = sharing_branches(links, is_made, stop)) {
            std::vector<std::uint32_t> heads;
            for (const std::size_t i : group->members) heads.push_back(links[i]);
            std::vector<FlowSequence> parts = branches_to(heads, group->meeting, from, depth + 1);
            FlowSequence whole = sequence(group->meeting, stop, none, depth + 1);
            made[group->members.front()] = joined(std::move(parts), std::move(whole));
            for (const std::size_t i : group->members) {
                is_made[i] = true;
                is_empty[i] = i != group->members.front();
            }
        }
        std::vector<FlowSequence> all;
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (!is_made[i]) made[i] = sequence(links[i], stop, from, depth);
            // A root that others come together over has no link of its own that leads to it.
            const bool is_root = from == none && made[i].pieces.empty();
            if (!is_empty[i] && !is_root) all.push_back(std::move(made[i]));
        }
        return all;
    }

    /// Branches that come together, and what follows them. A single one is no branch.
    static FlowSequence joined(std::vector<FlowSequence> parts, FlowSequence whole) {
        std::vector<FlowPiece> pieces;
        if (parts.size() == 1 && parts.front().end == FlowSequence::End::into) {
            pieces = std::move(parts.front().pieces);
        } else {
            pieces.push_back({none, std::move(parts), {}, {}});
        }
        whole.pieces.insert(whole.pieces.begin(), std::make_move_iterator(pieces.begin()),
                            std::make_move_iterator(pieces.end()));
        return whole;
    }

    struct Group {
        std::vector<std::size_t> members;
        std::uint32_t meeting = 0;
    };

    /// The place before `stop` that most of the branches pass, two at least, and which do.
    std::optional<Group> sharing_branches(const std::vector<std::uint32_t>& links,
                                          const std::vector<bool>& is_made,
                                          std::uint32_t stop) const {
        std::map<std::uint32_t, Group> passed;
        std::vector<std::uint32_t> in_order;
        for (std::size_t i = 0; i < links.size(); ++i) {
            if (is_made[i]) continue;
            for (const std::uint32_t place : order_.must_pass(links[i])) {
                if (place == stop) break;
                if (to_.is_node(place) && (is_placed_[place] || is_awaited_[place])) break;
                Group& group = passed[place];
                if (group.members.empty()) in_order.push_back(place);
                group.members.push_back(i);
                group.meeting = place;
            }
        }
        const Group* best = nullptr;
        for (const std::uint32_t place : in_order) {
            const Group& group = passed[place];
            if (group.members.size() < 2) continue;
            if (best == nullptr || group.members.size() > best->members.size()) best = &group;
        }
        return best != nullptr ? std::optional(*best) : std::nullopt;
    }

    std::vector<FlowNode>& nodes_;
    FlowOrder order_;
    const Destinations& to_;
    std::vector<bool> is_placed_;
    std::vector<bool> is_awaited_;  ///< branches being laid out come together there
};

}  // namespace

ChartFlow flow_of(const Grafcet& grafcet, BlockId block) {
    ChartFlow flow;
    flow.nodes = FlowNodes(grafcet, block).take();
    if (!flow.nodes.empty()) flow.sequences = FlowSequences(flow.nodes).make();
    return flow;
}

}  // namespace grafwire
