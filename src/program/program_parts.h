#pragma once

#include <string>
#include <vector>

#include "program/program.h"

namespace grafwire {

// What the parts of a scan program are made with.

/// Appends statements to one section.
class SectionWriter {
  public:
    SectionWriter(ScanProgram& program, SectionKind section)
        : statements_(program.sections[static_cast<std::size_t>(section)]) {}

    /// The reference is valid until the next statement.
    Statement& add(Statement::Kind kind, Localized comment, Location origin = {});
    void assign(Bit target, Condition condition, Localized comment, Location origin = {});
    /// Nothing where the condition is constantly 0 or there are no targets.
    void set(std::vector<Bit> targets, Condition condition, Localized comment,
             Location origin = {});
    void reset(std::vector<Bit> targets, Condition condition, Localized comment,
               Location origin = {});
    void table(TableOperation operation, Localized comment);

  private:
    void set_or_reset(Statement::Kind kind, std::vector<Bit> targets, Condition condition,
                      Localized comment, Location origin);

    std::vector<Statement>& statements_;
};

/// The expressions of a chart as conditions (see condition.cpp).
class ChartConditions {
  public:
    ChartConditions(const Grafcet& grafcet, bool has_modes)
        : grafcet_(grafcet), has_modes_(has_modes) {}

    Condition of(ExprId id) const;
    /// 0 in a program without modes.
    Condition control(ControlInput control) const;
    Condition not_control(ControlInput input) const { return not_condition(control(input)); }

  private:
    Condition of(Variable variable) const;
    static Condition any_step(Range<StepId> steps);

    const Grafcet& grafcet_;
    bool has_modes_;
};

/// SBR 5: forcing, enclosures and AUdur (see orders.cpp).
void add_orders(const Grafcet& grafcet, const ChartConditions& conditions, ScanProgram& program);

/// The end of SBR 5: stored actions (see stored_actions.cpp).
void add_stored_actions(const Grafcet& grafcet, const ChartConditions& conditions,
                        ScanProgram& program);

Bit step_bit(BitKind table, StepId step);
Bit new_scratch(ScanProgram& program);
/// `(0) 0 -> 1`, as in the chart.
std::string transition_text(const Grafcet& grafcet, TransitionId id);

}  // namespace grafwire
