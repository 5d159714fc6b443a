// Netlists of random charts in every style and format, with stimuli and test benches, and what the
// readers make of them: again a netlist, written once more.

#include <fmt/core.h>

#include "formats/netlist_formats.h"
#include "pinned/pinned_charts.h"
#include "pinned/pinned_table.h"
#include "random/random_cases.h"
#include "random/read_text.h"
#include "workflow/netlists.h"

namespace grafwire::testing {

namespace {

constexpr std::uint64_t first_format_seed = 44'000'000;
constexpr std::uint64_t format_charts = 90;

/// What the reader of a format says to what its writer wrote, or the netlist written once more.
std::string read_again(const NetlistFormat& format, const std::string& text) {
    if (format.read == nullptr) return {};
    Diagnostics diagnostics;
    const auto netlist = format.read({"netlist", text}, diagnostics);
    std::string result;
    for (const Diagnostic& item : diagnostics.items()) result += item.message.english + "\n";
    if (netlist) result += write_netlist(*netlist_format_named("blif"), *netlist);
    return result;
}

PinnedCase pinned_formats(const Chart& chart, const Netlist& netlist, const Stimuli& stimuli) {
    PinnedCase pinned;
    for (const NetlistFormat& format : netlist_formats()) {
        const WrittenNetlist written =
            write_netlist(chart, netlist, format, &stimuli, 10 * millisecond, DelayModel{});
        const WrittenNetlist idle =
            write_netlist(chart, netlist, format, nullptr, 20 * millisecond, DelayModel{});
        pinned.add(fmt::format("{} {}", format.name, of_any_version(written.text).size()),
                   written.text + written.bench + idle.text + read_again(format, written.text));
    }
    return pinned;
}

void pin_formats(PinnedTable& table, std::uint64_t seed) {
    const RandomCase item =
        random_case(first_format_seed + seed, seed % 2 == 0 ? Features::small() : Features{}, 8);
    const Chart chart = pinned_chart(item.chart);
    const auto stimuli = read_stimuli(item.stimuli, chart.grafcet);
    REQUIRE(stimuli);
    for (const StyleRow& row : style_table) {
        NetlistOptions options;
        options.style = row.style;
        options.modes = seed % 4 != 0;
        Diagnostics diagnostics;
        const auto netlist = make_netlist(chart, options, diagnostics);
        if (netlist) {
            table.add(fmt::format("{:03} {}", seed, row.name),
                      pinned_formats(chart, *netlist, *stimuli));
        }
    }
}

}  // namespace

TEST_CASE("pinned: netlists in all formats") {
    PinnedTable table("formats.txt");
    for (std::uint64_t seed = 0; seed < format_charts; seed += pinned_stride)
        pin_formats(table, seed);
    table.finish(!is_slow_build);
}

}  // namespace grafwire::testing
