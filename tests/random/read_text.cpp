#include "random/read_text.h"

#include "grafcet/parse_grafcet.h"

namespace grafwire::testing {

std::optional<Grafcet> read_grafcet(const std::string& text, std::string* messages) {
    const SourceFile source{"random.grafcet", text};
    Diagnostics diagnostics;
    std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
    if (messages != nullptr) *messages = format_diagnostics(diagnostics, source);
    return grafcet;
}

std::optional<Stimuli> read_stimuli(const std::string& text, const Grafcet& grafcet,
                                    std::string* messages) {
    const SourceFile source{"random.stim", text};
    Diagnostics diagnostics;
    std::optional<Stimuli> stimuli = parse_stimuli(source, grafcet, diagnostics);
    if (messages != nullptr) *messages = format_diagnostics(diagnostics, source);
    return stimuli;
}

}  // namespace grafwire::testing
