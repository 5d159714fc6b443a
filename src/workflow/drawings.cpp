#include "workflow/drawings.h"

#include "draw/timing_diagram.h"
#include "draw/write_drawing.h"
#include "story/instant_story.h"
#include "text/shown_duration.h"
#include "workflow/messages.h"

namespace grafwire {

namespace say = messages::workflow;

namespace {

/// What a picture of the chart is called.
std::string title_of(const Grafcet& grafcet) {
    return grafcet.title.empty() ? grafcet.name : grafcet.title;
}

constexpr TraceFormat trace_rows[] = {
    {"csv", {"a row for each instant or scan", "une ligne par instant ou par scrutation"}},
    {"svg", {"a timing diagram", "un chronogramme"}},
    {"wavedrom", {"a timing diagram for WaveDrom", "un chronogramme pour WaveDrom"}},
};

constexpr DrawingFormat formats[] = {
    {"svg",
     {"a picture for browsers and word processors",
      "une image pour navigateurs et traitements de texte"},
     ""},
    {"tikz", {"a TikZ picture for LaTeX", "une figure TikZ pour LaTeX"}, "--standalone"},
};

}  // namespace

std::span<const DrawingFormat> drawing_formats() {
    return formats;
}

std::optional<ShownSituation> situation_at(const Chart& chart, const Stimuli& stimuli, Time at,
                                           Language language) {
    const Grafcet& grafcet = chart.grafcet;
    const InstantStory* shown = nullptr;
    const std::vector<InstantStory> stories = tell_run(grafcet, stimuli, std::nullopt);
    for (const InstantStory& story : stories) {
        if (story.at <= at) shown = &story;
    }
    if (shown == nullptr || !shown->is_stable) return std::nullopt;
    ShownSituation situation;
    situation.active.resize(grafcet.steps.size());
    for (std::size_t step = 0; step < grafcet.steps.size(); ++step) {
        situation.active[step] = shown->situation.test(step);
    }
    situation.enabled.resize(grafcet.transitions.size());
    situation.clearable.resize(grafcet.transitions.size());
    for (const EnabledTransition& enabled : shown->enabled) {
        situation.enabled[index_of(enabled.transition)] = true;
        situation.clearable[index_of(enabled.transition)] = enabled.condition;
    }
    situation.caption = say::situation_at(shown_duration(at)).in(language);
    return situation;
}

std::string chart_drawing(const Chart& chart, const ChartDrawing& how, const DrawingFormat& format,
                          bool standalone) {
    const Grafcet& grafcet = chart.grafcet;
    const std::string title = title_of(grafcet);
    const std::vector<Sheet> sheets = draw_chart(grafcet, how);
    if (format.name == "tikz") return write_tikz_drawing(sheets, title, how.paper, standalone);
    return write_svg_drawing(sheets, title, how.paper, how.language);
}

std::span<const TraceFormat> trace_formats() {
    return trace_rows;
}

std::string trace_in_format(const Trace& trace, const Chart& chart, const TraceFormat& format,
                            Language language) {
    const std::string title = title_of(chart.grafcet);
    if (format.name == "svg") {
        TimingDrawing how;
        how.title = title;
        how.language = language;
        return write_svg_drawing(draw_timing(trace, how), title, how.paper, language);
    }
    if (format.name == "wavedrom") return write_wavedrom(trace, title, language);
    return write_csv(trace);
}

std::string picture_of_runs(const Grafcet& grafcet, const Trace& expected, const Trace& found,
                            Language language) {
    TimingDrawing how;
    how.title = title_of(grafcet);
    how.language = language;
    how.other = &found;
    return write_svg_drawing(draw_timing(expected, how), how.title, how.paper, language);
}

}  // namespace grafwire
