#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "program/program.h"
#include "text/safe_names.h"

namespace grafwire {

/// What a language makes of names.
struct NameRules {
    bool case_matters = true;
    /// Whether a word is none that a program may choose. Asked in lower case where case does not
    /// matter.
    bool (*is_reserved)(std::string_view word) = nullptr;
};

/// The names of a program in a language with records: inputs, outputs, vars and so on are fields of
/// records of their own, so each group has its names to itself. Names of the chart are kept where
/// the language can hold them (ascii_word); edges and time conditions are named after their texts:
/// `rise_dcy`, `t5s_X13`.
class ProgramNames {
  public:
    ProgramNames(const Grafcet& grafcet, const ScanProgram& program, const NameRules& rules);

    /// The chart's own name.
    const std::string& chart() const { return chart_; }
    /// The name within its group; the tables of steps share one group, an edge and its memory
    /// another.
    const std::string& operator[](Bit bit) const;
    const std::string& operator[](IntegerCell cell) const;

    /// The declared inputs, then the control inputs where the program has modes.
    std::vector<Bit> inputs() const;

    /// Names that differ from those of the chart, each with the one it stands for, quoted where the
    /// chart has to.
    const std::vector<std::pair<std::string, std::string>>& changed() const { return changed_; }

  private:
    void name_chart();
    void name_inputs();
    void name_parts();
    void name_expressions();
    static std::size_t place_of(BitKind kind);
    std::vector<std::string>& group_of(BitKind kind) { return bits_[place_of(kind)]; }
    SafeNames group() const { return {rules_.case_matters, rules_.is_reserved}; }
    void add(std::vector<std::string>& names, SafeNames& group, const std::string& original);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    NameRules rules_;
    std::string chart_;
    std::array<std::vector<std::string>, bit_kind_count> bits_;  ///< by place_of
    std::vector<std::string> counters_, scratch_integers_;
    std::vector<std::pair<std::string, std::string>> changed_;
};

}  // namespace grafwire
