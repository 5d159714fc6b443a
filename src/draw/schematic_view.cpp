#include "draw/schematic_view.h"

namespace grafwire {

namespace {

/// What a cell was made for, as a fact of its group.
std::string_view fact_of(Origin::Kind kind) {
    switch (kind) {
        case Origin::Kind::input:
            return "input";
        case Origin::Kind::step:
            return "step";
        case Origin::Kind::transition:
            return "transition";
        case Origin::Kind::output:
            return "output";
        case Origin::Kind::var:
            return "var";
        case Origin::Kind::counter:
            return "counter";
        case Origin::Kind::graph:
            return "graph";
        case Origin::Kind::edge:
            return "edge";
        case Origin::Kind::time_condition:
            return "time";
        case Origin::Kind::other:
            break;
    }
    return {};
}

}  // namespace

std::string SchematicView::value_of(NetId net) const {
    if (!shows_values()) return {};
    const Logic value = values[index_of(net)];
    return value == Logic::unknown ? "?" : value == Logic::one ? "1" : "0";
}

Text SchematicView::label(NetId net) const {
    const std::string& name = nets.names[index_of(net)];
    return plain_text(shows_values() ? name + " = " + value_of(net) : name);
}

std::string SchematicPens::with_value(std::string kind, NetId net) const {
    if (!view_.shows_values()) return kind;
    const Logic value = view_.values[index_of(net)];
    return kind + (value == Logic::unknown ? " unknown" : value == Logic::one ? " one" : " zero");
}

Pen SchematicPens::cell(CellId id) {
    const Netlist& netlist = view_.nets.netlist;
    const Cell& cell = netlist.cells[id];
    Owner owner{"cell",
                {{"cell", std::string(netlist.names[cell.output])},
                 {"type", std::string(row_of(cell.type).name)}},
                cell_description(netlist, id, view_.language)};
    const Origin& origin = netlist.origin_of(cell);
    const std::string_view fact = fact_of(origin.kind);
    if (!fact.empty()) owner.facts.emplace_back(fact, origin.name);
    return owned_by(std::move(owner));
}

Pen SchematicPens::pin(CellId id, std::uint32_t number) {
    const Netlist& netlist = view_.nets.netlist;
    const Cell& cell = netlist.cells[id];
    const bool is_output = number == output_pin;
    const NetId net = is_output ? cell.output : netlist.pins_of(cell)[number];
    return owned_by({with_value("pin", net),
                     {{"cell", std::string(netlist.names[cell.output])},
                      {"pin", is_output ? "out" : std::to_string(number)},
                      {"net", std::string(netlist.names[net])}},
                     {}});
}

Pen SchematicPens::net(NetId net) {
    const auto [found, is_new] =
        nets_.try_emplace(static_cast<std::uint32_t>(index_of(net)), OwnerId{});
    if (is_new) {
        const std::string& shown = view_.nets.names[index_of(net)];
        found->second =
            scene_.owners.add({with_value("net", net),
                               {{"net", std::string(view_.nets.netlist.names[net])}},
                               view_.shows_values() ? shown + " = " + view_.value_of(net) : shown});
    }
    return {scene_.shapes, found->second};
}

}  // namespace grafwire
