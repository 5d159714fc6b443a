#include "workflow/drawings.h"

#include <algorithm>
#include <utility>

#include "draw/moments.h"
#include "draw/timing_diagram.h"
#include "draw/write_drawing.h"
#include "story/instant_causes.h"
#include "text/shown_duration.h"
#include "workflow/messages.h"

namespace grafwire {

namespace say = messages::workflow;

namespace {

std::string timing_picture(const ShownRun& run, Language language) {
    return write_svg_drawing(sheets_of_runs(run, nullptr, language), run.title, papers[0],
                             language);
}

constexpr TraceFormat trace_rows[] = {
    {"csv",
     ".csv",
     {"a row for each instant or scan", "une ligne par instant ou par scrutation"},
     [](const ShownRun& run, Language) { return write_csv(run.trace); }},
    {"svg",
     ".svg",
     {"a timing diagram", "un chronogramme"},
     [](const ShownRun& run, Language language) { return timing_picture(run, language); },
     true,
     "--zoom"},
    {"wavedrom",
     ".json",
     {"a timing diagram for WaveDrom", "un chronogramme pour WaveDrom"},
     [](const ShownRun& run, Language language) {
         return write_wavedrom(run.trace, run.title, language, run.causes, run.scale);
     },
     true,
     "--zoom"},
};

constexpr DrawingFormat formats[] = {
    {"svg",
     ".svg",
     {"a picture for browsers and word processors",
      "une image pour navigateurs et traitements de texte"},
     [](const std::vector<Sheet>& sheets, std::string_view title, const Paper& paper,
        Language language, bool) { return write_svg_drawing(sheets, title, paper, language); }},
    {"tikz",
     ".tex",
     {"a TikZ picture for LaTeX", "une figure TikZ pour LaTeX"},
     [](const std::vector<Sheet>& sheets, std::string_view title, const Paper& paper, Language,
        bool standalone) { return write_tikz_drawing(sheets, title, paper, standalone); },
     "--standalone"},
};

}  // namespace

std::span<const DrawingFormat> drawing_formats() {
    return formats;
}

std::optional<ShownSituation> situation_at(const Chart& chart, const Stimuli& stimuli, Time at,
                                           Language language) {
    const Grafcet& grafcet = chart.grafcet;
    const InstantStory* shown = nullptr;
    const ToldRun run = tell_run(grafcet, stimuli, std::nullopt);
    for (const InstantStory& story : run.stories) {
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
    return format.write(draw_chart(chart.grafcet, how), title_of(chart.grafcet), how.paper,
                        how.language, standalone);
}

std::span<const TraceFormat> trace_formats() {
    return trace_rows;
}

std::string title_of(const Grafcet& grafcet) {
    return grafcet.title.empty() ? grafcet.name : grafcet.title;
}

std::vector<TimingCause> causes_of(const Trace& trace, const Grafcet& grafcet,
                                   const ToldRun& reference) {
    std::vector<TimingCause> all;
    for (InstantCauses& found : causes_in(grafcet, reference.stories)) {
        const auto at = std::lower_bound(trace.times.begin(), trace.times.end(), found.at);
        if (at == trace.times.begin() || at == trace.times.end() || *at != found.at) continue;
        const auto row = static_cast<std::size_t>(at - trace.times.begin());
        TimingCause cause{found.at, std::move(found.inputs), std::move(found.ended), {}};
        for (std::size_t column = 0; column < trace.columns.size(); ++column) {
            if (trace.columns[column].kind == Trace::Column::Kind::input) continue;
            if (value_in(trace, row, column) == value_in(trace, row - 1, column)) continue;
            cause.effects.push_back({column, found.at});
        }
        all.push_back(std::move(cause));
    }
    return all;
}

std::string trace_in_format(const Trace& trace, const Chart& chart, const TraceFormat& format,
                            Language language, std::vector<TimingCause> causes) {
    return format.write({trace, title_of(chart.grafcet), std::move(causes)}, language);
}

std::vector<Sheet> sheets_of_runs(const ShownRun& expected, const Trace* found, Language language) {
    TimingDrawing how;
    how.title = expected.title;
    how.language = language;
    how.other = found;
    how.causes = expected.causes;
    how.scale = expected.scale;
    return draw_timing(expected.trace, how);
}

}  // namespace grafwire
