#pragma once

#include <vector>

#include "netlist/styles/styles.h"

namespace grafwire::testing {

/// All styles of the table, so that a new one is tried wherever the others are.
inline std::vector<Style> all_styles() {
    std::vector<Style> styles;
    for (const StyleRow& row : style_table) styles.push_back(row.style);
    return styles;
}

/// Those without a clock.
inline std::vector<Style> asynchronous_styles() {
    std::vector<Style> styles = all_styles();
    std::erase(styles, Style::clocked);
    return styles;
}

/// Those that take every chart without counters.
inline bool takes_stored_actions(Style style) {
    return style != Style::handshake;
}

}  // namespace grafwire::testing
