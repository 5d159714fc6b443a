// libFuzzer target: a chart on its whole way. The bytes are the choices of the generator of the
// random tests, so every input is a chart without errors and stimuli for it, and a small change of
// the bytes is one of the chart. Whatever it is: no crash in any form that is made of it; the
// reference runs; every netlist reads back and does under simulation what a check has found
// equivalent; every program is written or refused, with a reason.

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "formats/netlist_formats.h"
#include "netlist/delay_model.h"
#include "plc/formats.h"
#include "random/features.h"
#include "random/random_grafcet.h"
#include "random/random_source.h"
#include "random/random_stimuli.h"
#include "require.h"
#include "trace/stimuli.h"
#include "workflow/chart.h"
#include "workflow/check.h"
#include "workflow/netlists.h"
#include "workflow/programs.h"
#include "workflow/runs.h"

namespace grafwire {

namespace {

Netlist read_back(const NetlistFormat& format, const std::string& written) {
    const SourceFile source{"fuzz", written};
    Diagnostics diagnostics;
    auto netlist = format.read(source, diagnostics);
    require(netlist.has_value(), "cannot be read back", written);
    return std::move(*netlist);
}

/// A netlist in each format. One that has a reader keeps all but the comments, so what has been
/// read once stays the same.
void try_formats(const Chart& chart, const Netlist& netlist, const Stimuli& stimuli) {
    for (const NetlistFormat& format : netlist_formats()) {
        const std::string written =
            write_netlist(chart, netlist, format, &stimuli, 10 * millisecond, {}).text;
        if (format.read == nullptr) continue;
        const std::string once = write_netlist(format, read_back(format, written));
        require(write_netlist(format, read_back(format, once)) == once,
                "another netlist when read back", written);
    }
}

void try_netlist(const Chart& chart, const Stimuli& stimuli, Style style) {
    NetlistOptions options;
    options.style = style;
    Diagnostics diagnostics;
    const auto netlist = make_netlist(chart, options, diagnostics);
    require(netlist.has_value() != diagnostics.has_errors(), "errors and a netlist, or neither",
            chart.source.text);
    if (!netlist) return;
    try_formats(chart, *netlist, stimuli);
    simulate_gates(chart, *netlist, stimuli, DelayModel(), std::nullopt, true);
    CheckRequest request;
    request.max_cases = 200;
    request.with_files = true;
    Diagnostics messages;
    const auto judgement = check_netlist(chart, *netlist, request, messages);
    require(judgement.has_value() != messages.has_errors(), "errors and a verdict, or neither",
            chart.source.text);
    if (!judgement) return;
    for (const ReportRow& form : report_forms()) {
        form.write(*judgement, chart, 0, Language::french);
    }
}

void try_programs(const Chart& chart) {
    for (const PlcFormat& format : plc_formats()) {
        Diagnostics diagnostics;
        const auto program = write_program(chart, format, {}, true, diagnostics);
        require(program.has_value() != diagnostics.has_errors(), "errors and a program, or neither",
                chart.source.text);
    }
}

void try_chart(const std::string& text, testing::RandomSource& choices) {
    Diagnostics diagnostics;
    const auto chart = read_chart({"fuzz.grafcet", text}, diagnostics);
    require(chart.has_value(), "the generator makes charts without errors", text);
    const std::string stimuli_text = testing::random_stimuli(choices, chart->grafcet, 8);
    const auto stimuli = parse_stimuli({"fuzz.stim", stimuli_text}, chart->grafcet, diagnostics);
    require(stimuli.has_value(), "the generator makes stimuli without errors", stimuli_text);
    const ToldRun run = tell_reference(*chart, *stimuli, std::nullopt);
    explain_run(*chart, run, Language::french);
    run_reference(*chart, *stimuli, 10 * millisecond);
    for (const StyleRow& style : style_table) try_netlist(*chart, *stimuli, style.style);
    try_programs(*chart);
}

}  // namespace

}  // namespace grafwire

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace grafwire;
    testing::RandomSource choices(std::vector<std::uint8_t>(data, data + size));
    const std::string text = testing::random_grafcet(choices, testing::Features::small());
    try_chart(text, choices);
    return 0;
}
