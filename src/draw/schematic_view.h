#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "draw/gate_symbols.h"
#include "draw/scene.h"
#include "draw/schematic_nets.h"
#include "logic/logic.h"
#include "text/message.h"

namespace grafwire {

/// What all parts of a schematic share.
struct SchematicView {
    const SchematicNets& nets;
    GateShapes shapes = GateShapes::iec;
    Language language = Language::english;
    const std::vector<Logic>& values;  ///< by net; empty where none are shown

    bool shows_values() const { return !values.empty(); }
    /// `1`, `0` or `?`; empty where no values are shown.
    std::string value_of(NetId net) const;
    /// How a net is called at the end of a line: `X3`, with its value `X3 = 1`.
    Text label(NetId net) const;
};

/// The pens of a sheet: each draws for a part of the netlist, which the sheet has one group for.
class SchematicPens {
  public:
    SchematicPens(const SchematicView& view, Scene& scene) : view_(view), scene_(scene) {}

    Pen cell(CellId cell);
    /// An input by its number in the cell, or the output.
    Pen pin(CellId cell, std::uint32_t number);
    static constexpr std::uint32_t output_pin = 0xffffffffU;
    /// Lines, dots and names of a net.
    Pen net(NetId net);
    Pen owned_by(Owner owner) { return {scene_.shapes, scene_.owners.add(std::move(owner))}; }

  private:
    std::string with_value(std::string kind, NetId net) const;

    const SchematicView& view_;
    Scene& scene_;
    std::unordered_map<std::uint32_t, OwnerId> nets_;
};

}  // namespace grafwire
