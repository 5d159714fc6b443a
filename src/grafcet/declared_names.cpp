#include "grafcet/declared_names.h"

namespace grafwire {

std::vector<std::string> declared_names(const Grafcet& grafcet) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
        names.emplace_back(input_name(grafcet, i));
    }
    for (const Output& output : grafcet.outputs) names.push_back(output.name);
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        names.push_back(variable_name(grafcet, {VariableKind::step, s}));
    }
    for (const Var& var : grafcet.vars) names.push_back(var.name);
    for (const Counter& counter : grafcet.counters) names.push_back(counter.name);
    return names;
}

}  // namespace grafwire
