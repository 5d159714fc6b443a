// grafwire info: what a GRAFCET consists of, and what there is to be said against it.

#include "command/chart_results.h"
#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "grafcet/describe_grafcet.h"

namespace grafwire {

namespace help = messages::help;

Task declare_info(const CommandLine& line) {
    const auto words = std::make_shared<std::vector<std::string>>();
    line.add_arguments(help::file_name, *words, help::files());
    return [words, line] {
        const ChartFiles charts = find_chart_files(*words);
        auto results = ChartResults::planned(charts, "-", {".txt", OnOneStream::headed}, {});
        if (!results) return ExitStatus::bad_request;
        const ExitStatus status = for_each_chart(charts, [&](std::size_t i) {
            // Read and check; errors and warnings go to standard error.
            const auto chart = load_chart(charts.files[i]);
            if (!chart) return ExitStatus::bad_request;
            show_wiring_warnings(*chart, CdxForm::successor);
            // Describe it.
            results->add(i, describe_grafcet(chart->grafcet, line.language()));
            return ExitStatus::done;
        });
        return results->finish(status);
    };
}

}  // namespace grafwire
