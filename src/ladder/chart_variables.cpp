// The variables of a diagram made from a chart: `X10` of a step, `T0` of a transition, `X10_before`
// and `X10_pulse`, `↑dcy` of an edge, `5s/X13` of a time condition while that is no longer than
// sixteen characters. Two that would have the same name get a number: `timer0_2`.

#include "ladder/chart_variables.h"

#include <fmt/format.h>

#include <algorithm>

#include "ladder/messages.h"
#include "program/bit_names.h"
#include "text/utf8.h"

namespace grafwire::ladder {

namespace say = messages::ladder;

ChartVariables::ChartVariables(const Grafcet& grafcet, const ScanProgram& program,
                               const SimplifiedScan& scan, Language language, Ladder& ladder)
    : grafcet_(grafcet), program_(program), scan_(scan), language_(language), ladder_(ladder) {
    declare_bits(BitKind::input, grafcet.inputs.size(), Role::input);
    if (program.has_modes) declare_bits(BitKind::control, control_input_count, Role::input);
    declare_bits(BitKind::output, grafcet.outputs.size(), Role::output);
    declare_steps();
    declare_bits(BitKind::var, grafcet.vars.size(), Role::memory);
    declare_counters();
}

void ChartVariables::declare_bits(BitKind kind, std::size_t count, Role role) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const Bit bit{kind, i};
        bits_[bit] = declare(name_of(bit), Type::bit, role, {});
    }
}

void ChartVariables::declare_steps() {
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        const Step& step = grafcet_.steps[StepId{s}];
        const Bit bit{BitKind::step, s};
        bits_[bit] = declare(name_of(bit), Type::bit, Role::memory,
                             step.initial ? say::initial_step(step.name) : say::step(step.name));
    }
}

void ChartVariables::declare_counters() {
    for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
        const Counter& counter = grafcet_.counters[CounterId{c}];
        widen(counter.low, counter.high);
        integers_[{false, c}] =
            declare(counter.name, Type::integer, Role::memory,
                    Localized::same_in_both(fmt::format("{}..{}", counter.low, counter.high)));
    }
}

VariableId ChartVariables::declare(std::string_view wish, Type type, Role role,
                                   const Localized& comment) {
    Variable variable;
    variable.name = wish;
    for (std::size_t n = 2; !names_.insert(variable.name).second; ++n) {
        variable.name = fmt::format("{}_{}", wish, n);
    }
    variable.type = type;
    variable.role = role;
    variable.comment = comment.in(language_);
    return ladder_.add(std::move(variable));
}

std::string ChartVariables::name_of(Bit bit) const {
    constexpr std::size_t longest = 16;  // of an expression that is a name
    const std::string name = name_in_chart(grafcet_, bit);
    const auto step_name = [&] { return variable_name(grafcet_, {VariableKind::step, bit.index}); };
    const auto expression = [&](std::string_view otherwise) {
        if (count_code_points(name) <= longest) return name;
        return fmt::format("{}{}", otherwise, bit.index);
    };
    switch (bit.kind) {
        case BitKind::step:
            return step_name();
        case BitKind::previous:
            return step_name() + "_before";
        case BitKind::pulse:
            return step_name() + "_pulse";
        case BitKind::transition:
            return "T" + name;
        case BitKind::may_evolve:
            return name + "_evolves";
        case BitKind::edge:
            return expression("edge");
        case BitKind::edge_memory:
            return fmt::format("edge_memory{}", bit.index);
        case BitKind::time_value:
            return expression("time");
        case BitKind::scratch:
            return fmt::format("work{}", bit.index);
        case BitKind::auxiliary:
            return fmt::format("work{}", program_.scratch_bits + bit.index);
        default:
            return name;
    }
}

VariableId ChartVariables::operator[](Bit bit) {
    const auto found = bits_.find(bit);
    if (found != bits_.end()) return found->second;
    const VariableId id = declare(name_of(bit), Type::bit, Role::memory, scan_.comment_of(bit));
    bits_.emplace(bit, id);
    return id;
}

VariableId ChartVariables::operator[](IntegerCell cell) {
    const auto found = integers_.find(cell);
    if (found != integers_.end()) return found->second;
    const VariableId id = new_integer();
    integers_.emplace(cell, id);
    return id;
}

VariableId ChartVariables::new_instance(BlockType type, std::string_view wish) {
    const VariableId id = declare(wish, Type::block, Role::memory, {});
    ladder_.variables.back().block = type;
    return id;
}

void ChartVariables::widen(std::int64_t low, std::int64_t high) {
    const auto holds = [&](std::int64_t limit) { return low >= -limit - 1 && high <= limit; };
    const std::uint32_t bits = holds(INT16_MAX) ? 16 : holds(INT32_MAX) ? 32 : 64;
    ladder_.integer_bits = std::max(ladder_.integer_bits, bits);
}

}  // namespace grafwire::ladder
