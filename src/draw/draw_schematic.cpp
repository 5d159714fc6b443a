// Modules on sheets. A module is one block, or several where it is higher than a sheet; blocks
// stand in rows, from left to right and from the upper edge down, and those of the steps are all
// equally wide, so that they stand in columns. Once it is known which block is on which sheet, the
// index is made, and each sheet is drawn by itself: the work grows with the number of cells and no
// faster.

#include "draw/draw_schematic.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "draw/messages.h"
#include "draw/schematic_index.h"
#include "draw/schematic_layout.h"
#include "draw/schematic_lines.h"
#include "draw/schematic_trees.h"
#include "draw/sheet_size.h"

namespace grafwire {

namespace say = messages::draw;

namespace {

constexpr double padding = 0.25;  ///< within the frame of a module
constexpr double module_gap = 0.5;
constexpr double title_line = 0.45;
/// Of a block that need not be higher: what a lying sheet has room for.
constexpr double most_height = 19;
/// Steps are equally wide as long as one fits an upright sheet.
constexpr double most_width = 22;

/// A frame with what is in it, or a column of the index.
struct Block {
    std::vector<std::string> title;
    Owner owner;
    std::optional<LaidPart> part;
    std::vector<Port> ports;  ///< output ports by the net that they are joined to
    std::optional<IndexColumn> index;
    PartWidths widths;
    double width = 0;
    double height = 0;
    // Where it stands.
    std::size_t sheet = 0;
    double x = 0;
    double y = 0;

    double title_height() const { return static_cast<double>(title.size()) * title_line; }
};

/// An equation in lines of that width; one that would fill the sheet ends with an ellipsis.
std::vector<std::string> title_lines(const std::string& text, double width) {
    constexpr std::size_t most = 3;
    std::vector<std::string> lines;
    std::string line;
    double used = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        const double wide = width_of(plain_text(word + " "));
        if (!line.empty() && used + wide > width) {
            if (lines.size() + 1 == most) {
                line += " …";
                break;
            }
            lines.push_back(std::move(line));
            line.clear();
            used = 0;
        }
        if (!line.empty()) line += ' ';
        line += word;
        used += wide;
        at = end + 1;
    }
    if (!line.empty()) lines.push_back(std::move(line));
    return lines;
}

class SchematicSheets {
  public:
    SchematicSheets(const Netlist& netlist, const SchematicDrawing& how)
        : netlist_(netlist),
          how_(how),
          nets_(netlist),
          view_{nets_, how.shapes, how.language, how.values} {}

    std::vector<Sheet> make() {
        add_modules();
        add_ports();
        size_blocks();
        const SheetSize size = best_size();
        place(size, 0);
        if (!blocks_.empty() && blocks_.back().sheet > 0) add_index(size);
        return drawn(size);
    }

  private:
    // ---- Blocks

    void add_modules() {
        std::vector<Range<CellId>> modules;
        for (const Module& module : netlist_.modules) {
            modules.push_back({module.first_cell, module.cell_count});
        }
        if (modules.empty() && !netlist_.cells.empty()) {
            modules.push_back({0, static_cast<std::uint32_t>(netlist_.cells.size())});
        }
        std::vector<std::uint8_t> is_done(modules.size());
        for (std::size_t i = 0; i < netlist_.step_count; ++i) {
            const CellId cell = nets_.drivers[netlist_.outputs[i].net];
            if (cell == no_cell) continue;
            const auto after = std::upper_bound(
                modules.begin(), modules.end(), index_of(cell),
                [](std::size_t at, const Range<CellId>& range) { return at < range.first; });
            const auto module = static_cast<std::size_t>(after - modules.begin()) - 1;
            if (is_done[module]++ == 0) add_module(modules[module], module, &netlist_.outputs[i]);
        }
        step_blocks_ = blocks_.size();
        for (std::size_t i = 0; i < modules.size(); ++i) {
            if (is_done[i] == 0 && modules[i].count != 0) add_module(modules[i], i, nullptr);
        }
    }

