// The comments of modules are written once a netlist has been made, so that what makes gates need
// not know how equations are shown. Modules are known by their names: those of steps stand in the
// order of the table.

#include "netlist/styles/annotate.h"

#include <fmt/format.h>

#include <string>
#include <unordered_map>

#include "grafcet/write_grafcet.h"
#include "netlist/styles/step_texts.h"

namespace grafwire {

namespace {

/// Of an asynchronous netlist: a longer equation cannot be read, and the comment is left out.
constexpr std::size_t most_operands = 256;

using Comments = std::unordered_map<std::string, std::string>;

void add_outputs(const Grafcet& grafcet, const Equations& equations, Comments& comments) {
    for (const OutputEquation& equation : equations.outputs) {
        const std::string& name = grafcet.outputs[equation.output].name;
        comments.emplace(
            name, fmt::format("{} = {}", name,
                              write_expression(grafcet, equations.expressions, equation.value)));
    }
}

/// The latches of stored outputs and vars, and what holds their values while they are written.
void add_stored(const Grafcet& grafcet, const Equations& equations, Comments& comments) {
    for (const StoredEquation& stored : equations.stored) {
        if (stored.target.kind == VariableKind::counter) continue;
        const std::string name = variable_name(grafcet, stored.target);
        if (stored.writes.empty()) {
            comments.emplace(name, name + " = 0");
            continue;
        }
        const std::string comment =
            fmt::format("{}: set {} reset {}", name,
                        write_expression(grafcet, equations.expressions, stored.set),
                        write_expression(grafcet, equations.expressions, stored.reset));
        comments.emplace(name, comment);
        comments.emplace(name + "$hold", comment);
    }
}

bool is_of_step(const Module& module, const Step& step) {
    return module.name.starts_with('X') && std::string_view(module.name).substr(1) == step.name;
}

}  // namespace

void annotate(Netlist& netlist, const Grafcet& grafcet, const Equations& equations) {
    Comments comments;
    add_outputs(grafcet, equations, comments);
    if (!netlist.is_clocked()) add_stored(grafcet, equations, comments);
    StepTexts texts(grafcet, equations,
                    netlist.is_clocked() ? StepTexts::any_length : most_operands);
    std::size_t step = 0;
    for (Module& module : netlist.modules) {
        if (step < grafcet.steps.size() &&
            is_of_step(module, grafcet.steps[grafcet.steps.id_at(step)])) {
            module.comment = texts.equation(grafcet.steps.id_at(step++));
        } else if (const auto comment = comments.find(module.name); comment != comments.end()) {
            module.comment = std::move(comment->second);
        }
    }
}

}  // namespace grafwire
