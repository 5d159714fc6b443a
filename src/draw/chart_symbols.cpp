// Proportions: a step is one unit high; the bar of a transition is half a unit long; rectangles of
// actions are 0.7 high and stand 0.45 right of their step. They are those of printed course sheets
// and of the LaTeX package `grafcet` (CTAN), in which a step is 2.5 em.

#include "draw/chart_symbols.h"

#include <algorithm>
#include <utility>

#include "draw/messages.h"
#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

constexpr double action_gap = 0.45;
constexpr double action_height = 0.7;
constexpr double action_top = (step_height - action_height) / 2;
constexpr double line_pitch = 0.44;
/// Conditions are broken into lines no wider than this, and actions in a row go no further.
constexpr double widest_condition = 6;
constexpr double widest_row = 4;
/// Above an action: its condition or event.
constexpr double condition_room = 0.52;

}  // namespace

/// An action as it is drawn.
struct SymbolMaker::ActionBox {
    enum class Mark : std::uint8_t { unmarked, condition, activation, deactivation, event };
    Text text;
    Mark mark = Mark::unmarked;
    Text above;  ///< the condition or event
    bool is_order = false;
    double width = 0;

    bool has_room_above() const { return mark != Mark::unmarked && mark != Mark::deactivation; }
    bool is_marked() const { return mark != Mark::unmarked; }
};

bool SymbolMaker::is_linked(StepId step) const {
    return std::any_of(grafcet_.enclosures.begin(), grafcet_.enclosures.end(),
                       [&](const Enclosure& enclosure) {
                           return std::find(enclosure.links.begin(), enclosure.links.end(), step) !=
                                  enclosure.links.end();
                       });
}

/// What draws a mark that a page shows or hides.
Pen SymbolMaker::token_pen(Symbol& symbol, std::pair<std::string, std::string> fact) {
    return {symbol.shapes, scene_.owners.add({"token", {std::move(fact)}, {}})};
}

Symbol SymbolMaker::step(StepId id) {
    const Step& step = grafcet_.steps[id];
    const std::vector<bool>& active = how_.situation.active;
    const bool is_active = !active.empty() && active[index_of(id)];
    Symbol symbol;
    Owner owner{"step", {{"step", step.name}}, {}};
    if (step.initial) owner.kind += " initial";
    if (step.enclosure != none) owner.kind += " enclosing";
    if (is_active) owner.kind += " active";
    owner.title =
        (is_active ? messages::draw::active_step(step.name) : messages::draw::step(step.name))
            .in(how_.language);
    Pen pen(symbol.shapes, scene_.owners.add(std::move(owner)));

    const Text name = plain_text(step.name);
    const double half = std::max(0.5, width_of(name, Label::Role::name) / 2 + 0.2);
    Bounds inner{-half, 0, half, step_height};
    pen.rectangle(inner);
    if (step.initial) {
        constexpr double inset = 0.12;
        inner = {inner.left + inset, inner.top + inset, inner.right - inset, inner.bottom - inset};
        pen.rectangle(inner, false);
    }
    if (step.enclosure != none) {
        constexpr double cut = 0.2;
        const auto corner = [&](double x, double dx, double y, double dy) {
            pen.line({{x, y + dy}, {x + dx, y}}, Line::Weight::thin);
        };
        corner(inner.left, cut, inner.top, cut);
        corner(inner.right, -cut, inner.top, cut);
        corner(inner.left, cut, inner.bottom, -cut);
        corner(inner.right, -cut, inner.bottom, -cut);
    }
    const bool has_dot = is_active || how_.animated;
    pen.label(name, {0, has_dot ? 0.4 : 0.5}, Label::Anchor::middle, Label::Role::name);
    if (is_active) pen.dot({0, 0.74}, 0.09);
    if (how_.animated) token_pen(symbol, {"step", step.name}).dot({0, 0.74}, 0.09);
    if (is_linked(id)) {
        pen.label(plain_text("*"), {-half - 0.3, 0.5}, Label::Anchor::middle, Label::Role::title);
    }
    add_actions(symbol, step, half);
    return symbol;
}

Symbol SymbolMaker::macro(MacroId id) {
    const Macro& macro = grafcet_.macros[id];
    const std::vector<bool>& active = how_.situation.active;
    bool is_active = false;
    for (const StepId step : macro.steps) {
        is_active = is_active || (!active.empty() && active[index_of(step)]);
    }
    Symbol symbol;
    Owner owner{"macro-step", {{"macro", macro.name}}, {}};
    if (is_active) owner.kind += " active";
    owner.title = messages::draw::macro_step(macro.name).in(how_.language);
    Pen pen(symbol.shapes, scene_.owners.add(std::move(owner)));
    const Text name = plain_text(macro.name);
    const double half = std::max(0.5, width_of(name, Label::Role::name) / 2 + 0.15);
    constexpr double inset = 0.14;
    pen.rectangle({-half, 0, half, step_height});
    for (const double y : {inset, step_height - inset}) {
        pen.line({{-half, y}, {half, y}}, Line::Weight::frame);
    }
    const bool has_dot = is_active || how_.animated;
    pen.label(name, {0, has_dot ? 0.42 : 0.5}, Label::Anchor::middle, Label::Role::name);
    if (is_active) pen.dot({0, 0.73}, 0.08);
    if (how_.animated) token_pen(symbol, {"macro", macro.name}).dot({0, 0.73}, 0.08);
    return symbol;
}

