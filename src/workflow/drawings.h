#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "draw/draw_chart.h"
#include "draw/time_scale.h"
#include "draw/timing_cause.h"
#include "story/instant_story.h"
#include "text/message.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "trace/trace.h"
#include "workflow/chart.h"

namespace grafwire {

/// A format of drawings, by the name users write.
struct DrawingFormat {
    std::string_view name;
    std::string_view extension;  ///< of its files, with the dot
    Message<> description;
    /// `standalone` makes a whole document, in formats that heed it.
    std::string (*write)(const std::vector<Sheet>& sheets, std::string_view title,
                         const Paper& paper, Language language, bool standalone);
    std::string_view options = "";  ///< those that only some formats heed
};
std::span<const DrawingFormat> drawing_formats();

/// The signs for NOT by the names users write.
struct NotationRow {
    std::string_view name;
    NotSign sign;
};
inline constexpr NotationRow notation_table[] = {
    {"overline", NotSign::overline},
    {"slash", NotSign::slash},
};

/// The moment of a run that a drawing shows: the last instant that is not later than `at`. Empty
/// where the run has no stable situation there.
std::optional<ShownSituation> situation_at(const Chart& chart, const Stimuli& stimuli, Time at,
                                           Language language);

/// The chart as IEC 60848 draws it, in a format of the table.
std::string chart_drawing(const Chart& chart, const ChartDrawing& how, const DrawingFormat& format,
                          bool standalone);

/// A run to be shown, and what pictures of it are called.
struct ShownRun {
    const Trace& trace;
    std::string title;
    // For pictures alone.
    std::vector<TimingCause> causes{};
    TimeScale scale = TimeScale::moments;
};

/// A format of traces, by the name users write.
struct TraceFormat {
    std::string_view name;
    std::string_view extension;
    Message<> description;
    std::string (*write)(const ShownRun& run, Language language);
    bool is_picture = false;
    std::string_view options = "";  ///< those that only some formats heed
};
std::span<const TraceFormat> trace_formats();

/// What pictures of a chart are called.
std::string title_of(const Grafcet& grafcet);

/// What began the changes that a run shows, by the account of the reference under the same stimuli.
std::vector<TimingCause> causes_of(const Trace& trace, const Grafcet& grafcet,
                                   const ToldRun& reference);

/// A run of the chart in a format of the table.
std::string trace_in_format(const Trace& trace, const Chart& chart, const TraceFormat& format,
                            Language language, std::vector<TimingCause> causes = {});

/// Two runs as one timing diagram: what the reference does, with its causes, and what was found,
/// if anything.
std::vector<Sheet> sheets_of_runs(const ShownRun& expected, const Trace* found, Language language);

}  // namespace grafwire
