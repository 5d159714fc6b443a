// The elements of an LD body, before any of them is a contact of a rung: each with what stands in
// it and what its inlets are fed by, taken from the connections alone. Where elements lie on the
// page decides nothing but the order of networks and which comment belongs to which.

#include "plcopen/ladder_elements.h"

#include <algorithm>
#include <numeric>

#include "iec/identifiers.h"
#include "plcopen/messages.h"
#include "text/utf8.h"

namespace grafwire::plcopen {

namespace {

using Kind = Element::Kind;

constexpr std::pair<std::string_view, Kind> kinds[] = {{"leftPowerRail", Kind::left_rail},
                                                       {"rightPowerRail", Kind::right_rail},
                                                       {"contact", Kind::contact},
                                                       {"coil", Kind::coil},
                                                       {"block", Kind::block},
                                                       {"inVariable", Kind::in_variable},
                                                       {"outVariable", Kind::out_variable},
                                                       {"connector", Kind::connector},
                                                       {"continuation", Kind::continuation},
                                                       {"comment", Kind::comment}};

/// Elements that say where a network is; rails and values may serve several.
bool places_network(Kind kind) {
    return kind == Kind::contact || kind == Kind::coil || kind == Kind::block ||
           kind == Kind::out_variable;
}

}  // namespace

const ladder::BlockTypeRow* block_named(std::string_view block_type) {
    for (const ladder::BlockTypeRow& row : ladder::block_table) {
        if (row.name == block_type) return &row;
    }
    return nullptr;
}

std::optional<Relation> comparison_named(std::string_view block_type) {
    for (std::size_t i = 0; i < ladder::comparison_names.size(); ++i) {
        if (ladder::comparison_names[i] == block_type) return static_cast<Relation>(i);
    }
    return std::nullopt;
}

bool is_gate(std::string_view block_type) {
    return block_type == "AND" || block_type == "OR";
}

std::string default_output(std::string_view block_type) {
    const ladder::BlockTypeRow* row = block_named(block_type);
    return row == nullptr ? "OUT" : std::string(row->output);
}

const Inlet* Element::inlet(std::string_view name) const {
    for (const Inlet& inlet : inlets) {
        if (inlet.name == name) return &inlet;
    }
    return nullptr;
}

LadderElements::LadderElements(const Source& source, pugi::xml_node body) : source_(source) {
    for (const pugi::xml_node node : body.children()) {
        if (node.type() == pugi::node_element) read(node);
    }
    connect();
    follow_connectors();
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        for (std::size_t i = 0; i < elements_[e].inlets.size(); ++i) {
            if (elements_[e].kind == Kind::right_rail) continue;
            for (const Output& output : elements_[e].inlets[i].sources) {
                consumers_[output].push_back({e, i});
            }
        }
    }
    number_networks();
}

void LadderElements::read(pugi::xml_node node) {
    const auto* kind = std::find_if(std::begin(kinds), std::end(kinds),
                                    [&](const auto& row) { return row.first == local_name(node); });
    if (kind == std::end(kinds)) {
        source_.error(node, messages::plcopen::unknown_element(local_name(node)));
        return;
    }
    Element element;
    element.kind = kind->second;
    element.node = node;
    const pugi::xml_node position = child_named(node, "position");
    element.x = position.attribute("x").as_int();
    element.y = position.attribute("y").as_int();
    if (const pugi::xml_attribute order = node.attribute("executionOrderId")) {
        if (order.as_ullong() > 0) element.order = order.as_ullong();
    }
    switch (element.kind) {
        case Kind::contact:
        case Kind::coil:
            element.text = text_of(child_named(node, "variable"));
            break;
        case Kind::in_variable:
        case Kind::out_variable:
            element.text = text_of(child_named(node, "expression"));
            break;
        case Kind::connector:
        case Kind::continuation:
            element.text = node.attribute("name").as_string();
            break;
        case Kind::comment:
            element.text = text_of(child_named(node, "content"));
            break;
        case Kind::block:
            read_block(element);
            break;
        default:
            break;
    }
    if (element.kind != Kind::block) {
        for (const pugi::xml_node point : node.children()) {
            if (local_name(point) == "connectionPointIn") {
                element.inlets.push_back(read_inlet(point));
            }
        }
    }
    const pugi::xml_attribute id = node.attribute("localId");
    if (!id || !by_id_.emplace(id.as_ullong(), elements_.size()).second) {
        source_.error(node, messages::plcopen::no_local_id());
        return;
    }
    elements_.push_back(std::move(element));
}

void LadderElements::read_block(Element& element) {
    element.text = iec::capitals(element.node.attribute("typeName").as_string());
    const bool is_known = block_named(element.text) != nullptr || comparison_named(element.text) ||
                          is_gate(element.text);
    if (!is_known) {
        source_.error(element.node, messages::plcopen::unknown_block(shortened(element.text)));
    }
    for (const pugi::xml_node variable : child_named(element.node, "inputVariables").children()) {
        if (variable.type() != pugi::node_element) continue;
        Inlet inlet = read_inlet(child_named(variable, "connectionPointIn"));
        inlet.name = iec::capitals(variable.attribute("formalParameter").as_string());
        inlet.negated = variable.attribute("negated").as_bool();
        const std::string_view edge = variable.attribute("edge").as_string("none");
        if (edge != "none") {
            source_.error(variable, messages::plcopen::edge_at_block());
        }
        element.inlets.push_back(std::move(inlet));
    }
    if (child_named(child_named(element.node, "inOutVariables"), "variable")) {
        source_.error(element.node, messages::plcopen::in_out_variable());
    }
    for (const pugi::xml_node variable : child_named(element.node, "outputVariables").children()) {
        if (variable.attribute("negated").as_bool()) {
            source_.error(variable, messages::plcopen::negated_output());
        }
    }
}

