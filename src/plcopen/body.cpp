#include "plcopen/body.h"

#include "text/utf8.h"

namespace grafwire::plcopen {

namespace {

void add_position(pugi::xml_node parent, const char* name, Point at) {
    pugi::xml_node position = parent.append_child(name);
    position.append_attribute("x") = at.x;
    position.append_attribute("y") = at.y;
}

}  // namespace

void add_text(pugi::xml_node parent, const std::string& text) {
    parent.append_child("xhtml:p").append_child(pugi::node_pcdata).set_value(text.c_str());
}

pugi::xml_node Body::element(const char* name, Point corner, int width, int height) {
    pugi::xml_node element = body_.append_child(name);
    element.append_attribute("localId") = next_id_++;
    element.append_attribute("height") = height;
    element.append_attribute("width") = width;
    add_position(element, "position", corner);
    return element;
}

std::uint64_t Body::id_of(pugi::xml_node element) {
    return element.attribute("localId").as_ullong();
}

void Body::inlet(pugi::xml_node owner, Point corner, Point at, const std::vector<Outlet>& sources,
                 const char* name) {
    pugi::xml_node point = owner.append_child(name);
    add_position(point, "relPosition", {at.x - corner.x, at.y - corner.y});
    for (const Outlet& source : sources) {
        pugi::xml_node connection = point.append_child("connection");
        connection.append_attribute("refLocalId") = source.id;
        if (!source.parameter.empty()) {
            connection.append_attribute("formalParameter") = source.parameter.c_str();
        }
        // A wire bends just before its end.
        const int bend = at.x - 12;
        add_position(connection, "position", at);
        if (source.at.y != at.y && source.at.x < at.x) {
            add_position(connection, "position", {bend, at.y});
            add_position(connection, "position", {bend, source.at.y});
        }
        add_position(connection, "position", source.at);
    }
}

void Body::outlet(pugi::xml_node owner, Point corner, Point at, bool named, const char* name) {
    pugi::xml_node point = owner.append_child(name);
    if (named) point.append_attribute("formalParameter") = "";
    add_position(point, "relPosition", {at.x - corner.x, at.y - corner.y});
}

void Body::comment(Point corner, int width, const std::string& text) {
    pugi::xml_node comment = element("comment", corner, width, 20);
    add_text(comment.append_child("content"), text);
}

Outlet Body::value(Point end, const std::string& expression) {
    const int width = 8 * static_cast<int>(count_code_points(expression)) + 8;
    const Point corner{end.x - width, end.y - 10};
    pugi::xml_node variable = element("inVariable", corner, width, 20);
    outlet(variable, corner, end);
    variable.append_child("expression")
        .append_child(pugi::node_pcdata)
        .set_value(expression.c_str());
    return {id_of(variable), "", end};
}

}  // namespace grafwire::plcopen