    /// `step`: the X that the module is of, if any.
    void add_module(Range<CellId> cells, std::size_t number, const Port* step) {
        const Module* module =
            number < netlist_.modules.size() ? &netlist_.modules[number] : nullptr;
        Owner owner{"module", {}, {}};
        if (module != nullptr) owner.facts.emplace_back("module", module->name);
        if (step != nullptr) {
            owner.kind += " step";
            const Origin& origin = netlist_.origin_of(netlist_.cells[nets_.drivers[step->net]]);
            owner.facts.emplace_back(
                "step", origin.kind == Origin::Kind::step ? origin.name : step->name.substr(1));
        }
        const std::string title = title_of(cells, module);
        std::vector<GateTree> trees = trees_of(nets_, cells);
        std::size_t part = 0;
        for (std::size_t first = 0; first < trees.size(); ++part) {
            double height = height_of(view_, trees[first]);
            std::size_t end = first + 1;
            while (end < trees.size() && height + height_of(view_, trees[end]) <= most_height) {
                height += height_of(view_, trees[end++]);
            }
            Block block;
            block.owner = owner;
            block.title = {part == 0 ? title : say::continued(title, part + 1).in(how_.language)};
            block.part = lay_out(
                view_, {std::make_move_iterator(trees.begin() + static_cast<std::ptrdiff_t>(first)),
                        std::make_move_iterator(trees.begin() + static_cast<std::ptrdiff_t>(end))});
            block.widths = block.part->widths;
            blocks_.push_back(std::move(block));
            first = end;
        }
    }

    /// The equation of a module, or what it is for.
    std::string title_of(Range<CellId> cells, const Module* module) const {
        if (module == nullptr) return netlist_.name;
        if (!module->comment.empty()) return module->comment;
        if (module->name == "inputs") return say::complements.in(how_.language);
        if (module->name == "edges") return say::edges.in(how_.language);
        const Origin& origin =
            netlist_.origin_of(netlist_.cells[CellId{cells.first + cells.count - 1}]);
        const auto named = [&](const Message<std::string>& words) {
            return words.in(how_.language, origin.name);
        };
        switch (origin.kind) {
            case Origin::Kind::step:
                return named(say::step_module);
            case Origin::Kind::transition:
                return named(say::transition);
            case Origin::Kind::output:
                return named(say::output);
            case Origin::Kind::var:
                return named(say::var);
            case Origin::Kind::counter:
                return named(say::counter);
            case Origin::Kind::graph:
                return named(say::graph);
            case Origin::Kind::time_condition:
                return named(say::time_condition);
            default:
                return module->name;
        }
    }

    /// Output ports that no gate drives under their own name.
    void add_ports() {
        Block block;
        for (const Port& port : netlist_.outputs) {
            if (nets_.drivers[port.net] != no_cell && netlist_.names[port.net] == port.name)
                continue;
            block.ports.push_back(port);
            block.widths.names =
                std::max(block.widths.names, width_of(view_.label(port.net)) + name_gap);
            block.widths.roots = std::max(block.widths.roots, width_of(plain_text(port.name)) + 1);
        }
        if (block.ports.empty()) return;
        block.owner = {"module", {{"module", "ports"}}, {}};
        block.title = {say::ports.in(how_.language)};
        blocks_.push_back(std::move(block));
    }

    void size_blocks() {
        PartWidths common;
        for (std::size_t i = 0; i < step_blocks_; ++i) common.include(blocks_[i].widths);
        for (std::size_t i = 0; i < blocks_.size(); ++i) {
            Block& block = blocks_[i];
            if (i < step_blocks_ && common.total() <= most_width) block.widths = common;
            block.width = std::max(block.widths.total() + 2 * padding, 4.0);
            block.title = title_lines(block.title.front(), block.width);
            const double content = block.part ? block.part->height
                                              : static_cast<double>(block.ports.size()) * pin_pitch;
            block.height = block.title_height() + content + 2 * padding;
            for (const std::string& line : block.title) {
                block.width = std::max(block.width, width_of(plain_text(line)));
            }
        }
    }

    // ---- Sheets

