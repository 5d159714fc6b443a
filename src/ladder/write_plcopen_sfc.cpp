// The SFC body. Elements are made first, all of them, because each refers to those before it by
// number, loops included; then they are connected.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "grafcet/write_grafcet.h"
#include "ladder/plcopen_parts.h"
#include "ladder/sfc_actions.h"
#include "ladder/sfc_layout.h"
#include "ladder/structured_text.h"

namespace grafwire::ladder {

namespace {

constexpr int column_width = 280;
constexpr int level_height = 180;
constexpr int step_width = 70;
constexpr int step_height = 40;

/// An element of the chart: where it is, and what comes out of it below.
struct Cell {
    pugi::xml_node node;
    Point corner;
    int width = 0;
    int height = 0;
    Outlet below() const {
        return {PlcopenBody::id_of(node), "", {corner.x + width / 2, corner.y + height}};
    }
    Point above() const { return {corner.x + width / 2, corner.y}; }
};

class SfcBody {
  public:
    SfcBody(const Grafcet& grafcet, pugi::xml_node body)
        : grafcet_(grafcet),
          names_(sfc_names(grafcet)),
          layout_(sfc_layout(grafcet)),
          body_(body) {}

    void write() {
        write_observer();
        make_elements();
        for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) connect_step(StepId{s});
        for (std::uint32_t t = 0; t < grafcet_.transitions.size(); ++t) {
            connect_transition(TransitionId{t});
        }
        write_remarks();
    }

  private:
    Cell make(const char* name, Point middle, int width, int height);
    Point middle_of(const SfcLayout::Place& place) const {
        return {140 + column_width * place.column, 240 + level_height * place.level};
    }
    void make_elements();
    void write_observer();
    void connect_step(StepId id);
    void connect_transition(TransitionId id);
    void connect_bar(const Cell& cell, const std::vector<Outlet>& sources,
                     const std::vector<Point>& ends, bool named_outlets);
    void write_remarks();
    std::vector<SfcLayout::Link> joined(StepId id) const;
    /// What the transition hangs on: a step, or the bar of a selection below it.
    Outlet out_of(StepId id) const;
    Outlet out_of(TransitionId id) const;

    const Grafcet& grafcet_;
    SfcNames names_;
    SfcLayout layout_;
    PlcopenBody body_;
    std::vector<Cell> steps_;
    std::vector<Cell> transitions_;
    std::map<StepId, Cell> selections_;    ///< below steps with several transitions
    std::map<StepId, Cell> convergences_;  ///< above steps that several transitions lead to
    std::map<TransitionId, Cell> splits_;  ///< below transitions with several following steps
    std::map<TransitionId, Cell> joins_;   ///< above those with several preceding ones
    std::map<TransitionId, std::vector<Cell>> jumps_;
};

Cell SfcBody::make(const char* name, Point middle, int width, int height) {
    Cell cell;
    cell.corner = {middle.x - width / 2, middle.y};
    cell.width = width;
    cell.height = height;
    cell.node = body_.element(name, cell.corner, width, height);
    return cell;
}

std::vector<SfcLayout::Link> SfcBody::joined(StepId id) const {
    std::vector<SfcLayout::Link> links;
    for (const SfcLayout::Link& link : layout_.into[index_of(id)]) {
        if (!link.is_jump) links.push_back(link);
    }
    return links;
}

void SfcBody::make_elements() {
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        const StepId id{s};
        const Point middle = middle_of(layout_.steps[s]);
        Cell step = make("step", middle, step_width, step_height);
        step.node.append_attribute("name") = names_.steps[s].c_str();
        if (grafcet_.steps[id].initial) step.node.append_attribute("initialStep") = true;
        steps_.push_back(step);
        const auto bar = [&](const char* name, int y) {
            return make(name, {middle.x, middle.y + y}, 60, 1);
        };
        if (layout_.out_of[s].size() > 1) selections_[id] = bar("selectionDivergence", 55);
        if (joined(id).size() > 1) convergences_[id] = bar("selectionConvergence", -20);
    }
    for (std::uint32_t t = 0; t < grafcet_.transitions.size(); ++t) {
        const TransitionId id{t};
        const Transition& transition = grafcet_.transitions[id];
        const Point middle = middle_of(layout_.transitions[t]);
        transitions_.push_back(make("transition", {middle.x, middle.y + 90}, 20, 2));
        const auto bar = [&](const char* name, int y) {
            return make(name, {middle.x, middle.y + y}, 60, 3);
        };
        if (transition.preceding_count > 1) joins_[id] = bar("simultaneousConvergence", 72);
        if (transition.following_count > 1) splits_[id] = bar("simultaneousDivergence", 108);
        int offset = 0;
        for (const StepId step : grafcet_.following(transition)) {
            for (const SfcLayout::Link& link : layout_.into[index_of(step)]) {
                if (link.transition != id || !link.is_jump) continue;
                Cell jump = make("jumpStep", {middle.x + offset, middle.y + 122}, 12, 14);
                jump.node.append_attribute("targetName") = names_.steps[index_of(step)].c_str();
                jumps_[id].push_back(jump);
                offset += 40;
            }
        }
    }
}

