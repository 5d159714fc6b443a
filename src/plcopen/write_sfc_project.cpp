// A project with a sequential function chart: the interface of its program.

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "grafcet/grafcet.h"
#include "grafcet/write_grafcet.h"
#include "plcopen/bodies.h"
#include "plcopen/messages.h"
#include "plcopen/project.h"
#include "plcopen/write_project.h"

namespace grafwire::plcopen {

namespace {

namespace say = messages::plcopen;

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

std::string write_sfc_project(const Grafcet& grafcet, const SfcProjectOptions& options) {
    const sfc::Plan plan = sfc::plan_of(grafcet, options.modes);
    const sfc::Names names = sfc::names_of(plan);
    Project project(grafcet.name, grafcet.title);
    pugi::xml_node program = project.program();
    write_sfc_interface(plan, names, options.language, program);
    write_sfc_body(plan, names, options.language, program.append_child("body").append_child("SFC"));
    std::string documentation = grafcet.title.empty() ? grafcet.name : grafcet.title;
    if (!options.made_by.empty()) documentation += "\n" + options.made_by;
    add_text(program.append_child("documentation"), documentation);
    return project.text();
}

}  // namespace grafwire::plcopen
