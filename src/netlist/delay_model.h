#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// How long gates take: the one place that says it. An asynchronous netlist is made for a model
/// (pulses last as long as a step needs to be set, and buffers bring signals together), and is
/// simulated, checked and written under one; a netlist made for one model may fail under another.
/// The model that nothing else is said about is the default one.
struct DelayModel {
    std::string_view name = "unit";  ///< as users ask for it and as reports call it
    Time gate = nanosecond;          ///< of every cell; positive

    /// From a change of an input of a cell of that type to the change of its output, either way.
    /// Timers and pulse cells add their own timing.
    Time of(CellType /*type*/) const { return gate; }

    /// Through these cells one after the other.
    Time of_path(std::span<const CellType> path) const {
        Time time = 0;
        for (const CellType type : path) time += of(type);
        return time;
    }

    /// How many buffers one after the other take that time, or as little more as can be.
    std::uint32_t buffers_for(Time time) const {
        const Time one = of(CellType::buffer);
        return static_cast<std::uint32_t>((time + one - 1) / one);
    }

    /// Longer than any netlist of so many cells takes to settle, unless it oscillates; and never
    /// less than what a thousand gates take.
    Time of_settling(std::size_t cells) const {
        return std::max<Time>(1'000, static_cast<Time>(cells)) * gate;
    }
};

/// The models that can be asked for by name.
inline constexpr std::array<DelayModel, 1> delay_models{{{}}};

/// The delay of every cell of a netlist, per edge of its output. Timers and pulse cells add their
/// own timing.
struct CellDelays {
    std::vector<Time> rise;  ///< one per cell, positive
    std::vector<Time> fall;
};

/// Every cell of the netlist under a model, which gives both edges the same delay.
inline CellDelays cell_delays(const Netlist& netlist, const DelayModel& model) {
    CellDelays delays;
    delays.rise.reserve(netlist.cells.size());
    for (const Cell& cell : netlist.cells) delays.rise.push_back(model.of(cell.type));
    delays.fall = delays.rise;
    return delays;
}

}  // namespace grafwire
