#pragma once

#include <algorithm>

#include "draw/scene.h"

namespace grafwire {

/// In mm, what a unit may measure: letters become smaller down to a size that copies well.
inline constexpr double sheet_units[] = {8, 7, 6};

/// What a sheet has room for besides its margin and its title, in units.
struct SheetSize {
    double width = 0;
    double height = 0;
    double unit = 8;
    bool lies = false;
};

inline SheetSize sheet_size(const Paper& paper, double unit, bool lies) {
    const double width = (lies ? paper.height : paper.width) / unit;
    const double height = (lies ? paper.width : paper.height) / unit;
    return {width - 2 * sheet_margin, height - 2 * sheet_margin - title_room, unit, lies};
}

/// Makes a sheet as large as what stands on it; where there are several, at least as large as the
/// paper, so that each is printed on one.
inline void fit_sheet(Sheet& sheet, const SheetSize& size, bool fills_paper) {
    const Bounds bounds = bounds_of(sheet.scene.shapes);
    sheet.width = bounds.right + sheet_margin;
    sheet.height = bounds.bottom + sheet_margin;
    if (fills_paper) {
        sheet.width = std::max(sheet.width, size.width + 2 * sheet_margin);
        sheet.height = std::max(sheet.height, size.height + 2 * sheet_margin + title_room);
    }
    sheet.unit = size.unit;
    sheet.lies = size.lies;
}

}  // namespace grafwire
