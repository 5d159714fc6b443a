#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/netlist_formats.h"
#include "plc/formats.h"
#include "text/time.h"
#include "workflow/chart.h"
#include "workflow/netlists.h"

namespace grafwire {

// What files say at their heads: of which chart they were made, and how to make them again. Of a
// path they tell the name of the file alone, and they bear no date: the same request gives the same
// bytes.

/// What else a file depends on. Files by their paths, empty where there are none.
struct NetlistFileRequest {
    Time scan_period = 0;
    std::string_view stimuli{};
    std::string_view bench_beside{};  ///< of a bench: the file of its netlist
    /// Sentences on the interlocks that the chart was given, if it was given any.
    std::span<const std::string> interlocks{};
};

/// The head of a netlist file (WriteOptions::head) and, `with_bench`, of the bench beside it, of
/// formats that have one: the chart and its title, style, form of CDX and modes, the version of the
/// program, and the request. The netlist does not depend on the bench; a deck holds its stimuli
/// itself. In English, as netlist files are.
NetlistHeads netlist_heads(const Chart& chart, const NetlistOptions& options,
                           const NetlistFormat& format, const NetlistFileRequest& request,
                           bool with_bench);

/// What a program says at its head of how it was made (PlcOptions::made_by), in the language of its
/// comments. `io`: the path of the assignment.
std::string program_head(const Chart& chart, const PlcFormat& format, const PlcOptions& options,
                         bool modes, std::string_view io);

}  // namespace grafwire
