#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command/chart_files.h"
#include "command/command_line.h"
#include "command/inputs.h"
#include "command/progress.h"
#include "text/workers.h"
#include "workflow/check.h"

namespace grafwire {

/// What may be written after `grafwire check`.
struct CheckArguments {
    std::vector<std::string> files;
    std::string styles = "nand";
    /// Of one check: its chart, and the netlist with its style.
    std::string path;
    NetlistRequest netlist;
    std::string against;
    std::string program;
    std::string io;
    std::string cpu = "214";
    std::string scan;
    std::string changes;   ///< empty: one
    std::string power_up;  ///< empty: unknown
    std::string format = "text";
    std::string witness;
    bool tolerance = false;
    bool pulses = false;
    std::vector<std::string> assumptions;
    std::string shard;       ///< empty: all
    std::uint64_t jobs = 0;  ///< 0: as many as there are cores
    std::uint64_t max_cases = 0;
    double max_seconds = 0;
    std::string max_memory;  ///< empty: no bound
    std::string output;

    /// The same for a check of that chart with that style; empty where there is no style.
    CheckArguments of_one(const std::string& chart, const std::string& style) const;
};

/// What is known of the request before anything is read.
unsigned facts_of(const CheckArguments& request);

/// What the reports say of a request for one check before anything has been read.
CheckSubject subject_of(const CheckArguments& request);

/// What a request says of values that are read from its words.
struct CheckValues {
    std::uint64_t max_memory = 0;  ///< in bytes; 0: no bound
    std::optional<Time> period;
};
/// Empty, and shown, where one is wrong.
std::optional<CheckValues> values_of(const CheckArguments& request);

/// The GRAFCET, with all that the plant never does; shown where it is wrong.
std::optional<Chart> load_plant(const CheckArguments& request, const ChartFile& file,
                                const CommandLine& line);

/// All that one check works with besides what is compared.
struct Session {
    const CheckArguments& request;
    const CommandLine& line;
    const Chart& chart;
    CheckValues values;
    Workers* workers;  ///< who share the exploration; nullptr: nobody does
    /// Where it is shown how far the check is, and under which name.
    ProgressLine& progress;
    std::string name;
    std::optional<OrderRemarks> orders{};  ///< of the style handshake
};

struct Judged {
    std::optional<Judgement> judgement;
    bool is_unsuitable = false;  ///< there is none, since the style cannot hold the chart
};

/// Compares what is asked for with the chart; where that is not possible the reason is shown.
Judged judge(const Session& session);

}  // namespace grafwire
