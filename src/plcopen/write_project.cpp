// PLCopen TC6 XML 2.01: the frame of the project and the interfaces of its programs.

#include "plcopen/write_project.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "grafcet/grafcet.h"
#include "grafcet/write_grafcet.h"
#include "iec/identifiers.h"
#include "plcopen/bodies.h"
#include "plcopen/messages.h"
#include "text/version.h"

namespace grafwire::plcopen {

namespace {

namespace say = messages::plcopen;

/// Collects what pugixml writes; a stream would bring all of the C++ locales into a page.
class TextWriter final : public pugi::xml_writer {
  public:
    void write(const void* data, std::size_t size) override {
        text.append(static_cast<const char*>(data), size);
    }
    std::string text;
};

pugi::xml_node add(pugi::xml_node parent, const char* name) {
    return parent.append_child(name);
}

/// The file says nothing of when it was made: the same chart gives the same bytes.
constexpr const char* some_date = "1970-01-01T00:00:00";

void add_headers(pugi::xml_node project, const ladder::Ladder& ladder) {
    pugi::xml_node file = add(project, "fileHeader");
    file.append_attribute("companyName") = "grafwire";
    file.append_attribute("productName") = "grafwire";
    file.append_attribute("productVersion") = std::string(version()).c_str();
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

class Interface {
  public:
    explicit Interface(pugi::xml_node pou) : interface_(pou.append_child("interface")) {}

    struct Declaration {
        std::string name;
        const char* type = "BOOL";
        std::string initial = {};      ///< empty: the type's own
        std::string explanation = {};  ///< empty: none
    };
    void add(const char* list, const Declaration& declaration) {
        pugi::xml_node variable = add_variable(list, declaration.name);
        variable.append_child("type").append_child(declaration.type);
        if (!declaration.initial.empty()) {
            variable.append_child("initialValue")
                .append_child("simpleValue")
                .append_attribute("value") = declaration.initial.c_str();
        }
        if (declaration.explanation.empty()) return;
        add_text(variable.append_child("documentation"), declaration.explanation);
    }
    void add_local(const Declaration& declaration) { add("localVars", declaration); }
    void add_instance(const std::string& name, const char* block) {
        pugi::xml_node variable = add_variable("localVars", name);
        variable.append_child("type").append_child("derived").append_attribute("name") = block;
    }

  private:
    /// Lists are made when they are first needed.
    pugi::xml_node add_variable(const char* list, const std::string& name) {
        pugi::xml_node node = interface_.child(list);
        if (!node) node = interface_.append_child(list);
        pugi::xml_node variable = node.append_child("variable");
        variable.append_attribute("name") = name.c_str();
        return variable;
    }

    pugi::xml_node interface_;
};

/// Nothing for 0, with which integers begin by themselves.
std::string initial_text(std::int64_t value) {
    return value == 0 ? std::string() : fmt::format("{}", value);
}

/// The type that holds every counter and every sum.
const char* integer_type(const Grafcet& grafcet) {
    IntegerRange widest;
    bool fits = true;
    const auto note = [&](const Sum& sum) {
        const auto range = range_of(grafcet, sum);
        fits = fits && range;
        if (!range) return;
        widest.low = std::min(widest.low, range->low);
        widest.high = std::max(widest.high, range->high);
    };
    for (const Counter& counter : grafcet.counters) {
        widest.low = std::min(widest.low, counter.low);
        widest.high = std::max(widest.high, counter.high);
    }
    for (const Sum& sum : grafcet.sums) note(sum);
    const Expressions& pool = grafcet.expressions;
    for (std::uint32_t i = 0; i < pool.size(); ++i) {
        if (pool.kind(ExprId{i}) != ExprKind::comparison) continue;
        note(pool.comparison_of(ExprId{i}).left);
        note(pool.comparison_of(ExprId{i}).right);
    }
    const auto holds = [&](std::int64_t limit) {
        return fits && widest.low >= -limit - 1 && widest.high <= limit;
    };
    return holds(INT16_MAX) ? "INT" : holds(INT32_MAX) ? "DINT" : "LINT";
}

void add_times(const Grafcet& grafcet, const sfc::Names& names, Interface& interface) {
    for (std::size_t i = 0; i < names.times.size(); ++i) {
        if (names.times[i].empty()) continue;
        const ExprId id = grafcet.expressions.time_conditions()[i];
        interface.add_local({.name = names.times[i],
                             .explanation = write_expression(grafcet, grafcet.expressions, id)});
        interface.add_instance(names.timers[i], "TON");
        if (!names.off_timers[i].empty()) interface.add_instance(names.off_timers[i], "TON");
    }
}

/// Copies begin with what they are copies of.
void add_copies(const Grafcet& grafcet, const sfc::Names& names, const char* integer,
                Language language, Interface& interface) {
    const auto any_initial = [&](Range<StepId> steps) {
        for (const StepId step : steps) {
            if (grafcet.steps[step].initial) return true;
        }
        return false;
    };
    const auto starts_true = [&](grafwire::Variable variable) {
        if (variable.kind == VariableKind::step) return any_initial({variable.index, 1});
        if (variable.kind == VariableKind::macro) {
            const Macro& macro = grafcet.macros[MacroId{variable.index}];
            return any_initial(macro.steps);
        }
        if (variable.kind != VariableKind::graph) return false;
        const Graph& graph = grafcet.graphs[GraphId{variable.index}];
        return any_initial(graph.steps);
    };
    for (const auto& [variable, name] : names.copies) {
        const bool is_counter = variable.kind == VariableKind::counter;
        std::string initial = starts_true(variable) ? "TRUE" : "";
        if (is_counter) initial = initial_text(grafcet.counters[CounterId{variable.index}].low);
        interface.add_local({name, is_counter ? integer : "BOOL", std::move(initial),
                             say::when_scan_began.in(language, variable_name(grafcet, variable))});
    }
    for (const auto& [time, name] : names.time_copies) {
        const ExprId id = grafcet.expressions.time_conditions()[time];
        interface.add_local({.name = name,
                             .explanation = say::when_scan_began.in(
                                 language, write_expression(grafcet, grafcet.expressions, id))});
    }
}

/// The variables of the sequential function chart.
void write_sfc_interface(const sfc::Plan& plan, const sfc::Names& names, Language language,
                         pugi::xml_node pou) {
    const Grafcet& grafcet = *plan.grafcet;
    Interface interface(pou);
    const std::size_t declared = grafcet.inputs.size();
    for (std::size_t i = 0; i < declared; ++i) interface.add("inputVars", {names.inputs[i]});
    for (const std::uint32_t i : plan.controls) {
        interface.add("inputVars", {names.inputs[declared + i]});
    }
    for (const std::string& name : names.outputs) interface.add("outputVars", {name});
    for (const std::string& name : names.vars) interface.add_local({name});
    const char* integer = integer_type(grafcet);
    for (std::uint32_t c = 0; c < names.counters.size(); ++c) {
        interface.add_local(
            {names.counters[c], integer, initial_text(grafcet.counters[CounterId{c}].low)});
    }
    add_times(grafcet, names, interface);
    for (const auto& [operand, name] : names.before) {
        interface.add_local(
            {.name = name,
             .explanation = say::before_this_scan.in(
                 language, write_expression(grafcet, grafcet.expressions, operand))});
    }
    add_copies(grafcet, names, integer, language, interface);
    if (!plan.has_start_bit) return;
    interface.add_local({.name = names.started, .explanation = say::started.in(language)});
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
    TextWriter writer;
    document.save(writer, "  ", pugi::format_default, pugi::encoding_utf8);
    return std::move(writer.text);
}

}  // namespace grafwire::plcopen
