// grafwire plc: the GRAFCET as a program in one of the languages, with the addresses of its names.

#include <algorithm>

#include "command/chart_results.h"
#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "command/option_uses.h"
#include "workflow/heads.h"

namespace grafwire {

namespace {

namespace help = messages::help;

/// What may be written after `grafwire plc`.
struct PlcArguments {
    std::vector<std::string> files;
    std::string format;
    std::string modes = "on";
    std::string io;
    std::string mnemonics = "simatic";
    std::string offsets = "on";
    std::string tables = "standard";
    std::string cpu;
    bool pull_up = false;
    std::string addresses;
    std::string output;
};

/// The options by the values that users write; those that the format does not heed have been
/// refused.
PlcOptions options_from(const PlcArguments& request) {
    PlcOptions options;
    options.mnemonics =
        request.mnemonics == "simatic" ? s7::Mnemonics::simatic : s7::Mnemonics::international;
    options.offsets = request.offsets == "on";
    options.wide_tables = request.tables == "wide";
    options.cpu = cpu_of_number(request.cpu);
    options.pull_up = request.pull_up;
    return options;
}

/// An assignment that suits chart and format, with messages shown; empty after an error.
std::optional<s7::IoAssignment> load_suitable_assignment(const std::string& path,
                                                         const PlcFormat& format,
                                                         const PlcOptions& options,
                                                         const Chart& chart) {
    Diagnostics diagnostics;
    const SourceFile source = read_source(path, diagnostics);
    std::optional<s7::IoAssignment> assignment;
    if (!diagnostics.has_errors()) {
        assignment = read_assignment(source, format, options, chart, diagnostics);
    }
    show_diagnostics(diagnostics, source);
    return assignment;
}

/// The program, and the table of its addresses if it is asked for.
ExitStatus add_program(const PlcArguments& request, const PlcFormat& format,
                       const CommandLine& line, const ChartFiles& charts, std::size_t number,
                       ChartResults& results) {
    // Read the GRAFCET and the addresses.
    const auto chart = load_chart(charts.files[number], line);
    if (!chart) return ExitStatus::bad_request;
    PlcOptions options = options_from(request);
    options.language = line.language();
    std::optional<s7::IoAssignment> assignment;
    if (!request.io.empty()) {
        assignment = load_suitable_assignment(request.io, format, options, *chart);
        if (!assignment) return ExitStatus::bad_request;
        options.io = &*assignment;
    }
    const bool modes = request.modes == "on";
    options.made_by = program_head(*chart, format, options, modes, request.io);
    // Make the program of one scan.
    Diagnostics diagnostics;
    auto written = write_program(*chart, format, options, modes, diagnostics);
    diagnostics = as_asked(std::move(diagnostics), line);
    show_diagnostics(diagnostics, chart->source);
    if (!written || diagnostics.has_errors()) return ExitStatus::bad_request;
    results.add(number, std::move(written->text));
    if (!request.addresses.empty()) {
        results.add_beside(results.place_of(number, request.addresses, ".io"),
                           std::move(written->addresses));
    }
    return ExitStatus::done;
}

ExitStatus write(const PlcArguments& request, const PlcFormat& format, const CommandLine& line) {
    const std::vector<std::string>& files = request.files;
    if (request.io == "-" && std::find(files.begin(), files.end(), "-") != files.end()) {
        complain(messages::command::assignment_shares_standard_input());
        return ExitStatus::bad_request;
    }
    const ChartFiles charts = find_chart_files(files);
    auto results = ChartResults::planned(charts, request.output, {format.extension}, {request.io});
    if (!results) return ExitStatus::bad_request;
    const ExitStatus status = for_each_chart(charts, [&](std::size_t i) {
        return add_program(request, format, line, charts, i, *results);
    });
    return results->finish(status);
}

}  // namespace

Task declare_plc(const CommandLine& line) {
    const auto request = std::make_shared<PlcArguments>();
    line.add_arguments(help::file_name, request->files, help::files()).names_file({".grafcet"});
    line.add("--to", request->format, with_rows(help::plc_to(), plc_formats()))
        .names_row(plc_formats())
        .required();
    line.add("--modes", request->modes, help::plc_modes()).one_of({"on", "off"}).shows_default();
    line.add("--io", request->io, help::plc_io()).names_file({".io"});
    line.add("--addresses", request->addresses, help::addresses()).names_file({".io"});
    line.add("--mnemonics", request->mnemonics, help::mnemonics())
        .one_of({"simatic", "iec", "en"})
        .shows_default();
    line.add("--offsets", request->offsets, help::offsets()).one_of({"on", "off"}).shows_default();
    line.add("--tables", request->tables, help::tables())
        .one_of({"standard", "wide"})
        .shows_default();
    line.add("--cpu", request->cpu, help::plc_cpu()).one_of(cpu_numbers());
    line.add_flag("--pull-up", request->pull_up, help::pull_up());
    line.add("-o", request->output, help::outputs()).names_file({});
    line.add_strict();
    return [request, line] {
        const PlcFormat* format = format_named(plc_formats(), request->format);
        if (format == nullptr) return ExitStatus::bad_request;
        const ChosenFormat chosen = chosen_format(plc_formats(), *format);
        if (refuse_idle_options(line, "plc", fact::none, &chosen)) return ExitStatus::bad_request;
        return write(*request, *format, line);
    };
}

}  // namespace grafwire
