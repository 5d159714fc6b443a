#include "draw/schematic_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace grafwire::testing {

namespace {

constexpr double close = 0.05;  // of a pixel

struct Spot {
    double x = 0, y = 0;
};

bool is_on(const Spot& spot, const Stroke& stroke) {
    const Area area = stroke.area();
    if (spot.x < area.left - close || spot.x > area.right + close) return false;
    if (spot.y < area.top - close || spot.y > area.bottom + close) return false;
    const double cross = (stroke.x2 - stroke.x1) * (spot.y - stroke.y1) -
                         (stroke.y2 - stroke.y1) * (spot.x - stroke.x1);
    return std::abs(cross) <= close * std::hypot(stroke.x2 - stroke.x1, stroke.y2 - stroke.y1);
}

bool is_end(const Spot& spot, const Stroke& stroke) {
    return std::hypot(spot.x - stroke.x1, spot.y - stroke.y1) < close ||
           std::hypot(spot.x - stroke.x2, spot.y - stroke.y2) < close;
}

bool touch(const Stroke& a, const Stroke& b) {
    return is_on({a.x1, a.y1}, b) || is_on({a.x2, a.y2}, b) || is_on({b.x1, b.y1}, a) ||
           is_on({b.x2, b.y2}, a);
}

/// Whether a name begins or ends at the end of a line.
bool is_named_by(const Stroke& stroke, const Area& text) {
    constexpr double gap = 5;
    for (const Spot end : {Spot{stroke.x1, stroke.y1}, Spot{stroke.x2, stroke.y2}}) {
        const bool level = end.y > text.top && end.y < text.bottom;
        const bool beside = (end.x >= text.right && end.x < text.right + gap) ||
                            (end.x <= text.left && end.x > text.left - gap);
        if (level && beside) return true;
    }
    return false;
}

std::string cell_name(const Netlist& netlist, const Cell& cell) {
    return std::string(netlist.names[cell.output]);
}

/// The pins of the picture by cell and pin.
using Pins = std::map<std::pair<std::string, std::string>, const PictureGroup*>;
Pins pins_of(const Picture& picture, Faults& faults) {
    Pins pins;
    for (const PictureGroup* pin : picture.all("pin")) {
        const bool is_new = pins.insert({{pin->fact("cell"), pin->fact("pin")}, pin}).second;
        if (!is_new || pin->strokes.size() != 1) {
            faults.push_back(
                fmt::format("pin {} of {} is there twice", pin->fact("pin"), pin->fact("cell")));
        }
    }
    return pins;
}

/// What is drawn of a net: its lines and pins in pieces that hang together, and its names.
struct DrawnNet {
    std::vector<Stroke> strokes;
    std::vector<bool> drives;  ///< by stroke: it is the output pin
    std::vector<Area> names;
    std::vector<Spot> dots;
    std::vector<std::size_t> piece;  ///< by stroke: the number of its piece

    bool are_joined(const Stroke& a, const Stroke& b) const {
        return touch(a, b) || std::any_of(dots.begin(), dots.end(), [&](const Spot& dot) {
                   return is_on(dot, a) && is_on(dot, b);
               });
    }

    void find_pieces() {
        piece.resize(strokes.size());
        std::iota(piece.begin(), piece.end(), std::size_t{0});
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < strokes.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    if (piece[i] == piece[j] || !are_joined(strokes[i], strokes[j])) continue;
                    const std::size_t least = std::min(piece[i], piece[j]);
                    piece[i] = piece[j] = least;
                    changed = true;
                }
            }
        }
    }
};

std::map<std::string, DrawnNet> drawn_nets(const Picture& picture) {
    std::map<std::string, DrawnNet> nets;
    for (const PictureGroup& group : picture.groups) {
        if (group.kind != "net" && group.kind != "pin") continue;
        DrawnNet& net = nets[group.fact("net")];
        for (const Stroke& stroke : group.strokes) {
            net.strokes.push_back(stroke);
            net.drives.push_back(group.fact("pin") == "out");
        }
        net.names.insert(net.names.end(), group.texts.begin(), group.texts.end());
        for (const Area& dot : group.marks) {
            net.dots.push_back({dot.middle(), (dot.top + dot.bottom) / 2});
        }
    }
    return nets;
}

