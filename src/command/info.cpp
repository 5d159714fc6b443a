// grafwire info: what a GRAFCET consists of, and what there is to be said against it; or the latter
// alone, for servers and editors that show it beside the lines.

#include <filesystem>

#include "command/chart_results.h"
#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "grafcet/describe_grafcet.h"
#include "workflow/sarif.h"

namespace grafwire {

namespace {

namespace help = messages::help;

struct InfoArguments {
    std::vector<std::string> files;
    std::string format = "text";
    std::string output;
};

/// Reads and checks; errors and warnings go to standard error.
std::optional<Chart> load_good_chart(const ChartFile& file, const CommandLine& line) {
    auto chart = load_chart(file, line);
    if (chart && !show_wiring_warnings(*chart, CdxForm::successor, line)) return std::nullopt;
    return chart;
}

ExitStatus describe(const InfoArguments& request, const CommandLine& line) {
    const ChartFiles charts = find_chart_files(request.files);
    auto results = ChartResults::planned(charts, request.output, {".txt", OnOneStream::headed}, {});
    if (!results) return ExitStatus::bad_request;
    const ExitStatus status = for_each_chart(charts, [&](std::size_t i) {
        const auto chart = load_good_chart(charts.files[i], line);
        if (!chart) return ExitStatus::bad_request;
        results->add(i, describe_grafcet(chart->grafcet, line.language()));
        return ExitStatus::done;
    });
    return results->finish(status);
}

/// One log of all charts, also of those that are wrong.
ExitStatus write_log(const InfoArguments& request, const CommandLine& line) {
    const ChartFiles charts = find_chart_files(request.files);
    std::vector<FileMessages> messages;
    const ExitStatus status = for_each_chart(charts, [&](std::size_t i) {
        const MessageRecord record;
        const bool is_good = load_good_chart(charts.files[i], line).has_value();
        messages.insert(messages.end(), record.messages().begin(), record.messages().end());
        return is_good ? ExitStatus::done : ExitStatus::bad_request;
    });
    std::error_code error;
    OutputFiles files(charts.paths());
    files.add(request.output, write_sarif(messages, std::filesystem::current_path(error).string()));
    return finish(files, status);
}

}  // namespace

Task declare_info(const CommandLine& line) {
    const auto request = std::make_shared<InfoArguments>();
    line.add_arguments(help::file_name, request->files, help::files()).names_file({".grafcet"});
    line.add("--to", request->format, help::info_to()).one_of({"text", "sarif"}).shows_default();
    line.add("-o", request->output, help::info_output()).names_file({});
    line.add_strict();
    return [request, line] {
        return request->format == "sarif" ? write_log(*request, line) : describe(*request, line);
    };
}

}  // namespace grafwire
