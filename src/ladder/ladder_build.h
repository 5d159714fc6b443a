#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ladder/ladder_from.h"

namespace grafwire::ladder {

/// Makes a ladder diagram (see ladder_from.cpp); the members are what its parts share.
class LadderBuild {
  public:
    LadderBuild(const ScanProgram& program, Diagnostics& diagnostics)
        : program_(program), grafcet_(*program.grafcet), diagnostics_(diagnostics) {}

    Ladder make();

  private:
    // ladder_from.cpp
    void simplify_program();
    void make_start();
    void make_previous();
    void make_section(SectionKind section, std::string heading);
    void translate(const Statement& statement);
    void move(const Statement& statement);
    void time(const Statement& statement);
    void pulses();
    const std::vector<Statement>& section(SectionKind kind) const {
        return sections_[static_cast<std::size_t>(kind)];
    }
    /// The next rung begins a section.
    void begin(std::string heading) { heading_ = std::move(heading); }
    void push(Rung rung, std::string comment, Location origin);
    void add_rung(Power power, CoilKind kind, const std::vector<Bit>& targets, std::string comment,
                  Location origin);

    // ladder_evolution.cpp
    void note_cleared_transitions();
    void make_transitions();
    void make_steps();
    void make_orders();
    std::size_t force(std::size_t first);

    // ladder_conditions.cpp
    Condition simplified(const Condition& condition) const;
    /// The contacts of a condition, or of its negation. What contacts cannot say (comparisons,
    /// exclusive or) is worked out into bits by rungs of its own before.
    Power power(const Condition& condition, bool positive = true);
    Power exclusive_or(const Condition& condition, bool positive);
    Condition worked_out(Power power);
    Power comparison(const Comparison& comparison);
    Operand value_of(const Sum& sum);
    /// Appends the blocks that add up a sum, the last of them into `target`.
    void add_up(const Sum& sum, VariableId target, std::vector<Block>& blocks);
    void check_range(const Sum& sum);
    /// Makes integers wide enough.
    void note_range(std::int64_t low, std::int64_t high);

    // ladder_names.cpp
    void declare_names();
    VariableId id_of(Bit bit);
    VariableId id_of(IntegerCell cell);
    VariableId new_integer();
    VariableId instance(BlockType type, const std::string& stem);
    std::string name_of(Bit bit);
    std::string unused_name(std::string_view wish);
    VariableId declare(std::string_view name, Type type, Role role, std::string comment);

    const ScanProgram& program_;
    const Grafcet& grafcet_;
    Diagnostics& diagnostics_;
    Ladder ladder_;
    std::string heading_;
    /// Of the statement that is being translated.
    std::string context_;
    Location origin_;
    /// The program without what never changes anything; see simplify_program.
    std::array<std::vector<Statement>, section_count> sections_;
    std::map<Bit, bool> constants_;
    std::set<Bit> read_;
    std::vector<Condition> cleared_;       ///< per transition: when it is cleared
    std::vector<std::set<Bit>> before_;    ///< per transition: its preceding steps
    std::map<Bit, std::string> comments_;  ///< what the bits written are for
    std::set<std::string> names_;
    std::map<Bit, VariableId> bits_;
    std::map<IntegerCell, VariableId> integers_;
    std::uint32_t next_work_ = 0;
};

/// All bits that a condition reads, added to a set.
void collect_reads(const Condition& condition, std::set<Bit>& bits);

}  // namespace grafwire::ladder
