// Action blocks of the sequential function chart: one row per action, beside the step.

#include "plcopen/plcopen_parts.h"

namespace grafwire::ladder {

void write_sfc_action_block(const std::vector<sfc::ActionBlockEntry>& actions, const Outlet& source,
                            PlcopenBody& body) {
    constexpr int row = 30;
    const Point corner{source.at.x + 30, source.at.y - row / 2};
    const int height = row * static_cast<int>(actions.size());
    pugi::xml_node block = body.element("actionBlock", corner, 130, height);
    PlcopenBody::inlet(block, corner, {corner.x, source.at.y}, {source});
    int y = 0;
    for (const sfc::ActionBlockEntry& action : actions) {
        pugi::xml_node node = block.append_child("action");
        node.append_attribute("localId") = body.new_id();
        node.append_attribute("qualifier") = action.qualifier.c_str();
        if (!action.duration.empty()) {
            node.append_attribute("duration") = action.duration.c_str();
        }
        pugi::xml_node place = node.append_child("relPosition");
        place.append_attribute("x") = 0;
        place.append_attribute("y") = y;
        y += row;
        if (!action.reference.empty()) {
            node.append_child("reference").append_attribute("name") = action.reference.c_str();
        } else {
            add_text(node.append_child("inline").append_child("ST"), action.statements);
        }
    }
}

}  // namespace grafwire::ladder
