#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "program/program.h"

namespace grafwire::ladder {

/// The program of a scan without what never changes anything: graphs that nothing freezes,
/// transitions that are never cleared, bits that nothing reads.
class SimplifiedScan {
  public:
    SimplifiedScan(const Grafcet& grafcet, const ScanProgram& program);

    const std::vector<Statement>& section(SectionKind kind) const {
        return sections_[static_cast<std::size_t>(kind)];
    }
    /// When a transition is cleared: its preceding steps are active and its transition condition
    /// is 1.
    const Condition& cleared(std::uint32_t transition) const { return cleared_[transition]; }
    /// Whether the bit has the same value in every scan.
    bool is_constant(Bit bit) const { return constants_.count(bit) > 0; }
    bool is_read(Bit bit) const { return read_.count(bit) > 0; }
    /// What the first statement that writes the bit is for; empty where none does.
    Localized comment_of(Bit bit) const;

    /// A condition with the bits that never change replaced by their values. A transition that is
    /// cleared had its preceding steps active: where it is a factor, those need not be asked again.
    Condition simplified(const Condition& condition) const;

  private:
    void note_graphs(const Grafcet& grafcet, const ScanProgram& program);
    void note_transitions(const Grafcet& grafcet, const ScanProgram& program);

    std::array<std::vector<Statement>, section_count> sections_;
    std::vector<Condition> cleared_;     ///< per transition
    std::vector<std::set<Bit>> before_;  ///< per transition: its preceding steps
    std::map<Bit, bool> constants_;
    std::set<Bit> read_;
    std::map<Bit, Localized> comments_;
};

}  // namespace grafwire::ladder
