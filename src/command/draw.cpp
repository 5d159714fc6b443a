// grafwire draw: the GRAFCET as a picture, with a situation of a run where one is asked for.

#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "command/option_uses.h"
#include "workflow/drawings.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

struct DrawArguments {
    std::string path;
    std::string stimuli;
    std::string at;
    std::string format = "svg";
    std::string notation = "overline";
    std::string paper = "a4";
    std::string output;
    bool standalone = false;
};

/// The situation at the moment asked for; empty, and shown, where there is none.
std::optional<ShownSituation> situation_of(const DrawArguments& request, const Chart& chart,
                                           Language language) {
    const std::optional<Time> at = parse_moment(request.at);
    if (!at) return std::nullopt;
    const auto stimuli = load_stimuli(request.stimuli, chart.grafcet);
    if (!stimuli) return std::nullopt;
    std::optional<ShownSituation> situation = situation_at(chart, *stimuli, *at, language);
    if (!situation) complain(say::no_situation_at(request.at));
    return situation;
}

ExitStatus draw(const DrawArguments& request, const CommandLine& line) {
    const DrawingFormat* format = format_named(drawing_formats(), request.format);
    if (format == nullptr) return ExitStatus::bad_request;
    const ChosenFormat chosen = chosen_format(drawing_formats(), *format);
    const unsigned facts = request.stimuli.empty() ? fact::none : fact::stimuli;
    if (refuse_idle_options(line, "draw", facts, &chosen)) return ExitStatus::bad_request;
    if (!request.stimuli.empty() && request.at.empty()) {
        complain(say::moment_needed());
        return ExitStatus::bad_request;
    }
    if (share_standard_input(request.path, request.stimuli)) return ExitStatus::bad_request;
    const auto chart = load_chart(request.path, line);
    if (!chart) return ExitStatus::bad_request;
    ChartDrawing how;
    how.sign = row_named(notation_table, request.notation)->sign;
    how.paper = *row_named(papers, request.paper);
    how.language = line.language();
    if (!request.at.empty()) {
        auto situation = situation_of(request, *chart, line.language());
        if (!situation) return ExitStatus::bad_request;
        how.situation = std::move(*situation);
    }
    OutputFiles files({request.path, request.stimuli});
    files.add(request.output, chart_drawing(*chart, how, *format, request.standalone));
    return finish(files, ExitStatus::done);
}

}  // namespace

Task declare_draw(const CommandLine& line) {
    const auto request = std::make_shared<DrawArguments>();
    line.add_argument(help::file_name, request->path, help::file()).names_file({".grafcet"});
    line.add_optional_argument(help::stim_name, request->stimuli, help::draw_stim())
        .names_file({".stim"});
    line.add("--at", request->at, help::draw_at());
    line.add("--to", request->format, with_rows(help::draw_to(), drawing_formats()))
        .names_row(drawing_formats())
        .shows_default();
    line.add("--notation", request->notation, help::notation())
        .one_of_names(notation_table)
        .shows_default();
    line.add("--paper", request->paper, help::paper()).one_of_names(papers).shows_default();
    line.add_flag("--standalone", request->standalone, help::standalone());
    line.add("-o", request->output, help::output()).names_file({});
    line.add_strict();
    return [request, line] { return draw(*request, line); };
}

}  // namespace grafwire
