// Programs and their addresses. Users name controllers by number, the tables by their full names.

#include "workflow/programs.h"

#include "program/program.h"
#include "s7/parse_listing.h"

namespace grafwire {

std::string_view number_of(s7::Cpu cpu) {
    const std::string_view name = s7::row_of(cpu).name;
    return name.substr(name.rfind(' ') + 1);
}

std::vector<std::string> cpu_numbers() {
    std::vector<std::string> numbers;
    for (const s7::CpuRow& row : s7::cpu_table) numbers.emplace_back(number_of(row.cpu));
    return numbers;
}

std::optional<s7::Cpu> cpu_of_number(std::string_view number) {
    for (const s7::CpuRow& row : s7::cpu_table) {
        if (number_of(row.cpu) == number) return row.cpu;
    }
    return std::nullopt;
}

std::optional<s7::IoAssignment> read_assignment(const SourceFile& source,
                                                Diagnostics& diagnostics) {
    return s7::parse_io_assignment(source, diagnostics);
}

std::optional<s7::IoAssignment> read_assignment(const SourceFile& source, const PlcFormat& format,
                                                const PlcOptions& options, const Chart& chart,
                                                Diagnostics& diagnostics) {
    auto assignment = read_assignment(source, diagnostics);
    if (!assignment) return std::nullopt;
    PlcOptions with_assignment = options;
    with_assignment.io = &*assignment;
    format.check_io(chart.grafcet, with_assignment, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    return assignment;
}

std::optional<s7::Listing> read_listing(const SourceFile& source, s7::Cpu cpu,
                                        const s7::IoAssignment* assignment,
                                        Diagnostics& diagnostics) {
    return s7::parse_listing(source, {cpu, assignment, false}, diagnostics);
}

std::optional<WrittenProgram> write_program(const Chart& chart, const PlcFormat& format,
                                            const PlcOptions& options, bool modes,
                                            Diagnostics& diagnostics) {
    const ScanProgram program = program_from(chart.grafcet, {modes});
    WrittenProgram written;
    written.text = format.write(chart.grafcet, program, options, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
    if (format.write_addresses != nullptr) {
        Diagnostics already_told;
        written.addresses = format.write_addresses(chart.grafcet, program, options, already_told);
    }
    return written;
}

}  // namespace grafwire
