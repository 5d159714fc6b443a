// The LD body: every rung between rails of its own, at the places that the layout of drawings gives
// its parts.

#include "ladder/draw/layout.h"
#include "plcopen/bodies.h"

namespace grafwire::plcopen {

namespace {

constexpr int cell_width = 8;
constexpr int row_height = 20;
constexpr int left_rail = 20;
constexpr int contacts_left = 150;  ///< leaves room for what the first block reads
constexpr int columns = 100;

/// One rung below a height. Its symbols and boxes are placed one after the other, in the order in
/// which the layout lists them.
class RungBody {
  public:
    RungBody(const ladder::Ladder& ladder, const std::vector<std::string>& names,
             const ladder::Rung& rung, int top, Body& body)
        : ladder_(ladder),
          names_(names),
          rung_(rung),
          layout_(draw(ladder, rung, columns)),
          body_(body),
          top_(top),
          bottom_(top + row_height * layout_.height) {}

    /// Gives the height at which the rung ends.
    int write();

  private:
    using Outlets = std::vector<Outlet>;

    Outlets power(const ladder::Power& power, Outlets sources);
    Outlet contact(const ladder::Power& power, const Outlets& sources);
    Outlet comparison(const ladder::Power& power, const Outlets& sources);
    Outlet block(const ladder::Block& block, const Outlets& sources);
    Outlet coil(const ladder::Coil& coil, const Outlets& sources);
    pugi::xml_node box(const std::string& type, Point corner, std::size_t inputs);
    static pugi::xml_node parameter(pugi::xml_node list, std::string_view name);
    void input(pugi::xml_node inputs, std::string_view name, Point corner, std::size_t row,
               const ladder::Operand& operand);

    Point wire_at(int x, int row) const {
        return {contacts_left + cell_width * x, top_ + row_height * row + row_height / 2};
    }
    const std::string& name(ladder::VariableId id) const {
        return names_[static_cast<std::size_t>(id)];
    }
    std::string text(const ladder::Operand& operand) const;

