// Ladder diagrams as pictures. The layout's grid becomes cells of 8 by 17 units; names are set in a
// monospaced font that fits them. Colours follow the viewer's preference for dark or light.

#include <fmt/format.h>

#include "ladder/draw/layout.h"
#include "ladder/draw/write_drawings.h"
#include "text/escape.h"

namespace grafwire::ladder {

namespace {

constexpr double cell_width = 8;
constexpr double cell_height = 17;
constexpr int columns = 104;
constexpr double margin = 24;

constexpr const char* style = R"(<style>
.paper { fill: #ffffff; }
.wire { stroke: #1d2b3a; stroke-width: 1.6; fill: none; stroke-linecap: square; }
.rail { stroke: #1d2b3a; stroke-width: 3; }
text { font: 13px "DejaVu Sans Mono", Menlo, Consolas, monospace; fill: #1d2b3a; white-space: pre; }
.title { font-size: 20px; font-weight: bold; }
.heading { font-size: 15px; font-weight: bold; fill: #0b5c8a; }
.comment { fill: #4f6272; font-style: italic; }
.number { fill: #0b5c8a; }
@media (prefers-color-scheme: dark) {
.paper { fill: #14191f; }
.wire, .rail { stroke: #d7dee6; }
text { fill: #d7dee6; }
.heading, .number { fill: #7cc4ee; }
.comment { fill: #9fb0c0; }
}
</style>
)";

class Picture {
  public:
    std::string write(const Ladder& ladder, Language language);

  private:
    void text(double x, double y, std::string_view kind, std::string_view anchor,
              std::string_view text);
    void line(double x1, double y1, double x2, double y2, std::string_view kind = "wire");
    void path(const std::string& path) {
        body_ += fmt::format("<path class=\"wire\" d=\"{}\"/>\n", path);
    }
    void paragraph(const std::string& words, std::string_view kind);
    void rung(const Ladder& ladder, const Rung& rung);
    void drawing(const Drawing& drawing);
    void symbol(const Drawing::Symbol& symbol);
    void box(const Drawing::Box& box);
    static double x_of(double cells) { return margin + cells * cell_width; }
    double y_of(double cells) const { return top_ + cells * cell_height; }

    std::string body_;
    double top_ = 0;
    double widest_ = 0;
};

void Picture::text(double x, double y, std::string_view kind, std::string_view anchor,
                   std::string_view text) {
    body_ += fmt::format("<text class=\"{}\" x=\"{:g}\" y=\"{:g}\" text-anchor=\"{}\">{}</text>\n",
                         kind, x, y, anchor, xml_text(text));
}

void Picture::line(double x1, double y1, double x2, double y2, std::string_view kind) {
    body_ += fmt::format("<line class=\"{}\" x1=\"{:g}\" y1=\"{:g}\" x2=\"{:g}\" y2=\"{:g}\"/>\n",
                         kind, x1, y1, x2, y2);
}

void Picture::paragraph(const std::string& words, std::string_view kind) {
    for (const std::string& line : wrapped_text(words, columns)) {
        text(margin, top_ + 13, kind, "start", line);
        top_ += cell_height;
    }
}

void Picture::symbol(const Drawing::Symbol& symbol) {
    const double y = y_of(symbol.y + 0.5);
    const double half = cell_width * symbol.width / 2.0;
    const int first = symbol.x - symbol.width / 2;
    const double left = x_of(first);
    const double middle = left + half;
    const double right = middle + half;
    if (symbol.kind == Drawing::Symbol::Kind::coil) {
        const double r = half - 1;
        line(left, y, left + 1, y);
        line(right - 1, y, right, y);
        path(fmt::format("M{:g} {:g} a{:g} {:g} 0 1 0 {:g} 0 a{:g} {:g} 0 1 0 {:g} 0", left + 1, y,
                         r, 8.0, 2 * r, r, 8.0, -2 * r));
    } else {
        const double inset = symbol.kind == Drawing::Symbol::Kind::contact ? 6 : 2;
        line(left, y, left + inset, y);
        line(right - inset, y, right, y);
        line(left + inset, y - 7.5, left + inset, y + 7.5);
        line(right - inset, y - 7.5, right - inset, y + 7.5);
        if (symbol.text == "/") {
            line(left + inset + 1, y + 7, right - inset - 1, y - 7);
            return;
        }
    }
    if (symbol.text == "/") {
        line(middle - 4, y + 6, middle + 4, y - 6);
    } else if (!symbol.text.empty()) {
        text(middle, y + 4.5, "mark", "middle", symbol.text);
    }
}

void Picture::box(const Drawing::Box& box) {
    const double x = x_of(box.x + 0.5);
    const double width = cell_width * (box.width - 1);
    body_ +=
        fmt::format("<rect class=\"wire\" x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\"/>\n",
                    x, y_of(box.y), width, cell_height * box.height - 4);
    text(x + width / 2, y_of(box.y) + 14, "number", "middle", box.title);
    for (std::size_t i = 0; i < box.rows.size(); ++i) {
        const double y = y_of(box.y + 1 + static_cast<double>(i)) + 13;
        text(x + cell_width, y, "name", "start", box.rows[i]);
        if (i < box.right.size()) text(x + width - cell_width, y, "name", "end", box.right[i]);
    }
    line(x_of(box.x), y_of(box.y + 1.5), x, y_of(box.y + 1.5));
    line(x + width, y_of(box.y + 1.5), x + width + cell_width / 2, y_of(box.y + 1.5));
}

void Picture::drawing(const Drawing& drawing) {
    for (const Drawing::Wire& wire : drawing.wires) {
        line(x_of(wire.x1 / 2.0), y_of(wire.y1 / 2.0), x_of(wire.x2 / 2.0), y_of(wire.y2 / 2.0));
    }
    for (const Drawing::Symbol& item : drawing.symbols) symbol(item);
    for (const Drawing::Box& item : drawing.boxes) box(item);
    for (const Drawing::Label& label : drawing.labels) {
        const bool is_arrow = label.kind == Drawing::Label::Kind::arrow;
        text(x_of(label.x), y_of(label.y) + (is_arrow ? 13 : 12), is_arrow ? "number" : "name",
             "start", label.text);
    }
}

void Picture::rung(const Ladder& ladder, const Rung& rung) {
    if (!rung.heading.empty()) {
        top_ += cell_height;
        text(margin, top_ + 14, "heading", "start", rung.heading);
        top_ += 1.6 * cell_height;
    }
    const Drawing layout = draw(ladder, rung, columns);
    const double right = x_of(layout.width - 0.5);
    widest_ = std::max(widest_, right);
    const double begin = top_;
    const std::vector<std::string> lines = wrapped_text(rung.comment, columns - 8);
    text(x_of(1.5), top_ + 13, "number", "start", fmt::format("{}", rung.number));
    for (const std::string& line : lines) {
        text(x_of(5.5), top_ + 13, "comment", "start", line);
        top_ += cell_height;
    }
    top_ += 4;
    drawing(layout);
    top_ = y_of(layout.height + 0.6);
    line(x_of(0.5), begin, x_of(0.5), top_, "rail");
    line(right, begin, right, top_, "rail");
}

std::string Picture::write(const Ladder& ladder, Language language) {
    top_ = margin;
    text(margin, top_ + 18, "title", "start", heading_of(ladder, language));
    top_ += 2 * cell_height;
    for (const std::string& remark : ladder.remarks) paragraph(remark, "comment");
    widest_ = x_of(columns);
    for (const Rung& item : ladder.rungs) rung(ladder, item);
    const double width = widest_ + margin;
    const double height = top_ + margin;
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
               "viewBox=\"0 0 {0:g} {1:g}\">\n<title>{2}</title>\n{3}"
               "<rect class=\"paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n",
               width, height, xml_text(ladder.name), style) +
           body_ + "</svg>\n";
}

}  // namespace

std::string write_svg(const Ladder& ladder, Language language) {
    return Picture().write(ladder, language);
}

}  // namespace grafwire::ladder
