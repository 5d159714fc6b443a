#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "netlist/netlist.h"
#include "netlist/part_families.h"
#include "text/time.h"

namespace grafwire {

/// How long gates take: the one place that says it. An asynchronous netlist is made for a model
/// (pulses last as long as a step needs to be set, and buffers bring signals together), and is
/// simulated, checked and written under one; a netlist made for one model may fail under another.
/// The model that nothing else is said about is the default one.
///
/// Where a model leaves delays open, a verdict is about every circuit that could be built: every
/// change of a gate takes a time of its own, as the model allows.
struct DelayModel {
    enum class Kind : std::uint8_t {
        fixed,     ///< every gate takes the same
        bounded,   ///< between two bounds
        any,       ///< any finite time; all that reads a net sees it change at once
        any_wire,  ///< any finite time, of every wire as well; such wires are cells of the netlist
    };
    std::string name = "unit";  ///< as users ask for it and as reports call it
    Kind kind = Kind::fixed;
    /// Of every cell. For `any` it is what its netlists are made for; for a part family the least
    /// and the most of its gates with up to four inputs, which is all that making a netlist needs.
    DelayBand gate{nanosecond, nanosecond};
    /// Bounded: the parts that say more exactly how long a cell takes; nullptr for none.
    const PartFamily* family = nullptr;

    bool is_fixed() const { return kind == Kind::fixed; }

    /// From a change of an input of a cell of that type to the change of its output, either way.
    /// Timers and pulse cells add their own timing.
    DelayBand band(CellType /*type*/) const { return gate; }

    /// The same of a cell with so many inputs, per edge of its output, from the parts of the family
    /// if there is one. What no part is (timers of clocked netlists) is taken as any gate.
    EdgeBands bands(CellType type, std::size_t inputs) const {
        if (family != nullptr) {
            if (const auto found = bands_of(*family, type, inputs)) return *found;
        }
        return {band(type), band(type)};
    }

    /// What a netlist is made for: the longest.
    Time of(CellType type) const { return band(type).max; }

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
        return std::max<Time>(1'000, static_cast<Time>(cells)) * gate.max;
    }
};

/// The model that a text asks for: a name, that of a part family, or bounds in ns, as `1..2` or
/// `0.4..1.6`. Nothing where it asks for none.
std::optional<DelayModel> delay_model_of(std::string_view text);
/// The names there are, and how bounds are written.
std::vector<std::string_view> delay_model_names();

/// The delay of every cell of a netlist, per edge of its output. Timers and pulse cells add their
/// own timing.
struct CellDelays {
    std::vector<Time> rise;  ///< one per cell, positive
    std::vector<Time> fall;
};

/// Every cell of the netlist as fast as a model allows, each edge for itself.
CellDelays cell_delays(const Netlist& netlist, const DelayModel& model);

}  // namespace grafwire
