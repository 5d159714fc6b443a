// Plain TikZ: packages for GRAFCET on CTAN place symbols by hand and need fonts that small
// installations of TeX do not have. Coordinates are in units of a step, with y downwards, so that
// the same layout serves SVG; sans serif letters of as many points as a unit has millimetres are
// narrower than those that it was made for.

#include <fmt/format.h>

#include <algorithm>

#include "draw/write_drawing.h"
#include "text/latex.h"
#include "text/utf8.h"
#include "text/version.h"

namespace grafwire {

namespace {

struct Sign {
    char32_t character;
    std::string_view latex;
};
/// Those of conditions, in mathematical mode.
constexpr Sign signs[] = {
    {U'↑', "$\\uparrow$"}, {U'↓', "$\\downarrow$"}, {U'·', "$\\cdot$"},
    {U'−', "$-$"},         {U'′', "$'$"},           {U'≤', "$\\leq$"},
    {U'≥', "$\\geq$"},     {U'≠', "$\\neq$"},       {U'⊕', "$\\oplus$"},
};

/// A text in one line.
std::string latex_label(std::string_view text) {
    std::string out;
    std::string last;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint c = decode_utf8(text, at);
        const std::uint32_t bytes = std::max(c.length, 1U);
        const auto* sign = std::find_if(std::begin(signs), std::end(signs),
                                        [&](const Sign& row) { return row.character == c.value; });
        const std::string written = sign != std::end(signs)
                                        ? std::string(sign->latex)
                                        : latex_character(c.value, text.substr(at, bytes));
        if (is_latex_ligature(last, written)) out += "{}";
        out += written;
        last = written;
        at += bytes;
    }
    return out;
}

class TikzWriter {
  public:
    std::string take() { return std::move(out_); }

    void write(const Sheet& sheet) {
        out_ += fmt::format(
            "\\begin{{tikzpicture}}[x={0:g}mm, y=-{0:g}mm, line width=0.3mm,\n"
            "  frame/.style={{line width=0.42mm}}, thin/.style={{line width=0.2mm}},\n"
            "  aid/.style={{line width=0.14mm, dash pattern=on 0.6mm off 0.6mm}},\n"
            "  every node/.style={{inner sep=0, outer sep=0, anchor=base,\n"
            "    font=\\sffamily\\fontsize{{{1:g}}}{{{2:g}}}\\selectfont}},\n"
            "  name/.style={{font=\\sffamily\\fontsize{{{2:g}}}{{{3:g}}}\\selectfont}},\n"
            "  "
            "title/.style={{font=\\sffamily\\bfseries\\fontsize{{{4:g}}}{{{5:g}}}\\selectfont}}]\n",
            sheet.unit, sheet.unit, sheet.unit + 1, sheet.unit + 2, sheet.unit + 3, sheet.unit + 4);
        out_ += fmt::format("\\path (0,0) rectangle ({:.6g},{:.6g});\n", sheet.width, sheet.height);
        for (const bool is_link : {true, false}) {
            for (const Shape& shape : sheet.scene.shapes) {
                owner_ = &sheet.scene.owners[shape.owner];
                if (owner_->kind.starts_with("link") != is_link) continue;
                std::visit([this](const auto& form) { write(form); }, shape.form);
            }
        }
        out_ += "\\end{tikzpicture}\n";
    }

  private:
    static std::string at(Point point) { return fmt::format("({:.6g},{:.6g})", point.x, point.y); }
    static std::string path(const std::vector<Point>& points) {
        std::string text;
        for (const Point& point : points) text += (text.empty() ? "" : " -- ") + at(point);
        return text;
    }

    void write(const Line& line) {
        constexpr std::string_view weights[] = {"", "[frame]", "[thin]", "[aid]", "[dotted]"};
        std::string_view options = weights[static_cast<std::size_t>(line.weight)];
        if (owner_->kind.ends_with(" one")) options = "[line width=0.6mm]";
        if (owner_->kind.ends_with(" zero")) options = "[thin]";
        if (owner_->kind.ends_with(" unknown")) options = "[dash pattern=on 1mm off 0.6mm]";
        out_ += fmt::format("\\draw{} {};\n", options, path(line.points));
    }
    void write(const Rectangle& rectangle) {
        const Bounds& bounds = rectangle.bounds;
        const bool is_active = owner_->kind.ends_with(" active");
        out_ += fmt::format("\\draw[frame{}] {} rectangle {};\n",
                            !rectangle.filled             ? ""
                            : rectangle.grey || is_active ? ", fill=black!15"
                                                          : ", fill=white",
                            at({bounds.left, bounds.top}), at({bounds.right, bounds.bottom}));
    }
    void write(const Patch& patch) {
        out_ += fmt::format("\\fill {} -- cycle;\n", path(patch.points));
    }
    void write(const Dot& dot) {
        out_ += fmt::format("\\{} {} circle [radius={:.6g}];\n",
                            dot.filled ? "fill" : "draw[frame, fill=white]", at(dot.centre),
                            dot.radius);
    }
    void write(const Outline& outline) {
        std::string curves = at(outline.from);
        for (const Outline::Curve& curve : outline.curves) {
            curves += fmt::format(" .. controls {} and {} .. {}", at(curve.control1),
                                  at(curve.control2), at(curve.to));
        }
        out_ += fmt::format("\\draw[frame{}] {}{};\n", outline.closed ? ", fill=white" : "", curves,
                            outline.closed ? " -- cycle" : "");
    }
    void write(const Label& label) {
        constexpr std::string_view anchors[] = {"base west", "base", "base east"};
        constexpr std::string_view roles[] = {"", ", name", ", title", ""};
        const double baseline = label.at.y + 0.365 * letter_size(label.role);
        std::string text;
        for (const TextRun& run : label.text) {
            const std::string words = latex_label(run.text);
            switch (run.rule) {
                case TextRun::Rule::plain:
                    text += words;
                    break;
                case TextRun::Rule::over:
                    text += fmt::format("$\\overline{{\\mbox{{{}}}}}$", words);
                    break;
                case TextRun::Rule::under:
                    text += fmt::format("\\underline{{{}}}", words);
                    break;
            }
        }
        out_ += fmt::format(
            "\\node[anchor={}{}] at {} {{{}}};\n", anchors[static_cast<std::size_t>(label.anchor)],
            roles[static_cast<std::size_t>(label.role)], at({label.at.x, baseline}), text);
    }

    std::string out_;
    const Owner* owner_ = nullptr;
};

}  // namespace

std::string write_tikz_drawing(const std::vector<Sheet>& sheets, std::string_view title,
                               const Paper& paper, bool standalone) {
    TikzWriter writer;
    for (const Sheet& sheet : sheets) writer.write(sheet);
    const std::string head = fmt::format("% {}\n% {}\n", visible(title, ""), program_and_version());
    if (!standalone) return head + writer.take();
    return head +
           fmt::format(
               "\\documentclass[{}paper]{{article}}\n"
               "\\usepackage[T1]{{fontenc}}\n\\usepackage[utf8]{{inputenc}}\n"
               "\\usepackage{{lmodern}}\n\\usepackage{{tikz}}\n"
               "\\usepackage[{}margin=9.9mm]{{geometry}}\n"
               "\\pagestyle{{empty}}\n\\parindent=0pt\n\\begin{{document}}\n",
               paper.name, sheets.front().lies ? "landscape, " : "") +
           writer.take() + "\\end{document}\n";
}

}  // namespace grafwire
