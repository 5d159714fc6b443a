// The variables that a program of a project declares, and those of its configuration that it can
// see.
//
// Names are compared without regard to case, as IEC 61131-3 wants it; a local variable hides a
// global one of the same name. A TIME with a value is a constant for the presets of timers. A
// variable of any other type is remembered by its type alone: it is an error only where the diagram
// uses it.

#include "plcopen/ladder_variables.h"

#include <algorithm>

#include "iec/identifiers.h"
#include "iec/literals.h"
#include "plcopen/messages.h"
#include "text/nearest_name.h"
#include "text/utf8.h"

namespace grafwire::plcopen {

namespace {

bool is_integer_type(std::string_view type) {
    static constexpr std::string_view types[] = {"SINT",  "INT",  "DINT",  "LINT",
                                                 "USINT", "UINT", "UDINT", "ULINT"};
    return std::find(std::begin(types), std::end(types), type) != std::end(types);
}

const ladder::BlockTypeRow* function_block_named(std::string_view name) {
    for (const ladder::BlockTypeRow& row : ladder::block_table) {
        if (!row.is_function && row.name == name) return &row;
    }
    return nullptr;
}

std::string initial_text(pugi::xml_node variable) {
    const pugi::xml_node value = child_named(child_named(variable, "initialValue"), "simpleValue");
    return value.attribute("value").as_string();
}

}  // namespace

void LadderVariables::read(pugi::xml_node project, pugi::xml_node pou) {
    for (const pugi::xml_node list : child_named(pou, "interface").children()) {
        const std::string_view kind = local_name(list);
        const ladder::Role role = kind == "inputVars"    ? ladder::Role::input
                                  : kind == "outputVars" ? ladder::Role::output
                                                         : ladder::Role::memory;
        if (kind != "externalVars") read_list(list, role);
    }
    const pugi::xml_node configurations =
        child_named(child_named(project, "instances"), "configurations");
    for (const pugi::xml_node configuration : configurations.children()) {
        for (const pugi::xml_node part : configuration.children()) {
            if (local_name(part) == "globalVars") read_list(part, ladder::Role::memory);
            for (const pugi::xml_node inner : part.children()) {
                if (local_name(inner) == "globalVars") read_list(inner, ladder::Role::memory);
            }
        }
    }
}

void LadderVariables::read_list(pugi::xml_node list, ladder::Role role) {
    for (const pugi::xml_node variable : list.children()) {
        if (local_name(variable) == "variable") read_variable(variable, role);
    }
}

void LadderVariables::read_variable(pugi::xml_node node, ladder::Role role) {
    ladder::Variable variable;
    variable.name = node.attribute("name").as_string();
    source_.check_name(variable.name, node);
    variable.role = role;
    variable.comment = text_of(child_named(node, "documentation"));
    const std::string key = iec::capitals(variable.name);
    const pugi::xml_node type = child_named(node, "type").find_child([](pugi::xml_node child) {
        return child.type() == pugi::node_element;
    });
    const std::string_view type_name =
        local_name(type) == "derived" ? type.attribute("name").as_string() : local_name(type);
    const std::string initial = initial_text(node);
    const ladder::BlockTypeRow* block = function_block_named(type_name);
    if (type_name == "TIME") {
        if (const auto time = iec::parse_time_literal(initial)) times_.emplace(key, *time);
    }
    if (type_name == "BOOL") {
        variable.type = ladder::Type::bit;
    } else if (is_integer_type(type_name)) {
        variable.type = ladder::Type::integer;
    } else if (block != nullptr) {
        variable.type = ladder::Type::block;
        variable.block = block->type;
    } else {
        foreign_.emplace(key, type_name);
        return;
    }
    if (!initial.empty() && block == nullptr) {
        const auto value = iec::parse_number_literal(initial);
        if (!value) {
            source_.error(node, messages::plcopen::no_initial_value(initial, variable.name));
            return;
        }
        variable.initial = *value;
    }
    if (ids_.count(key) > 0) return;  // a global of the same name is hidden
    ids_.emplace(key, ladder_.add(std::move(variable)));
}

bool LadderVariables::is_integer(std::string_view name) const {
    const auto found = ids_.find(iec::capitals(name));
    return found != ids_.end() && ladder_.variable(found->second).type == ladder::Type::integer;
}

ladder::VariableId LadderVariables::add_hidden(std::string name, ladder::Type type) {
    while (ids_.count(iec::capitals(name)) > 0) name += '_';
    ladder::Variable variable;
    variable.name = name;
    variable.type = type;
    const ladder::VariableId id = ladder_.add(std::move(variable));
    ids_.emplace(iec::capitals(name), id);
    return id;
}

std::optional<ladder::VariableId> LadderVariables::find(std::string_view name,
                                                        pugi::xml_node where) const {
    const std::string key = iec::capitals(name);
    if (const auto found = ids_.find(key); found != ids_.end()) return found->second;
    if (const auto foreign = foreign_.find(key); foreign != foreign_.end()) {
        source_.error(where, messages::plcopen::foreign_type(name, foreign->second));
        return std::nullopt;
    }
    std::vector<std::string_view> names;
    if (source_.error_count() < most_suggestions) {
        for (const ladder::Variable& variable : ladder_.variables) names.push_back(variable.name);
    }
    const std::string_view nearest = nearest_name(name, names);
    const std::string shown = shortened(name);
    source_.error(where, nearest.empty() ? messages::plcopen::undeclared(shown)
                                         : messages::plcopen::undeclared_near(shown, nearest));
    return std::nullopt;
}

std::optional<ladder::VariableId> LadderVariables::bit(std::string_view name,
                                                       pugi::xml_node where) const {
    const std::size_t dot = name.find('.');
    const auto id = find(name.substr(0, dot), where);
    if (!id) return std::nullopt;
    const ladder::Variable& variable = ladder_.variable(*id);
    const bool is_output = dot != std::string_view::npos && variable.type == ladder::Type::block &&
                           iec::capitals(name.substr(dot + 1)) == row_of(variable.block).output;
    if (is_output || (dot == std::string_view::npos && variable.type == ladder::Type::bit))
        return id;
    source_.error(where, messages::plcopen::no_bit(shortened(name)));
    return std::nullopt;
}

std::optional<ladder::VariableId> LadderVariables::integer(std::string_view name,
                                                           pugi::xml_node where) const {
    const auto id = find(name, where);
    if (!id || ladder_.variable(*id).type == ladder::Type::integer) return id;
    source_.error(where, messages::plcopen::no_integer(shortened(name)));
    return std::nullopt;
}

std::optional<ladder::VariableId> LadderVariables::instance(std::string_view name,
                                                            ladder::BlockType type,
                                                            pugi::xml_node where) const {
    const auto id = find(name, where);
    if (!id) return id;
    const ladder::Variable& variable = ladder_.variable(*id);
    if (variable.type == ladder::Type::block && variable.block == type) return id;
    source_.error(where, messages::plcopen::other_declaration(shortened(name), row_of(type).name));
    return std::nullopt;
}

std::optional<ladder::Operand> LadderVariables::operand(std::string_view text,
                                                        ladder::Operand::Kind wanted, bool of_bits,
                                                        pugi::xml_node where) const {
    ladder::Operand operand;
    operand.kind = wanted;
    if (wanted == ladder::Operand::Kind::time) {
        auto time = iec::parse_time_literal(text);
        if (!time) {
            const auto constant = times_.find(iec::capitals(text));
            if (constant != times_.end()) time = constant->second;
        }
        if (!time) {
            source_.error(where, messages::plcopen::no_constant_time(shortened(text)));
            return std::nullopt;
        }
        operand.value = *time;
        return operand;
    }
    if (const auto number = iec::parse_number_literal(text)) {
        operand.value = *number;
        return operand;
    }
    operand.kind = ladder::Operand::Kind::variable;
    const std::size_t dot = text.find('.');
    const bool is_count =
        !of_bits && dot != std::string_view::npos && iec::capitals(text.substr(dot)) == ".CV";
    const auto id = is_count  ? find(text.substr(0, dot), where)
                    : of_bits ? bit(text, where)
                              : integer(text, where);
    if (!id) return std::nullopt;
    operand.variable = *id;
    return operand;
}

}  // namespace grafwire::plcopen
