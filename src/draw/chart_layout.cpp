// Blocks within blocks: each sequence is laid out round its own axis, from the top down, and knows
// how far it reaches to both sides; branches are set side by side, so that nothing of one is in the
// way of another, and the sequence goes on below the longest. Links back up are drawn last, in the
// smallest sequence that holds their target: along its left side or its right, where nothing is in
// their way. Where something is, the link is cut and says where it leads: a crossing would have to
// be followed with the finger.
//
// Distances: a bar stands midway between two steps; half a unit lies between a bar and a step, more
// where actions or long conditions need it.

#include "draw/chart_layout.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "draw/links_up.h"

namespace grafwire {

namespace {

constexpr double half_gap = 0.5;     ///< between a bar and a step
constexpr double least_link = 0.4;   ///< between a line of branches and a step
constexpr double branch_pitch = 2;   ///< between the axes of two branches, at least
constexpr double branch_gap = 0.5;   ///< between what belongs to them
constexpr double double_gap = 0.1;   ///< between the two lines of simultaneous branches
constexpr double overhang = 0.4;     ///< of these beyond the outermost axis
constexpr double label_room = 0.85;  ///< below the end of a link that is cut

/// How far below the line of their branches bars and steps stand: the same for all of them.
struct Lead {
    double bar = half_gap;
    double step = least_link;
    bool has_line = true;  ///< else nothing leads to them from above
};

Laid lay_sequence(FlowSymbols& symbols, const FlowSequence& sequence, const Lead& lead,
                  std::uint32_t from);

/// The nodes with which branches begin, those that begin with branches included.
void add_heads(const FlowSequence& sequence, std::vector<std::uint32_t>& heads) {
    if (sequence.pieces.empty()) return;
    const FlowPiece& first = sequence.pieces.front();
    if (first.node != none) {
        heads.push_back(first.node);
    } else {
        for (const FlowSequence& branch : first.branches) add_heads(branch, heads);
    }
}

Lead lead_for(FlowSymbols& symbols, const std::vector<std::uint32_t>& heads) {
    Lead lead;
    for (const std::uint32_t head : heads) {
        if (symbols.is_transition(head)) {
            lead.bar = std::max(lead.bar, symbols.above(head) + 0.1);
        } else {
            lead.step = std::max(lead.step, symbols.above(head) + 0.1);
        }
    }
    return lead;
}

/// Branches side by side, at y = 0 the line that they begin at. The axis is in the middle of the
/// outer ones, or on a branch that is nearly there; on the only one that goes on, where there is
/// only one.
Laid lay_branches(FlowSymbols& symbols, const std::vector<FlowSequence>& branches, const Lead& lead,
                  std::uint32_t from) {
    Laid all;
    double right = 0;
    double last_axis = 0;
    for (const FlowSequence& branch : branches) {
        Laid laid = lay_sequence(symbols, branch, lead, from);
        const Bounds bounds = laid.extent();
        const bool is_first = all.heads.empty();
        if (!is_first)
            last_axis = std::max(last_axis + branch_pitch, right + branch_gap - bounds.left);
        laid.shift(last_axis, 0);
        right = last_axis + bounds.right;
        all.heads.insert(all.heads.end(), laid.heads.begin(), laid.heads.end());
        all.take(std::move(laid));
    }
    double axis = (all.heads.front() + all.heads.back()) / 2;
    for (const double head : all.heads) {
        if (std::abs(head - axis) < 0.5) axis = head;
    }
    std::vector<double> going_on;
    for (const Exit& exit : all.exits) {
        if (!exit.goes_up) going_on.push_back(exit.x);
    }
    if (going_on.size() == 1) axis = going_on.front();
    all.shift(-axis, 0);
    return all;
}

/// Lays out one sequence round x = 0.
class SequenceLayout {
  public:
    SequenceLayout(FlowSymbols& symbols, const Lead& lead, std::uint32_t from)
        : symbols_(symbols), lead_(lead), from_(from) {
        above_ = lead.has_line ? Above::line : Above::nothing;
    }

