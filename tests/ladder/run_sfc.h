#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ladder/ladder.h"
#include "ladder/sfc_machine.h"
#include "trace/stimuli.h"
#include "trace/trace.h"

namespace grafwire::testing {

/// The sequential function chart that is written for a GRAFCET, read back.
struct WrittenSfc {
    explicit WrittenSfc(const Grafcet& grafcet);

    std::string xml;
    SfcPou sfc;
    /// The names of the chart's own variables, and their identifiers in the file.
    std::vector<std::pair<std::string, std::string>> names;
};

struct SfcRun {
    /// The reference's columns; a row per scan, up to the first that left something to order.
    Trace trace;
    /// Of the scan after the last row; empty where the run went to its end.
    SfcScanReport left_open;
};

/// A scan every period. Meetings with the last action of the file are no matter of order.
SfcRun run_sfc(const Grafcet& grafcet, const WrittenSfc& written, const SfcDialect& dialect,
               const Stimuli& stimuli, Time period);

/// The stimuli without Init, AUdur and AUdoux.
Stimuli without_modes(Stimuli stimuli, const Grafcet& grafcet);

}  // namespace grafwire::testing
