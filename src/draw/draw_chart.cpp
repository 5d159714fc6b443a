// Blocks on sheets. A sheet holds graphs and expansions in the order of the file, side by side from
// the upper edge while they fit, then in the next row. One sheet is best, so the paper is laid on
// its longer side, and letters become smaller down to a size that copies well, before a second one
// is begun. A block that is longer than a sheet is cut where IEC 60848 allows it: at a link from a
// transition to a step, with the name of the step and its sheet at the end that leaves and that of
// the transition at the other.

#include "draw/draw_chart.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "draw/chart_flow.h"
#include "draw/chart_layout.h"
#include "draw/chart_symbols.h"
#include "draw/cut_flow.h"
#include "draw/messages.h"
#include "draw/sheet_size.h"

namespace grafwire {

namespace {

constexpr double block_gap = 1.5;

/// A block or a part of it, laid out with its heading, its upper left corner at the origin.
struct Part {
    std::vector<Shape> shapes;
    double width = 0;
    double height = 0;
};

/// Where a part stands.
struct Place {
    std::size_t sheet = 0;
    double x = 0;
    double y = 0;
};

/// Puts parts into rows, and rows on sheets.
std::vector<Place> places_of(const std::vector<Part>& parts, const SheetSize& size) {
    std::vector<Place> places;
    Place next;
    double row_height = 0;
    for (const Part& part : parts) {
        if (next.x > 0 && next.x + part.width > size.width) {
            next = {next.sheet, 0, next.y + row_height + block_gap};
            row_height = 0;
        }
        if ((next.x > 0 || next.y > 0) && next.y + part.height > size.height) {
            next = {next.sheet + 1, 0, 0};
            row_height = 0;
        }
        places.push_back(next);
        next.x += part.width + block_gap;
        row_height = std::max(row_height, part.height);
    }
    return places;
}

bool fits_one_sheet(const std::vector<Part>& parts, const SheetSize& size) {
    const std::vector<Place> places = places_of(parts, size);
    if (places.back().sheet > 0) return false;
    return std::all_of(parts.begin(), parts.end(), [&](const Part& part) {
        return part.width <= size.width && part.height <= size.height;
    });
}

/// Some sequences of a block that stand together, and the number of their sheet, from 1 on.
struct Stretch {
    std::size_t block = 0;
    std::vector<FlowSequence> sequences;
    std::size_t sheet = 0;
};

class ChartSheets {
  public:
    ChartSheets(const Grafcet& grafcet, const ChartDrawing& how)
        : grafcet_(grafcet), how_(how), symbols_(grafcet, how, scene_) {
        for (std::size_t i = 0; i < grafcet.blocks.size(); ++i) {
            flows_.push_back(flow_of(grafcet, grafcet.blocks.id_at(i)));
            stretches_.push_back({i, std::move(flows_.back().sequences), 0});
        }
        number_nodes();
    }

    std::vector<Sheet> make() {
        lay_out_all();
        if (const std::optional<SheetSize> size = one_sheet()) {
            return sheets_with(places_of(parts_, *size), *size);
        }
        const SheetSize size = cut_for_sheets();
        // Once more, now that the sheets are known whose numbers stand at cut links.
        number_nodes();
        lay_out_all();
        return sheets_with(places_of(parts_, size), size);
    }

  private:
    void number_nodes() {
        sheets_.clear();
        for (const ChartFlow& flow : flows_) sheets_.emplace_back(flow.nodes.size(), 0);
        for (const Stretch& stretch : stretches_) {
            for (const FlowSequence& sequence : stretch.sequences) number(sequence, stretch);
        }
    }
    void number(const FlowSequence& sequence, const Stretch& stretch) {
        for (const FlowPiece& piece : sequence.pieces) {
            if (piece.node != none) sheets_[stretch.block][piece.node] = stretch.sheet;
            for (const auto* list : {&piece.branches, &piece.before, &piece.after}) {
                for (const FlowSequence& branch : *list) number(branch, stretch);
            }
        }
    }

    void lay_out_all() {
        scene_ = {};
        parts_.clear();
        for (const Stretch& stretch : stretches_) parts_.push_back(part_of(stretch));
    }

    Part part_of(const Stretch& stretch) {
        std::vector<const FlowSequence*> sequences;
        for (const FlowSequence& sequence : stretch.sequences) sequences.push_back(&sequence);
        LaidOutBlock laid = lay_out(flows_[stretch.block], sequences, sheets_[stretch.block],
                                    symbols_, how_.language, scene_);
        add_heading(laid, grafcet_.blocks[grafcet_.blocks.id_at(stretch.block)]);
        laid.bounds = bounds_of(laid.shapes);
        move(laid.shapes, -laid.bounds.left, -laid.bounds.top);
        return {std::move(laid.shapes), laid.bounds.right - laid.bounds.left,
                laid.bounds.bottom - laid.bounds.top};
    }