    /// Puts the blocks from one on into rows, on sheets, below those that stand there.
    void place(const SheetSize& size, std::size_t first) {
        std::size_t sheet = first == 0 ? 0 : blocks_[first - 1].sheet;
        double x = 0, y = 0, row_height = 0;
        for (std::size_t i = first; i-- > 0 && blocks_[i].sheet == sheet;) {
            y = std::max(y, blocks_[i].y + blocks_[i].height + module_gap);
        }
        for (std::size_t i = first; i < blocks_.size(); ++i) {
            Block& block = blocks_[i];
            if (x > 0 && x + block.width > size.width) {
                x = 0;
                y += row_height + module_gap;
                row_height = 0;
            }
            if ((x > 0 || y > 0) && y + block.height > size.height) {
                ++sheet;
                x = y = row_height = 0;
            }
            block.sheet = sheet;
            block.x = x;
            block.y = y;
            x += block.width + module_gap;
            row_height = std::max(row_height, block.height);
        }
    }

    bool fit(const SheetSize& size) const {
        return std::all_of(blocks_.begin(), blocks_.end(), [&](const Block& block) {
            return block.width <= size.width && block.height <= size.height;
        });
    }

    /// The first size that holds all on one sheet; else, of those in which each block fits a sheet
    /// and letters need not be small, the one that takes the fewest; else the largest.
    SheetSize best_size() {
        std::optional<SheetSize> best;
        std::size_t fewest = 0;
        for (const double unit : sheet_units) {
            const bool is_small = unit == sheet_units[std::size(sheet_units) - 1];
            for (const bool lies : {false, true}) {
                const SheetSize size = sheet_size(how_.paper, unit, lies);
                if (!fit(size)) continue;
                place(size, 0);
                const std::size_t sheets = blocks_.empty() ? 0 : blocks_.back().sheet;
                if (sheets == 0) return size;
                if (best && (is_small || sheets >= fewest)) continue;
                best = size;
                fewest = sheets;
            }
        }
        return best.value_or(sheet_size(how_.paper, sheet_units[0], false));
    }

    void add_index(const SheetSize& size) {
        Table<NetId, IndexEntry> entries(netlist_.net_count());
        std::vector<NetId> named;
        const auto entry_of = [&](NetId net) -> IndexEntry& {
            IndexEntry& entry = entries[net];
            if (entry.net == no_net) {
                entry.net = net;
                named.push_back(net);
            }
            return entry;
        };
        for (const Block& block : blocks_) {
            if (!block.part) continue;
            for (const LaidGate& gate : block.part->gates) {
                if (gate.is_named)
                    entry_of(netlist_.cells[gate.cell].output).made_on = block.sheet + 1;
            }
        }
        const auto read = [&](NetId net, const Block& block) {
            std::vector<std::size_t>& sheets = entry_of(net).read_on;
            if (sheets.empty() || sheets.back() != block.sheet + 1)
                sheets.push_back(block.sheet + 1);
        };
        for (const Block& block : blocks_) {
            for (const Port& port : block.ports) read(port.net, block);
            if (!block.part) continue;
            for (const LaidGate& gate : block.part->gates) {
                for (const LaidPin& pin : gate.pins) {
                    const bool by_name =
                        pin.kind == LaidPin::Kind::name || pin.kind == LaidPin::Kind::own_name;
                    if (by_name) read(pin.net, block);
                }
            }
        }
        std::vector<IndexEntry> all;
        for (const NetId net : named) all.push_back(std::move(entries[net]));
        add_columns(std::move(all), size);
    }

    /// In columns side by side, each as high as the others and no higher than a sheet.
    void add_columns(std::vector<IndexEntry> entries, const SheetSize& size) {
        const std::size_t first = blocks_.size();
        const auto most = static_cast<std::size_t>((size.height - title_line) / title_line) - 1;
        const double wide = IndexColumn(view_, entries).width() + 2 * module_gap;
        const auto beside = static_cast<std::size_t>(std::max(1.0, size.width / wide));
        const std::size_t rows = (entries.size() + beside - 1) / beside;
        for (IndexColumn& column :
             index_columns(view_, std::move(entries), std::clamp<std::size_t>(rows, 1, most))) {
            Block block;
            block.width = column.width() + module_gap;
            block.height = column.height() + title_line;
            if (blocks_.size() == first) block.title = {say::index_of_names.in(how_.language)};
            block.index = std::move(column);
            blocks_.push_back(std::move(block));
        }
        place(size, first);
    }

