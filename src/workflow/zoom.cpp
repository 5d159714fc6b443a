// A net is called by its port where it is an X or an output, else in the words of the schematics.
// One that is an X and an output as well has a row for each.

#include "workflow/zoom.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <string_view>
#include <utility>

#include "draw/schematic_nets.h"
#include "explain/instant_detail.h"
#include "simulate/netlist_machine.h"
#include "simulate/simulate.h"
#include "text/shown_duration.h"
#include "workflow/messages.h"

namespace grafwire {

namespace {

namespace say = messages::workflow;
using Kind = Trace::Column::Kind;

/// The nets within a netlist, by what they are made for.
struct InnerNets {
    std::vector<std::vector<NetId>> of_steps;
    std::vector<std::vector<NetId>> of_outputs;
    std::vector<NetId> shared;

    InnerNets(const Grafcet& grafcet, const Netlist& netlist, const PortMap& ports)
        : of_steps(grafcet.steps.size()), of_outputs(grafcet.outputs.size()) {
        std::vector<bool> is_port(netlist.net_count());
        for (const auto* nets : {&ports.steps, &ports.outputs}) {
            for (const NetId net : *nets) {
                if (net != no_net) is_port[index_of(net)] = true;
            }
        }
        std::map<std::pair<Origin::Kind, std::string_view>, std::vector<NetId>*> places;
        for (std::size_t i = 0; i < of_steps.size(); ++i) {
            const std::string& name = grafcet.steps[grafcet.steps.id_at(i)].name;
            places[{Origin::Kind::step, name}] = &of_steps[i];
        }
        for (std::size_t i = 0; i < of_outputs.size(); ++i) {
            const std::string& name = grafcet.outputs[grafcet.outputs.id_at(i)].name;
            places[{Origin::Kind::output, name}] = &of_outputs[i];
        }
        for (const Cell& cell : netlist.cells) {
            if (is_port[index_of(cell.output)]) continue;
            const Origin& origin = netlist.origin_of(cell);
            const auto place = places.find({origin.kind, origin.name});
            (place == places.end() ? shared : *place->second).push_back(cell.output);
        }
    }
};

/// The nets that change in an instant, as columns of a trace.
class ZoomedNets {
  public:
    ZoomedNets(const Grafcet& grafcet, const Netlist& netlist, const InstantDetail& detail)
        : names_(shown_names(netlist, drivers_of(netlist))),
          changes_(netlist.net_count()),
          column_of_(netlist.net_count(), none) {
        for (const NetChange& change : detail.changes) changes_[index_of(change.net)] = true;
        const PortMap ports = map_ports(grafcet, netlist);
        const InnerNets inner(grafcet, netlist, ports);
        if (netlist.is_clocked()) add_inner({netlist.clock}, Kind::input);
        add_inner(ports.inputs, Kind::input);
        add_inner(inner.shared, Kind::internal);
        for (std::size_t i = 0; i < ports.steps.size(); ++i) {
            add(ports.steps[i], "X" + grafcet.steps[grafcet.steps.id_at(i)].name, Kind::step);
            add_inner(inner.of_steps[i], Kind::step);
        }
        for (std::size_t i = 0; i < ports.outputs.size(); ++i) {
            add(ports.outputs[i], grafcet.outputs[grafcet.outputs.id_at(i)].name, Kind::output);
            add_inner(inner.of_outputs[i], Kind::output);
        }
    }

    const std::vector<NetId>& nets() const { return nets_; }
    const std::vector<Trace::Column>& columns() const { return columns_; }
    /// Its first one.
    std::size_t column_of(NetId net) const { return column_of_[index_of(net)]; }

  private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void add(NetId net, std::string name, Kind kind) {
        if (net == no_net || !changes_[index_of(net)]) return;
        std::size_t& column = column_of_[index_of(net)];
        if (column == none) column = columns_.size();
        nets_.push_back(net);
        columns_.push_back({std::move(name), 1, kind});
    }
    void add_inner(const std::vector<NetId>& nets, Kind kind) {
        for (const NetId net : nets) {
            if (net != no_net) add(net, names_[index_of(net)], kind);
        }
    }

