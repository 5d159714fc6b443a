#pragma once

#include <string>
#include <vector>

#include "ladder/chart_variables.h"
#include "ladder/ladder.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire::ladder {

/// What a rung is for: its comment, and a place in the chart.
struct Purpose {
    Localized comment;
    Location origin;
};

/// Writes conditions of a program as contacts, and appends rungs to a diagram (see
/// rung_writer.cpp).
class RungWriter {
  public:
    RungWriter(const Grafcet& grafcet, ChartVariables& variables, Language language, Ladder& ladder,
               Diagnostics& diagnostics)
        : grafcet_(grafcet),
          variables_(variables),
          language_(language),
          ladder_(ladder),
          diagnostics_(diagnostics) {}

    /// The contacts of a condition, or of its negation. What contacts cannot say (comparisons,
    /// exclusive or) is worked out into bits by rungs that are added here, before the one with
    /// these contacts; `purpose` is that of the latter.
    Power power(const Condition& condition, const Purpose& purpose, bool positive = true);
    /// Appends the blocks that add up a sum, the last of them into `target`. An error where the sum
    /// can exceed 64 bits.
    void add_up(const Sum& sum, VariableId target, Location origin, std::vector<Block>& blocks);

    void add(Rung rung, const Purpose& purpose);
    void add(Power power, CoilKind kind, const std::vector<Bit>& targets, const Purpose& purpose);

  private:
    Power exclusive_or(const Condition& condition, const Purpose& purpose, bool positive);
    Condition worked_out(Power power, const Purpose& purpose);
    Power comparison(const Comparison& comparison, const Purpose& purpose);
    Operand value_of(const Sum& sum, const Purpose& purpose);
    void check_range(const Sum& sum, Location origin);

    const Grafcet& grafcet_;
    ChartVariables& variables_;
    Language language_;
    Ladder& ladder_;
    Diagnostics& diagnostics_;
};

}  // namespace grafwire::ladder
