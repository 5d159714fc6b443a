#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/scene.h"
#include "draw/time_scale.h"
#include "draw/timing_cause.h"
#include "text/message.h"
#include "trace/trace.h"

namespace grafwire {

/// Sheets as one self-contained SVG file, one below the other, in mm; printed from a browser, a
/// sheet takes a page. Every group carries the class of its owner and its facts (`data-step`), so a
/// style sheet or a script finds the parts again. For light and dark viewers, black on white on
/// paper. `title` is what a viewer calls the picture; what it shows stands in words beside it, for
/// those who hear it.
std::string write_svg_drawing(const std::vector<Sheet>& sheets, std::string_view title,
                              const Paper& paper, Language language);

/// The same for a page of HTML that holds many: an `<svg>` for each sheet, without the style sheet,
/// which stands once in the page. `id` is theirs alone there: what names a sheet and describes it
/// has an id that begins so.
std::vector<std::string> write_svg_sheets(const std::vector<Sheet>& sheets, std::string_view title,
                                          Language language, std::string_view id);
/// The style sheet of all of them, as CSS.
std::string svg_style();

/// Sheets as TikZ pictures, to be read into a document that loads TikZ; or as a whole document, a
/// page each.
std::string write_tikz_drawing(const std::vector<Sheet>& sheets, std::string_view title,
                               const Paper& paper, bool standalone);

/// A run as JSON for WaveDrom (WaveJSON): a period for each moment at which something changes, with
/// the times in the first line; inputs, steps, outputs and the rest in groups. Arrows lead from
/// causes to their effects, up to as many as WaveDrom has names for their ends.
std::string write_wavedrom(const Trace& trace, std::string_view title, Language language,
                           const std::vector<TimingCause>& causes = {},
                           TimeScale scale = TimeScale::moments);

}  // namespace grafwire
