#pragma once

#include "text/message.h"

namespace grafwire::messages::plc_shared {

// Headings of the sections of a scan, each with its subroutine of the method.
inline constexpr Message<> section_start{
    "SBR 0: before the first scan, the initial situation",
    "SBR 0 : avant la première scrutation, situation initiale"};
inline constexpr Message<> section_begin{
    "SBR 1: the situation the scan begins with; work tables cleared",
    "SBR 1 : situation en début de scrutation ; tables de travail à 0"};
inline constexpr Message<> section_edges{"SBR 2: edges", "SBR 2 : fronts"};
inline constexpr Message<> section_conditions{"SBR 3: transition conditions",
                                              "SBR 3 : réceptivités"};
inline constexpr Message<> section_evolution{"SBR 4: evolution, rules 2 to 5",
                                             "SBR 4 : évolution, règles 2 à 5"};
inline constexpr Message<> section_orders{"SBR 5: orders and enclosures",
                                          "SBR 5 : forçages et encapsulations"};
inline constexpr Message<> section_stored{"SBR 5, end: stored actions",
                                          "SBR 5, fin : actions mémorisées"};
inline constexpr Message<> section_times{"SBR 6: time conditions", "SBR 6 : temporisations"};
inline constexpr Message<> section_outputs{"SBR 8: outputs", "SBR 8 : sorties"};

}  // namespace grafwire::messages::plc_shared
