#include "simulate/waveform.h"

#include <algorithm>

namespace grafwire {

namespace {

bool is_whole(Time time) {
    return time % nanosecond == 0;
}

bool all_whole(const Netlist& netlist, const CellDelays& delays) {
    const bool cells = std::all_of(delays.rise.begin(), delays.rise.end(), is_whole) &&
                       std::all_of(delays.fall.begin(), delays.fall.end(), is_whole);
    return cells &&
           std::all_of(netlist.timings.begin(), netlist.timings.end(),
                       [](const Timing& t) { return is_whole(t.rise) && is_whole(t.fall); });
}

}  // namespace

Waveform::Waveform(const Netlist& netlist, const CellDelays& delays, bool whole_nanoseconds)
    : writer_(netlist.name, whole_nanoseconds && all_whole(netlist, delays) ? nanosecond : 1),
      net_count_(netlist.net_count()) {
    for (std::size_t net = 0; net < net_count_; ++net) {
        writer_.add_signal(netlist.names[static_cast<NetId>(net)]);
    }
    writer_.begin();
}

void Waveform::follow(Simulator& simulator) {
    for (std::size_t net = 0; net < net_count_; ++net) {
        writer_.change(0, static_cast<std::uint32_t>(net),
                       digit_of(simulator.value(static_cast<NetId>(net))));
    }
    simulator.observe([this](Time at, NetId net, Logic value) {
        writer_.change(at, static_cast<std::uint32_t>(net), digit_of(value));
    });
}

std::string Waveform::stop(Simulator& simulator, Time end) {
    simulator.observe({});
    return writer_.finish(std::max(end, simulator.now()));
}

}  // namespace grafwire
