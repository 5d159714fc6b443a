#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "s7check/blame.h"
#include "s7check/expected_tables.h"
#include "s7check/method_tables.h"
#include "s7check/suspects.h"

namespace grafwire {

/// Follows a witness to its end, reference and listing side by side, and looks for the first bit
/// that deviates there. What it refers to must outlive it.
class Investigation {
  public:
    Investigation(const Grafcet& grafcet, const s7::Listing& listing, s7::Cpu cpu,
                  const s7::Binding& binding, const Witness& witness);
    std::optional<Finding> run();

  private:
    using Kind = Finding::Kind;
    using Operand = s7::Operand;
    using Deviation = std::optional<Finding>;

    bool follow();
    void note_what_is_kept();
    void note(Kind kind, const std::string& name, const std::optional<Operand>& place,
              bool expected);

    // The deviations of the last scan, in its order.
    Deviation in_receptivities();
    Deviation in_freezing(const Transition& transition);
    Deviation in_vars(const Transition& transition);
    Deviation in_timer(const Finding& receptivity, const Transition& transition);
    Deviation in_evolution();
    Deviation in_forcing();
    Deviation in_situation();
    Deviation in_outputs();
    Finding set_by_transition(Kind kind, MethodTables::Distance distance, std::size_t step,
                              bool expected);
    Finding set_by_order(Kind kind, MethodTables::Distance distance, std::size_t step,
                         bool expected);

    void collect(ExprId id, ExprKind kind, std::vector<ExprId>& found) const;
    bool got(const Operand& place) const { return machine_.bit(state_, place).is_one(); }
    bool got_in(MethodTables::Distance table, std::size_t step) const {
        return got(MethodTables::in(table, step_place(step)));
    }
    const Operand& step_place(std::size_t step) const { return *binding_.steps[step]; }
    std::string step_name(std::size_t step) const {
        return "X" + grafcet_.steps[static_cast<StepId>(step)].name;
    }

    const Grafcet& grafcet_;
    const s7::Listing& listing_;
    const s7::Binding& binding_;
    const Witness& witness_;
    Evolution evolution_;
    s7::Machine machine_;
    s7::MachineState state_;
    s7::MachineState state_before_;  ///< of the machine, before the scan
    bool has_tables_;
    Suspects suspects_;
    Time now_ = 0;
    EvolutionState before_;    ///< the reference before the scan
    ExpectedTables expected_;  ///< and what it expects after it
    /// What is kept from scan to scan and deviates now, since when, by name.
    std::map<std::string, Finding> kept_;
};

}  // namespace grafwire