    /// The name of a graph above it; that of an enclosed one in the frame round it.
    void add_heading(LaidOutBlock& laid, const Block& block) {
        Pen pen(laid.shapes, scene_.owners.add({"graph", {{"graph", block.name}}, {}}));
        const Bounds& bounds = laid.bounds;
        const EnclosureId enclosure =
            block.is_expansion ? EnclosureId(none) : grafcet_.graphs[block.graph].enclosed_by;
        if (enclosure != none) {
            add_frame(laid, pen, block.name,
                      grafcet_.steps[grafcet_.enclosures[enclosure].step].name);
            return;
        }
        if (grafcet_.blocks.size() == 1) return;
        std::string name = block.name;
        if (block.is_expansion) {
            for (const Macro& macro : grafcet_.macros) {
                if (&grafcet_.blocks[macro.expansion] == &block) {
                    name = messages::draw::expansion(macro.name).in(how_.language);
                }
            }
        }
        pen.label(plain_text(std::move(name)), {std::min(-0.5, bounds.left), bounds.top - 0.6},
                  Label::Anchor::start, Label::Role::name);
    }

    /// The enclosing step breaks the upper edge, the name of the graph the lower one.
    void add_frame(const LaidOutBlock& laid, Pen& pen, const std::string& graph,
                   const std::string& step) {
        constexpr double room = 0.6;
        const Bounds frame{laid.bounds.left - room, laid.bounds.top - room,
                           laid.bounds.right + room, laid.bounds.bottom + room};
        const auto edge = [&](double y, const std::string& name) {
            const Text text = plain_text(name);
            const double half = width_of(text, Label::Role::name) / 2 + 0.15;
            const double middle =
                std::max(frame.left + 0.3 * (frame.right - frame.left), frame.left + half + 0.1);
            pen.line({{frame.left, y}, {middle - half, y}}, Line::Weight::frame);
            pen.line({{middle + half, y}, {std::max(frame.right, middle + half), y}},
                     Line::Weight::frame);
            pen.label(text, {middle, y}, Label::Anchor::middle, Label::Role::name);
        };
        edge(frame.top, step);
        edge(frame.bottom, graph);
        for (const double x : {frame.left, frame.right}) {
            pen.line({{x, frame.top}, {x, frame.bottom}}, Line::Weight::frame);
        }
    }

    /// The first size that holds all on one sheet.
    std::optional<SheetSize> one_sheet() const {
        for (const double unit : sheet_units) {
            for (const bool lies : {false, true}) {
                const SheetSize size = sheet_size(how_.paper, unit, lies);
                if (fits_one_sheet(parts_, size)) return size;
            }
        }
        return std::nullopt;
    }

    /// Cuts what is too long, in the size that needs the fewest sheets; where several do, the one
    /// with the fewest cuts, and of those the first. Enters the sheet of each stretch.
    SheetSize cut_for_sheets() {
        struct Trial {
            SheetSize size;
            std::vector<ChartFlow> flows;
            std::vector<Stretch> stretches;
        };
        const Trial whole{{}, flows_, stretches_};
        const std::vector<Part> whole_parts = parts_;
        std::optional<Trial> best;
        std::pair<std::size_t, std::size_t> least;
        for (const double unit : {sheet_units[0], sheet_units[std::size(sheet_units) - 1]}) {
            for (const bool lies : {false, true}) {
                const SheetSize size = sheet_size(how_.paper, unit, lies);
                flows_ = whole.flows;
                stretches_ = whole.stretches;
                cut_long_blocks(whole_parts, size);
                number_nodes();
                lay_out_all();
                const std::vector<Place> places = places_of(parts_, size);
                const std::pair cost{places.back().sheet, stretches_.size()};
                if (best && cost >= least) continue;
                least = cost;
                for (std::size_t i = 0; i < places.size(); ++i) {
                    stretches_[i].sheet = places[i].sheet + 1;
                }
                best = {size, std::move(flows_), std::move(stretches_)};
            }
        }
        flows_ = std::move(best->flows);
        stretches_ = std::move(best->stretches);
        return best->size;
    }

    // ---- Cutting

    /// `parts`: the stretches as they are laid out.
    void cut_long_blocks(const std::vector<Part>& parts, const SheetSize& size) {
        std::vector<Stretch> stretches;
        for (std::size_t i = 0; i < stretches_.size(); ++i) {
            Stretch& stretch = stretches_[i];
            if (parts[i].height <= size.height && parts[i].width <= size.width) {
                stretches.push_back(std::move(stretch));
                continue;
            }
            for (FlowSequence& sequence : stretch.sequences) {
                cut(stretch.block, std::move(sequence), size, stretches);
            }
        }
        stretches_ = std::move(stretches);
    }

