#include "formats/spice/spice_elements.h"

#include <algorithm>

namespace grafwire {

namespace {

struct GateModel {
    std::string_view name;    ///< of any number of inputs
    std::string_view single;  ///< of one
    std::string_view part;    ///< gathers some of many inputs
};

GateModel model_of(CellType type) {
    switch (type) {
        case CellType::and_gate:
            return {"and", "buffer", "and"};
        case CellType::or_gate:
            return {"or", "buffer", "or"};
        case CellType::nand_gate:
            return {"nand", "not", "and"};
        case CellType::nor_gate:
            return {"nor", "not", "or"};
        case CellType::xor_gate:
            return {"xor", "buffer", "xor"};
        case CellType::inverter:
            return {"not", "not", ""};
        default:
            return {"buffer", "buffer", ""};
    }
}

}  // namespace

std::string spice_list(std::span<const std::string_view> nodes) {
    std::string text = "[";
    std::size_t on_line = 0;
    for (const std::string_view node : nodes)
        append(text, ++on_line % 16 == 0 ? "\n+ " : " ", node);
    return text + " ]";
}

std::string_view SpiceElements::inner_node() {
    std::string name = "__";
    append(name, ++inner_count_);
    return keep(std::move(name));
}

std::vector<std::string_view> SpiceElements::gather(std::span<const std::string_view> nodes,
                                                    std::string_view model) {
    std::vector<std::string_view> gathered;
    for (std::size_t first = 0; first < nodes.size(); first += widest) {
        const auto part = nodes.subspan(first, std::min(widest, nodes.size() - first));
        const std::string_view node = inner_node();
        if (part.size() == 1) {
            add(part[0], ' ', node, " fast_buffer");
        } else {
            add(spice_list(part), ' ', node, " fast_", model);
        }
        gathered.push_back(node);
    }
    return gathered;
}

void SpiceElements::add_gate(std::string_view speed, CellType type,
                             std::vector<std::string_view> pins, std::string_view output) {
    const GateModel model = model_of(type);
    while (pins.size() > widest) pins = gather(pins, model.part);
    if (pins.size() == 1) return add(pins[0], ' ', output, ' ', speed, model.single);
    add(spice_list(pins), ' ', output, ' ', speed, model.name);
}

}  // namespace grafwire
