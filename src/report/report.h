#pragma once

#include <string>
#include <vector>

#include "text/message.h"

namespace grafwire {

// A report on a chart: what is to stand on its page, as finished texts and pictures in one
// language, and the page itself. Parts that are empty are left out.

/// An input or output as it is declared.
struct ReportedName {
    std::string name;
    std::string comment;  ///< behind its declaration
};

/// A run of the reference.
struct ReportedRun {
    std::string file;                   ///< of the stimuli
    std::vector<std::string> remarks;   ///< assumptions that it breaks
    std::vector<std::string> pictures;  ///< SVG, a sheet each
    std::string story;
};

/// A style of netlists, and what its check has come to.
struct ReportedStyle {
    enum class Outcome {
        equivalent,
        different,
        undecided,
        not_made,  ///< the style cannot hold the chart
    };
    std::string name;
    std::string description;
    Outcome outcome = Outcome::undecided;
    std::string compared;               ///< how much was
    std::string basis;                  ///< what the verdict rests on
    std::string remarks;                ///< what else there is to say; of not_made, the reason
    std::string witness;                ///< a difference in words, its stimuli first
    std::vector<std::string> pictures;  ///< the same as timing diagrams: SVG, a sheet each
};

/// Everything that stands on the page.
struct Report {
    std::string title;
    std::string name;  ///< of the GRAFCET
    std::string file;
    std::vector<std::string> chart;  ///< SVG, a sheet each
    std::vector<ReportedName> inputs;
    std::vector<ReportedName> outputs;
    std::string equations;               ///< HTML
    std::string wired_style;             ///< whose schematic is shown
    std::vector<std::string> schematic;  ///< SVG, a sheet each
    std::vector<ReportedRun> runs;
    std::vector<ReportedStyle> styles;
    std::vector<std::string> assumptions;
    std::vector<std::string> warnings;  ///< of the chart, with their lines
    std::vector<std::string> hazards;   ///< of asynchronous wiring
    std::string source;                 ///< the text of the chart
    std::string picture_style;          ///< CSS that all pictures share
};

/// The page: one file of HTML (and of XML as well) that loads nothing and needs no script; made for
/// screens, light and dark, and for A4 paper.
std::string write_report(const Report& report, Language language);

}  // namespace grafwire