    std::vector<std::string> names_;  ///< by net
    std::vector<bool> changes_;       ///< by net
    std::vector<std::size_t> column_of_;
    std::vector<NetId> nets_;  ///< by column
    std::vector<Trace::Column> columns_;
};

std::int64_t shown_value(Logic value) {
    return value == Logic::unknown ? Trace::unknown : value == Logic::one ? 1 : 0;
}

Trace trace_of(const InstantDetail& detail, const ZoomedNets& nets) {
    Trace trace;
    trace.columns = nets.columns();
    std::vector<Logic> values = detail.before;
    const auto add_row = [&](Time at) {
        trace.times.push_back(at);
        for (const NetId net : nets.nets()) {
            trace.values.push_back(shown_value(values[index_of(net)]));
        }
    };
    add_row(-nanosecond);
    for (std::size_t i = 0; i < detail.changes.size(); ++i) {
        const NetChange& change = detail.changes[i];
        values[index_of(change.net)] = change.value;
        const bool is_last =
            i + 1 == detail.changes.size() || detail.changes[i + 1].at != change.at;
        if (is_last) add_row(change.at);
    }
    return trace;
}

/// One cause for the delays that end at a moment, and one for every change that has effects.
std::vector<TimingCause> causes_in(const InstantDetail& detail, const ZoomedNets& nets) {
    std::vector<TimingCause> all(detail.changes.size());
    std::vector<TimingCause> ends;
    for (std::size_t i = 0; i < detail.changes.size(); ++i) {
        const NetChange& change = detail.changes[i];
        const TimingCause::Effect place{nets.column_of(change.net), change.at};
        all[i].at = change.at;
        all[i].columns = {place.column};
        for (const std::size_t cause : detail.causes[i].changes) {
            all[cause].effects.push_back(place);
        }
        if (detail.causes[i].ended.empty()) continue;
        if (ends.empty() || ends.back().at != change.at) ends.push_back({change.at, {}, {}, {}});
        ends.back().ended.push_back(detail.causes[i].ended);
        ends.back().effects.push_back(place);
    }
    std::erase_if(all, [](const TimingCause& cause) { return cause.effects.empty(); });
    ends.insert(ends.end(), std::make_move_iterator(all.begin()),
                std::make_move_iterator(all.end()));
    return ends;
}

/// A netlist without instants does not settle at its start.
const Message<Localized>& heading(const std::optional<InstantDetail>& detail) {
    if (!detail || !detail->is_settled) return say::unsettled_gates_at;
    return detail->changes.empty() ? say::idle_gates_at : say::gates_at;
}

std::vector<Time> nearest_to(Time at, const std::vector<Time>& instants) {
    std::vector<Time> nearest;
    const auto after = std::lower_bound(instants.begin(), instants.end(), at);
    if (after != instants.begin()) nearest.push_back(*(after - 1));
    if (after != instants.end()) nearest.push_back(*after);
    return nearest;
}

}  // namespace

ZoomResult zoom_into(const Chart& chart, const Netlist& netlist, const Stimuli& stimuli,
                     const GateDelays& delays, std::optional<Time> period, bool with_waveform,
                     Time at, Language language) {
    SimulateOptions options;
    options.waveform = with_waveform;
    options.scan_period = period.value_or(0);
    options.schedule = delays.schedule;
    DetailedSimulation simulation = simulate_in_detail(
        chart.grafcet, netlist, cell_delays(netlist, delays.model), stimuli, options, at);
    ZoomedInstant instant;
    instant.title = title_of(chart.grafcet) + " – " +
                    heading(simulation.detail)(shown_duration(at)).in(language);
    if (simulation.detail) {
        const ZoomedNets nets(chart.grafcet, netlist, *simulation.detail);
        instant.trace = trace_of(*simulation.detail, nets);
        instant.causes = causes_in(*simulation.detail, nets);
    } else if (!simulation.instants.empty()) {
        return {std::move(simulation.result), std::nullopt, nearest_to(at, simulation.instants)};
    }
    return {std::move(simulation.result), std::move(instant), {}};
}

}  // namespace grafwire
