#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "check/scanned_device.h"
#include "check/witness.h"
#include "ladder/ladder.h"
#include "ladder/machine.h"
#include "text/message.h"

namespace grafwire {

/// Which variables of a ladder diagram are the inputs, steps and outputs of a GRAFCET: those of
/// their names (`X5`), as identifiers where a name is none (`V_plus` for `V+`).
struct LadderNames {
    std::vector<std::optional<ladder::VariableId>> inputs;  ///< with Init, AUdur, AUdoux
    std::vector<ladder::VariableId> steps;
    std::vector<ladder::VariableId> outputs;
    /// Declared inputs that the diagram does not have; they cannot change anything in it.
    std::vector<std::string> missing_inputs;
    /// Steps and outputs that it does not have; it cannot be compared then, and the lists above are
    /// of no meaning.
    std::vector<std::string> missing;
};

/// Identifiers are compared without regard to case, as IEC 61131-3 has them; but a variable of the
/// very name comes first.
LadderNames find_names(const Grafcet& grafcet, const ladder::Ladder& ladder);

/// A ladder diagram as a check sees it. Its inputs are the variables named after those of the
/// GRAFCET, whatever it declares them as.
class LadderDevice : public ScannedDevice {
  public:
    /// The names lack no step and no output. GRAFCET and ladder diagram must outlive it.
    LadderDevice(const Grafcet& grafcet, const ladder::Ladder& ladder, LadderNames names);

    std::string start() const override;
    Outcome scan(const std::string& memory, const PartialInputs& inputs, Time now) const override;
    std::string key(const std::string& memory, Time now) const override;
    std::vector<Time> delays() const override { return machine_.delays(); }
    bool has_modes() const override;

    /// The witness explained, with the rungs that wrote what differs, or that could have, and those
    /// that these depend on.
    std::string explain(const Witness& witness, Language language) const;

  private:
    ladder::Machine::Outcome last_scan(const Witness& witness) const;

    const Grafcet& grafcet_;
    const ladder::Ladder& ladder_;
    LadderNames names_;
    ladder::Machine machine_;
    std::map<ladder::VariableId, std::uint32_t> input_of_;
};

}  // namespace grafwire