/// The sheet on which something stands, from 1 on: sheets begin at their titles.
std::size_t sheet_of(const Picture& picture, double y) {
    std::size_t sheet = 0;
    for (const PictureGroup* title : picture.all("title")) sheet += title->texts.front().top <= y;
    return sheet;
}

}  // namespace

Faults missing_cells(const Netlist& netlist, const Picture& picture) {
    Faults faults;
    std::map<std::string, const PictureGroup*> drawn;
    for (const PictureGroup* cell : picture.all("cell")) {
        if (!drawn.insert({cell->fact("cell"), cell}).second) {
            faults.push_back(fmt::format("cell {} is there twice", cell->fact("cell")));
        }
    }
    if (drawn.size() != netlist.cells.size()) {
        faults.push_back(
            fmt::format("{} cells rather than {}", drawn.size(), netlist.cells.size()));
    }
    const Pins pins = pins_of(picture, faults);
    std::size_t count = 0;
    for (const Cell& cell : netlist.cells) {
        const std::string name = cell_name(netlist, cell);
        const auto found = drawn.find(name);
        if (found == drawn.end() || found->second->fact("type") != row_of(cell.type).name) {
            faults.push_back(fmt::format("cell {} is not there", name));
        }
        const auto expect = [&](const std::string& pin, NetId net) {
            const auto there = pins.find({name, pin});
            if (there == pins.end() || there->second->fact("net") != netlist.names[net]) {
                faults.push_back(fmt::format("pin {} of {} is not there", pin, name));
            }
            ++count;
        };
        for (std::uint32_t pin = 0; pin < cell.pin_count; ++pin) {
            expect(std::to_string(pin), netlist.pins_of(cell)[pin]);
        }
        expect("out", cell.output);
    }
    if (count != pins.size()) faults.push_back("there are pins of no cell");
    return faults;
}

Faults unjoined_nets(const Netlist& netlist, const Picture& picture) {
    Faults faults;
    std::set<std::string> inputs;
    for (const Port& port : netlist.inputs) inputs.insert(std::string(netlist.names[port.net]));
    for (auto& [name, net] : drawn_nets(picture)) {
        net.find_pieces();
        std::map<std::size_t, std::pair<bool, bool>> pieces;  // drives, is named
        for (std::size_t i = 0; i < net.strokes.size(); ++i) {
            auto& [drives, is_named] = pieces[net.piece[i]];
            drives = drives || net.drives[i];
            const Stroke& stroke = net.strokes[i];
            is_named = is_named || std::any_of(net.names.begin(), net.names.end(), [&](auto& text) {
                           return is_named_by(stroke, text);
                       });
        }
        const bool is_whole = pieces.size() == 1 && !inputs.contains(name);
        for (const auto& [piece, has] : pieces) {
            if (has.second || (is_whole && has.first)) continue;
            const auto first = std::find(net.piece.begin(), net.piece.end(), piece);
            const Stroke& stroke = net.strokes[static_cast<std::size_t>(first - net.piece.begin())];
            faults.push_back(fmt::format("the piece of net {} at {:.0f} {:.0f} has no name", name,
                                         stroke.x1, stroke.y1));
        }
    }
    return faults;
}

