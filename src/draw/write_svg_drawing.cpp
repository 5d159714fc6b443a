#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/describe_sheet.h"
#include "draw/write_drawing.h"
#include "text/escape.h"
#include "text/joined.h"
#include "text/version.h"

namespace grafwire {

namespace {

/// Pixels to a unit inside the picture; its size on paper is told in mm.
constexpr double scale = 40;

/// What few pictures need is no part of their style sheet.
constexpr std::string_view dotted =
    " class=\"dotted\" stroke-width=\"1.4\" stroke-dasharray=\"0.1 3.9\" stroke-linecap=\"round\"";
constexpr std::string_view grey = "unknown\" fill=\"#808080\" fill-opacity=\"0.3";

constexpr std::string_view style = R"(.paper { fill: #ffffff; }
g { stroke: #1b1b1b; fill: none; stroke-width: 1.6; }
.frame { stroke-width: 2.2; }
.thin { stroke-width: 1; }
.aid { stroke-width: 0.7; stroke-dasharray: 3 3; }
.ground { fill: #ffffff; stroke-width: 2.2; }
.mark { fill: #1b1b1b; stroke: none; }
text { font-family: "DejaVu Sans", Arial, sans-serif; font-size: 14px; fill: #1b1b1b; stroke: none; }
text.name { font-size: 16px; }
text.title { font-size: 20px; font-weight: bold; }
text.remark { fill: #444444; }
.over { text-decoration: overline; }
.under { text-decoration: underline; }
.active .ground { fill: #ffe08a; stroke-width: 3.2; }
.clearable, .other { stroke: #b3261e; }
.clearable .mark { fill: #b3261e; }
@media (prefers-color-scheme: dark) {
.paper, .ground { fill: #16191d; }
g { stroke: #e3e6ea; }
.mark, text { fill: #e3e6ea; }
text.remark { fill: #a9b1ba; }
.active .ground { fill: #6b5300; }
.clearable, .other { stroke: #ff8a80; }
.clearable .mark { fill: #ff8a80; }
}
@media print {
.paper, .ground { fill: #ffffff; }
g { stroke: #000000; }
.mark, text { fill: #000000; }
.active .ground { fill: #d9d9d9; }
}
)";

/// Of schematics that show the values of nets: by colour, by weight and by dashes.
constexpr std::string_view style_of_values = R"(.one { stroke: #0b57c2; stroke-width: 3.2; }
.zero { stroke-width: 1; }
.unknown { stroke: #a04400; stroke-dasharray: 5 3; }
.one .mark { fill: #0b57c2; }
.unknown .mark { fill: #a04400; }
@media (prefers-color-scheme: dark) {
.one { stroke: #7db2ff; }
.unknown { stroke: #ffb27d; }
.one .mark { fill: #7db2ff; }
.unknown .mark { fill: #ffb27d; }
}
@media print {
.one .mark, .unknown .mark { fill: #000000; }
}
)";

bool shows_values(const std::vector<Sheet>& sheets) {
    return std::any_of(sheets.begin(), sheets.end(), [](const Sheet& sheet) {
        return std::any_of(sheet.scene.owners.begin(), sheet.scene.owners.end(),
                           [](const Owner& owner) { return owner.kind.starts_with("net "); });
    });
}

/// A coordinate in pixels: as exact at the foot of many sheets as on the first one.
std::string number(double pixels) {
    return fmt::format("{:.{}g}", pixels, std::abs(pixels) < 10'000 ? 6 : 9);
}

class SvgWriter {
  public:
    std::string take() { return std::move(out_); }

    void write(const Sheet& sheet, double top) {
        top_ = top;
        // The shapes of each owner together, in the order of the owners.
        std::vector<std::vector<const Shape*>> shapes(sheet.scene.owners.size());
        for (const Shape& shape : sheet.scene.shapes)
            shapes[index_of(shape.owner)].push_back(&shape);
        // Links first: what stands on them covers them.
        for (const bool is_link : {true, false}) {
            for (std::size_t i = 0; i < shapes.size(); ++i) {
                const Owner& owner = sheet.scene.owners[sheet.scene.owners.id_at(i)];
                if (shapes[i].empty() || owner.kind.starts_with("link") != is_link) continue;
                begin(owner);
                for (const Shape* shape : shapes[i]) {
                    std::visit([this](const auto& form) { write(form); }, shape->form);
                }
                out_ += "</g>\n";
            }
        }
    }

  private:
    static std::string at(double units) { return number(units * scale); }
    std::string y_at(double units) const { return number((units + top_) * scale); }

    void begin(const Owner& owner) {
        out_ += fmt::format("<g class=\"{}\"", owner.kind);
        for (const auto& [name, value] : owner.facts) {
            out_ += fmt::format(" data-{}=\"{}\"", name, xml_attribute(value));
        }
        out_ += ">\n";
        if (!owner.title.empty()) out_ += fmt::format("<title>{}</title>\n", xml_text(owner.title));
    }

    std::string points(const std::vector<Point>& all) const {
        std::string text;
        for (const Point& point : all) {
            text += fmt::format("{}{},{}", text.empty() ? "" : " ", at(point.x), y_at(point.y));
        }
        return text;
    }

    void write(const Line& line) {
        constexpr std::string_view classes[] = {"", " class=\"frame\"", " class=\"thin\"",
                                                " class=\"aid\"", dotted};
        out_ += fmt::format("<polyline{} points=\"{}\"/>\n",
                            classes[static_cast<std::size_t>(line.weight)], points(line.points));
    }
    void write(const Rectangle& rectangle) {
        const Bounds& bounds = rectangle.bounds;
        out_ += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
                            rectangle.grey     ? grey
                            : rectangle.filled ? std::string_view("ground")
                                               : "frame",
                            at(bounds.left), y_at(bounds.top), at(bounds.right - bounds.left),
                            at(bounds.bottom - bounds.top));
    }
    void write(const Patch& patch) {
        out_ += fmt::format("<polygon class=\"mark\" points=\"{}\"/>\n", points(patch.points));
    }
    void write(const Dot& dot) {
        out_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n",
                            dot.filled ? "mark" : "ground", at(dot.centre.x), y_at(dot.centre.y),
                            at(dot.radius));
    }
    void write(const Outline& outline) {
        std::string path = "M " + points({outline.from});
        for (const Outline::Curve& curve : outline.curves) {
            path += " C " + points({curve.control1, curve.control2, curve.to});
        }
        out_ += fmt::format("<path class=\"{}\" d=\"{}{}\"/>\n",
                            outline.closed ? "ground" : "frame", path, outline.closed ? " Z" : "");
    }
    void write(const Label& label) {
        constexpr std::string_view anchors[] = {"", " text-anchor=\"middle\"",
                                                " text-anchor=\"end\""};
        constexpr std::string_view roles[] = {"", " class=\"name\"", " class=\"title\"",
                                              " class=\"remark\""};
        // Half the height of a capital letter of DejaVu Sans.
        const double baseline = label.at.y + 0.365 * letter_size(label.role);
        out_ += fmt::format(
            "<text{}{} x=\"{}\" y=\"{}\">", roles[static_cast<std::size_t>(label.role)],
            anchors[static_cast<std::size_t>(label.anchor)], at(label.at.x), y_at(baseline));
        for (const TextRun& run : label.text) {
            const std::string text = xml_text(run.text);
            if (run.rule == TextRun::Rule::plain) {
                out_ += text;
            } else {
                out_ += fmt::format("<tspan class=\"{}\">{}</tspan>",
                                    run.rule == TextRun::Rule::over ? "over" : "under", text);
            }
        }
        out_ += "</text>\n";
    }

    std::string out_;
    double top_ = 0;
};

/// What a picture is called and what it shows, in words.
struct Words {
    std::string_view title;
    std::string description;
    Language language;
    std::string id;  ///< what the ids of both begin with; nothing in a file of its own
};

/// An `<svg>` of so many units, with a style sheet or none, round a body.
std::string svg_element(double width, double height, double unit, const Words& words,
                        const std::string& style_element, const std::string& body) {
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
               "aria-labelledby=\"{}title {}description\" lang=\"{}\" "
               "width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\">\n",
               words.id, words.id, words.language == Language::french ? "fr" : "en",
               number(width * unit), number(height * unit), number(width * scale),
               number(height * scale)) +
           fmt::format(
               "<title id=\"{}title\">{}</title>\n<desc id=\"{}description\">{}</desc>\n{}"
               "<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n",
               words.id, xml_text(words.title), words.id, xml_text(words.description),
               style_element, number(width * scale), number(height * scale)) +
           body + "</svg>\n";
}

}  // namespace

std::string write_svg_drawing(const std::vector<Sheet>& sheets, std::string_view title,
                              const Paper& paper, Language language) {
    double width = 0;
    double height = 0;
    std::vector<std::string> descriptions;
    SvgWriter writer;
    for (const Sheet& sheet : sheets) {
        descriptions.push_back(describe_sheet(sheet, language));
        writer.write(sheet, height);
        width = std::max(width, sheet.width);
        height += sheet.height;
    }
    const std::string style_element =
        fmt::format("<!-- {} -->\n<style>\n{}{}@page {{ size: {}{}; margin: 10mm; }}\n</style>\n",
                    program_and_version(), style, shows_values(sheets) ? style_of_values : "",
                    paper.name, sheets.front().lies ? " landscape" : "");
    const Words words{title, joined(descriptions, "\n"), language, ""};
    return svg_element(width, height, sheets.front().unit, words, style_element, writer.take());
}

std::vector<std::string> write_svg_sheets(const std::vector<Sheet>& sheets, std::string_view title,
                                          Language language, std::string_view id) {
    std::vector<std::string> pictures;
    for (const Sheet& sheet : sheets) {
        SvgWriter writer;
        writer.write(sheet, 0);
        const Words words{title, describe_sheet(sheet, language), language,
                          fmt::format("{}-{}-", id, pictures.size() + 1)};
        pictures.push_back(
            svg_element(sheet.width, sheet.height, sheet.unit, words, "", writer.take()));
    }
    return pictures;
}

std::string svg_style() {
    return std::string(style);
}

}  // namespace grafwire
