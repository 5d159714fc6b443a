#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/paper_notation.h"
#include "draw/scene.h"
#include "grafcet/grafcet.h"
#include "text/message.h"

namespace grafwire {

/// A moment of a run to be shown in a chart: by step, whether it is active; by transition, whether
/// all steps before it are, and whether it is clearable then, its condition being 1. All of them
/// empty: no moment is shown.
struct ShownSituation {
    std::vector<bool> active;
    std::vector<bool> enabled;
    std::vector<bool> clearable;
    std::string caption;  ///< what the moment is; may be empty
};

/// How a chart is to be drawn.
struct ChartDrawing {
    NotSign sign = NotSign::overline;
    Paper paper = papers[0];
    Language language = Language::english;
    ShownSituation situation;
    /// For a page that shows one situation after the other: what marks active steps and enabled
    /// transitions is there for each of them, as a group `token` of its own, to be shown or hidden.
    bool animated = false;
};

/// The chart as IEC 60848 draws it. Upright if it fits, else lying, else in smaller letters, else
/// on several sheets: graphs one after the other, and a graph that is longer than a sheet cut at
/// links from transitions to steps. What does not fit even so gets a larger sheet.
std::vector<Sheet> draw_chart(const Grafcet& grafcet, const ChartDrawing& how);

}  // namespace grafwire