namespace {

/// Lines of nets and symbols, by bands of the picture: what is far apart need not be compared.
struct Band {
    struct Item {
        Stroke stroke;
        std::string net;
        bool is_pin = false;
    };
    std::vector<Item> lines;
    std::vector<Area> symbols;
};
std::map<int, Band> bands_of(const Picture& picture) {
    constexpr double height = 100;
    std::map<int, Band> bands;
    const auto add = [&](const Area& area, auto what) {
        const int last = static_cast<int>(area.bottom / height);
        for (int i = static_cast<int>(area.top / height); i <= last; ++i) what(bands[i]);
    };
    for (const PictureGroup& group : picture.groups) {
        const bool is_pin = group.kind == "pin";
        if (group.kind == "cell") {
            for (const Area& box : group.boxes) {
                add(box, [&](Band& band) { band.symbols.push_back(box); });
            }
        }
        if (group.kind != "net" && !is_pin) continue;
        for (const Stroke& stroke : group.strokes) {
            add(stroke.area(), [&](Band& band) {
                band.lines.push_back({stroke, group.fact("net"), is_pin});
            });
        }
    }
    return bands;
}

/// Slanted lines are those of latches, between their gates.
bool passes(const Stroke& stroke, const Area& box) {
    const Area area = stroke.area();
    return (stroke.is_level() || stroke.is_upright()) &&
           overlap({area.left - 1, area.top - 1, area.right + 1, area.bottom + 1}, box, 1.01);
}

void add_faults_of_lines(const Band& band, Faults& faults) {
    for (std::size_t i = 0; i < band.lines.size(); ++i) {
        const Band::Item& line = band.lines[i];
        for (const Area& box : band.symbols) {
            if (!line.is_pin && passes(line.stroke, box)) {
                faults.push_back(fmt::format("net {} passes a symbol", line.net));
            }
        }
        for (std::size_t j = 0; j < i; ++j) {
            const Band::Item& other = band.lines[j];
            if (line.net != other.net && touch(line.stroke, other.stroke)) {
                faults.push_back(fmt::format("nets {} and {} touch", line.net, other.net));
            }
        }
    }
}

void add_faults_of_dots(const std::string& name, const DrawnNet& net, Faults& faults) {
    const auto lines_at = [&](const Spot& spot) {
        std::size_t lines = 0;
        for (const Stroke& stroke : net.strokes) {
            if (is_on(spot, stroke)) lines += is_end(spot, stroke) ? 1 : 2;
        }
        return lines;
    };
    const auto has_dot = [&](const Spot& spot) {
        return std::any_of(net.dots.begin(), net.dots.end(), [&](const Spot& dot) {
            return std::hypot(dot.x - spot.x, dot.y - spot.y) < close;
        });
    };
    for (const Spot& dot : net.dots) {
        if (lines_at(dot) < 3) faults.push_back(fmt::format("a dot of {} joins less", name));
    }
    for (const Stroke& stroke : net.strokes) {
        for (const Spot end : {Spot{stroke.x1, stroke.y1}, Spot{stroke.x2, stroke.y2}}) {
            if (lines_at(end) > 2 && !has_dot(end)) {
                faults.push_back(fmt::format("lines of {} meet without a dot", name));
            }
        }
    }
}

}  // namespace

Faults tangled_lines(const Picture& picture) {
    Faults faults;
    for (const auto& [number, band] : bands_of(picture)) add_faults_of_lines(band, faults);
    for (const auto& [name, net] : drawn_nets(picture)) add_faults_of_dots(name, net, faults);
    return faults;
}

Faults wrong_names(const Netlist& netlist, const Picture& picture) {
    Faults faults;
    std::map<std::string, std::string> net_of;
    std::map<std::string, std::set<std::size_t>> sheets_of;
    for (const PictureGroup* group : picture.all("net")) {
        for (std::size_t i = 0; i < group->words.size(); ++i) {
            if (group->words[i].size() == 1 && group->classes.size() > 1) continue;  // a value
            const std::string net = group->fact("net");
            if (net_of.insert({group->words[i], net}).first->second != net) {
                faults.push_back(fmt::format("two nets are called {}", group->words[i]));
            }
            sheets_of[net].insert(sheet_of(picture, group->texts[i].top));
        }
    }
    const bool has_index = picture.all("title").size() > 1;
    std::map<std::string, std::set<std::size_t>> index;
    for (const PictureGroup* entry : picture.all("index")) {
        std::set<std::size_t>& sheets = index[entry->fact("net")];
        const std::string made = entry->fact("made-on");
        if (made != "0") sheets.insert(std::stoul(made));
        std::string read = entry->fact("read-on");
        for (std::size_t at = 0; at < read.size();) {
            const std::size_t end = std::min(read.find(' ', at), read.size());
            sheets.insert(std::stoul(read.substr(at, end - at)));
            at = end + 1;
        }
    }
    if (index != (has_index ? sheets_of : decltype(sheets_of){})) {
        faults.push_back(fmt::format("the index of {} is wrong", netlist.name));
    }
    return faults;
}

Faults all_schematic_faults(const Netlist& netlist, const Picture& picture) {
    Faults all;
    for (Faults faults :
         {missing_cells(netlist, picture), unjoined_nets(netlist, picture), tangled_lines(picture),
          wrong_names(netlist, picture), crowded_texts(picture)}) {
        all.insert(all.end(), faults.begin(), faults.end());
    }
    return all;
}

}  // namespace grafwire::testing
