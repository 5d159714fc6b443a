// Ladder diagrams as pictures: pages of A4 below one another, each exactly as high as the paper, so
// that a browser prints one on each sheet. A rung stands on one page; only one that is taller than
// a page goes on on the next. The unit is a quarter of a millimetre; the layout's grid becomes
// cells of 8 by 17 units, with names in a monospaced font that fits them. Where a rung is too wide,
// all pages show everything smaller. Colours follow the viewer's preference for dark or light.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ladder/draw/cut_drawing.h"
#include "ladder/draw/layout.h"
#include "ladder/draw/messages.h"
#include "ladder/draw/write_drawings.h"
#include "text/escape.h"
#include "text/utf8.h"
#include "text/version.h"

namespace grafwire::ladder {

namespace {

constexpr double cell_width = 8;
constexpr double cell_height = 17;
constexpr int columns = 95;
constexpr double margin = 40;
/// Of A4: 210 mm by 297 mm. One that is wider and its height are multiples of the steps.
constexpr double paper_width = 840;
constexpr double paper_height = 1188;
constexpr double width_step = 70;
constexpr double height_step = 99;
/// The room of a section's heading, between the comment of a rung and its drawing, and below that.
constexpr double heading_height = 2.6 * cell_height;
constexpr double comment_gap = 4;
constexpr double rung_end = 0.6 * cell_height;
/// With room for fewer the rest of a drawing goes on on the next page.
constexpr int fewest_rows = 8;
/// Characters of the title in one line, and at most.
constexpr std::size_t title_columns = 52;
constexpr std::size_t longest_title = 3 * title_columns;

constexpr const char* style = R"(<style>
@page { size: 210mm 297mm; margin: 0; }
.paper { fill: #ffffff; }
.edge { stroke: #9fb0c0; stroke-dasharray: 6 6; }
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
@media print {
.edge { display: none; }
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
    void drawing(const Drawing& drawing);
    void symbol(const Drawing::Symbol& symbol);
    void box(const Drawing::Box& box);
    void remark(const std::string& words);
    void rung(const Rung& rung, const Drawing& drawing, Language language);
    void rows(const Rung& rung, const Drawing& drawing, Language language);
    void head(const Rung& rung, const std::vector<std::string>& lines);
    void close_rails();
    void turn_page();
    std::string page(std::size_t index) const;

    static double x_of(double cells) { return margin + cells * cell_width; }
    double y_of(double cells) const { return top_ + cells * cell_height; }
    /// What is left of the page.
    double room() const { return height_ - margin - top_; }
    /// What a page has below its title.
    double whole_room() const { return height_ - margin - body_top(); }
    double body_top() const {
        return margin + cell_height * (1.6 + static_cast<double>(title_.size()));
    }

    double width_ = paper_width;  ///< of a page
    double height_ = paper_height;
    std::vector<std::string> title_;  ///< in lines
    std::vector<std::string> pages_;  ///< those that are full
    std::string body_;                ///< of the page that is drawn on
    double top_ = 0;                  ///< where its next part begins
    double rails_top_ = 0;            ///< where the rails of the rung begin on it
    double right_rail_ = 0;
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

void Picture::remark(const std::string& words) {
    for (const std::string& line : wrapped_text(words, columns)) {
        if (room() < cell_height) turn_page();
        text(margin, top_ + 13, "comment", "start", line);
        top_ += cell_height;
    }
}

void Picture::turn_page() {
    pages_.push_back(std::move(body_));
    body_.clear();
    top_ = body_top();
    rails_top_ = top_;
}

void Picture::close_rails() {
    line(x_of(0.5), rails_top_, x_of(0.5), top_, "rail");
    line(right_rail_, rails_top_, right_rail_, top_, "rail");
}

/// The number of a rung and what is said of it.
void Picture::head(const Rung& rung, const std::vector<std::string>& lines) {
    text(x_of(1.5), top_ + 13, "number", "start", fmt::format("{}", rung.number));
    for (const std::string& line : lines) {
        if (room() < cell_height) {
            close_rails();
            turn_page();
        }
        text(x_of(5.5), top_ + 13, "comment", "start", line);
        top_ += cell_height;
    }
    top_ += comment_gap;
}

/// A drawing, on as many pages as it takes.
void Picture::rows(const Rung& rung, const Drawing& drawing, Language language) {
    const std::vector<std::string> continued{messages::ladder_draw::continued.in(language)};
    for (int from = 0; from < drawing.height;) {
        const int most = static_cast<int>((room() - rung_end) / cell_height);
        const bool is_last = drawing.height - from <= most;
        if (is_last || most >= fewest_rows) {
            const int to = row_to_cut(drawing, from, most);
            this->drawing(rows_of(drawing, from, to));
            top_ = y_of(to - from) + (is_last ? rung_end : 0);
            from = to;
        }
        close_rails();
        if (is_last) return;
        turn_page();
        head(rung, continued);
    }
}

void Picture::rung(const Rung& rung, const Drawing& drawing, Language language) {
    const std::vector<std::string> lines = wrapped_text(rung.comment, columns - 8);
    const double heading = rung.heading.empty() ? 0 : heading_height;
    const double height = heading + static_cast<double>(lines.size()) * cell_height + comment_gap +
                          drawing.height * cell_height + rung_end;
    // One that is taller than a page may as well begin where half of one is left.
    const double needed = height <= whole_room() ? height : whole_room() / 2;
    if (room() < needed && top_ > body_top()) turn_page();
    if (!rung.heading.empty()) {
        text(margin, top_ + cell_height + 14, "heading", "start", rung.heading);
        top_ += heading_height;
    }
    rails_top_ = top_;
    right_rail_ = x_of(drawing.width - 0.5);
    head(rung, lines);
    rows(rung, drawing, language);
}

std::string Picture::page(std::size_t index) const {
    const double y = height_ * static_cast<double>(index);
    std::string text = fmt::format(
        "<g class=\"page\" transform=\"translate(0 {})\">\n"
        "<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n",
        y, width_, height_);
    if (index > 0)
        text +=
            fmt::format("<line class=\"edge\" x1=\"0\" y1=\"0\" x2=\"{}\" y2=\"0\"/>\n", width_);
    Picture head;
    for (std::size_t i = 0; i < title_.size(); ++i) {
        head.text(margin, margin + 18 + static_cast<double>(i) * cell_height, "title", "start",
                  title_[i]);
    }
    head.text(width_ - margin, margin + 18, "heading", "end",
              fmt::format("{}/{}", index + 1, pages_.size()));
    return text + head.body_ + pages_[index] + "</g>\n";
}

std::string Picture::write(const Ladder& ladder, Language language) {
    std::vector<Drawing> drawings;
    for (const Rung& item : ladder.rungs) {
        drawings.push_back(draw(ladder, item, columns));
        width_ = std::max(width_, x_of(drawings.back().width) + margin);
    }
    width_ = std::ceil(width_ / width_step) * width_step;
    height_ = width_ / width_step * height_step;
    title_ = wrapped_text(shortened(heading_of(ladder, language), longest_title), title_columns);
    top_ = body_top();
    for (const std::string& words : ladder.remarks) remark(words);
    for (std::size_t i = 0; i < drawings.size(); ++i) rung(ladder.rungs[i], drawings[i], language);
    turn_page();
    const auto count = static_cast<double>(pages_.size());
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"210mm\" height=\"{}mm\" "
        "viewBox=\"0 0 {} {}\">\n<!-- {} -->\n<title>{}</title>\n{}",
        297 * pages_.size(), width_, height_ * count, program_and_version(), xml_text(ladder.name),
        style);
    for (std::size_t i = 0; i < pages_.size(); ++i) svg += page(i);
    return svg + "</svg>\n";
}

}  // namespace

std::string write_svg(const Ladder& ladder, Language language) {
    return Picture().write(ladder, language);
}

}  // namespace grafwire::ladder
