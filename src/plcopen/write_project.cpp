// PLCopen TC6 XML 2.01: the frame of the project and the interfaces of its programs.

#include "plcopen/write_project.h"

#include <fmt/format.h>

#include <sstream>

#include "iec/identifiers.h"
#include "plcopen/bodies.h"
#include "plcopen/messages.h"

namespace grafwire::plcopen {

namespace {

namespace say = messages::plcopen;

pugi::xml_node add(pugi::xml_node parent, const char* name) {
    return parent.append_child(name);
}

/// The file says nothing of when it was made: the same chart gives the same bytes.
constexpr const char* some_date = "1970-01-01T00:00:00";

void add_headers(pugi::xml_node project, const ladder::Ladder& ladder) {
    pugi::xml_node file = add(project, "fileHeader");
    file.append_attribute("companyName") = "grafwire";
    file.append_attribute("productName") = "grafwire";
    file.append_attribute("productVersion") = "1";
    file.append_attribute("creationDateTime") = some_date;
    pugi::xml_node content = add(project, "contentHeader");
    content.append_attribute("name") = ladder.name.c_str();
    if (!ladder.title.empty()) {
        add(content, "Comment").append_child(pugi::node_pcdata).set_value(ladder.title.c_str());
    }
    pugi::xml_node coordinates = add(content, "coordinateInfo");
    for (const char* language : {"fbd", "ld", "sfc"}) {
        pugi::xml_node scaling = add(add(coordinates, language), "scaling");
        scaling.append_attribute("x") = 8;
        scaling.append_attribute("y") = 8;
    }
}

void add_variable(pugi::xml_node list, const ladder::Ladder& ladder,
                  const ladder::Variable& variable, const std::string& name, Language language) {
    pugi::xml_node node = add(list, "variable");
    node.append_attribute("name") = name.c_str();
    pugi::xml_node type = add(node, "type");
    if (variable.type == ladder::Type::bit) {
        add(type, "BOOL");
    } else if (variable.type == ladder::Type::integer) {
        add(type, ladder.integer_bits == 16 ? "INT" : ladder.integer_bits == 32 ? "DINT" : "LINT");
    } else {
        add(type, "derived").append_attribute("name") =
            std::string(row_of(variable.block).name).c_str();
    }
    if (variable.initial != 0) {
        const std::string value =
            variable.type == ladder::Type::bit ? "TRUE" : fmt::format("{}", variable.initial);
        add(add(node, "initialValue"), "simpleValue").append_attribute("value") = value.c_str();
    }
    std::string text = variable.comment;
    if (name != variable.name) {
        text = text.empty() || text == variable.name
                   ? variable.name
                   : say::commented_name.in(language, variable.name, text);
    }
    if (!text.empty()) add_text(add(node, "documentation"), text);
}

void add_interface(pugi::xml_node pou, const ladder::Ladder& ladder,
                   const std::vector<std::string>& names, Language language) {
    static constexpr std::pair<ladder::Role, const char*> lists[] = {
        {ladder::Role::input, "inputVars"},
        {ladder::Role::output, "outputVars"},
        {ladder::Role::memory, "localVars"}};
    pugi::xml_node interface = add(pou, "interface");
    for (const auto& [role, list_name] : lists) {
        pugi::xml_node list;
        for (std::size_t v = 0; v < ladder.variables.size(); ++v) {
            const ladder::Variable& variable = ladder.variables[v];
            if (variable.role != role) continue;
            if (!list) list = add(interface, list_name);
            add_variable(list, ladder, variable, names[v], language);
        }
    }
}

std::string documentation_of(const ladder::Ladder& ladder, const std::vector<std::string>& names,
                             Language language) {
    std::string text = ladder.title.empty() ? ladder.name : ladder.title;
    for (const std::string& remark : ladder.remarks) text += "\n" + remark;
    std::string changed;
    for (std::size_t v = 0; v < ladder.declared; ++v) {
        if (names[v] == ladder.variables[v].name) continue;
        changed += "\n  " + say::changed_name.in(language, names[v], ladder.variables[v].name);
    }
    if (!changed.empty()) text += "\n" + say::changed_names.in(language) + changed;
    return text;
}

void add_instance(pugi::xml_node project, const std::string& program) {
    pugi::xml_node configuration =
        add(add(add(project, "instances"), "configurations"), "configuration");
    configuration.append_attribute("name") = "config";
    pugi::xml_node resource = add(configuration, "resource");
    resource.append_attribute("name") = "plc";
    pugi::xml_node task = add(resource, "task");
    task.append_attribute("name") = "scan";
    task.append_attribute("interval") = "T#10ms";
    task.append_attribute("priority") = 0;
    pugi::xml_node instance = add(task, "pouInstance");
    instance.append_attribute("name") = "main";
    instance.append_attribute("typeName") = program.c_str();
}

pugi::xml_node add_program(pugi::xml_node pous, const std::string& name) {
    pugi::xml_node pou = add(pous, "pou");
    pou.append_attribute("name") = name.c_str();
    pou.append_attribute("pouType") = "program";
    return pou;
}

}  // namespace

std::vector<std::string> identifiers_of(const ladder::Ladder& ladder) {
    iec::Identifiers identifiers;
    std::vector<std::string> declared;
    std::vector<std::string> others;
    for (std::size_t v = 0; v < ladder.variables.size(); ++v) {
        (v < ladder.declared ? declared : others).push_back(ladder.variables[v].name);
    }
    std::vector<std::string> names = identifiers.add(declared);
    for (std::string& name : identifiers.add(others)) names.push_back(std::move(name));
    return names;
}

std::string write_project(const Grafcet& grafcet, const ladder::Ladder& ladder, Language language) {
    const std::vector<std::string> names = identifiers_of(ladder);
    iec::Identifiers programs;
    const std::string program = programs.add({ladder.name}).front();
    const std::string chart = programs.add({ladder.name + " SFC"}).front();
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node project = document.append_child("project");
    project.append_attribute("xmlns") = "http://www.plcopen.org/xml/tc6_0201";
    project.append_attribute("xmlns:xhtml") = "http://www.w3.org/1999/xhtml";
    add_headers(project, ladder);
    pugi::xml_node types = add(project, "types");
    add(types, "dataTypes");
    pugi::xml_node pous = add(types, "pous");

    pugi::xml_node pou = add_program(pous, program);
    add_interface(pou, ladder, names, language);
    write_ladder_body(ladder, names, add(add(pou, "body"), "LD"));
    add_text(add(pou, "documentation"), documentation_of(ladder, names, language));

    const sfc::Plan plan = sfc::plan_of(grafcet);
    const sfc::Names sfc_name_list = sfc::names_of(plan);
    pugi::xml_node sfc = add_program(pous, chart);
    write_sfc_interface(plan, sfc_name_list, language, sfc);
    write_sfc_body(plan, sfc_name_list, language, add(add(sfc, "body"), "SFC"));

    add_instance(project, program);
    std::ostringstream text;
    document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
    return text.str();
}

}  // namespace grafwire::plcopen
