// grafwire info: what a GRAFCET consists of, and what there is to be said against it.

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "grafcet/describe_grafcet.h"

namespace grafwire {

namespace help = messages::help;

Task declare_info(const CommandLine& line) {
    const auto path = std::make_shared<std::string>();
    line.add_argument(help::file_name, *path, help::file());
    return [path, line] {
        // Read and check; errors and warnings go to standard error.
        const auto chart = load_chart(*path);
        if (!chart) return ExitStatus::bad_request;
        show_wiring_warnings(*chart, CdxForm::successor);
        // Describe it.
        OutputFiles files({*path});
        files.add("-", describe_grafcet(chart->grafcet, line.language()));
        return finish(files, ExitStatus::done);
    };
}

}  // namespace grafwire
