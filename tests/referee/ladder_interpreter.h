#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ladder/ladder.h"
#include "referee/scanned_program.h"

namespace grafwire::testing {

/// Executes a ladder diagram by IEC 61131-3, rung by rung; what the standard leaves open as the
/// README of src/ladder says. Apart from the machine there. The variables of inputs, steps and
/// outputs have the names of the chart.
class LadderInterpreter : public ScannedProgram {
  public:
    LadderInterpreter(const Grafcet& grafcet, const ladder::Ladder& ladder)
        : grafcet_(grafcet), ladder_(ladder) {}

    void start() override;
    void scan(Time now, const InputValues& inputs) override;
    std::vector<bool> shown() const override;

  private:
    /// Of a function block, besides its Q.
    struct Instance {
        bool last = false;  ///< its power in the scan before
        bool runs = false;
        Time since = 0;
    };

    std::size_t variable_named(const std::string& name) const;
    bool flow(const ladder::Power& power);
    bool edge(bool now, bool rising);
    bool compare(const ladder::Power& power) const;
    bool block(const ladder::Block& block, bool power);
    void timer(const ladder::Block& block, bool power);
    void counter(const ladder::Block& block, bool counts);
    void function(const ladder::Block& block);
    void coil(const ladder::Coil& coil, bool power);
    std::int64_t number(const ladder::Operand& operand) const;
    bool bit(const ladder::Operand& operand) const;

    const Grafcet& grafcet_;
    const ladder::Ladder& ladder_;
    std::vector<bool> bits_;             ///< per variable; Q of an instance
    std::vector<std::int64_t> numbers_;  ///< per variable; CV of a counter
    std::vector<Instance> instances_;    ///< per variable
    std::map<std::size_t, bool> edges_;  ///< by their place in the diagram: what they saw last
    std::size_t place_ = 0;
    Time now_ = 0;
};

}  // namespace grafwire::testing
