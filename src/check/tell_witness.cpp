// The last instant of a witness in words: what changed outside, what the reference made of it scan
// by scan, which gates moved first, and where the two sides part.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "check/witness.h"
#include "evolution/run.h"
#include "simulate/simulate.h"

namespace grafwire {

namespace {

constexpr std::size_t most_gates = 12;
constexpr std::size_t most_scans = 8;

class Story {
  public:
    Story(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
          const Witness& witness, Language language)
        : grafcet_(grafcet),
          netlist_(netlist),
          delays_(delays),
          witness_(witness),
          french_(language == Language::french) {}

    std::string tell() {
        tell_changes();
        tell_reference();
        tell_gates();
        tell_difference();
        return std::move(text_);
    }

  private:
    std::string_view choose(std::string_view english, std::string_view french) const {
        return french_ ? french : english;
    }
    std::string describe(CellId cell) const {
        return cell_description(netlist_, cell, french_ ? Language::french : Language::english);
    }
    void tell_changes();
    void tell_reference();
    void tell_scans(const Evolution& evolution, EvolutionState state, const InputValues& inputs,
                    Time at);
    std::string situation_text(const BitTable& situation) const;
    std::string transition_text(TransitionId id) const;
    void tell_gates();
    void tell_difference();

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const CellDelays& delays_;
    const Witness& witness_;
    bool french_;
    std::string text_;
};

void Story::tell_changes() {
    const Time last = witness_.stimuli.end;
    text_ += fmt::format("{} {} ms", choose("At", "À"), format_milliseconds(last));
    const auto& changes = witness_.stimuli.changes;
    std::vector<std::string> set;
    if (!changes.empty() && changes.back().at == last) {
        for (const Stimuli::Assignment& assignment : changes.back().assignments) {
            set.push_back(fmt::format("{}={}", input_name(grafcet_, assignment.input),
                                      assignment.value ? 1 : 0));
        }
    }
    text_ += set.empty() ? std::string(choose(", no input changes", ", aucune entrée ne change"))
                         : fmt::format("{} {}", choose(":", " :"), fmt::join(set, " "));
    text_ += ".\n";
}

std::string Story::situation_text(const BitTable& situation) const {
    std::vector<std::string> active;
    for (std::size_t i = 0; i < situation.size(); ++i) {
        if (situation.test(i)) {
            active.push_back("X" + grafcet_.steps[grafcet_.steps.id_at(i)].name);
        }
    }
    if (active.empty()) return std::string(choose("no step", "aucune étape"));
    return fmt::format("{}", fmt::join(active, " "));
}

std::string Story::transition_text(TransitionId id) const {
    const Transition& transition = grafcet_.transitions[id];
    const auto names = [&](std::span<const StepId> steps) {
        std::vector<std::string> list;
        for (const StepId step : steps) list.push_back(grafcet_.steps[step].name);
        return fmt::format("{}", fmt::join(list, ", "));
    };
    const std::string before = names(grafcet_.preceding(transition));
    return fmt::format("({}) {}{}-> {}", transition.name, before, before.empty() ? "" : " ",
                       names(grafcet_.following(transition)));
}

void Story::tell_scans(const Evolution& evolution, EvolutionState state, const InputValues& inputs,
                       Time at) {
    const EvolutionInputs read{inputs};
    text_ += fmt::format("  {}: {}\n", choose("before", "avant "), situation_text(state.situation));
    for (std::size_t scan = 1; scan <= most_scans; ++scan) {
        const auto cleared = evolution.cleared_by_scan(state, read, at);
        const EvolutionState before = state;
        evolution.scan(state, read, at);
        if (before.situation != state.situation || !cleared.empty()) {
            std::vector<std::string> names;
            for (const TransitionId id : cleared) names.push_back(transition_text(id));
            text_ +=
                fmt::format("  {} {}{} {}{} -> {}\n", choose("scan", "cycle"), scan,
                            choose(":", " :"), names.empty() ? "" : choose("clears ", "franchit "),
                            names.empty() ? std::string(choose("orders", "ordres"))
                                          : fmt::format("{}", fmt::join(names, "; ")),
                            situation_text(state.situation));
        }
        if (Evolution::is_settled(before, state)) return;
    }
}

void Story::tell_reference() {
    const RunResult run = run_until_stable(grafcet_, witness_.stimuli);
    text_ += choose("The reference:\n", "La référence :\n");
    const Evolution evolution(grafcet_);
    InputValues inputs(grafcet_.all_input_count(), 0);
    EvolutionState state;
    std::size_t next = 0;
    const auto& changes = witness_.stimuli.changes;
    for (std::size_t row = 0; row < run.trace.row_count(); ++row) {
        const Time at = run.trace.times[row];
        for (; next < changes.size() && changes[next].at <= at; ++next) {
            for (const auto& set : changes[next].assignments) inputs[set.input] = set.value;
        }
        if (row == 0) {
            state = evolution.start({inputs});
        } else {
            evolution.end_delays(state, at);
        }
        if (row + 1 == run.trace.row_count()) return tell_scans(evolution, state, inputs, at);
        evolution.settle(state, {inputs}, at);
    }
}

void Story::tell_gates() {
    struct Change {
        Time at;
        NetId net;
        Logic value;
    };
    std::vector<Change> changes;
    SimulateOptions options;
    options.scan_period = witness_.scan_period;
    const Time last = witness_.stimuli.end;
    options.observer = [&](Time at, NetId net, Logic value) {
        if (at >= last && changes.size() < 1000) changes.push_back({at, net, value});
    };
    simulate(grafcet_, netlist_, delays_, witness_.stimuli, options);
    const Table<NetId, CellId> drivers = drivers_of(netlist_);
    text_ += choose("The netlist, gate by gate:\n", "Le câblage, porte par porte :\n");
    std::size_t shown = 0;
    for (const Change& change : changes) {
        if (drivers[change.net] == no_cell) continue;
        if (shown++ == most_gates) {
            text_ += "  …\n";
            break;
        }
        const std::string_view verb = change.value == Logic::one ? choose("rises", "monte")
                                      : change.value == Logic::zero
                                          ? choose("falls", "descend")
                                          : choose("is undefined", "est indéterminée");
        text_ += fmt::format("  +{} ns  {} {}\n", (change.at - last) / nanosecond,
                             describe(drivers[change.net]), verb);
    }
    if (shown == 0) text_ += choose("  no gate changes\n", "  aucune porte ne change\n");
}

void Story::tell_difference() {
    if (witness_.kind == DifferenceKind::oscillation) {
        text_ += choose("The netlist does not settle. These keep changing:\n",
                        "Le câblage ne se stabilise pas. Changent sans cesse :\n");
        std::size_t shown = 0;
        for (const CellId id : witness_.oscillating) {
            const std::string cell = describe(id);
            text_ += shown++ == most_gates ? "  …\n" : fmt::format("  {}\n", cell);
            if (shown > most_gates) break;
        }
        return;
    }
    text_ += choose("Where they part:\n", "Où ils se séparent :\n");
    const auto digit = [](Logic value) {
        return value == Logic::unknown ? 'x' : value == Logic::one ? '1' : '0';
    };
    for (const Witness::Value& value : witness_.values) {
        if (value.expected == value.got) continue;
        text_ += fmt::format(
            "  {}: {} {}, {} {}\n", value.name, choose("the reference gives", "la référence donne"),
            digit(value.expected), choose("the netlist", "le câblage"), digit(value.got));
    }
}

}  // namespace

std::string tell_witness(const Grafcet& grafcet, const Netlist& netlist, const CellDelays& delays,
                         const Witness& witness, Language language) {
    return Story(grafcet, netlist, delays, witness, language).tell();
}

}  // namespace grafwire
