// grafwire equations: CAX, CDX, X and the equations of the actions, in one of the forms.

#include <span>

#include "command/chart_results.h"
#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/option_uses.h"

namespace grafwire {

namespace {

namespace help = messages::help;

struct EquationsArguments {
    std::vector<std::string> files;
    std::string cdx = "successor";
    std::string modes = "on";
    std::string format = "text";
    std::string output;
    bool karnaugh = false;
    bool standalone = false;
};

/// Documents and tables for programs have one head each.
OnOneStream on_one_stream(EquationFormat format) {
    switch (format) {
        case EquationFormat::text:
        case EquationFormat::markdown:
            return OnOneStream::headed;
        case EquationFormat::json:
            return OnOneStream::lines;
        case EquationFormat::latex:
        case EquationFormat::csv:
        case EquationFormat::html:
            break;
    }
    return OnOneStream::never;
}

/// Those of charts that have been named, in a form that is heeded.
ExitStatus write(const EquationsArguments& request, const EquationFormatRow& format,
                 const CommandLine& line) {
    const CdxForm cdx = row_named(cdx_table, request.cdx)->form;
    const ChartFiles charts = find_chart_files(request.files);
    auto results = ChartResults::planned(charts, request.output,
                                         {format.extension, on_one_stream(format.format)}, {});
    if (!results) return ExitStatus::bad_request;
    const ExitStatus status = for_each_chart(charts, [&](std::size_t i) {
        // Read the GRAFCET.
        const auto chart = load_chart(charts.files[i], line);
        if (!chart) return ExitStatus::bad_request;
        // Derive the equations, and write them down.
        if (!show_wiring_warnings(*chart, cdx, line)) return ExitStatus::bad_request;
        results->add(i, equation_report(*chart, {cdx, request.modes == "on"},
                                        {format.format, request.karnaugh, line.language(),
                                         request.standalone}));
        return ExitStatus::done;
    });
    return results->finish(status);
}

}  // namespace

Task declare_equations(const CommandLine& line) {
    const auto request = std::make_shared<EquationsArguments>();
    line.add_arguments(help::file_name, request->files, help::files()).names_file({".grafcet"});
    line.add("--cdx", request->cdx, help::cdx()).one_of_names(cdx_table).shows_default();
    line.add("--modes", request->modes, help::modes()).one_of({"on", "off"}).shows_default();
    line.add("--to", request->format, help::equations_to())
        .one_of_names(equation_format_table)
        .shows_default();
    line.add_flag("--karnaugh", request->karnaugh, help::karnaugh());
    line.add_flag("--standalone", request->standalone, help::whole_report());
    line.add("-o", request->output, help::outputs()).names_file({});
    line.add_strict();
    return [request, line] {
        const EquationFormatRow& format = *row_named(equation_format_table, request->format);
        const ChosenFormat chosen =
            chosen_format(std::span<const EquationFormatRow>(equation_format_table), format);
        if (refuse_idle_options(line, "equations", fact::none, &chosen)) {
            return ExitStatus::bad_request;
        }
        return write(*request, format, line);
    };
}

}  // namespace grafwire