    Laid lay(const FlowSequence& sequence) {
        laid_.heads.push_back(0);
        const std::vector<FlowPiece>& pieces = sequence.pieces;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (pieces[i].node == none) {
                const bool goes_on = i + 1 < pieces.size();
                add_branches(pieces[i], goes_on ? pieces[i + 1].node : none, sequence.end,
                             sequence.target, goes_on);
            } else {
                const bool is_last = i + 1 == pieces.size();
                add_node(pieces[i].node,
                         is_last || has_side(pieces[i]) ? none : pieces[i + 1].node);
                if (has_side(pieces[i])) begin_side_branches(pieces[i], pieces, i + 1);
            }
        }
        if (pieces.empty() || pieces.back().node != none) end(sequence);
        for (auto side = sides_.rbegin(); side != sides_.rend(); ++side) add_side_branches(*side);
        draw_returns();
        return std::move(laid_);
    }

  private:
    enum class Above { nothing, line, node };
    struct Side {
        double y = 0;
        const FlowPiece* piece = nullptr;
        Lead lead;
    };

    static bool has_side(const FlowPiece& piece) {
        return !piece.before.empty() || !piece.after.empty();
    }

    void add_shapes(std::vector<Shape> shapes, double y) {
        move(shapes, 0, y);
        laid_.shapes.insert(laid_.shapes.end(), std::make_move_iterator(shapes.begin()),
                            std::make_move_iterator(shapes.end()));
    }

    // -- Nodes

    void add_node(std::uint32_t node, std::uint32_t next) {
        if (symbols_.is_transition(node) && !symbols_.node(node).named.empty() && !is_joined_) {
            join_by_name(node);
        }
        is_joined_ = false;
        const double at = place_of(node, next);
        const bool is_entered = above_ != Above::nothing;
        if (is_entered && at > y_) {
            Pen(laid_.shapes, symbols_.link("link", from_, node)).line({{0, y_}, {0, at}});
        }
        add_shapes(std::move(symbols_.symbol(node).shapes), at);
        y_ = at;
        if (!symbols_.is_transition(node)) {
            y_ += step_height;
            targets_[node] = {at, symbols_.symbol(node).room_above, is_entered};
            add_arrivals(node, at, is_entered);
        }
        laid_.bottom = std::max(laid_.bottom, y_ + symbols_.below(node));
        from_ = node;
        above_ = Above::node;
    }

    /// Where the bar of a transition, or the upper edge of a step, comes to stand. `next` is the
    /// node that follows at once, if one does.
    double place_of(std::uint32_t node, std::uint32_t next) {
        const double room = symbols_.above(node);
        const bool is_bar = symbols_.is_transition(node);
        switch (above_) {
            case Above::nothing:
                return y_ + std::max(room, !is_bar && symbols_.is_returned_to(node) ? 0.45 : 0);
            case Above::line:
                return y_ + (is_bar ? lead_.bar : lead_.step);
            case Above::node:
                break;
        }
        double gap = std::max(half_gap, symbols_.below(from_) + room + 0.05);
        if (is_bar && next != none && !symbols_.is_transition(next)) {
            gap = std::max(gap, symbols_.below(node) + symbols_.above(next) + 0.05);
            next_gap_ = gap;
        } else if (!is_bar && next_gap_ > 0) {
            gap = next_gap_;
            next_gap_ = 0;
        }
        return y_ + gap;
    }

    /// The names of what leads here by links that are cut, left of the link that enters.
    void add_arrivals(std::uint32_t node, double top, bool is_entered) {
        const std::vector<std::uint32_t>& named = symbols_.node(node).named;
        if (named.empty()) return;
        std::string names;
        for (const std::uint32_t from : named) {
            if (!names.empty()) names += ", ";
            names += symbols_.name_at_cut(from, node);
        }
        Pen pen(laid_.shapes, symbols_.link("cut arrival", none, node));
        const double y = top - 0.25;
        pen.line({{-0.6, y}, {0, y}});
        pen.patch({{-0.1, y}, {-0.36, y - 0.1}, {-0.36, y + 0.1}});
        if (!is_entered) pen.line({{0, y}, {0, top}});
        pen.label(plain_text(std::move(names)), {-0.7, y}, Label::Anchor::end, Label::Role::remark);
    }

    /// A simultaneous convergence of the link from above with links that come from elsewhere.
    void join_by_name(std::uint32_t transition) {
        std::vector<Exit> exits;
        if (above_ == Above::node) {
            exits.push_back({false, 0, y_, y_ + symbols_.below(from_), from_});
        } else if (above_ == Above::line) {
            exits.push_back({false, 0, y_, y_, from_});
        }
        converge(exits, transition);
    }

    // -- Branches that come together

