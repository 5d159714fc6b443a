// A net that changes too often is raced to by two ways that begin at the same event. The way to a
// change goes back from it, at each gate by the last of the changes that brought it about, to what
// began the instant. What the two ways have in common has no part in the race.

#include "explain/pulse_race.h"

#include <algorithm>
#include <map>

#include "explain/causal_chain.h"
#include "explain/messages.h"
#include "explain/named_chain.h"
#include "text/joined.h"

namespace grafwire {

namespace {

namespace words = messages::explain;

Witness witness_of(const Pulse& pulse) {
    Witness witness;
    witness.stimuli = pulse.stimuli;
    witness.delays = pulse.delays;
    return witness;
}

/// The nets on the way to a change, from what began it to the one before it.
std::vector<NetId> way_to(std::size_t change, const std::vector<CausalLink>& links,
                          const NetHistory& history) {
    std::map<std::size_t, const CausalLink*> link_of;
    for (const CausalLink& link : links) link_of[link.change] = &link;
    std::vector<NetId> way;
    for (;;) {
        const CausalLink& link = *link_of.at(change);
        if (link.causes.empty()) break;
        change = *std::max_element(link.causes.begin(), link.causes.end());
        if (change < history.first_of_end) break;
        way.push_back(history.changes[change].net);
    }
    std::reverse(way.begin(), way.end());
    return way;
}

/// Those of a way that are not on the other, else the last of it.
std::vector<NetId> own_part(const std::vector<NetId>& way, const std::vector<NetId>& other) {
    std::vector<NetId> own;
    for (const NetId net : way) {
        if (std::find(other.begin(), other.end(), net) == other.end()) own.push_back(net);
    }
    if (own.empty() && !way.empty()) own.push_back(way.back());
    return own;
}

}  // namespace

PulseRace race_of(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                  const Pulse& pulse) {
    const NetHistory history(grafcet, netlist, delays, witness_of(pulse));
    std::vector<std::size_t> changes;
    for (std::size_t i = history.first_of_end; i < history.changes.size(); ++i) {
        if (history.changes[i].net == pulse.net) changes.push_back(i);
    }
    PulseRace race;
    if (changes.size() < pulse.expected + 2) return race;
    std::vector<CausalLink> links = causal_chain(netlist, delays, history, changes, pulse.delays);
    const std::vector<NetId> first = way_to(changes[pulse.expected], links, history);
    const std::vector<NetId> next = way_to(changes[pulse.expected + 1], links, history);
    race.sooner = own_part(first, next);
    race.later = own_part(next, first);
    std::erase_if(links,
                  [&](const CausalLink& link) { return link.change < history.first_of_end; });
    race.chain = named_chain(netlist, history, links, pulse.stimuli.end);
    return race;
}

namespace {

/// The gates that drive these nets, as people know them; an input by its name.
std::string gates_text(const Netlist& netlist, const std::vector<NetId>& nets, Language language) {
    const Table<NetId, CellId> drivers = drivers_of(netlist);
    std::vector<std::string> texts;
    for (const NetId net : nets) {
        texts.push_back(drivers[net] == no_cell
                            ? words::input.in(language, std::string(netlist.names[net]))
                            : cell_description(netlist, drivers[net], language));
    }
    return joined(texts, ", ");
}

std::string count_text(const Pulse& pulse, Language language) {
    if (pulse.expected == 0) return words::pulses_unasked.in(language, pulse.name, pulse.got);
    if (pulse.expected == 1) return words::pulses_beside_one.in(language, pulse.name, pulse.got);
    return words::pulses_beside_some.in(language, pulse.name, pulse.got, pulse.expected);
}

}  // namespace

std::string write_pulse(const Grafcet& grafcet, const Netlist& netlist, const Pulse& pulse,
                        const PulseRace& race, const ExplanationOptions& options) {
    const Language language = options.language;
    std::string text = count_text(pulse, language);
    if (!race.sooner.empty() && !race.later.empty()) {
        text += words::gates_that_race.in(language, gates_text(netlist, race.sooner, language),
                                          gates_text(netlist, race.later, language));
    }
    Explanation explanation;
    explanation.chain = race.chain;
    return text + write_explanation(grafcet, netlist, witness_of(pulse), explanation, options);
}

}  // namespace grafwire
