#pragma once

#include <string>
#include <utility>
#include <vector>

#include "draw/draw_chart.h"
#include "draw/scene.h"
#include "grafcet/grafcet.h"

namespace grafwire {

// The symbols of IEC 60848, each round its own origin: of a step the middle of its upper edge, of a
// transition the middle of its bar.

/// A symbol, and how far what belongs to it reaches beyond its own link above and below: above the
/// upper and below the lower edge of a step, above and below the bar of a transition.
struct Symbol {
    std::vector<Shape> shapes;
    double room_above = 0;
    double room_below = 0;
};

/// How high a step is.
inline constexpr double step_height = 1;

/// Draws symbols for one chart; what they show are owners of the scene.
class SymbolMaker {
  public:
    SymbolMaker(const Grafcet& grafcet, const ChartDrawing& how, Scene& scene)
        : grafcet_(grafcet), how_(how), scene_(scene) {}

    Symbol step(StepId id);
    Symbol macro(MacroId id);
    Symbol transition(TransitionId id);

    /// How it is named where a link to it is cut: `12`, `M2`, `(3)`.
    std::string name_of(StepId id) const { return grafcet_.steps[id].name; }
    std::string name_of(MacroId id) const { return grafcet_.macros[id].name; }
    std::string name_of(TransitionId id) const { return '(' + grafcet_.transitions[id].name + ')'; }

  private:
    struct ActionBox;

    void add_actions(Symbol& symbol, const Step& step, double right);
    std::vector<ActionBox> boxes_of(const Step& step);
    void add_box(Symbol& symbol, const ActionBox& box, double left, double top, double width);
    void add_row(Symbol& symbol, const std::vector<ActionBox>& boxes, double left);
    void add_column(Symbol& symbol, const std::vector<ActionBox>& boxes, double left);
    void add_clearing_actions(Symbol& symbol, const Transition& transition, double text_bottom);
    bool is_linked(StepId step) const;
    Pen token_pen(Symbol& symbol, std::pair<std::string, std::string> fact);

    const Grafcet& grafcet_;
    const ChartDrawing& how_;
    Scene& scene_;
};

}  // namespace grafwire