    void add_branches(const FlowPiece& fork, std::uint32_t meeting, FlowSequence::End end_kind,
                      std::uint32_t target, bool goes_on) {
        Laid branches = begin_branches(fork);
        std::vector<Exit> exits;
        std::vector<Exit> others;
        const bool come_together =
            goes_on || end_kind == FlowSequence::End::up || end_kind == FlowSequence::End::named;
        for (const Exit& exit : branches.exits) {
            (come_together && !exit.goes_up ? exits : others).push_back(exit);
        }
        branches.exits = std::move(others);
        const bool is_first = above_ != Above::node && laid_.shapes.empty();
        if (is_first) laid_.heads = branches.heads;
        laid_.take(std::move(branches));
        if (!come_together || (exits.empty() && !goes_on)) return;
        y_ = laid_.bottom;
        if (exits.empty() && symbols_.node(meeting).named.empty()) {
            // Nothing that is drawn leads there.
            above_ = Above::nothing;
            y_ += branch_gap;
            return;
        }
        converge(exits, goes_on ? meeting : none, target);
        if (goes_on) return;
        // From the line at which the branches come together, or from the only one that goes on.
        const bool is_alone = above_ == Above::node;
        const std::uint32_t from = is_alone ? from_ : none;
        const double clear = is_alone ? exits.front().clear : y_;
        if (end_kind == FlowSequence::End::up) {
            go_up({true, 0, y_, is_alone ? clear : y_ + 0.3, from, target});
        } else {
            draw_cut(symbols_, laid_, {false, 0, y_, clear, from, target});
        }
    }

    /// The branches, with the line that they begin at.
    Laid begin_branches(const FlowPiece& fork) {
        std::vector<std::uint32_t> heads;
        for (const FlowSequence& branch : fork.branches) add_heads(branch, heads);
        if (above_ != Above::node) {
            // Nothing between this line and the one above: they are one.
            Laid branches = lay_branches(symbols_, fork.branches, lead_, from_);
            branches.shift(0, y_);
            return branches;
        }
        const Lead lead = lead_for(symbols_, heads);
        const double line = line_below();
        Laid branches = lay_branches(symbols_, fork.branches, lead, from_);
        const bool is_double = symbols_.is_transition(from_);
        branches.shift(0, line + (is_double ? double_gap : 0));
        draw_divergence(line, branches.heads.front(), branches.heads.back());
        return branches;
    }

    /// Where a line of branches stands below the node.
    double line_below() {
        return y_ + (symbols_.is_transition(from_) ? std::max(0.4, symbols_.below(from_) + 0.1)
                                                   : std::max(0.3, symbols_.below(from_) + 0.1));
    }

    void draw_divergence(double line, double left, double right) {
        const bool is_double = symbols_.is_transition(from_);
        Pen(laid_.shapes, symbols_.link("link", from_, none)).line({{0, y_}, {0, line}});
        draw_line("divergence", from_, none, is_double, line, std::min(left, 0.0),
                  std::max(right, 0.0));
    }

    /// The line below `from`, or above `to`, where branches begin or come together.
    void draw_line(const std::string& kind, std::uint32_t from, std::uint32_t to, bool is_double,
                   double y, double left, double right) {
        Pen pen(laid_.shapes, symbols_.link(kind + (is_double ? " and" : " or"), from, to));
        if (!is_double) {
            pen.line({{left, y}, {right, y}});
            return;
        }
        for (const double line : {y, y + double_gap}) {
            pen.line({{left - overhang, line}, {right + overhang, line}}, Line::Weight::frame);
        }
    }

