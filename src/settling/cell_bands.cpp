#include "settling/cell_bands.h"

namespace grafwire {

CellBands cell_bands(const Netlist& netlist, const DelayModel& model) {
    CellBands bands;
    for (const Cell& cell : netlist.cells) {
        const EdgeBands edges = model.bands(cell.type, cell.pin_count);
        const Time width = is_pulse(cell.type) ? netlist.timings[cell.timing].fall : 0;
        bands.rise.push_back(edges.rise);
        bands.fall.push_back(width == 0 ? edges.fall : DelayBand{width, width});
    }
    return bands;
}

}  // namespace grafwire
