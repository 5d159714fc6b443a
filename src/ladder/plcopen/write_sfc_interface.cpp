// The variables of the sequential function chart.

#include <fmt/format.h>

#include "ladder/plcopen/plcopen_parts.h"
#include "ladder/plcopen/structured_text.h"

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
    /// Of the variable added last.
    void initial(std::int64_t value) {
        if (value == 0) return;
        variable_.append_child("initialValue")
            .append_child("simpleValue")
            .append_attribute("value") = fmt::format("{}", value).c_str();
    }

  private:
    pugi::xml_node interface_;
    pugi::xml_node list_;
    pugi::xml_node variable_;
    const char* name_ = "";
};

}  // namespace

void write_sfc_interface(const Grafcet& grafcet, pugi::xml_node pou) {
    const SfcNames names = sfc_names(grafcet);
    const Expressions& pool = grafcet.expressions;
    Interface interface(pou);
    interface.begin("inputVars");
    for (const std::string& name : names.inputs) interface.add(name, "BOOL");
    interface.begin("outputVars");
    for (const std::string& name : names.outputs) interface.add(name, "BOOL");
    interface.begin("localVars");
    for (const std::string& name : names.vars) interface.add(name, "BOOL");
    for (std::uint32_t c = 0; c < names.counters.size(); ++c) {
        const Counter& counter = grafcet.counters[CounterId{c}];
        const bool is_short = counter.low >= INT16_MIN && counter.high <= INT16_MAX;
        interface.add(names.counters[c], is_short ? "INT" : "LINT");
        interface.initial(counter.low);
    }
    for (std::size_t i = 0; i < pool.edges().size(); ++i) {
        const bool rises = pool.kind(pool.edges()[i]) == ExprKind::rise;
        interface.add(names.edges[i], "BOOL");
        interface.add(fmt::format("edge{}", i), rises ? "R_TRIG" : "F_TRIG", true);
    }
    for (std::size_t i = 0; i < pool.time_conditions().size(); ++i) {
        const TimeCondition& condition = pool.time_condition_of(pool.time_conditions()[i]);
        if (is_step_time(grafcet, condition)) continue;
        interface.add(names.times[i], "BOOL");
        interface.add(fmt::format("timer{}", i), "TON", true);
        if (condition.off_delay != 0) interface.add(fmt::format("timer{}_off", i), "TON", true);
    }
}

}  // namespace grafwire::ladder
