#include "command/trace_output.h"

#include <fmt/format.h>

#include <algorithm>

#include "command/inputs.h"
#include "grafcet/write_grafcet.h"
#include "trace/stimuli_player.h"

namespace grafwire {

void TraceOutput::declare(const CommandLine& line) {
    line.add("-o", csv, "the trace as CSV (default: standard output)");
    line.add("--vcd", vcd, "the waveform as VCD, for GTKWave");
}

void warn_of_broken_assumptions(const Grafcet& grafcet,
                                const std::vector<RunResult::BrokenAssumption>& broken) {
    for (const auto& [at, assumption] : broken) {
        warn(fmt::format("at {} ms the stimuli break what the GRAFCET assumes: {}",
                         format_milliseconds(at),
                         write_expression(grafcet, grafcet.expressions,
                                          grafcet.assumptions[assumption].expression)));
    }
}

std::vector<RunResult::BrokenAssumption> broken_assumptions(const Grafcet& grafcet,
                                                            const Stimuli& stimuli) {
    std::vector<RunResult::BrokenAssumption> broken;
    StimuliPlayer player(stimuli, grafcet.all_input_count());
    for (const Stimuli::Change& change : stimuli.changes) {
        player.advance(change.at);
        const std::size_t found = broken_assumption(grafcet, player.inputs());
        const bool known = std::any_of(broken.begin(), broken.end(),
                                       [&](const auto& item) { return item.assumption == found; });
        if (found < grafcet.assumptions.size() && !known) broken.push_back({change.at, found});
    }
    return broken;
}

}  // namespace grafwire
