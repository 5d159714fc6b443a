// The last instant of a witness in words: what changed outside, what the reference made of it scan
// by scan, which gates moved first, and where the two sides part.

#include <fmt/format.h>

#include "check/netlist_witness.h"
#include "check/story.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr std::size_t most_gates = 12;

struct GateChange {
    Time at;
    NetId net;
    Logic value;
};

std::string_view verb_of(Logic value, const Story& story) {
    switch (value) {
        case Logic::one:
            return story.choose("rises", "monte");
        case Logic::zero:
            return story.choose("falls", "descend");
        default:
            return story.choose("is undefined", "est indéterminée");
    }
}

void tell_gates(Story& story, const Netlist& netlist, const std::vector<GateChange>& changes,
                Time instant) {
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    story.add(story.choose("The netlist, gate by gate:\n", "Le câblage, porte par porte :\n"));
    std::size_t shown = 0;
    for (const GateChange& change : changes) {
        const CellId driver = drivers[change.net];
        if (driver == no_cell) continue;
        if (shown++ == most_gates) {
            story.add("  …\n");
            break;
        }
        story.add(fmt::format("  +{} ns  {} {}\n", (change.at - instant) / nanosecond,
                              cell_description(netlist, driver, story.language()),
                              verb_of(change.value, story)));
    }
    if (shown == 0) story.add(story.choose("  no gate changes\n", "  aucune porte ne change\n"));
}

void tell_oscillation(Story& story, const Netlist& netlist, const std::vector<NetId>& nets) {
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    story.add(story.choose("The netlist does not settle. These keep changing:\n",
                           "Le câblage ne se stabilise pas. Changent sans cesse :\n"));
    std::size_t shown = 0;
    for (const NetId net : nets) {
        const CellId driver = drivers[net];
        if (driver == no_cell) continue;
        if (shown++ == most_gates) {
            story.add("  …\n");
            break;
        }
        story.add(fmt::format("  {}\n", cell_description(netlist, driver, story.language())));
    }
}

}  // namespace

std::string tell_witness(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                         const Witness& witness, Language language) {
    Story story(grafcet, witness, language);
    story.tell_changes();
    story.tell_reference();

    std::vector<GateChange> changes;
    SimulateOptions options;
    options.scan_period = witness.scan_period;
    const Time last = witness.stimuli.end;
    options.observer = [&](Time at, NetId net, Logic value) {
        if (at >= last && changes.size() < 1000) changes.push_back({at, net, value});
    };
    const SimulateResult run = simulate(grafcet, netlist, delays, witness.stimuli, options);
    tell_gates(story, netlist, changes, last);
    if (witness.kind == DifferenceKind::oscillation) {
        tell_oscillation(story, netlist, run.oscillating);
    } else {
        story.tell_difference(story.choose("the netlist", "le câblage"));
    }
    return story.take();
}

}  // namespace grafwire
