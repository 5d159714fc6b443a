#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ladder/sfc_reader.h"
#include "support/iec_block.h"
#include "support/st_body.h"

namespace grafwire::testing {

/// What IEC 61131-3 and its implementations see differently. A chart that is exact is so in all of
/// them.
struct SfcDialect {
    bool final_scan = true;      ///< an N action is executed once more after its step
    bool pulse_at_start = true;  ///< P1 of an initial step acts in the first scan
    /// The time of D and L begins anew where a step is left and entered in one scan.
    bool restarts_time = false;
};

/// What a scan left to an order that the standard does not say.
struct SfcScanReport {
    /// Pairs of transitions after one step that could both be cleared.
    std::vector<std::pair<std::size_t, std::size_t>> selections;
    /// Two actions (S, R or statements) of which one wrote what the other wrote or read.
    struct Meeting {
        std::size_t first = 0;
        std::size_t second = 0;
        std::set<std::string> variables;
        std::set<std::string> written_by_both;
    };
    std::vector<Meeting> meetings;
};

/// Executes a sequential function chart by IEC 61131-3 (2nd edition), 2.6.4 and 2.6.5, once a scan:
///
/// 1. Transitions with all their preceding steps active are looked at from left to right, on the
///    situation that the scan began with; one is not cleared where another one after a step of its
///    own has been.
/// 2. Preceding steps are deactivated, following ones activated. A step that is both stays active,
///    without a pulse.
/// 3. Action control: a BOOL variable is 1 where any of its N, D and L actions is, or it has been
///    set by S and not reset by R. Then statements are executed in the order of the file.
///
/// The time `X5.T` of a step is not in it. Throws a PlcError for what is not understood.
class SfcMachine {
  public:
    SfcMachine(const SfcPou& sfc, const SfcDialect& dialect);

    // Names in any case. An input that does not exist is ignored.
    void set_input(const std::string& name, bool value);
    SfcScanReport scan(Time now);
    /// Of a variable, or 0 or 1 of a step; 0 where there is none of the name.
    std::int64_t value(const std::string& name) const;

  private:
    struct ActionState {
        bool is_timing = false;
        Time since = 0;
    };
    struct Executed {
        std::size_t action = 0;
        StAccess access;
    };
    void read_actions();
    void evolve(Time now, SfcScanReport& report);
    void control_variables(Time now, std::vector<Executed>& executed);
    bool is_time_over(std::size_t action, Time now);
    void execute(Time now, std::vector<Executed>& executed);
    bool is_executed(const SfcPou::Action& action) const;

    const SfcPou& sfc_;
    SfcDialect dialect_;
    IecBlock block_;
    std::vector<StBody> conditions_;
    std::vector<std::size_t> from_left_;  ///< transitions
    std::vector<StBody> bodies_;          ///< per action
    std::vector<ActionState> states_;     ///< likewise
    std::set<std::string> controlled_;    ///< variables that action blocks name
    std::set<std::string> latched_;       ///< those of them that S has set
    std::vector<bool> active_;
    std::vector<bool> was_active_;
    std::vector<bool> entered_;  ///< by a transition of this scan
    bool is_first_ = true;
};

}  // namespace grafwire::testing
