#include "evolution/run_text.h"

#include <doctest/doctest.h>

#include <sstream>
#include <vector>

#include "grafcet/parse_grafcet.h"

namespace grafwire::testing {

Grafcet grafcet_from(std::string_view text) {
    const SourceFile source{"test.grafcet", std::string(text)};
    Diagnostics diagnostics;
    std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
    if (!grafcet) FAIL(format_diagnostics(diagnostics, source));
    return std::move(*grafcet);
}

Stimuli stimuli_from(std::string_view text, const Grafcet& grafcet) {
    const SourceFile source{"test.stim", std::string(text)};
    Diagnostics diagnostics;
    std::optional<Stimuli> stimuli = parse_stimuli(source, grafcet, diagnostics);
    if (!stimuli) FAIL(format_diagnostics(diagnostics, source));
    return std::move(*stimuli);
}

std::string rows(const Trace& trace, std::string_view columns) {
    std::vector<std::size_t> chosen;
    std::istringstream names{std::string(columns)};
    for (std::string name; names >> name;) {
        std::size_t c = 0;
        while (c < trace.columns.size() && trace.columns[c].name != name) ++c;
        if (c == trace.columns.size()) FAIL("no column " << name);
        chosen.push_back(c);
    }
    std::string text = "\n";  // expected texts begin on a line of their own
    for (std::size_t row = 0; row < trace.row_count(); ++row) {
        text += format_milliseconds(trace.times[row]);
        for (const std::size_t c : chosen) {
            text += ' ' + std::to_string(trace.values[row * trace.columns.size() + c]);
        }
        text += '\n';
    }
    return text;
}

std::string until_stable(std::string_view grafcet, std::string_view stimuli,
                         std::string_view columns) {
    const Grafcet model = grafcet_from(grafcet);
    const RunResult result = run_until_stable(model, stimuli_from(stimuli, model));
    std::string text = rows(result.trace, columns);
    if (result.unstable_at) {
        text += "unstable at " + format_milliseconds(*result.unstable_at) + ":";
        for (const std::string& name : result.changing) text += ' ' + name;
        text += '\n';
    }
    return text;
}

std::string scans(std::string_view grafcet, std::string_view stimuli, Time period,
                  std::string_view columns) {
    const Grafcet model = grafcet_from(grafcet);
    return rows(run_scans(model, stimuli_from(stimuli, model), period).trace, columns);
}

}  // namespace grafwire::testing