    /// The sequence in stretches that are as long as fits a sheet. Where branches are too long for
    /// one, they are cut as well; what cannot be cut gets a larger sheet.
    void cut(std::size_t block, FlowSequence sequence, const SheetSize& size,
             std::vector<Stretch>& stretches) {
        std::vector<FlowNode>& nodes = flows_[block].nodes;
        std::vector<FlowSequence> waiting;
        waiting.push_back(std::move(sequence));
        while (!waiting.empty()) {
            FlowSequence next = std::move(waiting.back());
            waiting.pop_back();
            const std::size_t count = longest_fit(block, next, size);
            if (count < next.pieces.size()) waiting.push_back(cut_before(nodes, next, count));
            while (!fits(block, next, next.pieces.size(), size)) {
                std::vector<FlowSequence> rests = cut_largest_branch(nodes, next);
                if (rests.empty()) break;
                for (FlowSequence& rest : rests) waiting.push_back(std::move(rest));
            }
            Stretch stretch{block, {}, 0};
            stretch.sequences.push_back(std::move(next));
            stretches.push_back(std::move(stretch));
        }
    }

    /// How many of its pieces fit, up to a place where it may be cut; where not even the first of
    /// these fits, up to there. Small ones are tried first, then the rest is halved.
    std::size_t longest_fit(std::size_t block, const FlowSequence& sequence,
                            const SheetSize& size) {
        std::vector<std::size_t> cuts = places_to_cut(flows_[block].nodes, sequence);
        cuts.push_back(sequence.pieces.size());
        std::size_t low = 0;
        std::size_t high = 1;
        while (high < cuts.size() && fits(block, sequence, cuts[high], size)) {
            low = high;
            high = std::min(2 * high, cuts.size());
        }
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (fits(block, sequence, cuts[middle], size) ? low : high) = middle;
        }
        return cuts[low];
    }

    bool fits(std::size_t block, const FlowSequence& sequence, std::size_t count,
              const SheetSize& size) {
        FlowSequence begun;
        begun.pieces.assign(sequence.pieces.begin(),
                            sequence.pieces.begin() + static_cast<std::ptrdiff_t>(count));
        begun.end = count == sequence.pieces.size() ? sequence.end : FlowSequence::End::stops;
        begun.target = sequence.target;
        const Part part = part_of({block, {std::move(begun)}, 0});
        // What is written at cut links comes on top.
        return part.width <= size.width && part.height + 1.5 <= size.height;
    }

    // ---- Sheets

    std::vector<Sheet> sheets_with(const std::vector<Place>& places, const SheetSize& size) {
        const std::size_t count = places.back().sheet + 1;
        std::vector<Sheet> sheets(count);
        for (std::size_t i = 0; i < places.size(); ++i) {
            std::vector<Shape> shapes = std::move(parts_[i].shapes);
            move(shapes, sheet_margin + places[i].x, sheet_margin + title_room + places[i].y);
            std::vector<Shape>& all = sheets[places[i].sheet].scene.shapes;
            all.insert(all.end(), std::make_move_iterator(shapes.begin()),
                       std::make_move_iterator(shapes.end()));
        }
        for (std::size_t i = 0; i < count; ++i) {
            Sheet& sheet = sheets[i];
            add_title(sheet, i, count);
            fit_sheet(sheet, size, count > 1);
        }
        for (Sheet& sheet : sheets) sheet.scene.owners = scene_.owners;
        return sheets;
    }

    void add_title(Sheet& sheet, std::size_t number, std::size_t count) {
        std::string title = grafcet_.name;
        if (!grafcet_.title.empty()) title += " – " + grafcet_.title;
        if (!how_.situation.caption.empty()) title += " – " + how_.situation.caption;
        if (count > 1) {
            title += " – " + messages::draw::sheet(number + 1, count).in(how_.language);
        }
        Pen pen(sheet.scene.shapes, scene_.owners.add({"title", {}, {}}));
        pen.label(plain_text(std::move(title)), {sheet_margin, sheet_margin + 0.3},
                  Label::Anchor::start, Label::Role::title);
    }

    const Grafcet& grafcet_;
    const ChartDrawing& how_;
    Scene scene_;
    SymbolMaker symbols_;
    std::vector<ChartFlow> flows_;     ///< by block
    std::vector<Stretch> stretches_;   ///< in the order of the file
    std::vector<SheetOfNode> sheets_;  ///< by block
    std::vector<Part> parts_;          ///< by stretch
};

}  // namespace

std::vector<Sheet> draw_chart(const Grafcet& grafcet, const ChartDrawing& how) {
    return ChartSheets(grafcet, how).make();
}

}  // namespace grafwire
