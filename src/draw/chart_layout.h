#pragma once

#include <vector>

#include "draw/chart_flow.h"
#include "draw/chart_symbols.h"
#include "draw/flow_symbols.h"
#include "draw/scene.h"

namespace grafwire {

/// A graph or an expansion, laid out.
struct LaidOutBlock {
    std::vector<Shape> shapes;
    Bounds bounds;
};

/// Lays out sequences of a flow side by side. What they show are owners of the scene.
LaidOutBlock lay_out(const ChartFlow& flow, const std::vector<const FlowSequence*>& sequences,
                     const SheetOfNode& sheets, SymbolMaker& maker, Language language,
                     Scene& scene);

}  // namespace grafwire
