#pragma once

#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "ladder/ladder.h"
#include "text/message.h"

namespace grafwire::plcopen {

// PLCopen TC6 XML 2.01 projects. Names are made identifiers. Each has one program, so that a tool
// that cannot read a sequential function chart still reads the ladder diagram.

/// The ladder diagram, which is the GRAFCET scan for scan. Which names had to be changed stands in
/// its documentation, in the language; comments are the diagram's own.
std::string write_ladder_project(const ladder::Ladder& ladder,
                                 Language language = Language::english);

struct SfcProjectOptions {
    bool modes = true;  ///< where off, an expression that reads Init, AUdur or AUdoux reads 0
    std::string made_by = {};  ///< stands in the documentation; empty: nothing
    Language language = Language::english;
};

/// The GRAFCET as a sequential function chart, which is the GRAFCET scan for scan as far as SFC can
/// say it, and tells the rest in comments.
std::string write_sfc_project(const Grafcet& grafcet, const SfcProjectOptions& options = {});

/// The identifiers of the variables of a diagram, in their order.
std::vector<std::string> identifiers_of(const ladder::Ladder& ladder);

}  // namespace grafwire::plcopen