Inlet LadderElements::read_inlet(pugi::xml_node point) const {
    Inlet inlet;
    inlet.node = point;
    inlet.expression = text_of(child_named(point, "expression"));
    return inlet;
}

void LadderElements::connect() {
    for (Element& element : elements_) {
        for (Inlet& inlet : element.inlets) {
            for (const pugi::xml_node connection : inlet.node.children()) {
                if (local_name(connection) != "connection") continue;
                const auto found = by_id_.find(connection.attribute("refLocalId").as_ullong());
                if (found == by_id_.end()) {
                    source_.error(connection, messages::plcopen::no_such_element(
                                                  connection.attribute("refLocalId").as_string()));
                    continue;
                }
                const Element& from = elements_[found->second];
                std::string parameter;
                if (from.kind == Kind::block) {
                    parameter = iec::capitals(connection.attribute("formalParameter").as_string());
                    if (parameter.empty()) parameter = default_output(from.text);
                }
                if (from.kind == Kind::right_rail || from.kind == Kind::out_variable ||
                    from.kind == Kind::comment) {
                    source_.error(connection, messages::plcopen::without_outlet());
                    continue;
                }
                inlet.sources.push_back({found->second, std::move(parameter)});
            }
            std::sort(inlet.sources.begin(), inlet.sources.end());
            inlet.sources.erase(std::unique(inlet.sources.begin(), inlet.sources.end()),
                                inlet.sources.end());
        }
    }
}

/// A continuation stands for what feeds the connector of its name. One round for each of them is
/// enough to follow those that lead to one another.
void LadderElements::follow_connectors() {
    std::map<std::string, std::size_t> connectors;
    std::size_t rounds = 0;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        if (elements_[e].kind == Kind::connector) connectors.emplace(elements_[e].text, e);
        if (elements_[e].kind == Kind::continuation) ++rounds;
    }
    const auto is_continuation = [&](const Output& output) {
        return elements_[output.element].kind == Kind::continuation;
    };
    for (; rounds > 0; --rounds) {
        for (Element& element : elements_) {
            for (Inlet& inlet : element.inlets) {
                std::vector<Output> sources;
                for (const Output& output : inlet.sources) {
                    const auto found = is_continuation(output)
                                           ? connectors.find(elements_[output.element].text)
                                           : connectors.end();
                    if (found == connectors.end()) {
                        sources.push_back(output);
                        continue;
                    }
                    for (const Inlet& feeding : elements_[found->second].inlets) {
                        sources.insert(sources.end(), feeding.sources.begin(),
                                       feeding.sources.end());
                    }
                }
                std::sort(sources.begin(), sources.end());
                sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
                inlet.sources = std::move(sources);
            }
        }
    }
    for (const Element& element : elements_) {
        for (const Inlet& inlet : element.inlets) {
            if (std::any_of(inlet.sources.begin(), inlet.sources.end(), is_continuation)) {
                source_.error(element.node, messages::plcopen::no_connector());
            }
        }
    }
}

std::vector<LadderElements::Consumer> LadderElements::consumers(const Output& output) const {
    const auto found = consumers_.find(output);
    return found == consumers_.end() ? std::vector<Consumer>() : found->second;
}

/// What hangs together is a network; rails and values do not count, for all networks may share
/// them. Networks are numbered from top to bottom, then from left to right.
void LadderElements::number_networks() {
    std::vector<std::size_t> group(elements_.size());
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](std::size_t e) {
        while (group[e] != e) e = group[e] = group[group[e]];
        return e;
    };
    const auto is_shared = [&](std::size_t e) {
        const Kind kind = elements_[e].kind;
        return kind == Kind::left_rail || kind == Kind::right_rail || kind == Kind::in_variable;
    };
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        for (const Inlet& inlet : elements_[e].inlets) {
            for (const Output& output : inlet.sources) {
                if (!is_shared(e) && !is_shared(output.element)) {
                    group[root(e)] = root(output.element);
                }
            }
        }
    }
    std::map<std::size_t, std::pair<int, int>> corners;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        if (!places_network(elements_[e].kind)) continue;
        const std::pair<int, int> place{elements_[e].y, elements_[e].x};
        const auto [corner, is_new] = corners.emplace(root(e), place);
        if (!is_new) corner->second = std::min(corner->second, place);
    }
    std::vector<std::pair<std::pair<int, int>, std::size_t>> order;
    for (const auto& [network, corner] : corners) order.emplace_back(corner, network);
    std::sort(order.begin(), order.end());
    std::map<std::size_t, std::size_t> numbers;
    for (const auto& [corner, network] : order) numbers.emplace(network, numbers.size());
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        if (places_network(elements_[e].kind)) elements_[e].network = numbers[root(e)];
    }
    network_count_ = numbers.size();
}

}  // namespace grafwire::plcopen
