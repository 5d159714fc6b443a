// The SFC body. Elements are made first, all of them, because each refers to those before it by
// number, loops included; then they are connected.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "grafcet/write_grafcet.h"
#include "plcopen/bodies.h"
#include "sfc/actions.h"
#include "sfc/layout.h"
#include "sfc/messages.h"
#include "sfc/remarks.h"
#include "sfc/structured_text.h"

namespace grafwire::plcopen {

namespace {

constexpr int column_width = 280;
constexpr int level_height = 180;
constexpr int step_width = 70;
constexpr int step_height = 40;
constexpr int observer_height = 100;  ///< with what is left free below it

/// An element of the chart: where it is, and what comes out of it below.
struct Cell {
    pugi::xml_node node;
    Point corner;
    int width = 0;
    int height = 0;
    Outlet below() const {
        return {Body::id_of(node), "", {corner.x + width / 2, corner.y + height}};
    }
    /// Of a bar: straight above column x.
    Outlet below_at(int x) const { return {Body::id_of(node), "", {x, corner.y + height}}; }
    Point above() const { return {corner.x + width / 2, corner.y}; }
};

/// An action block beside a step, a row per action, which hangs on the outlet of the step for
/// actions.
void write_action_block(const std::vector<sfc::ActionBlockEntry>& actions, const Outlet& source,
                        Body& body) {
    constexpr int row = 30;
    const Point corner{source.at.x + 30, source.at.y - row / 2};
    const int height = row * static_cast<int>(actions.size());
    pugi::xml_node block = body.element("actionBlock", corner, 130, height);
    Body::inlet(block, corner, {corner.x, source.at.y}, {source});
    int y = 0;
    for (const sfc::ActionBlockEntry& action : actions) {
        pugi::xml_node node = block.append_child("action");
        node.append_attribute("localId") = body.new_id();
        node.append_attribute("qualifier") = action.qualifier.c_str();
        if (!action.duration.empty()) {
            node.append_attribute("duration") = action.duration.c_str();
        }
        pugi::xml_node place = node.append_child("relPosition");
        place.append_attribute("x") = 0;
        place.append_attribute("y") = y;
        y += row;
        if (!action.reference.empty()) {
            node.append_child("reference").append_attribute("name") = action.reference.c_str();
        } else {
            add_text(node.append_child("inline").append_child("ST"), action.statements);
        }
    }
}

class SfcBody {
  public:
    SfcBody(const sfc::Plan& plan, const sfc::Names& names, Language language, pugi::xml_node body)
        : plan_(plan),
          chart_(plan.chart),
          names_(names),
          language_(language),
          text_(plan, names),
          layout_(sfc::layout_of(chart_)),
          body_(body) {}

    /// The observer stands last, and so does its action: actions are executed in the order of the
    /// file, and a compiler knows the flag of a step only below it.
    void write() {
        if (plan_.has_observer()) top_ += observer_height;
        make_elements();
        for (std::uint32_t s = 0; s < chart_.step_count(); ++s) connect_step(StepId{s});
        for (std::uint32_t t = 0; t < chart_.transition_count(); ++t) {
            connect_transition(TransitionId{t});
        }
        write_remarks();
        if (plan_.has_observer()) write_observer();
    }

  private:
    Cell make(const char* name, Point middle, int width, int height);
    Point middle_of(const sfc::Layout::Place& place) const {
        return {140 + column_width * place.column, top_ + level_height * place.level};
    }
    int column_of(StepId id) const { return middle_of(layout_.steps[index_of(id)]).x; }
    int column_of(TransitionId id) const { return middle_of(layout_.transitions[index_of(id)]).x; }
    void make_elements();
    void make_transition(TransitionId id);
    void write_observer();
    void write_actions(const Cell& step, const std::vector<sfc::ActionBlockEntry>& actions);
    void connect_step(StepId id);
    void connect_transition(TransitionId id);
    void write_condition(TransitionId id);
    /// A horizontal bar at a height, as wide as what meets there.
    Cell make_bar(const char* name, std::vector<int> ends, int y, int thickness);
    static void connect_bar(const Cell& bar, const std::vector<Outlet>& sources,
                            const std::vector<int>& ends, bool named_outlets);
    void write_remarks();
    std::vector<sfc::Layout::Link> joined(StepId id) const;
    /// The transitions that hang on the selection below a step. Those with other steps before them
    /// as well hang on the step itself: tools know no bar of a selection above a bar that joins.
    std::vector<TransitionId> selected_after(StepId id) const;
    /// What a transition or step at column x hangs on: what is before it, or the bar below that.
    Outlet out_of(StepId id, int x) const;
    Outlet out_of(TransitionId id, int x) const;

