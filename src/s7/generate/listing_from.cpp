// A GRAFCET as a listing of the table method for S7-200.
//
// The method and its skeleton are Cordier's, "Méthode d'implémentation du GRAFCET sur automate à
// instruction de type list" (1998): the tables of section 3.2, the subroutines of chapter V. The
// work is divided as his text is: where things live (addresses.h, tables.h, timers.h), the skeleton
// (listing_skeleton.cpp), the parts of the chart (listing_start.cpp, listing_sections.cpp,
// listing_statements.cpp), conditions (condition_writer.h), and the head (listing_head.h).

#include "s7/generate/listing_from.h"

#include "program/messages.h"
#include "s7/addresses/messages.h"
#include "s7/addresses/operand_text.h"
#include "s7/generate/assignment.h"
#include "s7/generate/integer_width.h"
#include "s7/generate/listing_build.h"
#include "s7/generate/listing_head.h"
#include "s7/generate/messages.h"
#include "s7/instruction_set.h"

namespace grafwire::s7 {

namespace {

namespace say = messages::s7_generate;

/// Bits of E, and of A.
std::size_t image_bits(Cpu cpu) {
    return static_cast<std::size_t>(row_of(cpu).image_bytes) * 8;
}

void check_tables(const Grafcet& grafcet, Diagnostics& diagnostics) {
    const TableLayout layout = standard_tables();
    const auto check = [&](const Message<std::size_t, std::uint32_t>& message, std::size_t count,
                           std::uint32_t bytes) {
        if (count <= std::size_t{bytes} * 8) return;
        diagnostics.error(code::beyond_limit, {}, message(count, bytes * 8));
    };
    check(say::too_many_steps, grafcet.steps.size(), layout.step_bytes);
    check(say::too_many_transitions, grafcet.transitions.size(), layout.transition_bytes);
    check(say::too_many_graphs, grafcet.graphs.size(), layout.graph_bytes);
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
    result.listing.head = head_of(grafcet, addresses, result.assignment, networks,
                                  options.mnemonics, options.language);
    result.listing.networks = networks.take();
    return result;
}

}  // namespace grafwire::s7
