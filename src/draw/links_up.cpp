// A link back up leaves its end at once, or below everything beside it; goes out to a track beside
// all that stands between the two heights; and enters above the step. Each of these pieces must be
// free. Links to one step may share their last piece, and one may end in another.

#include "draw/links_up.h"

#include <optional>

namespace grafwire {

namespace {

constexpr double track_gap = 0.45;    ///< between a link back up and what it passes
constexpr double left_entry = 0.2;    ///< above a step, where a link back up enters
constexpr double right_entry = 0.12;  ///< the same from the right

/// Finds ways back up within one sequence.
class Returns {
  public:
    Returns(FlowSymbols& symbols, Laid& laid) : symbols_(symbols), laid_(laid) {}

    /// Draws the link; false where something is in its way on both sides.
    bool draw(const Exit& exit, const Target& target) {
        // A step may have come to stand below the end of a shorter branch.
        if (target.top > exit.y) return false;
        if (joins_another(exit)) return true;
        const double first = exit.x > 0 ? 1 : -1;
        return draw(exit, target, first) || draw(exit, target, -first);
    }

  private:
    /// `side` is -1 for the left, 1 for the right.
    bool draw(const Exit& exit, const Target& target, double side) {
        const double entry =
            target.top - (side < 0
                              ? left_entry
                              : target.right_room + (target.right_room > 0 ? 0.1 : right_entry));
        for (const double turn : {exit.clear, bottom_beside(exit, side) + track_gap}) {
            const double track = track_beside(exit, side, entry, turn);
            if (!is_free(exit, side, entry, turn, track)) continue;
            const OwnerId owner = symbols_.link("link up", exit.from, exit.target);
            Pen pen(laid_.shapes, owner);
            pen.line({{exit.x, exit.y}, {exit.x, turn}});
            pen.line({{exit.x, turn}, {track, turn}});
            pen.line({{track, turn}, {track, entry}});
            pen.line({{track, entry}, {0, entry}});
            if (!target.is_entered) pen.line({{0, entry}, {0, target.top}});
            pen.arrow_head({track, (turn + entry) / 2 - 0.13}, true);
            laid_.bottom = std::max(laid_.bottom, turn + 0.1);
            return true;
        }
        return false;
    }

    /// Ends in a link to the same step that passes below, if one does.
    bool joins_another(const Exit& exit) {
        std::optional<double> turn;
        for (const Shape& shape : laid_.shapes) {
            const Bounds bounds = shape.bounds;
            const bool passes = bounds.top == bounds.bottom && bounds.top > exit.y + 0.3 &&
                                bounds.left < exit.x && bounds.right > exit.x;
            if (passes && leads_to(exit.target, shape))
                turn = std::min(turn.value_or(1e9), bounds.top);
        }
        if (!turn || !is_free_down(exit, *turn - 0.1)) return false;
        Pen(laid_.shapes, symbols_.link("link up", exit.from, exit.target))
            .line({{exit.x, exit.y}, {exit.x, *turn}});
        return true;
    }

    /// The lowest of what stands on that side of the exit.
    double bottom_beside(const Exit& exit, double side) const {
        double bottom = exit.clear;
        for (const Shape& shape : laid_.shapes) {
            const Bounds bounds = shape.bounds;
            if (side < 0 ? bounds.left < exit.x : bounds.right > exit.x) {
                bottom = std::max(bottom, bounds.bottom);
            }
        }
        return bottom;
    }

    /// Beside everything between these heights.
    double track_beside(const Exit& exit, double side, double entry, double turn) const {
        double outermost = 0;
        const auto pass = [&](const Bounds& bounds) {
            if (bounds.bottom < entry - 0.15 || bounds.top > turn + 0.15) return;
            outermost =
                side < 0 ? std::min(outermost, bounds.left) : std::max(outermost, bounds.right);
        };
        for (const Shape& shape : laid_.shapes) pass(shape.bounds);
        for (const Exit& other : laid_.exits) {
            if (other.goes_up && other.target != exit.target) pass(other.name);
        }
        return outermost + side * track_gap;
    }

    bool is_free(const Exit& exit, double side, double entry, double turn, double track) const {
        constexpr double near = 0.08;
        const auto between = [](double a, double b, double top, double bottom) {
            return Bounds{std::min(a, b), top, std::max(a, b), bottom};
        };
        const Bounds out = between(track, exit.x + side * near, turn - near, turn + near);
        const Bounds in = between(track, side * near, entry - near, entry + near);
        if (!is_free_down(exit, turn) || passes_name(exit, out) || passes_name(exit, in))
            return false;
        return std::none_of(laid_.shapes.begin(), laid_.shapes.end(), [&](const Shape& shape) {
            const Bounds bounds = widened(shape.bounds);
            return bounds.overlaps(out) || (bounds.overlaps(in) && !leads_to(exit.target, shape));
        });
    }

    /// Whether the link can go down from the exit to there.
    bool is_free_down(const Exit& exit, double turn) const {
        constexpr double near = 0.08;
        const Bounds down{exit.x - near, exit.y + near, exit.x + near, turn + near};
        if (passes_name(exit, down)) return false;
        return std::none_of(laid_.shapes.begin(), laid_.shapes.end(), [&](const Shape& shape) {
            return widened(shape.bounds).overlaps(down) && !is_of(exit, shape);
        });
    }

    /// Whether a link would pass where the name of another may have to be written. (Those to the
    /// same step can end in this one.)
    bool passes_name(const Exit& exit, const Bounds& link) const {
        return std::any_of(laid_.exits.begin(), laid_.exits.end(), [&](const Exit& other) {
            return other.goes_up && other.target != exit.target && other.name.overlaps(link);
        });
    }

    /// A line has no area that could overlap anything.
    static Bounds widened(Bounds bounds) {
        constexpr double little = 0.01;
        return {bounds.left - little, bounds.top - little, bounds.right + little,
                bounds.bottom + little};
    }

    /// Links to one step may share their last piece.
    bool leads_to(std::uint32_t target, const Shape& shape) const {
        const Owner& owner = symbols_.owner(shape.owner);
        return owner.kind == "link up" && owner.facts.back().second == symbols_.name_of(target);
    }
    /// What belongs to the transition above the exit, whose condition stands beside its link.
    bool is_of(const Exit& exit, const Shape& shape) const {
        return shape.bounds.bottom <= exit.clear;
    }

    FlowSymbols& symbols_;
    Laid& laid_;
};

}  // namespace

bool draw_link_up(FlowSymbols& symbols, Laid& laid, const Exit& exit, const Target& target) {
    return Returns(symbols, laid).draw(exit, target);
}

/// A short link with an arrow and the name of where it leads.
void draw_cut(FlowSymbols& symbols, Laid& laid, const Exit& exit) {
    Pen pen(laid.shapes, symbols.link("cut", exit.from, exit.target));
    const double tip = exit.clear + 0.3;
    pen.line({{exit.x, exit.y}, {exit.x, tip - 0.2}});
    pen.arrow_head({exit.x, tip}, false);
    pen.label(plain_text(symbols.name_at_cut(exit.target, exit.from)), {exit.x, tip + 0.27},
              Label::Anchor::middle, Label::Role::remark);
    laid.bottom = std::max(laid.bottom, tip + 0.5);
}

}  // namespace grafwire
