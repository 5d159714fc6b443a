// A project with a ladder diagram: the interface of its program, and what is said of the whole.

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "iec/identifiers.h"
#include "plcopen/bodies.h"
#include "plcopen/messages.h"
#include "plcopen/project.h"
#include "plcopen/write_project.h"

namespace grafwire::plcopen {

namespace {

namespace say = messages::plcopen;

void add_variable(pugi::xml_node list, const ladder::Ladder& ladder,
                  const ladder::Variable& variable, const std::string& name, Language language) {
    pugi::xml_node node = list.append_child("variable");
    node.append_attribute("name") = name.c_str();
    pugi::xml_node type = node.append_child("type");
    if (variable.type == ladder::Type::bit) {
        type.append_child("BOOL");
    } else if (variable.type == ladder::Type::integer) {
        type.append_child(ladder.integer_bits == 16   ? "INT"
                          : ladder.integer_bits == 32 ? "DINT"
                                                      : "LINT");
    } else {
        type.append_child("derived").append_attribute("name") =
            std::string(row_of(variable.block).name).c_str();
    }
    if (variable.initial != 0) {
        const std::string value =
            variable.type == ladder::Type::bit ? "TRUE" : fmt::format("{}", variable.initial);
        node.append_child("initialValue").append_child("simpleValue").append_attribute("value") =
            value.c_str();
    }
    std::string text = variable.comment;
    if (name != variable.name) {
        text = text.empty() || text == variable.name
                   ? variable.name
                   : say::commented_name.in(language, variable.name, text);
    }
    if (!text.empty()) add_text(node.append_child("documentation"), text);
}

void add_interface(pugi::xml_node pou, const ladder::Ladder& ladder,
                   const std::vector<std::string>& names, Language language) {
    static constexpr std::pair<ladder::Role, const char*> lists[] = {
        {ladder::Role::input, "inputVars"},
        {ladder::Role::output, "outputVars"},
        {ladder::Role::memory, "localVars"}};
    pugi::xml_node interface = pou.append_child("interface");
    for (const auto& [role, list_name] : lists) {
        pugi::xml_node list;
        for (std::size_t v = 0; v < ladder.variables.size(); ++v) {
            const ladder::Variable& variable = ladder.variables[v];
            if (variable.role != role) continue;
            if (!list) list = interface.append_child(list_name);
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

std::string write_ladder_project(const ladder::Ladder& ladder, Language language) {
    const std::vector<std::string> names = identifiers_of(ladder);
    Project project(ladder.name, ladder.title);
    add_interface(project.program(), ladder, names, language);
    write_ladder_body(ladder, names, project.program().append_child("body").append_child("LD"));
    add_text(project.program().append_child("documentation"),
             documentation_of(ladder, names, language));
    return project.text();
}

}  // namespace grafwire::plcopen
