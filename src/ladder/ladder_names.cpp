// The names of the variables of a ladder diagram. What the chart declares keeps its name; what the
// method adds is named after it in the chart's own notation where that is short (`↑dcy`, `5s/X13`),
// so that the drawing reads like the chart.

#include <fmt/format.h>

#include "ladder/ladder_build.h"
#include "text/utf8.h"

namespace grafwire::ladder {

namespace {

constexpr std::size_t longest_name = 16;  // that is made of an expression

}  // namespace

std::string LadderBuild::unused_name(std::string_view wish) {
    std::string name(wish);
    for (std::size_t n = 2; names_.count(name) > 0; ++n) name = fmt::format("{}_{}", wish, n);
    return name;
}

VariableId LadderBuild::declare(std::string_view wish, Type type, Role role, std::string comment) {
    Variable variable;
    variable.name = unused_name(wish);
    variable.type = type;
    variable.role = role;
    variable.comment = std::move(comment);
    names_.insert(variable.name);
    return ladder_.add(std::move(variable));
}

/// Inputs, control inputs, outputs, steps, vars and counters, whether used or not: whoever looks at
/// the program looks for them. Everything else is declared when it first occurs.
void LadderBuild::declare_names() {
    const auto declare_bits = [&](BitKind kind, std::size_t count, Role role,
                                  const std::string& comment) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const Bit bit{kind, i};
            bits_[bit] = declare(name_of(bit), Type::bit, role, comment);
        }
    };
    declare_bits(BitKind::input, grafcet_.inputs.size(), Role::input, "");
    if (program_.has_modes) declare_bits(BitKind::control, control_input_count, Role::input, "");
    declare_bits(BitKind::output, grafcet_.outputs.size(), Role::output, "");
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        const Step& step = grafcet_.steps[StepId{s}];
        bits_[{BitKind::step, s}] = declare(name_of({BitKind::step, s}), Type::bit, Role::memory,
                                            (step.initial ? "initial step " : "step ") + step.name);
    }
    declare_bits(BitKind::var, grafcet_.vars.size(), Role::memory, "");
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        const Counter& counter = grafcet_.counters[CounterId{c}];
        note_range(counter.low, counter.high);
        integers_[{false, c}] = declare(counter.name, Type::integer, Role::memory,
                                        fmt::format("{}..{}", counter.low, counter.high));
    }
}

std::string LadderBuild::name_of(Bit bit) {
    const auto step_name = [&] { return variable_name(grafcet_, {VariableKind::step, bit.index}); };
    const auto expression = [&](std::string_view otherwise) {
        const std::string& text = comments_[bit];
        if (count_code_points(text) <= longest_name) return text;
        return fmt::format("{}{}", otherwise, bit.index);
    };
    switch (bit.kind) {
        case BitKind::input:
            return grafcet_.inputs[InputId{bit.index}].name;
        case BitKind::control:
            return std::string(input_name(grafcet_, grafcet_.inputs.size() + bit.index));
        case BitKind::output:
            return grafcet_.outputs[OutputId{bit.index}].name;
        case BitKind::var:
            return grafcet_.vars[VarId{bit.index}].name;
        case BitKind::step:
            return step_name();
        case BitKind::previous:
            return step_name() + "_before";
        case BitKind::pulse:
            return step_name() + "_pulse";
        case BitKind::transition:
            return "T" + grafcet_.transitions[TransitionId{bit.index}].name;
        case BitKind::may_evolve:
            return grafcet_.graphs[GraphId{bit.index}].name + "_evolves";
        case BitKind::edge:
            return expression("edge");
        case BitKind::edge_memory:
            return fmt::format("edge_memory{}", bit.index);
        case BitKind::time_value:
            return expression("time");
        default:
            return fmt::format("work{}", bit.index);
    }
}

VariableId LadderBuild::id_of(Bit bit) {
    const auto found = bits_.find(bit);
    if (found != bits_.end()) return found->second;
    const VariableId id = declare(name_of(bit), Type::bit, Role::memory, comments_[bit]);
    bits_.emplace(bit, id);
    return id;
}

VariableId LadderBuild::id_of(IntegerCell cell) {
    const auto found = integers_.find(cell);
    if (found != integers_.end()) return found->second;
    const VariableId id = new_integer();
    integers_.emplace(cell, id);
    return id;
}

VariableId LadderBuild::new_integer() {
    return declare("sum", Type::integer, Role::memory, "");
}

VariableId LadderBuild::instance(BlockType type, const std::string& stem) {
    const VariableId id = declare(stem, Type::block, Role::memory, "");
    ladder_.variables.back().block = type;
    return id;
}

}  // namespace grafwire::ladder
