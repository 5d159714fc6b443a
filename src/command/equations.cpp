// grafwire equations: CAX, CDX, X and the equations of the actions, in one of the forms.

#include <span>

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/option_uses.h"

namespace grafwire {

namespace {

namespace help = messages::help;

struct EquationsArguments {
    std::string path;
    std::string cdx = "successor";
    std::string modes = "on";
    std::string format = "text";
    std::string output;
    bool karnaugh = false;
    bool standalone = false;
};

}  // namespace

Task declare_equations(const CommandLine& line) {
    const auto request = std::make_shared<EquationsArguments>();
    line.add_argument(help::file_name, request->path, help::file());
    line.add("--cdx", request->cdx, help::cdx()).one_of_names(cdx_table).shows_default();
    line.add("--modes", request->modes, help::modes()).one_of({"on", "off"}).shows_default();
    line.add("--to", request->format, help::equations_to())
        .one_of_names(equation_format_table)
        .shows_default();
    line.add_flag("--karnaugh", request->karnaugh, help::karnaugh());
    line.add_flag("--standalone", request->standalone, help::whole_report());
    line.add("-o", request->output, help::output());
    return [request, line] {
        const EquationFormatRow& format = *row_named(equation_format_table, request->format);
        const CdxForm cdx = row_named(cdx_table, request->cdx)->form;
        const ChosenFormat chosen =
            chosen_format(std::span<const EquationFormatRow>(equation_format_table), format);
        if (refuse_idle_options(line, "equations", fact::none, &chosen)) {
            return ExitStatus::bad_request;
        }
        // Read the GRAFCET.
        const auto chart = load_chart(request->path);
        if (!chart) return ExitStatus::bad_request;
        // Derive the equations, and write them down.
        show_wiring_warnings(*chart, cdx);
        OutputFiles files({request->path});
        files.add(request->output, equation_report(*chart, {cdx, request->modes == "on"},
                                                   {format.format, request->karnaugh,
                                                    line.language(), request->standalone}));
        return finish(files, ExitStatus::done);
    };
}

}  // namespace grafwire
