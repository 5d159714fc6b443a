#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "ladder/ladder.h"
#include "ladder/simplified_scan.h"
#include "program/program.h"

namespace grafwire::ladder {

/// The variables of a diagram that is made from a chart, by the bits and integers that they are.
/// What the chart declares keeps its name; what the method adds is named after it in the chart's
/// own notation where that is short (`↑dcy`, `5s/X13`), so that the drawing reads like the chart.
class ChartVariables {
  public:
    /// Declares what the chart declares: inputs, control inputs, outputs, steps, vars and counters,
    /// whether used or not, because readers look for them. Everything else is declared when it is
    /// first asked for.
    ChartVariables(const Grafcet& grafcet, const ScanProgram& program, const SimplifiedScan& scan,
                   Language language, Ladder& ladder);

    VariableId operator[](Bit bit);
    VariableId operator[](IntegerCell cell);
    /// A bit that holds a part of a condition until the end of the scan.
    Bit new_work_bit() { return {BitKind::auxiliary, work_bits_++}; }
    VariableId new_integer() { return declare("sum", Type::integer, Role::memory, {}); }
    VariableId new_instance(BlockType type, std::string_view wish);
    /// A variable of that name, or of the name with the next number where that is taken.
    VariableId declare(std::string_view wish, Type type, Role role, const Localized& comment);

    /// Makes the integers of the diagram wide enough for these values.
    void widen(std::int64_t low, std::int64_t high);

  private:
    void declare_bits(BitKind kind, std::size_t count, Role role);
    void declare_steps();
    void declare_counters();
    std::string name_of(Bit bit) const;

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    const SimplifiedScan& scan_;
    Language language_;
    Ladder& ladder_;
    std::set<std::string> names_;
    std::map<Bit, VariableId> bits_;
    std::map<IntegerCell, VariableId> integers_;
    std::uint32_t work_bits_ = 0;
};

}  // namespace grafwire::ladder
