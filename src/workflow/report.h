#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "check/check_result.h"
#include "draw/gate_symbols.h"
#include "netlist/styles/styles.h"
#include "text/keep_going.h"
#include "text/message.h"
#include "trace/stimuli.h"
#include "workflow/chart.h"

namespace grafwire {

/// What a report is asked to hold, and how long its checks may take.
struct ReportRequest {
    std::string file;                  ///< of the chart
    const Stimuli* stimuli = nullptr;  ///< of the run that is shown; null: none
    std::string stimuli_file;
    Style style = Style::gates;  ///< whose schematic is shown
    GateShapes shapes = GateShapes::iec;
    Changes changes = Changes::one;  ///< of asynchronous netlists
    Workers* workers = nullptr;      ///< as in CheckOptions
    std::uint64_t max_cases = 0;     ///< of each check; 0: no bound
    /// As in CheckOptions; once it says no, this check and those that follow are undecided.
    std::function<void(const Coverage&)> progress;
    KeepGoing keep_going;
    Language language = Language::english;
};

/// Everything about a chart on one page of HTML: the drawing, equations, the run, and the verdict
/// on each style with what shows a difference.
std::string report_of(const Chart& chart, const ReportRequest& request);

}  // namespace grafwire
