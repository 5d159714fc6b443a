#include "s7/generate/listing_head.h"

#include <fmt/format.h>

#include <set>

#include "program/bit_names.h"
#include "s7/addresses/cpu.h"
#include "s7/generate/messages.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_generate;

/// What a step adds to a program on the average (Cordier, chapter VI).
constexpr std::uint32_t usual_step_bytes = 45;

/// With one decimal, after a comma in French.
std::string decimal(double number, Language language) {
    std::string text = fmt::format("{:.1f}", number);
    if (language == Language::french) text[text.find('.')] = ',';
    return text;
}

std::string range_text(std::uint32_t first, std::uint32_t bytes) {
    return fmt::format("VB{} … VB{}", first, first + bytes - 1);
}

/// Whether a controller has all timers that are used.
bool has_timers(const CpuRow& cpu, const NetworkList& networks) {
    for (const Network& network : networks.networks()) {
        for (const Instruction& instruction : network.instructions) {
            for (const Operand& operand : instruction.operands) {
                if (operand.area == Area::timer && operand.address >= cpu.timers) return false;
            }
        }
    }
    return true;
}

void tell_memory(const Grafcet& grafcet, const Addresses& addresses, const NetworkList& networks,
                 Language language, std::vector<std::string>& head) {
    const std::uint32_t skeleton = networks.size_of_part(Part::skeleton);
    const std::uint32_t chart = networks.size_of_part(Part::chart);
    head.push_back(say::program_memory.in(language, skeleton + chart, skeleton));
    if (const std::size_t steps = grafcet.steps.size(); steps != 0) {
        const double average = static_cast<double>(chart) / static_cast<double>(steps);
        head.push_back(
            say::bytes_of_chart.in(language, chart, decimal(average, language), usual_step_bytes));
    }
    for (const CpuRow& cpu : cpu_table) {
        const bool fits =
            skeleton + chart <= cpu.program_bytes &&
            addresses.variable_bytes() <= static_cast<std::uint32_t>(cpu.variable_bytes) &&
            has_timers(cpu, networks);
        head.push_back((fits ? say::fits : say::does_not_fit)
                           .in(language, cpu.name, cpu.program_bytes, cpu.variable_bytes));
    }
}

void tell_tables(const Addresses& addresses, Language language, std::vector<std::string>& head) {
    const TableLayout& layout = addresses.layout();
    const auto tell = [&](std::string_view name, std::uint32_t first, std::uint32_t bytes,
                          const Message<>& meaning) {
        head.push_back(
            fmt::format("{:<6} {:<16} {}", name, range_text(first, bytes), meaning.in(language)));
    };
    const auto tell_steps = [&](std::string_view name, BitKind kind, const Message<>& meaning) {
        tell(name, layout.first_byte(kind), layout.step_bytes, meaning);
    };
    head.push_back(say::tables.in(language));
    tell("Tfig", layout.graphs, layout.graph_bytes, say::table_of_graphs);
    tell("", 2, 4, say::accumulator);
    tell("", 6, 4, say::free_bits);
    tell_steps("Tp", BitKind::previous, say::steps_before);
    tell_steps("Ts", BitKind::step, say::steps);
    tell_steps("Tpulse", BitKind::pulse, say::steps_just_activated);
    tell_steps("Ta", BitKind::activate, say::steps_to_activate);
    tell_steps("Td", BitKind::deactivate, say::steps_to_deactivate);
    tell_steps("Tf1", BitKind::forced_on, say::steps_forced_on);
    tell_steps("Tf0", BitKind::forced_off, say::steps_forced_off);
    tell("Tt", layout.transitions, layout.transition_bytes, say::table_of_transitions);
    if (addresses.variable_bytes() > layout.end()) {
        tell("", layout.end(), addresses.variable_bytes() - layout.end(), say::more_memory);
    }
}

}  // namespace

IoAssignment assignment_of(const Grafcet& grafcet, const ScanProgram& program,
                           const Addresses& addresses) {
    IoAssignment assignment;
    std::set<std::string> names;
    const auto add = [&](std::string name, const Operand& operand) {
        if (names.insert(name).second) assignment.entries.push_back({operand, std::move(name), {}});
    };
    const auto add_bits = [&](BitKind kind, const auto& table) {
        for (std::uint32_t i = 0; i < table.size(); ++i) {
            add(table.items()[i].name, addresses[Bit{kind, i}]);
        }
    };
    add_bits(BitKind::input, grafcet.inputs);
    for (std::uint32_t c = 0; c < control_input_count; ++c) {
        if (!reads_control(program, static_cast<ControlInput>(c))) continue;
        add(std::string(input_name(grafcet, grafcet.inputs.size() + c)),
            addresses[Bit{BitKind::control, c}]);
    }
    add_bits(BitKind::output, grafcet.outputs);
    add_bits(BitKind::var, grafcet.vars);
    for (std::uint32_t c = 0; c < grafcet.counters.size(); ++c) {
        add(grafcet.counters.items()[c].name, addresses[IntegerCell{false, c}]);
    }
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        add(variable_name(grafcet, {VariableKind::step, s}), addresses[Bit{BitKind::step, s}]);
    }
    for (std::uint32_t t = 0; t < grafcet.transitions.size(); ++t) {
        add("(" + grafcet.transitions.items()[t].name + ")",
            addresses[Bit{BitKind::transition, t}]);
    }
    // A graph that bears the name of a variable is left out.
    for (std::uint32_t g = 0; g < grafcet.graphs.size(); ++g) {
        add(grafcet.graphs.items()[g].name, addresses[Bit{BitKind::may_evolve, g}]);
    }
    return assignment;
}

std::vector<std::string> head_of(const Grafcet& grafcet, const Addresses& addresses,
                                 const IoAssignment& assignment, const NetworkList& networks,
                                 Mnemonics mnemonics, Language language) {
    std::vector<std::string> head;
    head.push_back(titled_name(grafcet.name, grafcet.title, language));
    head.push_back(say::what_it_is.in(language));
    head.push_back("");
    tell_memory(grafcet, addresses, networks, language, head);
    head.push_back("");
    tell_tables(addresses, language, head);
    head.push_back("");
    head.push_back(say::addresses.in(language));
    const std::string text = write_io_assignment(assignment, mnemonics);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        head.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return head;
}

}  // namespace grafwire::s7
