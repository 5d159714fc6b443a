#pragma once

#include "draw/schematic_layout.h"
#include "draw/schematic_view.h"

namespace grafwire {

/// Draws a part with its upper left corner there, as wide as `widths` says: its gates, their pins,
/// the lines between them and the names at their ends.
void draw_part(SchematicPens& pens, const SchematicView& view, const LaidPart& part,
               const PartWidths& widths, Point at);

}  // namespace grafwire
