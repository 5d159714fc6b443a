#pragma once

#include <map>
#include <string>
#include <vector>

#include "draw/draw_chart.h"
#include "grafcet/grafcet.h"

namespace grafwire::testing {

// A drawing as one finds it in an SVG file, in its pixels: 40 are the side of a step.

struct Area {
    double left = 0, top = 0, right = 0, bottom = 0;
    double middle() const { return (left + right) / 2; }
    double height() const { return bottom - top; }
};
/// Whether they have more than `touch` in common in both directions.
bool overlap(const Area& a, const Area& b, double touch = 0.5);

struct Stroke {
    double x1 = 0, y1 = 0, x2 = 0, y2 = 0;
    bool is_heavy = false;
    Area area() const;
    bool is_level() const { return y1 == y2; }
    bool is_upright() const { return x1 == x2; }
};

/// A group of the picture: what is drawn for one part of the chart.
struct PictureGroup {
    std::string kind;  ///< the first class
    std::vector<std::string> classes;
    std::map<std::string, std::string> facts;
    std::vector<Stroke> strokes;
    std::vector<Area> boxes;
    std::vector<Area> marks;  ///< filled polygons and dots
    std::vector<Area> texts;
    std::vector<std::string> words;  ///< of the texts

    bool is(const std::string& name) const;
    std::string fact(const std::string& name) const;
};

struct Picture {
    double width = 0, height = 0;
    std::vector<PictureGroup> groups;

    std::vector<const PictureGroup*> all(const std::string& kind) const;
    /// The only group of a kind with this fact; nullptr where there is none or more than one.
    const PictureGroup* only(const std::string& kind, const std::string& name,
                             const std::string& value) const;
};

/// A chart as SVG.
std::string svg_of(const Grafcet& grafcet, const ChartDrawing& how = {});

/// Reads a picture. What is no such picture fails the test.
Picture read_picture(const std::string& svg);

}  // namespace grafwire::testing
