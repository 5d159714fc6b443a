// Results of several charts wait until all are made: nobody finds half of them after a failure to
// write, and names that clash are known before anything is.

#include "command/chart_results.h"

#include <filesystem>
#include <map>

#include "command/messages.h"
#include "command/standard_error.h"
#include "text/utf8.h"
#include "workflow/json_line.h"

namespace grafwire {

namespace {

namespace fs = std::filesystem;
namespace say = messages::command;

}  // namespace

std::string name_for(const ChartFile& chart) {
    return chart.path == "-" ? "stdin" : fs::path(chart.path).stem().string();
}

bool have_names_of_their_own(const ChartFiles& charts) {
    std::map<std::string, const ChartFile*> known;
    for (const ChartFile& chart : charts.files) {
        if (chart.problem) continue;
        const auto [other, is_new] = known.emplace(name_for(chart), &chart);
        if (is_new) continue;
        complain(say::same_name(visible(other->second->path), visible(chart.path),
                                visible(other->first)));
        return false;
    }
    return true;
}

ChartResults::ChartResults(const ChartFiles& charts, std::string output, Form form,
                           std::vector<std::string> inputs)
    : charts_(charts), output_(std::move(output)), form_(form), files_(std::move(inputs)) {}

std::optional<ChartResults> ChartResults::planned(const ChartFiles& charts, std::string output,
                                                  Form form,
                                                  const std::vector<std::string>& others) {
    std::vector<std::string> inputs = charts.paths();
    inputs.insert(inputs.end(), others.begin(), others.end());
    ChartResults results(charts, std::move(output), form, std::move(inputs));
    if (results.is_folder(results.output_)) {
        if (!have_names_of_their_own(charts)) return std::nullopt;
    } else if (charts.are_several && form.on_one_stream == OnOneStream::never) {
        complain(say::several_need_folder());
        return std::nullopt;
    }
    return results;
}

/// Whether what an option says is a folder for the results of several charts.
bool ChartResults::is_folder(const std::string& output) const {
    return charts_.are_several && !output.empty() && output != "-";
}

std::string ChartResults::place_of(std::size_t chart) const {
    return place_of(chart, output_, form_.extension);
}

std::string ChartResults::place_of(std::size_t chart, const std::string& other_output,
                                   std::string_view extension) const {
    if (!is_folder(other_output)) return other_output;
    return (fs::path(other_output) / (name_for(charts_.files[chart]) + std::string(extension)))
        .string();
}

void ChartResults::add(std::size_t chart, std::string text) {
    if (!charts_.are_several || is_folder(output_)) {
        add_beside(place_of(chart), std::move(text));
        return;
    }
    const std::string& path = charts_.files[chart].path;
    if (form_.on_one_stream == OnOneStream::lines) {
        stream_ += json_line(text, path);
    } else {
        if (!stream_.empty()) stream_ += '\n';
        stream_ += say::file_heading.in(Language::english, visible(path));
        stream_ += text;
    }
}

void ChartResults::add_beside(std::string path, std::string text) {
    const fs::path folder = fs::path(path).parent_path();
    if (charts_.are_several && !folder.empty()) files_.add_folder(folder.string());
    files_.add(std::move(path), std::move(text));
}

ExitStatus ChartResults::finish(ExitStatus status) {
    if (!stream_.empty()) files_.add("-", std::move(stream_));
    return grafwire::finish(files_, status);
}

}  // namespace grafwire
