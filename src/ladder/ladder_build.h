#pragma once

#include <string>
#include <vector>

#include "ladder/chart_variables.h"
#include "ladder/ladder_from.h"
#include "ladder/rung_writer.h"
#include "ladder/simplified_scan.h"

namespace grafwire::ladder {

/// Makes a ladder diagram (see ladder_from.cpp); the members are what its parts share.
class LadderBuild {
  public:
    LadderBuild(const Grafcet& grafcet, const ScanProgram& program, Language language,
                Diagnostics& diagnostics);

    Ladder make();

  private:
    /// The rungs that `make_rungs` makes, under a heading.
    template <typename MakeRungs>
    void section(const Message<>& heading, const MakeRungs& make_rungs);

    // The scan in its order (ladder_from.cpp).
    void make_start();
    void make_previous();
    void translate(SectionKind section);
    void translate(const Statement& statement);
    void move(const Statement& statement);
    void time(const Statement& statement);
    void pulses();

    // What the steps become (ladder_evolution.cpp).
    void make_transitions();
    void make_steps();
    void make_orders();
    std::size_t force(std::size_t first);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Language language_;
    Ladder ladder_;
    SimplifiedScan scan_;
    ChartVariables variables_;
    RungWriter rungs_;
};

}  // namespace grafwire::ladder
