#include "draw/scene.h"

#include <algorithm>

#include "draw/letter_widths.h"

namespace grafwire {

namespace {

Bounds around(const std::vector<Point>& points) {
    Bounds bounds{points.front().x, points.front().y, points.front().x, points.front().y};
    for (const Point& point : points) bounds.include({point.x, point.y, point.x, point.y});
    return bounds;
}

Bounds around(const Label& label) {
    const double width = width_of(label.text, label.role);
    const double half = 0.6 * letter_size(label.role);
    double left = label.at.x;
    if (label.anchor == Label::Anchor::middle) left -= width / 2;
    if (label.anchor == Label::Anchor::end) left -= width;
    return {left, label.at.y - half, left + width, label.at.y + half};
}

struct BoundsOf {
    Bounds operator()(const Line& line) const { return around(line.points); }
    Bounds operator()(const Rectangle& rectangle) const { return rectangle.bounds; }
    Bounds operator()(const Patch& patch) const { return around(patch.points); }
    Bounds operator()(const Dot& dot) const {
        return {dot.centre.x - dot.radius, dot.centre.y - dot.radius, dot.centre.x + dot.radius,
                dot.centre.y + dot.radius};
    }
    /// The curves stay within their control points.
    Bounds operator()(const Outline& outline) const {
        std::vector<Point> points{outline.from};
        for (const Outline::Curve& curve : outline.curves) {
            points.insert(points.end(), {curve.control1, curve.control2, curve.to});
        }
        return around(points);
    }
    Bounds operator()(const Label& label) const { return around(label); }
};

struct Move {
    double dx;
    double dy;

    void operator()(Point& point) const {
        point.x += dx;
        point.y += dy;
    }
    void operator()(Line& line) const {
        for (Point& point : line.points) (*this)(point);
    }
    void operator()(Bounds& bounds) const {
        bounds.left += dx;
        bounds.right += dx;
        bounds.top += dy;
        bounds.bottom += dy;
    }
    void operator()(Rectangle& rectangle) const { (*this)(rectangle.bounds); }
    void operator()(Patch& patch) const {
        for (Point& point : patch.points) (*this)(point);
    }
    void operator()(Dot& dot) const { (*this)(dot.centre); }
    void operator()(Outline& outline) const {
        (*this)(outline.from);
        for (Outline::Curve& curve : outline.curves) {
            for (Point* point : {&curve.control1, &curve.control2, &curve.to}) (*this)(*point);
        }
    }
    void operator()(Label& label) const { (*this)(label.at); }
};

}  // namespace

void Bounds::include(const Bounds& other) {
    left = std::min(left, other.left);
    top = std::min(top, other.top);
    right = std::max(right, other.right);
    bottom = std::max(bottom, other.bottom);
}

bool Bounds::overlaps(const Bounds& other) const {
    constexpr double nothing = 1e-6;
    return left < other.right - nothing && other.left < right - nothing &&
           top < other.bottom - nothing && other.top < bottom - nothing;
}

double letter_size(Label::Role role) {
    switch (role) {
        case Label::Role::title:
            return 0.5;
        case Label::Role::name:
            return 0.4;
        case Label::Role::plain:
        case Label::Role::remark:
            return 0.35;
    }
    return 0.35;
}

double width_of(const Text& text, Label::Role role) {
    constexpr double bold = 1.14;
    double width = 0;
    for (const TextRun& run : text) width += width_in_letters(run.text);
    return width * letter_size(role) * (role == Label::Role::title ? bold : 1);
}

Text plain_text(std::string text) {
    Text runs;
    runs.push_back({std::move(text), TextRun::Rule::plain});
    return runs;
}

Bounds bounds_of(const std::vector<Shape>& shapes) {
    if (shapes.empty()) return {};
    Bounds bounds = shapes.front().bounds;
    for (const Shape& shape : shapes) bounds.include(shape.bounds);
    return bounds;
}

void move(std::vector<Shape>& shapes, double dx, double dy) {
    const Move by{dx, dy};
    for (Shape& shape : shapes) {
        std::visit(by, shape.form);
        by(shape.bounds);
    }
}

template <typename Form>
void Pen::add(Form form) {
    const Bounds bounds = BoundsOf{}(form);
    shapes_.push_back({std::move(form), owner_, bounds});
}

void Pen::line(std::vector<Point> points, Line::Weight weight) {
    add(Line{std::move(points), weight});
}

void Pen::rectangle(const Bounds& bounds, bool filled) {
    add(Rectangle{bounds, filled});
}

void Pen::grey_rectangle(const Bounds& bounds) {
    add(Rectangle{bounds, true, true});
}

void Pen::patch(std::vector<Point> points) {
    add(Patch{std::move(points)});
}

void Pen::dot(Point centre, double radius) {
    add(Dot{centre, radius});
}

void Pen::ring(Point centre, double radius) {
    add(Dot{centre, radius, false});
}

void Pen::outline(Outline outline) {
    add(std::move(outline));
}

void Pen::label(Text text, Point at, Label::Anchor anchor, Label::Role role) {
    add(Label{std::move(text), at, anchor, role});
}

void Pen::arrow_head(Point tip, bool points_up) {
    constexpr double half_width = 0.1;
    const double length = points_up ? 0.26 : -0.26;
    patch({tip, {tip.x - half_width, tip.y + length}, {tip.x + half_width, tip.y + length}});
}

}  // namespace grafwire