    /// Lets ends of branches come together on the axis, over a step or a transition, or over a link
    /// (`meeting` none) that leads back up to `target`.
    void converge(const std::vector<Exit>& exits, std::uint32_t meeting,
                  std::uint32_t target = none) {
        const bool is_double = meeting != none && symbols_.is_transition(meeting);
        const std::uint32_t to = meeting != none ? meeting : target;
        const std::vector<std::uint32_t> no_names;
        const std::vector<std::uint32_t>& named =
            is_double ? symbols_.node(meeting).named : no_names;
        if (is_plain(exits, named)) {
            y_ = exits.front().y;
            from_ = exits.front().from;
            above_ = Above::node;
            is_joined_ = true;
            return;
        }
        double line = y_;
        for (const Exit& exit : exits) line = std::max(line, exit.clear);
        if (is_double) line += named.empty() ? 0.3 : 1.05;
        double left = 0;
        double right = 0;
        for (const Exit& exit : exits) {
            left = std::min(left, exit.x);
            right = std::max(right, exit.x);
            if (exit.y < line) {
                Pen(laid_.shapes, symbols_.link("link", exit.from, to))
                    .line({{exit.x, exit.y}, {exit.x, line}});
            }
        }
        bool is_alone = exits.empty();
        double last_name = right;
        for (const std::uint32_t from : named) {
            const double half = width_of(plain_text(symbols_.name_at_cut(from, meeting))) / 2;
            if (!is_alone) right = std::max(right + 1.2, last_name + half + 0.3);
            add_arrival_from_above(from, meeting, right, line);
            last_name = right + half;
            is_alone = false;
        }
        if (exits.size() + named.size() > 1 || left != right) {
            draw_line("convergence", none, to, is_double, line, left, right);
            if (is_double) line += double_gap;
        }
        y_ = line;
        above_ = Above::line;
        from_ = none;
        is_joined_ = true;
        lead_ = meeting != none ? lead_for(symbols_, {meeting}) : Lead{};
        laid_.bottom = std::max(laid_.bottom, line);
    }

    /// One branch goes on, and no other is longer: nothing comes together, and the next node
    /// follows as if there were no branches.
    bool is_plain(const std::vector<Exit>& exits, const std::vector<std::uint32_t>& named) const {
        return exits.size() == 1 && named.empty() && exits.front().x == 0 &&
               exits.front().from != none && laid_.bottom <= exits.front().clear;
    }

    void add_arrival_from_above(std::uint32_t from, std::uint32_t to, double x, double line) {
        Pen pen(laid_.shapes, symbols_.link("cut arrival", from, to));
        pen.line({{x, line - 0.5}, {x, line}});
        pen.label(plain_text(symbols_.name_at_cut(from, to)), {x, line - 0.72},
                  Label::Anchor::middle, Label::Role::remark);
    }

    // -- Branches beside the line

    void begin_side_branches(const FlowPiece& piece, const std::vector<FlowPiece>& pieces,
                             std::size_t next) {
        std::vector<std::uint32_t> heads;
        for (const auto* list : {&piece.before, &piece.after}) {
            for (const FlowSequence& branch : *list) add_heads(branch, heads);
        }
        if (next < pieces.size() && pieces[next].node != none) heads.push_back(pieces[next].node);
        const Lead lead = lead_for(symbols_, heads);
        const double line = line_below();
        const bool is_double = symbols_.is_transition(from_);
        Pen(laid_.shapes, symbols_.link("link", from_, none)).line({{0, y_}, {0, line}});
        sides_.push_back({line, &piece, lead});
        y_ = line + (is_double ? double_gap : 0);
        above_ = Above::line;
        lead_ = lead;
        next_gap_ = 0;
    }

    /// Beside all that stands there already, the nearest to the line first.
    void add_side_branches(const Side& side) {
        const FlowPiece& piece = *side.piece;
        const bool is_double = symbols_.is_transition(piece.node);
        double left = 0;
        double right = 0;
        for (auto branch = piece.before.rbegin(); branch != piece.before.rend(); ++branch) {
            left = add_side_branch(*branch, side, is_double, -1);
        }
        for (const FlowSequence& branch : piece.after) {
            right = add_side_branch(branch, side, is_double, 1);
        }
        draw_line("divergence", piece.node, none, is_double, side.y, left, right);
    }

    /// Returns the x of its outermost link.
    double add_side_branch(const FlowSequence& branch, const Side& side, bool is_double,
                           double direction) {
        Laid laid = lay_sequence(symbols_, branch, side.lead, side.piece->node);
        const Bounds bounds = laid.extent();
        double axis = direction * branch_pitch;
        const auto pass = [&](const Bounds& there) {
            if (there.bottom < side.y - 0.1 || there.top > side.y + laid.bottom + 0.3) return;
            axis = direction < 0 ? std::min(axis, there.left - branch_gap - bounds.right)
                                 : std::max(axis, there.right + branch_gap - bounds.left);
        };
        for (const Shape& shape : laid_.shapes) pass(shape.bounds);
        for (const Exit& exit : laid_.exits) {
            if (exit.goes_up) pass(exit.name);
        }
        laid.shift(axis, side.y + (is_double ? double_gap : 0));
        const double outermost = direction < 0 ? laid.heads.front() : laid.heads.back();
        laid_.take(std::move(laid));
        return outermost;
    }