    std::vector<Sheet> drawn(const SheetSize& size) {
        const std::size_t count = blocks_.empty() ? 1 : blocks_.back().sheet + 1;
        std::vector<Sheet> sheets(count);
        std::size_t next = 0;
        for (std::size_t i = 0; i < count; ++i) {
            Sheet& sheet = sheets[i];
            SchematicPens pens(view_, sheet.scene);
            add_title(pens, i, count);
            for (; next < blocks_.size() && blocks_[next].sheet == i; ++next) {
                draw(pens, blocks_[next]);
            }
            fit_sheet(sheet, size, count > 1);
        }
        return sheets;
    }

    void add_title(SchematicPens& pens, std::size_t number, std::size_t count) {
        std::string title = how_.title;
        if (count > 1) title += " – " + say::sheet(number + 1, count).in(how_.language);
        Pen pen = pens.owned_by({"title", {}, {}});
        pen.label(plain_text(std::move(title)), {sheet_margin, sheet_margin + 0.15},
                  Label::Anchor::start, Label::Role::title);
        const bool has_delayed =
            std::any_of(nets_.names.begin(), nets_.names.end(),
                        [](const std::string& name) { return name.ends_with("′"); });
        if (number > 0 || !has_delayed) return;
        pen.label(plain_text(say::gate_delay_later.in(how_.language)),
                  {sheet_margin, sheet_margin + 0.63}, Label::Anchor::start, Label::Role::remark);
    }

    void draw(SchematicPens& pens, const Block& block) {
        const Point at{sheet_margin + block.x, sheet_margin + title_room + block.y};
        Pen pen =
            pens.owned_by(block.owner.kind.empty() ? Owner{"index-head", {}, {}} : block.owner);
        double y = at.y;
        for (const std::string& line : block.title) {
            pen.label(plain_text(line), {at.x, y + title_line / 2 - 0.05}, Label::Anchor::start);
            y += title_line;
        }
        if (block.index) {
            block.index->draw(pens, {at.x, at.y + title_line});
            return;
        }
        const double right = at.x + block.widths.total() + 2 * padding;
        const double bottom = at.y + block.height;
        pen.line({{at.x, y}, {right, y}, {right, bottom}, {at.x, bottom}, {at.x, y}},
                 Line::Weight::aid);
        const Point inside{at.x + padding, y + padding};
        if (block.part) {
            draw_part(pens, view_, *block.part, block.widths, inside);
        } else {
            draw_ports(pens, block, inside);
        }
    }

    void draw_ports(SchematicPens& pens, const Block& block, Point at) {
        double y = at.y + pin_pitch / 2;
        const double names = at.x + block.widths.names;
        for (const Port& port : block.ports) {
            Pen net = pens.net(port.net);
            net.label(view_.label(port.net), {names - name_gap, y}, Label::Anchor::end);
            net.line({{names, y}, {names + 0.8, y}});
            pens.owned_by({"port",
                           {{"port", port.name}, {"net", std::string(netlist_.names[port.net])}},
                           {}})
                .label(plain_text(port.name), {names + 0.9, y}, Label::Anchor::start);
            y += pin_pitch;
        }
    }

    const Netlist& netlist_;
    const SchematicDrawing& how_;
    SchematicNets nets_;
    SchematicView view_;
    std::vector<Block> blocks_;
    std::size_t step_blocks_ = 0;  ///< the first so many are of steps
};

}  // namespace

std::vector<Sheet> draw_schematic(const Netlist& netlist, const SchematicDrawing& how) {
    return SchematicSheets(netlist, how).make();
}

}  // namespace grafwire
