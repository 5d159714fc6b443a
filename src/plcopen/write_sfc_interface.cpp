// The variables of the sequential function chart.

#include <fmt/format.h>

#include <algorithm>

#include "grafcet/write_grafcet.h"
#include "plcopen/plcopen_parts.h"
#include "program/program.h"

namespace grafwire::ladder {

namespace {

class Interface {
  public:
    explicit Interface(pugi::xml_node pou) : interface_(pou.append_child("interface")) {}

    void begin(const char* list) {
        name_ = list;
        list_ = {};
    }
    void add(const std::string& name, const char* type, bool derived = false) {
        if (!list_) list_ = interface_.append_child(name_);
        variable_ = list_.append_child("variable");
        variable_.append_attribute("name") = name.c_str();
        pugi::xml_node node = variable_.append_child("type");
        if (!derived) {
            node.append_child(type);
        } else {
            node.append_child("derived").append_attribute("name") = type;
        }
    }
    // Of the variable added last:
    void initial(std::int64_t value) {
        if (value != 0) initial(fmt::format("{}", value));
    }
    void initial(const std::string& value) {
        variable_.append_child("initialValue")
            .append_child("simpleValue")
            .append_attribute("value") = value.c_str();
    }
    void explain(const std::string& text) {
        add_text(variable_.append_child("documentation"), text);
    }

  private:
    pugi::xml_node interface_;
    pugi::xml_node list_;
    pugi::xml_node variable_;
    const char* name_ = "";
};

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
        interface.add(names.times[i], "BOOL");
        interface.explain(write_expression(grafcet, grafcet.expressions, id));
        interface.add(names.timers[i], "TON", true);
        if (!names.off_timers[i].empty()) interface.add(names.off_timers[i], "TON", true);
    }
}

/// Copies begin with what they are copies of.
void add_copies(const Grafcet& grafcet, const sfc::Names& names, const char* integer,
                Interface& interface) {
    const auto any_initial = [&](std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            if (grafcet.steps[StepId{first + i}].initial) return true;
        }
        return false;
    };
    const auto starts_true = [&](grafwire::Variable variable) {
        if (variable.kind == VariableKind::step) return any_initial(variable.index, 1);
        if (variable.kind == VariableKind::macro) {
            const Macro& macro = grafcet.macros[MacroId{variable.index}];
            return any_initial(macro.first_step, macro.step_count);
        }
        if (variable.kind != VariableKind::graph) return false;
        const Graph& graph = grafcet.graphs[GraphId{variable.index}];
        return any_initial(graph.first_step, graph.step_count);
    };
    for (const auto& [variable, name] : names.copies) {
        const bool is_counter = variable.kind == VariableKind::counter;
        interface.add(name, is_counter ? integer : "BOOL");
        if (is_counter) interface.initial(grafcet.counters[CounterId{variable.index}].low);
        if (starts_true(variable)) interface.initial("TRUE");
        interface.explain("when the scan began: " + variable_name(grafcet, variable));
    }
    for (const auto& [time, name] : names.time_copies) {
        const ExprId id = grafcet.expressions.time_conditions()[time];
        interface.add(name, "BOOL");
        interface.explain("when the scan began: " +
                          write_expression(grafcet, grafcet.expressions, id));
    }
}

}  // namespace

void write_sfc_interface(const sfc::Plan& plan, const sfc::Names& names, pugi::xml_node pou) {
    const Grafcet& grafcet = *plan.grafcet;
    Interface interface(pou);
    interface.begin("inputVars");
    const std::size_t declared = grafcet.inputs.size();
    for (std::size_t i = 0; i < declared; ++i) interface.add(names.inputs[i], "BOOL");
    for (const std::uint32_t i : plan.controls) interface.add(names.inputs[declared + i], "BOOL");
    interface.begin("outputVars");
    for (const std::string& name : names.outputs) interface.add(name, "BOOL");
    interface.begin("localVars");
    for (const std::string& name : names.vars) interface.add(name, "BOOL");
    const char* integer = integer_type(grafcet);
    for (std::uint32_t c = 0; c < names.counters.size(); ++c) {
        interface.add(names.counters[c], integer);
        interface.initial(grafcet.counters[CounterId{c}].low);
    }
    add_times(grafcet, names, interface);
    for (const auto& [operand, name] : names.before) {
        interface.add(name, "BOOL");
        interface.explain("before this scan: " +
                          write_expression(grafcet, grafcet.expressions, operand));
    }
    add_copies(grafcet, names, integer, interface);
    if (!plan.has_start_bit) return;
    interface.add(names.started, "BOOL");
    interface.explain("0 in the first scan only");
}

}  // namespace grafwire::ladder
