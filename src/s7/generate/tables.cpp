// The places of steps, transitions and graphs in their tables.
//
// A teacher who reads V21.3 should see step 13, so numbers decide first. What has no number that
// fits keeps with its graph: forcing a whole graph is then one S with a count per table (Cordier,
// section 5.6: "il est intéressant de 'caler' nos graphes sur des frontières de byte").

#include "s7/generate/tables.h"

#include <optional>
#include <string_view>

namespace grafwire::s7 {

namespace {

/// One table being filled.
class Places {
  public:
    Places(std::uint32_t bytes, std::vector<std::uint32_t> fixed)
        : places_(std::move(fixed)), used_(bytes * std::size_t{8}, false) {
        for (const std::uint32_t place : places_) {
            if (place != free_place) used_[place] = true;
        }
    }

    void take_if_free(std::size_t item, std::uint32_t place) {
        if (places_[item] != free_place || place >= used_.size() || used_[place]) return;
        put(item, place);
    }

    /// Places what is left of one graph: the items first … first + count - 1.
    void fill(std::size_t first, std::size_t count) {
        std::vector<std::size_t> rest;
        for (std::size_t item = first; item < first + count; ++item) {
            if (places_[item] == free_place) rest.push_back(item);
        }
        std::vector<std::uint32_t> room = own_bits(first, count);
        if (room.size() < rest.size()) {
            const std::size_t missing = rest.size() - room.size();
            for (const std::uint32_t place : whole_bytes(missing)) room.push_back(place);
        }
        std::size_t next = 0;
        for (const std::size_t item : rest) {
            while (next < room.size() && used_[room[next]]) ++next;
            put(item, next < room.size() ? room[next] : first_free());
        }
    }

    std::vector<std::uint32_t> finish() { return std::move(places_); }

  private:
    void put(std::size_t item, std::uint32_t place) {
        places_[item] = place;
        used_[place] = true;
    }

    bool is_free_byte(std::size_t byte) const {
        for (std::size_t bit = 0; bit < 8; ++bit) {
            if (used_[byte * 8 + bit]) return false;
        }
        return true;
    }

    /// The free bits of the bytes in which the items already have one.
    std::vector<std::uint32_t> own_bits(std::size_t first, std::size_t count) const {
        std::vector<bool> own(used_.size() / 8, false);
        for (std::size_t item = first; item < first + count; ++item) {
            if (places_[item] != free_place) own[places_[item] / 8] = true;
        }
        std::vector<std::uint32_t> bits;
        for (std::uint32_t place = 0; place < used_.size(); ++place) {
            if (own[place / 8] && !used_[place]) bits.push_back(place);
        }
        return bits;
    }

    /// The bits of the first run of free bytes that holds so many; none where there is no such run.
    std::vector<std::uint32_t> whole_bytes(std::size_t bits) const {
        const std::size_t wanted = (bits + 7) / 8;
        std::size_t found = 0;
        for (std::size_t byte = 0; byte < used_.size() / 8; ++byte) {
            found = is_free_byte(byte) ? found + 1 : 0;
            if (found < wanted) continue;
            std::vector<std::uint32_t> places;
            const auto from = static_cast<std::uint32_t>((byte + 1 - wanted) * 8);
            for (std::uint32_t i = 0; i < bits; ++i) places.push_back(from + i);
            return places;
        }
        return {};
    }

    std::uint32_t first_free() const {
        std::uint32_t place = 0;
        while (used_[place]) ++place;
        return place;
    }

