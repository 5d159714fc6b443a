// A GRAFCET as a listing of the table method for S7-200.
//
// The method and its skeleton are Cordier's, "Méthode d'implémentation du GRAFCET sur automate à
// instruction de type list" (1998): the tables of section 3.2, the subroutines of chapter V. The
// work is divided as his text is: where things live (tables.h, addresses.h, timers.h), the
// subroutines with the parts of the chart in them (listing_sections.cpp, listing_statements.cpp),
// and conditions (condition_writer.h). Here it is put together: the limits of the controllers are
// checked, and the head tells what memory the program takes and what stands at which address.

#include "s7/generate/listing_from.h"

#include <fmt/format.h>

#include <set>

#include "program/bit_names.h"
#include "program/messages.h"
#include "s7/addresses/cpu.h"
#include "s7/addresses/messages.h"
#include "s7/addresses/operand.h"
#include "s7/generate/assignment.h"
#include "s7/generate/integer_width.h"
#include "s7/generate/listing_build.h"
#include "s7/generate/messages.h"
#include "s7/instruction_set.h"
#include "text/counted.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_generate;

/// Bits of E, and of A.
std::size_t image_bits(Cpu cpu) {
    return static_cast<std::size_t>(row_of(cpu).image_bytes) * 8;
}

void check_tables(const Grafcet& grafcet, Diagnostics& diagnostics) {
    const TableLayout layout = standard_tables();
    const auto check = [&](const CountedMessage<>& what, std::size_t count, std::uint32_t bytes) {
        if (count <= std::size_t{bytes} * 8) return;
        diagnostics.error(code::beyond_limit, {}, say::beyond_tables(what(count), bytes * 8));
    };
    check(messages::counted::steps, grafcet.steps.size(), layout.step_bytes);
    check(messages::counted::transitions, grafcet.transitions.size(), layout.transition_bytes);
    check(messages::counted::graphs, grafcet.graphs.size(), layout.graph_bytes);
}

/// What did not find room in the process images, and what the assignment forgot.
class InterfaceCheck {
  public:
    InterfaceCheck(const Addresses& addresses, Cpu cpu, const ResolvedAssignment* assignment,
                   Diagnostics& diagnostics)
        : addresses_(addresses), cpu_(cpu), assignment_(assignment), diagnostics_(diagnostics) {}

    void check(Bit bit, std::string_view name, Location where) {
        const Operand operand = addresses_[bit];
        const bool is_assigned = assignment_ != nullptr && assignment_->bits.contains(bit);
        const bool is_output = bit.kind == BitKind::output;
        if (!is_assigned && operand.address >= row_of(cpu_).image_bytes) {
            diagnostics_.error(code::beyond_limit, where,
                               is_output ? say::no_room_for_output(name, image_bits(cpu_))
                                         : say::no_room_for_input(name, image_bits(cpu_)));
        } else if (!is_assigned && assignment_ != nullptr) {
            diagnostics_.warning(code::unassigned_name, where,
                                 say::unassigned(name, write_operand(operand, Mnemonics::simatic)));
        }
    }

  private:
    const Addresses& addresses_;
    Cpu cpu_;
    const ResolvedAssignment* assignment_;
    Diagnostics& diagnostics_;
};

void check_interface(const Grafcet& grafcet, const ScanProgram& program, InterfaceCheck check) {
    for (std::uint32_t i = 0; i < grafcet.inputs.size(); ++i) {
        const Input& input = grafcet.inputs.items()[i];
        check.check({BitKind::input, i}, input.name, input.where);
    }
    for (std::uint32_t c = 0; c < control_input_count; ++c) {
        if (!reads_control(program, static_cast<ControlInput>(c))) continue;
        check.check({BitKind::control, c}, input_name(grafcet, grafcet.inputs.size() + c), {});
    }
    for (std::uint32_t o = 0; o < grafcet.outputs.size(); ++o) {
        const Output& output = grafcet.outputs.items()[o];
        check.check({BitKind::output, o}, output.name, output.where);
    }
}