    const ladder::Ladder& ladder_;
    const std::vector<std::string>& names_;
    const ladder::Rung& rung_;
    const ladder::Drawing layout_;
    Body& body_;
    const int top_;
    int bottom_;
    std::size_t next_symbol_ = 0;
    std::size_t next_box_ = 0;
};

std::string RungBody::text(const ladder::Operand& operand) const {
    if (operand.kind != ladder::Operand::Kind::variable) return operand_text(ladder_, operand);
    const bool is_block = ladder_.variable(operand.variable).type == ladder::Type::block;
    return is_block ? name(operand.variable) + ".CV" : name(operand.variable);
}

RungBody::Outlets RungBody::power(const ladder::Power& power, Outlets sources) {
    Outlets outlets;
    switch (power.kind) {
        case ladder::Power::Kind::wire:
            return sources;
        case ladder::Power::Kind::contact:
            outlets.push_back(contact(power, sources));
            return outlets;
        case ladder::Power::Kind::comparison:
            outlets.push_back(comparison(power, sources));
            return outlets;
        case ladder::Power::Kind::series:
            for (const ladder::Power& part : power.parts) {
                sources = this->power(part, std::move(sources));
            }
            return sources;
        case ladder::Power::Kind::parallel:
            for (const ladder::Power& part : power.parts) {
                const Outlets ends = this->power(part, sources);
                outlets.insert(outlets.end(), ends.begin(), ends.end());
            }
            return outlets;
    }
    return outlets;
}

Outlet RungBody::contact(const ladder::Power& power, const Outlets& sources) {
    const ladder::Drawing::Symbol& symbol = layout_.symbols[next_symbol_++];
    const Point in = wire_at(symbol.x - 1, symbol.y);
    const Point out{in.x + 21, in.y};
    const Point corner{in.x, in.y - 8};
    pugi::xml_node contact = body_.element("contact", corner, 21, 15);
    contact.append_attribute("negated") = power.contact == ladder::ContactKind::negated;
    if (power.contact == ladder::ContactKind::rising) contact.append_attribute("edge") = "rising";
    if (power.contact == ladder::ContactKind::falling) contact.append_attribute("edge") = "falling";
    Body::inlet(contact, corner, in, sources);
    Body::outlet(contact, corner, out);
    contact.append_child("variable")
        .append_child(pugi::node_pcdata)
        .set_value(name(power.variable).c_str());
    return {Body::id_of(contact), "", out};
}

Outlet RungBody::coil(const ladder::Coil& coil, const Outlets& sources) {
    const ladder::Drawing::Symbol& symbol = layout_.symbols[next_symbol_++];
    const Point in = wire_at(symbol.x - 1, symbol.y);
    const Point out{in.x + 21, in.y};
    const Point corner{in.x, in.y - 8};
    pugi::xml_node node = body_.element("coil", corner, 21, 15);
    node.append_attribute("negated") = coil.kind == ladder::CoilKind::negated;
    if (coil.kind == ladder::CoilKind::set) node.append_attribute("storage") = "set";
    if (coil.kind == ladder::CoilKind::reset) node.append_attribute("storage") = "reset";
    if (coil.kind == ladder::CoilKind::rising) node.append_attribute("edge") = "rising";
    if (coil.kind == ladder::CoilKind::falling) node.append_attribute("edge") = "falling";
    Body::inlet(node, corner, in, sources);
    Body::outlet(node, corner, out);
    node.append_child("variable")
        .append_child(pugi::node_pcdata)
        .set_value(name(coil.variable).c_str());
    return {Body::id_of(node), "", out};
}

constexpr int box_width = 80;

/// A block whose first input lies on the wire, the others a row each below it.
pugi::xml_node RungBody::box(const std::string& type, Point corner, std::size_t inputs) {
    const int height = row_height * (static_cast<int>(inputs) + 2);
    pugi::xml_node block = body_.element("block", corner, box_width, height);
    block.append_attribute("typeName") = type.c_str();
    bottom_ = std::max(bottom_, corner.y + height);
    return block;
}

pugi::xml_node RungBody::parameter(pugi::xml_node list, std::string_view name) {
    pugi::xml_node variable = list.append_child("variable");
    variable.append_attribute("formalParameter") = std::string(name).c_str();
    return variable;
}

void RungBody::input(pugi::xml_node inputs, std::string_view name, Point corner, std::size_t row,
                     const ladder::Operand& operand) {
    const Point at{corner.x, corner.y + row_height * (static_cast<int>(row) + 1) + 10};
    const Outlet source = body_.value({at.x - 16, at.y}, text(operand));
    Body::inlet(parameter(inputs, name), corner, at, {source});
}

/// EN and ENO, as the standard has a function either with both or with neither (IEC 61131-3, 3rd
/// edition, 6.6.1.6); a reader may take EN alone for the first operand.
Outlet RungBody::comparison(const ladder::Power& power, const Outlets& sources) {
    const ladder::Drawing::Symbol& symbol = layout_.symbols[next_symbol_++];
    const Point in = wire_at(symbol.x - symbol.width / 2, symbol.y);
    const Point corner{in.x, in.y - row_height - 10};
    const std::string type(ladder::comparison_names[static_cast<std::size_t>(power.relation)]);
    pugi::xml_node block = box(type, corner, 2);
    pugi::xml_node inputs = block.append_child("inputVariables");
    Body::inlet(parameter(inputs, "EN"), corner, in, sources);
    input(inputs, "IN1", corner, 1, power.left);
    input(inputs, "IN2", corner, 2, power.right);
    block.append_child("inOutVariables");
    pugi::xml_node outputs = block.append_child("outputVariables");
    Body::outlet(parameter(outputs, "ENO"), corner, {corner.x + box_width, in.y});
    const Point out{corner.x + box_width, in.y + row_height};
    Body::outlet(parameter(outputs, "OUT"), corner, out);
    return {Body::id_of(block), "OUT", out};
}

Outlet RungBody::block(const ladder::Block& block, const Outlets& sources) {
    const ladder::Drawing::Box& place = layout_.boxes[next_box_++];
    const ladder::BlockTypeRow& row = row_of(block.type);
    const Point in = wire_at(place.x + 12, place.y + 1);
    const Point corner{in.x, in.y - row_height - 10};
    pugi::xml_node node = box(std::string(row.name), corner, block.operands.size());
    if (!row.is_function) node.append_attribute("instanceName") = name(block.target).c_str();
    pugi::xml_node inputs = node.append_child("inputVariables");
    Body::inlet(parameter(inputs, row.power), corner, in, sources);
    for (std::size_t i = 0; i < block.operands.size(); ++i) {
        input(inputs, row.inputs[i], corner, i + 1, block.operands[i]);
    }
    node.append_child("inOutVariables");
    pugi::xml_node outputs = node.append_child("outputVariables");
    const Point out{corner.x + box_width, in.y};
    const std::string_view onward = row.is_function ? "ENO" : row.output;
    Body::outlet(parameter(outputs, onward), corner, out);
    if (!row.is_function) return {Body::id_of(node), std::string(onward), out};

    const Point result{out.x, out.y + row_height};
    Body::outlet(parameter(outputs, row.output), corner, result);
    const Point end{result.x + 16, result.y};
    const Point end_corner{end.x, end.y - 10};
    pugi::xml_node target = body_.element("outVariable", end_corner, 80, 20);
    const Outlet source{Body::id_of(node), std::string(row.output), result};
    Body::inlet(target, end_corner, end, {source});
    target.append_child("expression")
        .append_child(pugi::node_pcdata)
        .set_value(name(block.target).c_str());
    return {Body::id_of(node), std::string(onward), out};
}

int RungBody::write() {
    const int height = bottom_ - top_;
    const Point corner{left_rail, top_};
    pugi::xml_node rail = body_.element("leftPowerRail", corner, 3, height);
    int first_row = 1;
    if (!layout_.symbols.empty()) first_row = layout_.symbols.front().y;
    const Point begin{left_rail + 3, wire_at(0, first_row).y};
    Body::outlet(rail, corner, begin, true);
    std::vector<Outlet> sources{{Body::id_of(rail), "", begin}};

    sources = power(rung_.power, std::move(sources));
    for (const ladder::Block& item : rung_.blocks) {
        const Outlet end = block(item, sources);
        sources = {end};
    }
    std::vector<Outlet> ends;
    for (const ladder::Coil& item : rung_.coils) ends.push_back(coil(item, sources));
    if (ends.empty()) ends = sources;
    const Point right_corner{contacts_left + cell_width * layout_.width, top_};
    pugi::xml_node right = body_.element("rightPowerRail", right_corner, 3, height);
    for (const Outlet& end : ends) {
        Body::inlet(right, right_corner, {right_corner.x, end.at.y}, {end});
    }
    return bottom_;
}

}  // namespace

void write_ladder_body(const ladder::Ladder& ladder, const std::vector<std::string>& names,
                       pugi::xml_node node) {
    Body body(node);
    int top = 20;
    for (const ladder::Rung& rung : ladder.rungs) {
        for (const std::string& text : {rung.heading, rung.comment}) {
            if (text.empty()) continue;
            body.comment({left_rail, top}, 900, text);
            top += 30;
        }
        top = RungBody(ladder, names, rung, top + row_height, body).write() + row_height;
    }
}

}  // namespace grafwire::plcopen