    const sfc::Plan& plan_;
    const sfc::Chart& chart_;
    const sfc::Names& names_;
    Language language_;
    sfc::StructuredText text_;
    sfc::Layout layout_;
    Body body_;
    int top_ = 60;  ///< of the first level
    std::vector<Cell> steps_;
    std::vector<Cell> transitions_;
    std::map<StepId, Cell> selections_;    ///< below steps with several transitions of their own
    std::map<StepId, Cell> convergences_;  ///< above steps that several transitions lead to
    std::map<TransitionId, Cell> splits_;  ///< below transitions with several following steps
    std::map<TransitionId, Cell> joins_;   ///< above those with several preceding ones
    std::map<TransitionId, std::vector<Cell>> jumps_;
};

Cell SfcBody::make(const char* name, Point middle, int width, int height) {
    const Point corner{middle.x - width / 2, middle.y};
    return {body_.element(name, corner, width, height), corner, width, height};
}

std::vector<sfc::Layout::Link> SfcBody::joined(StepId id) const {
    std::vector<sfc::Layout::Link> links;
    for (const sfc::Layout::Link& link : layout_.into[index_of(id)]) {
        if (!link.is_jump) links.push_back(link);
    }
    return links;
}

std::vector<TransitionId> SfcBody::selected_after(StepId id) const {
    std::vector<TransitionId> selected;
    for (const TransitionId next : layout_.out_of[index_of(id)]) {
        if (chart_.preceding(next).size() == 1) selected.push_back(next);
    }
    return selected;
}

Cell SfcBody::make_bar(const char* name, std::vector<int> ends, int y, int thickness) {
    const auto [left, right] = std::minmax_element(ends.begin(), ends.end());
    constexpr int overhang = 10;
    const int middle = (*left + *right) / 2;
    return make(name, {middle, y}, *right - *left + 2 * overhang, thickness);
}

void SfcBody::make_elements() {
    for (std::uint32_t s = 0; s < chart_.step_count(); ++s) {
        const StepId id{s};
        const Point middle = middle_of(layout_.steps[s]);
        Cell step = make("step", middle, step_width, step_height);
        step.node.append_attribute("name") = names_.steps[s].c_str();
        if (chart_.is_initial(id)) step.node.append_attribute("initialStep") = true;
        steps_.push_back(step);
        std::vector<int> below{middle.x};
        std::vector<int> above{middle.x};
        for (const TransitionId next : selected_after(id)) below.push_back(column_of(next));
        for (const sfc::Layout::Link& link : joined(id))
            above.push_back(column_of(link.transition));
        if (below.size() > 2) {
            selections_[id] = make_bar("selectionDivergence", below, middle.y + 60, 1);
        }
        if (above.size() > 2) {
            convergences_[id] = make_bar("selectionConvergence", above, middle.y - 20, 1);
        }
    }
    for (std::uint32_t t = 0; t < chart_.transition_count(); ++t) make_transition(TransitionId{t});
}

void SfcBody::make_transition(TransitionId id) {
    const Point middle = middle_of(layout_.transitions[index_of(id)]);
    transitions_.push_back(make("transition", {middle.x, middle.y + 90}, 20, 2));
    std::vector<int> above{middle.x};
    std::vector<int> below{middle.x};
    for (const StepId step : chart_.preceding(id)) above.push_back(column_of(step));
    int jump_x = middle.x;
    for (const StepId step : chart_.following(id)) {
        const std::vector<sfc::Layout::Link>& links = layout_.into[index_of(step)];
        const bool is_jump = std::any_of(links.begin(), links.end(), [&](const auto& link) {
            return link.transition == id && link.is_jump;
        });
        if (!is_jump) {
            below.push_back(column_of(step));
            continue;
        }
        Cell jump = make("jumpStep", {jump_x, middle.y + 122}, 12, 14);
        jump.node.append_attribute("targetName") = names_.steps[index_of(step)].c_str();
        jumps_[id].push_back(jump);
        below.push_back(jump_x);
        jump_x += 60;
    }
    if (chart_.preceding(id).size() > 1) {
        joins_[id] = make_bar("simultaneousConvergence", above, middle.y + 75, 3);
    }
    if (chart_.following(id).size() > 1) {
        splits_[id] = make_bar("simultaneousDivergence", below, middle.y + 106, 3);
    }
}

Outlet SfcBody::out_of(StepId id, int x) const {
    const auto bar = selections_.find(id);
    if (bar == selections_.end()) return steps_[index_of(id)].below();
    return bar->second.below_at(x);
}

Outlet SfcBody::out_of(TransitionId id, int x) const {
    const auto bar = splits_.find(id);
    if (bar == splits_.end()) return transitions_[index_of(id)].below();
    return bar->second.below_at(x);
}

/// A bar with what leads to it, each straight from above, and the columns of what hangs on it.
void SfcBody::connect_bar(const Cell& bar, const std::vector<Outlet>& sources,
                          const std::vector<int>& ends, bool named_outlets) {
    for (const Outlet& source : sources) {
        Body::inlet(bar.node, bar.corner, {source.at.x, bar.corner.y}, {source});
    }
    for (const int x : ends) {
        Body::outlet(bar.node, bar.corner, bar.below_at(x).at, named_outlets);
    }
}

void SfcBody::connect_step(StepId id) {
    const Cell& cell = steps_[index_of(id)];
    const int x = cell.above().x;
    std::vector<Outlet> sources;
    const auto convergence = convergences_.find(id);
    for (const sfc::Layout::Link& link : joined(id)) {
        const bool is_alone = convergence == convergences_.end();
        sources.push_back(out_of(link.transition, is_alone ? x : column_of(link.transition)));
    }
    if (convergence != convergences_.end()) {
        connect_bar(convergence->second, sources, {x}, false);
        sources = {convergence->second.below_at(x)};
    }
    if (!sources.empty()) Body::inlet(cell.node, cell.corner, cell.above(), sources);
    Body::outlet(cell.node, cell.corner, cell.below().at, true);
    const std::vector<sfc::ActionBlockEntry> actions = sfc::actions_of(plan_, names_, id);
    if (!actions.empty()) write_actions(cell, actions);
    const std::string notes = sfc::notes_of(plan_, names_, id, language_);
    pugi::xml_node node = cell.node;
    if (!notes.empty()) add_text(node.append_child("documentation"), notes);
    const auto selection = selections_.find(id);
    if (selection == selections_.end()) return;
    std::vector<int> ends;
    for (const TransitionId next : selected_after(id)) ends.push_back(column_of(next));
    connect_bar(selection->second, {cell.below()}, ends, true);
}

void SfcBody::connect_transition(TransitionId id) {
    const Cell& cell = transitions_[index_of(id)];
    const int x = cell.above().x;
    std::vector<Outlet> sources;
    const auto join = joins_.find(id);
    for (const StepId step : chart_.preceding(id)) {
        const bool is_joined = join != joins_.end();
        sources.push_back(is_joined ? steps_[index_of(step)].below() : out_of(step, x));
    }
    if (join != joins_.end()) {
        connect_bar(join->second, sources, {x}, false);
        sources = {join->second.below_at(x)};
    }
    if (!sources.empty()) Body::inlet(cell.node, cell.corner, cell.above(), sources);
    Body::outlet(cell.node, cell.corner, cell.below().at);
    write_condition(id);
    const auto split = splits_.find(id);
    std::vector<int> ends;
    for (const StepId step : chart_.following(id)) {
        for (const sfc::Layout::Link& link : joined(step)) {
            if (link.transition != id) continue;
            const bool converges = convergences_.count(step) > 0;
            ends.push_back(converges ? column_of(id) : column_of(step));
        }
    }
    for (const Cell& jump : jumps_[id]) {
        const Point above = jump.above();
        Body::inlet(jump.node, jump.corner, above, {out_of(id, above.x)});
        ends.push_back(above.x);
    }
    if (split != splits_.end()) connect_bar(split->second, {cell.below()}, ends, true);
}

void SfcBody::write_condition(TransitionId id) {
    const Grafcet& grafcet = *plan_.grafcet;
    pugi::xml_node node = transitions_[index_of(id)].node;
    pugi::xml_node condition = node.append_child("condition").append_child("inline");
    condition.append_attribute("name") = "";
    pugi::xml_node text = condition.append_child("ST");
    pugi::xml_node documentation = node.append_child("documentation");
    if (index_of(id) >= grafcet.transitions.size()) {
        const std::string& step = names_.steps[index_of(chart_.following(id).front())];
        add_text(text, "FALSE");
        return add_text(documentation, messages::sfc::not_reached.in(language_, step));
    }
    const Transition& transition = grafcet.transitions[id];
    add_text(text, text_.expression(transition.condition, sfc::reading_before_evolution));
    add_text(documentation,
             fmt::format("({}) {}", quoted_where_needed(transition.name),
                         write_expression(grafcet, grafcet.expressions, transition.condition)));
}

/// Above the chart on paper.
void SfcBody::write_observer() {
    Cell observer = make("step", {140, 20}, step_width, step_height);
    observer.node.append_attribute("name") = names_.observer.c_str();
    observer.node.append_attribute("initialStep") = true;
    Body::outlet(observer.node, observer.corner, observer.below().at, true);
    write_actions(observer, {{"N", "", "", observer_text(plan_, names_, language_)}});
}

/// An action block to the right of a step.
void SfcBody::write_actions(const Cell& step, const std::vector<sfc::ActionBlockEntry>& actions) {
    const Point side{step.corner.x + step.width, step.corner.y + step.height / 2};
    Body::outlet(step.node, step.corner, side, true, "connectionPointOutAction");
    write_action_block(actions, {Body::id_of(step.node), "", side}, body_);
}

void SfcBody::write_remarks() {
    Point at{140 + column_width * layout_.columns, 20};
    for (const sfc::Remark& remark : sfc::remarks_of(plan_, names_)) {
        body_.comment(at, 500, remark.text.in(language_));
        at.y += 30;
    }
}

}  // namespace

void write_sfc_body(const sfc::Plan& plan, const sfc::Names& names, Language language,
                    pugi::xml_node body) {
    SfcBody(plan, names, language, body).write();
}

}  // namespace grafwire::plcopen