    // -- Ends

    void end(const FlowSequence& sequence) {
        const bool is_bar = from_ != none && above_ == Above::node && symbols_.is_transition(from_);
        const double room = above_ == Above::node ? symbols_.below(from_) : 0;
        const double clear = y_ + (is_bar ? std::max(half_gap, room + 0.05) : room);
        const Exit exit{
            sequence.end == FlowSequence::End::up, 0, y_, clear, from_, sequence.target};
        switch (sequence.end) {
            case FlowSequence::End::stops:
                break;
            case FlowSequence::End::into:
                laid_.exits.push_back(exit);
                laid_.bottom = std::max(laid_.bottom, clear);
                break;
            case FlowSequence::End::up:
                go_up({true, 0, y_, std::max(clear, y_ + 0.3), from_, sequence.target});
                break;
            case FlowSequence::End::named:
                draw_cut(symbols_, laid_, exit);
                break;
        }
    }

    /// Leaves room for the name that has to be written if no way up is found.
    void go_up(const Exit& exit) {
        const Text name = plain_text(symbols_.name_at_cut(exit.target, exit.from));
        const double half = width_of(name) / 2;
        laid_.exits.push_back(exit);
        laid_.exits.back().name = {-half, exit.clear, half, exit.clear + label_room};
        laid_.bottom = std::max(laid_.bottom, exit.clear + label_room);
    }

    /// The shortest first: longer ones go round them.
    void draw_returns() {
        std::vector<Exit> others;
        std::vector<Exit> returns;
        for (const Exit& exit : laid_.exits) {
            const bool is_here = exit.goes_up && targets_.contains(exit.target);
            (is_here ? returns : others).push_back(exit);
        }
        std::stable_sort(returns.begin(), returns.end(), [&](const Exit& a, const Exit& b) {
            return a.y - targets_[a.target].top < b.y - targets_[b.target].top;
        });
        for (auto exit = returns.begin(); exit != returns.end(); ++exit) {
            // The names of those that wait may still be written.
            laid_.exits = others;
            laid_.exits.insert(laid_.exits.end(), exit + 1, returns.end());
            if (!draw_link_up(symbols_, laid_, *exit, targets_[exit->target])) {
                draw_cut(symbols_, laid_, *exit);
            }
        }
        laid_.exits = std::move(others);
    }

    FlowSymbols& symbols_;
    Laid laid_;
    std::map<std::uint32_t, Target> targets_;
    std::vector<Side> sides_;

    // Where the next piece goes.
    Above above_ = Above::nothing;
    double y_ = 0;            ///< of the line, the bar or the lower edge of the step above
    Lead lead_;               ///< below a line
    std::uint32_t from_;      ///< the node above; none where several come together
    double next_gap_ = 0;     ///< between the bar and the step that follows it
    bool is_joined_ = false;  ///< the links that lead to the next node have come together
};

Laid lay_sequence(FlowSymbols& symbols, const FlowSequence& sequence, const Lead& lead,
                  std::uint32_t from) {
    return SequenceLayout(symbols, lead, from).lay(sequence);
}

/// Links back up that found no way in any sequence.
void cut_open_links(FlowSymbols& symbols, Laid& laid) {
    for (const Exit& exit : laid.exits) {
        if (exit.goes_up) draw_cut(symbols, laid, exit);
    }
    laid.exits.clear();
}

}  // namespace

LaidOutBlock lay_out(const ChartFlow& flow, const std::vector<const FlowSequence*>& sequences,
                     const SheetOfNode& sheets, SymbolMaker& maker, Language language,
                     Scene& scene) {
    FlowSymbols symbols(flow, sheets, maker, language, scene);
    for (const FlowSequence* sequence : sequences) symbols.mark_returns(*sequence);
    Lead lead;
    lead.has_line = false;
    LaidOutBlock block;
    double right = 0;
    for (std::size_t i = 0; i < sequences.size(); ++i) {
        Laid laid = lay_sequence(symbols, *sequences[i], lead, none);
        cut_open_links(symbols, laid);
        const Bounds bounds = laid.extent();
        const double axis = i == 0 ? 0 : right + 1 - bounds.left;
        laid.shift(axis, 0);
        right = axis + bounds.right;
        block.shapes.insert(block.shapes.end(), laid.shapes.begin(), laid.shapes.end());
    }
    block.bounds = bounds_of(block.shapes);
    return block;
}

}  // namespace grafwire
