#include "draw/picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <pugixml.hpp>
#include <sstream>

#include "draw/letter_widths.h"
#include "draw/write_drawing.h"

namespace grafwire::testing {

namespace {

std::vector<double> numbers(std::string text) {
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream in(text);
    std::vector<double> all;
    for (double number = 0; in >> number;) all.push_back(number);
    return all;
}

Area around(const std::vector<double>& points) {
    Area area{points[0], points[1], points[0], points[1]};
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        area.left = std::min(area.left, points[i]);
        area.right = std::max(area.right, points[i]);
        area.top = std::min(area.top, points[i + 1]);
        area.bottom = std::max(area.bottom, points[i + 1]);
    }
    return area;
}

std::string words_of(const pugi::xml_node& text) {
    std::string words;
    for (const pugi::xml_node& child : text.children()) {
        words += child.type() == pugi::node_element ? child.child_value() : child.value();
    }
    return words;
}

Area area_of_text(const pugi::xml_node& text, const std::string& words) {
    const std::string role = text.attribute("class").value();
    const double size = role == "title" ? 20 * 1.14 : role == "name" ? 16 : 14;
    const double width = width_in_letters(words) * size;
    const double x = text.attribute("x").as_double();
    const double y = text.attribute("y").as_double();
    const std::string anchor = text.attribute("text-anchor").value();
    const double left = anchor == "middle" ? x - width / 2 : anchor == "end" ? x - width : x;
    // From the height of a capital letter with its accent down to the tail of a `q`.
    return {left, y - 0.8 * size, left + width, y + 0.2 * size};
}

void add(PictureGroup& group, const pugi::xml_node& shape) {
    const std::string name = shape.name();
    if (name == "polyline") {
        const std::vector<double> points = numbers(shape.attribute("points").value());
        const bool is_heavy = std::string(shape.attribute("class").value()) == "frame";
        for (std::size_t i = 0; i + 3 < points.size(); i += 2) {
            group.strokes.push_back(
                {points[i], points[i + 1], points[i + 2], points[i + 3], is_heavy});
        }
    } else if (name == "polygon") {
        group.marks.push_back(around(numbers(shape.attribute("points").value())));
    } else if (name == "rect") {
        const double x = shape.attribute("x").as_double();
        const double y = shape.attribute("y").as_double();
        group.boxes.push_back({x, y, x + shape.attribute("width").as_double(),
                               y + shape.attribute("height").as_double()});
    } else if (name == "circle") {
        const double x = shape.attribute("cx").as_double();
        const double y = shape.attribute("cy").as_double();
        const double r = shape.attribute("r").as_double();
        group.marks.push_back({x - r, y - r, x + r, y + r});
    } else if (name == "path") {
        std::string path = shape.attribute("d").value();
        for (const char letter : {'M', 'C', 'Z'})
            std::replace(path.begin(), path.end(), letter, ' ');
        group.boxes.push_back(around(numbers(std::move(path))));
    } else if (name == "text") {
        group.words.push_back(words_of(shape));
        group.texts.push_back(area_of_text(shape, group.words.back()));
    }
}

}  // namespace

bool overlap(const Area& a, const Area& b, double touch) {
    return a.left + touch < b.right && b.left + touch < a.right && a.top + touch < b.bottom &&
           b.top + touch < a.bottom;
}

Area Stroke::area() const {
    return {std::min(x1, x2), std::min(y1, y2), std::max(x1, x2), std::max(y1, y2)};
}

bool PictureGroup::is(const std::string& name) const {
    return std::find(classes.begin(), classes.end(), name) != classes.end();
}

std::string PictureGroup::fact(const std::string& name) const {
    const auto found = facts.find(name);
    return found == facts.end() ? "" : found->second;
}

std::vector<const PictureGroup*> Picture::all(const std::string& kind) const {
    std::vector<const PictureGroup*> found;
    for (const PictureGroup& group : groups) {
        if (group.kind == kind) found.push_back(&group);
    }
    return found;
}

const PictureGroup* Picture::only(const std::string& kind, const std::string& name,
                                  const std::string& value) const {
    const PictureGroup* found = nullptr;
    for (const PictureGroup& group : groups) {
        if (group.kind != kind || group.fact(name) != value) continue;
        if (found != nullptr) return nullptr;
        found = &group;
    }
    return found;
}

std::string svg_of(const Grafcet& grafcet, const ChartDrawing& how) {
    return write_svg_drawing(draw_chart(grafcet, how), grafcet.name, how.paper, how.language);
}

Picture read_picture(const std::string& svg) {
    pugi::xml_document document;
    REQUIRE(document.load_string(svg.c_str()));
    const pugi::xml_node root = document.child("svg");
    Picture picture;
    const std::vector<double> view = numbers(root.attribute("viewBox").value());
    REQUIRE(view.size() == 4);
    picture.width = view[2];
    picture.height = view[3];
    for (const pugi::xml_node& node : root.children("g")) {
        PictureGroup group;
        std::istringstream classes(node.attribute("class").value());
        for (std::string name; classes >> name;) group.classes.push_back(name);
        REQUIRE(!group.classes.empty());
        group.kind = group.classes.front();
        for (const pugi::xml_attribute& attribute : node.attributes()) {
            const std::string name = attribute.name();
            if (name.starts_with("data-")) group.facts[name.substr(5)] = attribute.value();
        }
        for (const pugi::xml_node& shape : node.children()) add(group, shape);
        picture.groups.push_back(std::move(group));
    }
    return picture;
}

}  // namespace grafwire::testing