/// The memory of the controller that was asked for; of V memory at least that of a CPU 214.
void check_memory(const Addresses& addresses, const NetworkList& networks,
                  const std::optional<Cpu>& cpu, bool has_modes, Diagnostics& diagnostics) {
    const CpuRow& row = row_of(cpu.value_or(Cpu::cpu_214));
    if (addresses.variable_bytes() > static_cast<std::uint32_t>(row.variable_bytes)) {
        const auto& message =
            cpu == Cpu::cpu_212 ? say::too_much_v_memory_of_212 : say::too_much_v_memory;
        diagnostics.error(code::beyond_limit, {},
                          message(addresses.variable_bytes(), row.name, row.variable_bytes));
    }
    const std::uint32_t size =
        networks.size_of_part(Part::skeleton) + networks.size_of_part(Part::chart);
    if (!cpu || size <= row.program_bytes) return;
    const Message<>& to_do =
        *cpu == Cpu::cpu_212 ? (has_modes ? say::without_modes_or_214 : say::take_a_214)
                             : (has_modes ? say::without_modes_or_divide : say::divide_the_chart);
    diagnostics.error(code::beyond_limit, {},
                      say::program_too_long(size, row.name, row.program_bytes, to_do()));
}

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

/// What every address stands for: inputs, control inputs that are read, outputs, vars, counters,
/// steps (in Ts), transitions (in Tt) and graphs (in Tfig).
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

/// The lines at the head of a listing: what it is, the memory it takes, its tables, and the
/// assignment, one line a name as parse_io_assignment reads them.
std::vector<std::string> head_of(const Grafcet& grafcet, const Addresses& addresses,
                                 const IoAssignment& assignment, const NetworkList& networks,
                                 const ListingOptions& options) {
    const Language language = options.language;
    std::vector<std::string> head;
    head.push_back(titled_name(grafcet.name, grafcet.title, language));
    if (!options.made_by.empty()) head.push_back(options.made_by);
    head.push_back(say::what_it_is.in(language));
    head.push_back("");
    tell_memory(grafcet, addresses, networks, language, head);
    head.push_back("");
    tell_tables(addresses, language, head);
    head.push_back("");
    head.push_back(say::addresses.in(language));
    const std::string text = write_io_assignment(assignment, options.mnemonics);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        head.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return head;
}

}  // namespace

std::optional<AssignedListing> listing_from(const Grafcet& grafcet, const ScanProgram& given,
                                            const ListingOptions& options,
                                            Diagnostics& diagnostics) {
    if (!options.wide_tables) check_tables(grafcet, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;

    // Where things live.
    const bool is_assigned = options.io != nullptr;
    const ResolvedAssignment assignment = resolve_assignment(
        grafcet, is_assigned ? *options.io : IoAssignment(), options.wide_tables, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    const ScanProgram program =
        is_assigned ? without_unassigned_controls(given, assignment) : given;
    const Cpu cpu = options.cpu.value_or(Cpu::cpu_214);
    const auto timers = plan_timers(grafcet, program, cpu, diagnostics);
    const auto width = integer_width(grafcet, program, assignment, diagnostics);
    if (diagnostics.has_errors() || !width) return std::nullopt;
    Addresses addresses(grafcet, program,
                        options.wide_tables ? wide_tables(grafcet) : standard_tables(),
                        options.wide_tables, assignment, timers, *width);
    check_interface(
        grafcet, program,
        InterfaceCheck(addresses, cpu, is_assigned ? &assignment : nullptr, diagnostics));

    // The networks, and what they take.
    NetworkList networks =
        ListingBuild(grafcet, program, addresses, timers, options.language).make_networks();
    check_memory(addresses, networks, options.cpu, program.has_modes, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    AssignedListing result;
    result.assignment = assignment_of(grafcet, program, addresses);
    result.listing.head = head_of(grafcet, addresses, result.assignment, networks, options);
    result.listing.networks = networks.take();
    return result;
}

}  // namespace grafwire::s7
