#pragma once

#include <string>

#include "command/command_line.h"
#include "command/files.h"
#include "evolution/run.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire {

/// Where the trace and the waveform of a run go.
struct TraceOutput {
    std::string csv;
    std::string vcd;

    void declare(const CommandLine& line);
    void add_files(OutputFiles& files, const Trace& trace, std::string waveform) const {
        files.add(csv, write_csv(trace));
        if (!vcd.empty()) files.add(vcd, std::move(waveform));
    }
};

void warn_of_broken_assumptions(const Grafcet& grafcet,
                                const std::vector<RunResult::BrokenAssumption>& broken);

/// The moments at which stimuli break an assumption, the first for each that is found broken.
std::vector<RunResult::BrokenAssumption> broken_assumptions(const Grafcet& grafcet,
                                                            const Stimuli& stimuli);

}  // namespace grafwire