Outlet SfcBody::out_of(StepId id) const {
    const auto bar = selections_.find(id);
    return bar == selections_.end() ? steps_[index_of(id)].below() : bar->second.below();
}

Outlet SfcBody::out_of(TransitionId id) const {
    const auto bar = splits_.find(id);
    return bar == splits_.end() ? transitions_[index_of(id)].below() : bar->second.below();
}

/// A bar: where it is fed from, and an outlet for each of what hangs on it.
void SfcBody::connect_bar(const Cell& cell, const std::vector<Outlet>& sources,
                          const std::vector<Point>& ends, bool named_outlets) {
    const bool converges = sources.size() > 1;
    if (converges) {
        for (const Outlet& source : sources) {
            PlcopenBody::inlet(cell.node, cell.corner, cell.above(), {source});
        }
    } else {
        PlcopenBody::inlet(cell.node, cell.corner, cell.above(), sources);
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
        PlcopenBody::outlet(cell.node, cell.corner, cell.below().at, named_outlets);
    }
}

void SfcBody::connect_step(StepId id) {
    const Cell& cell = steps_[index_of(id)];
    std::vector<Outlet> sources;
    for (const SfcLayout::Link& link : joined(id)) sources.push_back(out_of(link.transition));
    const auto convergence = convergences_.find(id);
    if (convergence != convergences_.end()) {
        connect_bar(convergence->second, sources, {Point()}, false);
        sources = {convergence->second.below()};
    }
    if (!sources.empty()) PlcopenBody::inlet(cell.node, cell.corner, cell.above(), sources);
    PlcopenBody::outlet(cell.node, cell.corner, cell.below().at, true);
    const Point side{cell.corner.x + cell.width, cell.corner.y + cell.height / 2};
    if (has_sfc_actions(grafcet_, names_, id)) {
        PlcopenBody::outlet(cell.node, cell.corner, side, true, "connectionPointOutAction");
        write_sfc_actions(grafcet_, names_, id, {PlcopenBody::id_of(cell.node), "", side}, body_);
    }
    const auto selection = selections_.find(id);
    if (selection == selections_.end()) return;
    connect_bar(selection->second, {cell.below()},
                std::vector<Point>(layout_.out_of[index_of(id)].size()), true);
}

void SfcBody::connect_transition(TransitionId id) {
    const Transition& transition = grafcet_.transitions[id];
    const Cell& cell = transitions_[index_of(id)];
    std::vector<Outlet> sources;
    for (const StepId step : grafcet_.preceding(transition)) sources.push_back(out_of(step));
    const auto join = joins_.find(id);
    if (join != joins_.end()) {
        connect_bar(join->second, sources, {Point()}, false);
        sources = {join->second.below()};
    }
    if (!sources.empty()) PlcopenBody::inlet(cell.node, cell.corner, cell.above(), sources);
    PlcopenBody::outlet(cell.node, cell.corner, cell.below().at);
    pugi::xml_node node = cell.node;
    pugi::xml_node condition = node.append_child("condition").append_child("inline");
    condition.append_attribute("name") = "";
    add_text(condition.append_child("ST"),
             structured_text(grafcet_, names_, transition.receptivity));
    add_text(node.append_child("documentation"),
             fmt::format("({}) {}", quoted_where_needed(transition.name),
                         write_expression(grafcet_, grafcet_.expressions, transition.receptivity)));
    if (const auto split = splits_.find(id); split != splits_.end()) {
        connect_bar(split->second, {cell.below()}, std::vector<Point>(transition.following_count),
                    true);
    }
    for (const Cell& jump : jumps_[id]) {
        PlcopenBody::inlet(jump.node, jump.corner, jump.above(), {out_of(id)});
    }
}

/// Edges and time conditions are worked out by an action of a step that is always active.
void SfcBody::write_observer() {
    const std::string text = observing_text(grafcet_, names_);
    if (text.empty()) return;
    Cell step = make("step", {140, 20}, step_width, step_height);
    step.node.append_attribute("name") = "observe";
    step.node.append_attribute("initialStep") = true;
    PlcopenBody::outlet(step.node, step.corner, step.below().at, true);
    const Point side{step.corner.x + step.width, step.corner.y + step.height / 2};
    PlcopenBody::outlet(step.node, step.corner, side, true, "connectionPointOutAction");
    write_sfc_action_block({{"N", "", "", text}}, {PlcopenBody::id_of(step.node), "", side}, body_);
}

void SfcBody::write_remarks() {
    Point at{140 + column_width * layout_.columns, 20};
    for (const std::string& remark : sfc_remarks(grafcet_, names_)) {
        body_.comment(at, 500, remark);
        at.y += 30;
    }
}

}  // namespace

void write_sfc_body(const Grafcet& grafcet, pugi::xml_node body) {
    SfcBody(grafcet, body).write();
}

}  // namespace grafwire::ladder