// ---- Actions

std::vector<SymbolMaker::ActionBox> SymbolMaker::boxes_of(const Step& step) {
    using Mark = ActionBox::Mark;
    std::vector<ActionBox> boxes;
    for (const Action& action : grafcet_.actions_of(step)) {
        ActionBox box;
        switch (action.kind) {
            case ActionKind::continuous:
                box.text = plain_text(grafcet_.outputs[action.output].name);
                break;
            case ActionKind::held:
                box.text = plain_text(grafcet_.vars[action.var].name);
                break;
            case ActionKind::stored:
                box.text = write_on_paper(grafcet_, action.write, how_.sign);
                box.mark = action.trigger == Trigger::activation     ? Mark::activation
                           : action.trigger == Trigger::deactivation ? Mark::deactivation
                                                                     : Mark::event;
                break;
            case ActionKind::order:
                box.text = plain_text(order_on_paper(grafcet_, grafcet_.orders[action.order]));
                box.is_order = true;
                break;
        }
        if (action.expression != no_expr) {
            box.above = condition_on_paper(grafcet_, action.expression, how_.sign);
            if (box.mark != Mark::event) box.mark = Mark::condition;
        }
        box.width = std::max(1.0, width_of(box.text) + (box.is_order ? 0.5 : 0.3));
        boxes.push_back(std::move(box));
    }
    return boxes;
}

void SymbolMaker::add_actions(Symbol& symbol, const Step& step, double right) {
    const std::vector<ActionBox> boxes = boxes_of(step);
    if (boxes.empty()) return;
    const double left = right + action_gap;
    Pen pen(symbol.shapes, scene_.owners.add({"action-link", {{"step", step.name}}, {}}));
    pen.line({{right, step_height / 2}, {left, step_height / 2}});
    double row = 0;
    for (const ActionBox& box : boxes) row += box.width;
    const bool is_row =
        boxes.size() == 1 ||
        (row <= widest_row && std::none_of(boxes.begin(), boxes.end(),
                                           [](const ActionBox& box) { return box.is_marked(); }));
    if (is_row) {
        add_row(symbol, boxes, left);
    } else {
        add_column(symbol, boxes, left);
    }
}

void SymbolMaker::add_row(Symbol& symbol, const std::vector<ActionBox>& boxes, double left) {
    for (const ActionBox& box : boxes) {
        add_box(symbol, box, left, action_top, box.width);
        left += box.width;
        if (box.has_room_above()) symbol.room_above = condition_room - action_top;
        if (box.mark == ActionBox::Mark::deactivation) symbol.room_below = 0.2;
    }
}

/// Edge to edge where nothing stands between them, else each on a link of its own.
void SymbolMaker::add_column(Symbol& symbol, const std::vector<ActionBox>& boxes, double left) {
    const bool is_marked = std::any_of(boxes.begin(), boxes.end(),
                                       [](const ActionBox& box) { return box.is_marked(); });
    double width = 0;
    for (const ActionBox& box : boxes) width = std::max(width, box.width);
    double top = action_top;
    double last_middle = step_height / 2;
    if (boxes.front().has_room_above()) symbol.room_above = condition_room - action_top;
    std::vector<Shape> links;
    const OwnerId owner = scene_.owners.add({"action-link", {}, {}});
    Pen pen(links, owner);
    const double trunk = left - action_gap / 2;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i > 0 && is_marked) top += 0.15 + (boxes[i].has_room_above() ? condition_room : 0);
        add_box(symbol, boxes[i], left, top, width);
        last_middle = top + action_height / 2;
        if (i > 0 && is_marked) pen.line({{trunk, last_middle}, {left, last_middle}});
        top += action_height;
        if (boxes[i].mark == ActionBox::Mark::deactivation) top += 0.3;
    }
    if (is_marked) pen.line({{trunk, step_height / 2}, {trunk, last_middle}});
    symbol.shapes.insert(symbol.shapes.end(), links.begin(), links.end());
    symbol.room_below = std::max(0.0, top - step_height);
}

