#include "command/command.h"
#include "command/inputs.h"
#include "grafcet/describe_grafcet.h"

namespace grafwire {

Task declare_info(const CommandLine& line, const Language& language) {
    const auto path = std::make_shared<std::string>();
    line.add("FILE", *path, "the GRAFCET, - for standard input").required();
    return [path, &language] {
        // Read and check; errors and warnings go to standard error.
        const auto chart = load_chart(*path);
        if (!chart) return ExitStatus::bad_request;
        show_wiring_warnings(*chart, CdxForm::successor);
        // Describe it.
        OutputFiles files({*path});
        files.add("-", describe_grafcet(chart->grafcet, language));
        return finish(files, ExitStatus::done);
    };
}

}  // namespace grafwire
