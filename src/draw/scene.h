#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "text/table.h"

namespace grafwire {

// A drawing as a list of shapes, before it becomes SVG or TikZ. One unit is the side of a step, 8
// mm on paper; x goes to the right, y down. Every shape belongs to an owner, the part of the chart
// that it shows, under whose name a reader of the picture finds it again.

struct Point {
    double x = 0;
    double y = 0;
    bool operator==(const Point&) const = default;
};

/// The smallest upright rectangle round something.
struct Bounds {
    double left = 0;
    double top = 0;
    double right = 0;
    double bottom = 0;

    void include(const Bounds& other);
    /// Whether they have more than an edge in common.
    bool overlaps(const Bounds& other) const;
};

/// A line from point to point; aids to the eye are dashed, from a cause to its effects dotted.
struct Line {
    std::vector<Point> points;
    enum class Weight : std::uint8_t { link, frame, thin, aid, dotted } weight = Weight::link;
};

/// A rectangle in outline, on a ground that hides what is below it where it is `filled`; a grey one
/// says that nothing is known there.
struct Rectangle {
    Bounds bounds;
    bool filled = true;
    bool grey = false;
};

/// A filled polygon: the head of an arrow, a flag.
struct Patch {
    std::vector<Point> points;
};

/// A filled circle, or one in outline on a ground that hides what is below it.
struct Dot {
    Point centre;
    double radius = 0;
    bool filled = true;
};

/// A line of curves, each a cubic Bézier curve that begins where the one before it ends. Where it
/// is `closed` it has a ground that hides what is below it.
struct Outline {
    struct Curve {
        Point control1, control2, to;
    };
    Point from;
    std::vector<Curve> curves;
    bool closed = true;
};

/// Some characters in one style. A line over them says NOT, a line under a 1 that it is a
/// condition.
struct TextRun {
    std::string text;
    enum class Rule : std::uint8_t { plain, over, under } rule = Rule::plain;
    bool operator==(const TextRun&) const = default;
};
using Text = std::vector<TextRun>;

/// A text in one line.
struct Label {
    Text text;
    Point at;  ///< its beginning, middle or end, at half the height of a capital letter
    enum class Anchor : std::uint8_t { start, middle, end } anchor = Anchor::start;
    enum class Role : std::uint8_t { plain, name, title, remark } role = Role::plain;
};

enum class OwnerId : std::uint32_t {};

/// What a group of shapes shows.
struct Owner {
    std::string kind;  ///< classes, the first says what it is: `step initial active`, `link`
    /// Names and values: `step` and `12`, `from` and `(3)`.
    std::vector<std::pair<std::string, std::string>> facts;
    std::string title;  ///< what a viewer shows of it in words; may be empty
};

struct Shape {
    std::variant<Line, Rectangle, Patch, Dot, Outline, Label> form;
    OwnerId owner{};
    Bounds bounds;  ///< kept, since measuring texts takes time
};

struct Scene {
    Table<OwnerId, Owner> owners;
    std::vector<Shape> shapes;
};

/// A sheet of paper, without its margins, in mm.
struct Paper {
    std::string_view name;
    double width = 190;
    double height = 277;
};
inline constexpr Paper papers[] = {{"a4", 190, 277}, {"a3", 277, 400}};

/// Round what stands on a sheet, and above it for the title; in units.
inline constexpr double sheet_margin = 0.4;
inline constexpr double title_room = 1;

/// A sheet of a drawing: what stands on it, between (0, 0) and (width, height), in units.
struct Sheet {
    Scene scene;
    double width = 0;
    double height = 0;
    double unit = 8;    ///< in mm
    bool lies = false;  ///< the longer side of the paper is the lower one
};

/// The size of letters of a role, in units.
double letter_size(Label::Role role);
/// How wide a text is in letters of that role, in units: in DejaVu Sans, the widest of the fonts
/// that pictures ask for.
double width_of(const Text& text, Label::Role role = Label::Role::plain);
/// The text of one run without a rule.
Text plain_text(std::string text);

/// Of all shapes; empty at the origin where there are none.
Bounds bounds_of(const std::vector<Shape>& shapes);
void move(std::vector<Shape>& shapes, double dx, double dy);

/// Adds shapes for one owner to a list.
class Pen {
  public:
    Pen(std::vector<Shape>& shapes, OwnerId owner) : shapes_(shapes), owner_(owner) {}

    void line(std::vector<Point> points, Line::Weight weight = Line::Weight::link);
    void rectangle(const Bounds& bounds, bool filled = true);
    /// One on a grey ground.
    void grey_rectangle(const Bounds& bounds);
    void patch(std::vector<Point> points);
    void dot(Point centre, double radius);
    void ring(Point centre, double radius);
    void outline(Outline outline);
    void label(Text text, Point at, Label::Anchor anchor, Label::Role role = Label::Role::plain);
    /// The head of an arrow whose tip is there and that points up or down.
    void arrow_head(Point tip, bool points_up);

  private:
    template <typename Form>
    void add(Form form);

    std::vector<Shape>& shapes_;
    OwnerId owner_;
};

}  // namespace grafwire