void SymbolMaker::add_box(Symbol& symbol, const ActionBox& box, double left, double top,
                          double width) {
    using Mark = ActionBox::Mark;
    std::string name;
    for (const TextRun& run : box.text) name += run.text;
    Pen pen(symbol.shapes,
            scene_.owners.add({box.is_order ? "action order" : "action", {{"action", name}}, {}}));
    const double bottom = top + action_height;
    pen.rectangle({left, top, left + width, bottom});
    if (box.is_order) {
        constexpr double inset = 0.09;
        pen.rectangle({left + inset, top + inset, left + width - inset, bottom - inset}, false);
    }
    pen.label(box.text, {left + width / 2, (top + bottom) / 2}, Label::Anchor::middle);
    switch (box.mark) {
        case Mark::unmarked:
            break;
        case Mark::condition:
            pen.line({{left + 0.2, top}, {left + 0.2, top - 0.3}});
            pen.label(box.above, {left + 0.32, top - 0.26}, Label::Anchor::start);
            break;
        case Mark::event:
            pen.line({{left + 0.2, top}, {left + 0.2, top - 0.45}});
            pen.patch({{left + 0.2, top - 0.45}, {left + 0.2, top - 0.21}, {left, top - 0.33}});
            pen.label(box.above, {left + 0.34, top - 0.26}, Label::Anchor::start);
            break;
        case Mark::activation:
            pen.line({{left, top}, {left, top - 0.2}}, Line::Weight::frame);
            pen.arrow_head({left, top - 0.42}, true);
            break;
        case Mark::deactivation:
            pen.line({{left, bottom}, {left, bottom + 0.12}}, Line::Weight::frame);
            pen.arrow_head({left, bottom + 0.34}, false);
            break;
    }
}

// ---- Transitions

Symbol SymbolMaker::transition(TransitionId id) {
    const Transition& transition = grafcet_.transitions[id];
    const ShownSituation& shown = how_.situation;
    const bool is_enabled = !shown.enabled.empty() && shown.enabled[index_of(id)];
    const bool is_clearable = !shown.clearable.empty() && shown.clearable[index_of(id)];
    Symbol symbol;
    Owner owner{"transition", {{"transition", '(' + transition.name + ')'}}, {}};
    if (is_enabled) owner.kind += " enabled";
    if (is_clearable) owner.kind += " clearable";
    owner.title = write_expression(grafcet_, grafcet_.expressions, transition.condition);
    Pen pen(symbol.shapes, scene_.owners.add(std::move(owner)));
    pen.line({{-0.25, 0}, {0.25, 0}}, Line::Weight::frame);
    const std::vector<Point> arrow{{-0.58, -0.14}, {-0.58, 0.14}, {-0.34, 0}};
    if (is_clearable) {
        pen.patch(arrow);
    } else if (is_enabled) {
        pen.line({arrow[0], arrow[1], arrow[2], arrow[0]}, Line::Weight::thin);
    }
    if (how_.animated) {
        token_pen(symbol, {"transition", '(' + transition.name + ')'}).patch(arrow);
    }
    const bool has_arrow = is_enabled || is_clearable || how_.animated;
    pen.label(plain_text('(' + transition.name + ')'), {has_arrow ? -0.7 : -0.4, 0},
              Label::Anchor::end, Label::Role::remark);
    const std::vector<Text> lines =
        condition_on_paper(grafcet_, transition.condition, how_.sign, widest_condition);
    const double half = line_pitch * static_cast<double>(lines.size()) / 2;
    double y = line_pitch / 2 - half;
    for (const Text& line : lines) {
        pen.label(line, {0.45, y}, Label::Anchor::start);
        y += line_pitch;
    }
    symbol.room_above = half + 0.05;
    symbol.room_below = half + 0.05;
    add_clearing_actions(symbol, transition, half);
    return symbol;
}

/// An oblique line from the crossing of the transition, below the condition, to the actions.
void SymbolMaker::add_clearing_actions(Symbol& symbol, const Transition& transition,
                                       double text_bottom) {
    const auto actions = grafcet_.clearing_actions_of(transition);
    if (actions.empty()) return;
    constexpr double left = 0.95;
    const double middle = std::max(0.8, (text_bottom + 0.1) * left / 0.42);
    std::vector<ActionBox> boxes;
    double width = 1;
    for (const ClearingAction& action : actions) {
        ActionBox box;
        box.text = write_on_paper(grafcet_, action.write, how_.sign);
        width = std::max(width, width_of(box.text) + 0.3);
        boxes.push_back(std::move(box));
    }
    Pen pen(symbol.shapes,
            scene_.owners.add({"action-link", {{"transition", '(' + transition.name + ')'}}, {}}));
    pen.line({{0, 0}, {left, middle}});
    double top = middle - action_height / 2;
    for (const ActionBox& box : boxes) {
        add_box(symbol, box, left, top, width);
        top += action_height;
    }
    symbol.room_below = top + 0.1;
}

}  // namespace grafwire
