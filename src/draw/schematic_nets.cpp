#include "draw/schematic_nets.h"

#include <fmt/format.h>

#include <string_view>
#include <unordered_set>

#include "text/utf8.h"

namespace grafwire {

namespace {

/// Longer words would push everything else aside.
constexpr std::size_t longest = 24;

class NetWords {
  public:
    NetWords(const Netlist& netlist, const Table<NetId, CellId>& drivers)
        : netlist_(netlist), drivers_(drivers), words_(netlist.net_count()) {}

    std::vector<std::string> take() {
        for (std::size_t i = 0; i < words_.size(); ++i) words(static_cast<NetId>(i));
        make_unique();
        return std::move(words_);
    }

  private:
    /// Recursive, but each level has a shorter name than the one above it.
    const std::string& words(NetId net) {
        std::string& made = words_[index_of(net)];
        if (!made.empty()) return made;
        std::string found = found_words(net);
        if (found.empty() || count_code_points(found) > longest) found = netlist_.names[net];
        return made = std::move(found);
    }

    std::string found_words(NetId net) {
        if (drivers_[net] == no_cell) return {};
        const Cell& cell = netlist_.cells[drivers_[net]];
        const std::string_view name = netlist_.names[net];
        if (cell.type == CellType::inverter && is_named_after(net, "$not")) {
            return "/" + words(netlist_.pins_of(cell).front());
        }
        if (cell.type == CellType::buffer && is_named_after(net, "$buf")) {
            return words(netlist_.pins_of(cell).front()) + "′";
        }
        if (const std::string_view transition = cleared(name); !transition.empty()) {
            return "(" + std::string(transition) + ")";
        }
        const Origin& origin = netlist_.origin_of(cell);
        switch (origin.kind) {
            case Origin::Kind::edge:
            case Origin::Kind::time_condition: {
                const std::size_t role = name.rfind('$');
                const bool is_whole = role != std::string_view::npos && is_result(name, role);
                return is_whole ? origin.name : "";
            }
            default:
                return {};
        }
    }

    /// The transition whose clearing a net is, by its name: `T3$clear`.
    static std::string_view cleared(std::string_view name) {
        constexpr std::string_view role = "$clear";
        if (!name.starts_with('T') || !name.ends_with(role)) return {};
        const std::string_view transition = name.substr(1, name.size() - 1 - role.size());
        return transition.find('$') == std::string_view::npos ? transition : std::string_view();
    }

    /// Whether the net is named after the net that its cell reads, with that role.
    bool is_named_after(NetId net, std::string_view role) const {
        const NetId input = netlist_.pins_of(netlist_.cells[drivers_[net]]).front();
        const std::string_view name = netlist_.names[net];
        const std::string_view owner = netlist_.names[input];
        return name.size() == owner.size() + role.size() && name.starts_with(owner) &&
               name.ends_with(role);
    }

    /// `edge$3`, `a$rise3`, `a$fall3`, `timer$3`, `X2$timer3`: the edge or the condition itself,
    /// not a gate that helps to make it.
    static bool is_result(std::string_view name, std::size_t role) {
        std::string_view part = name.substr(role + 1);
        while (!part.empty() && is_digit(part.back())) part.remove_suffix(1);
        if (part.size() + role + 1 == name.size()) return false;
        if (part.empty()) return name.starts_with("edge$") || name.starts_with("timer$");
        return part == "rise" || part == "fall" || part == "timer";
    }

    void make_unique() {
        std::unordered_set<std::string> taken;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            if (words_[i] == netlist_.names[static_cast<NetId>(i)]) taken.insert(words_[i]);
        }
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const std::string_view own = netlist_.names[static_cast<NetId>(i)];
            if (words_[i] != own && !taken.insert(words_[i]).second) words_[i] = own;
        }
    }

    const Netlist& netlist_;
    const Table<NetId, CellId>& drivers_;
    std::vector<std::string> words_;
};

}  // namespace

std::vector<std::string> shown_names(const Netlist& netlist, const Table<NetId, CellId>& drivers) {
    return NetWords(netlist, drivers).take();
}

SchematicNets::SchematicNets(const Netlist& all)
    : netlist(all),
      drivers(drivers_of(all)),
      uses(all.net_count()),
      is_output(all.net_count()),
      names(shown_names(all, drivers)) {
    for (const NetId pin : all.pins) ++uses[index_of(pin)];
    for (const Port& port : all.outputs) {
        ++uses[index_of(port.net)];
        is_output[index_of(port.net)] = 1;
    }
}

}  // namespace grafwire
