#include "settling/cell_bands.h"

namespace grafwire {

CellBands cell_bands(const Netlist& netlist, const DelayModel& model) {
    CellBands bands;
    for (const Cell& cell : netlist.cells) {
        bands.rise.push_back(model.band(cell.type));
        const Time width = is_pulse(cell.type) ? netlist.timings[cell.timing].fall : 0;
        bands.fall.push_back(width == 0 ? bands.rise.back() : DelayBand{width, width});
    }
    return bands;
}

}  // namespace grafwire