    std::vector<std::uint32_t> places_;
    std::vector<bool> used_;
};

/// The bit that a name nm (or nnm) with m <= 7 stands for; a number as only the method writes it:
/// no zeros before it.
std::optional<std::uint32_t> numbered_place(std::string_view name) {
    if (name.empty() || name.size() > 3) return std::nullopt;
    if (name.size() > 1 && name.front() == '0') return std::nullopt;
    std::uint32_t number = 0;
    for (const char c : name) {
        if (c < '0' || c > '9') return std::nullopt;
        number = number * 10 + static_cast<std::uint32_t>(c - '0');
    }
    if (number % 10 > 7) return std::nullopt;
    return number / 10 * 8 + number % 10;
}

/// `G12` and `12` alike.
std::optional<std::uint32_t> graph_place(std::string_view name) {
    if (name.starts_with('G')) name.remove_prefix(1);
    return numbered_place(name);
}

std::vector<std::uint32_t> graph_places(const Grafcet& grafcet, const TableLayout& layout,
                                        bool wide, std::vector<std::uint32_t> fixed) {
    Places places(layout.graph_bytes, std::move(fixed));
    for (std::size_t g = 0; g < grafcet.graphs.size() && !wide; ++g) {
        if (const auto place = graph_place(grafcet.graphs[grafcet.graphs.id_at(g)].name)) {
            places.take_if_free(g, *place);
        }
    }
    places.fill(0, grafcet.graphs.size());
    return places.finish();
}

std::vector<std::uint32_t> step_places(const Grafcet& grafcet, const TableLayout& layout, bool wide,
                                       std::vector<std::uint32_t> fixed) {
    Places places(layout.step_bytes, std::move(fixed));
    for (std::size_t s = 0; s < grafcet.steps.size() && !wide; ++s) {
        if (const auto place = numbered_place(grafcet.steps[grafcet.steps.id_at(s)].name)) {
            places.take_if_free(s, *place);
        }
    }
    for (const Graph& graph : grafcet.graphs) places.fill(graph.steps.first, graph.steps.count);
    return places.finish();
}

std::vector<std::uint32_t> transition_places(const Grafcet& grafcet, const TableLayout& layout,
                                             bool wide, std::vector<std::uint32_t> fixed) {
    Places places(layout.transition_bytes, std::move(fixed));
    for (std::size_t t = 0; t < grafcet.transitions.size() && !wide; ++t) {
        const Transition& transition = grafcet.transitions[grafcet.transitions.id_at(t)];
        if (!transition.labelled) continue;
        if (const auto place = numbered_place(transition.name)) places.take_if_free(t, *place);
    }
    for (const Graph& graph : grafcet.graphs) {
        places.fill(graph.transitions.first, graph.transitions.count);
    }
    return places.finish();
}

/// The bytes of a table in which each graph begins a byte, in whole double words.
template <typename Count>
std::uint32_t bytes_of(const Grafcet& grafcet, const Count& count_of) {
    std::uint32_t bytes = 0;
    for (const Graph& graph : grafcet.graphs) bytes += (count_of(graph) + 7) / 8;
    return bytes == 0 ? 4 : (bytes + 3) / 4 * 4;
}

}  // namespace

std::uint32_t TableLayout::first_byte(BitKind kind) const {
    std::uint32_t table = 0;
    switch (kind) {
        case BitKind::previous:
            break;
        case BitKind::step:
            table = 1;
            break;
        case BitKind::pulse:
            table = 2;
            break;
        case BitKind::activate:
            table = 3;
            break;
        case BitKind::deactivate:
            table = 4;
            break;
        case BitKind::forced_on:
            table = 5;
            break;
        case BitKind::forced_off:
            table = 6;
            break;
        default:
            break;
    }
    return steps + table * step_bytes;
}

TableLayout standard_tables() {
    return {};
}

TableLayout wide_tables(const Grafcet& grafcet) {
    TableLayout layout;
    layout.step_bytes = bytes_of(grafcet, [](const Graph& graph) { return graph.steps.count; });
    layout.transitions = layout.steps + 7 * layout.step_bytes;
    layout.transition_bytes =
        bytes_of(grafcet, [](const Graph& graph) { return graph.transitions.count; });
    if (grafcet.graphs.size() <= 16) return layout;
    layout.graphs = layout.end();
    layout.graph_bytes = static_cast<std::uint32_t>((grafcet.graphs.size() + 15) / 16 * 2);
    return layout;
}

TablePlaces place_in_tables(const Grafcet& grafcet, const TableLayout& layout, bool wide,
                            TablePlaces fixed) {
    TablePlaces places;
    places.graphs = graph_places(grafcet, layout, wide, std::move(fixed.graphs));
    places.steps = step_places(grafcet, layout, wide, std::move(fixed.steps));
    places.transitions = transition_places(grafcet, layout, wide, std::move(fixed.transitions));
    return places;
}

}  // namespace grafwire::s7
