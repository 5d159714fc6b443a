#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "grafwire/check.h"
#include "text/diagnostics.h"
#include "text/message.h"
#include "text/time.h"
#include "trace/stimuli.h"
#include "workflow/chart.h"
#include "workflow/netlists.h"

namespace grafwire::api {

// What stands behind the handles of the public headers, and how their values become those of the
// workflow. Not installed.

struct Chart::Parts {
    grafwire::Chart chart;
};

struct Netlist::Parts {
    Chart chart;
    grafwire::Netlist netlist;
    std::string style;  ///< of a generated one, with its form of CDX
    std::string cdx;
    std::string source;  ///< what a netlist from elsewhere is called
};

/// The messages without their notes and source lines.
std::vector<Message> messages_from(const Diagnostics& diagnostics);
Message error(Localized text);

inline grafwire::Language language_from(Language language) {
    return language == Language::french ? grafwire::Language::french : grafwire::Language::english;
}
inline CdxForm form_from(Cdx cdx) {
    return cdx == Cdx::successor ? CdxForm::successor : CdxForm::transition;
}

/// A period that may be wrong: then `is_wrong`, and the value is none.
struct CheckedPeriod {
    std::optional<Time> value;
    bool is_wrong = false;
};
CheckedPeriod period_from(std::optional<std::chrono::nanoseconds> period);

/// What runs and benches begin with: stimuli as text, where there are any, and a period, where
/// there is one. What is wrong with them is in the messages, and then it is not good.
struct Start {
    std::optional<Stimuli> stimuli;
    std::optional<Time> period;
    std::vector<Message> messages;
    bool is_good = true;
};
Start begin(const grafwire::Chart& chart, const std::optional<std::string>& stimuli,
            std::optional<std::chrono::nanoseconds> period);
Message wrong_period();

/// Copies, for values that outlive the tables of the library.
std::vector<std::string> strings(const std::vector<std::string_view>& names);

}  // namespace grafwire::api
