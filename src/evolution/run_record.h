#pragma once

#include <string>
#include <vector>

#include "evolution/evolution.h"
#include "evolution/run.h"
#include "grafcet/grafcet.h"
#include "text/time.h"
#include "trace/input_values.h"

namespace grafwire {

/// The result of a run while it grows, instant by instant or scan by scan. The GRAFCET must outlive
/// it.
class RunRecord {
  public:
    explicit RunRecord(const Grafcet& grafcet);

    /// To be called whenever inputs have changed, and at the start.
    void check_assumptions(Time now, const InputValues& inputs);
    /// How an instant or scan has ended.
    void add_row(Time now, const Evolution& evolution, const EvolutionState& state,
                 const InputValues& inputs);
    /// An instant without a stable situation, which is the last.
    void end_unstable(Time now, std::vector<std::string> changing);

    RunResult take() { return std::move(result_); }

  private:
    void add_bits(const BitTable& table);

    const Grafcet& grafcet_;
    std::vector<bool> is_broken_;  ///< per assumption
    RunResult result_;
};

}  // namespace grafwire
