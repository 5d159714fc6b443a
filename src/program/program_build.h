#pragma once

#include <map>
#include <string>
#include <vector>

#include "program/program.h"

namespace grafwire {

/// Makes a scan program (see program.cpp); the members are what its parts share.
class ProgramBuild {
  public:
    ProgramBuild(const Grafcet& grafcet, const ProgramOptions& options);

    ScanProgram make();

  private:
    // program.cpp
    void make_start();
    void make_begin();
    void make_edges();
    void make_receptivities();
    void make_evolution();
    void make_times();
    void make_outputs();
    // program_orders.cpp
    void make_orders();
    void note_ordered_enclosures();
    void make_forcing();
    void make_enclosures();
    // program_stored.cpp
    void make_stored();
    struct StoredAction;
    std::vector<StoredAction> stored_actions() const;
    Condition trigger_of(const Action& action) const;
    Condition clearing_of(TransitionId transition) const;
    void read_before_writing(std::vector<StoredAction>& actions);
    void write(const StoredAction& action);

    Condition condition_of(ExprId id) const;
    Condition variable_condition(Variable variable) const;
    Condition any_step(std::uint32_t first, std::uint32_t count) const;
    Condition control(ControlInput control) const;
    Condition not_control(ControlInput input) const { return not_condition(control(input)); }

    /// The section that the next statements belong to.
    void begin(SectionKind kind) { section_ = static_cast<std::size_t>(kind); }
    Statement& add(Statement::Kind kind, std::string comment, Location origin = {});
    void assign(Bit target, Condition condition, std::string comment, Location origin = {});
    /// Nothing where the condition is constantly 0 or there are no targets.
    void set(Statement::Kind kind, std::vector<Bit> targets, Condition condition,
             std::string comment, Location origin = {});
    void table(TableOperation operation, std::string comment);
    Bit new_scratch() { return {BitKind::scratch, program_.scratch_bits++}; }

    const Grafcet& grafcet_;
    ScanProgram program_;
    std::size_t section_ = 0;
    /// Per enclosure whose graph some order bears on: the bit that says so in this scan.
    std::map<std::uint32_t, Bit> ordered_;
};

Bit step_bit(BitKind table, StepId step);
std::vector<Bit> graph_bits(BitKind table, const Graph& graph);
/// `(0) 0 -> 1`, as in the chart.
std::string transition_text(const Grafcet& grafcet, TransitionId id);

}  // namespace grafwire
