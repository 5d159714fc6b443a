#pragma once

#include <cstdint>

#include "evolution/evolution.h"
#include "evolution/tables.h"

namespace grafwire {

/// A sum of whole numbers that cannot overflow: two halves of 32 bits, each summed in 64 bits.
class ExactSum {
  public:
    void add(std::int64_t value, bool negative) {
        const std::int64_t high = value >> 32;
        const std::int64_t low = value & 0xffffffff;
        high_ += negative ? -high : high;
        low_ += negative ? -low : low;
    }
    /// Less than, equal to or greater than 0 as this sum is to the other.
    int compare(const ExactSum& other) const;
    /// The number in low..high that is nearest to the sum.
    std::int64_t held_within(std::int64_t low, std::int64_t high) const;

  private:
    ExactSum carried() const;

    std::int64_t high_ = 0;
    std::int64_t low_ = 0;
};

/// Reads expressions in a state under given inputs. Steps are read in `situation`, edges and time
/// conditions in their tables, all as they are at the time of the call.
///
/// What is decided without an input does not look at it: operands are read from left to right, and
/// none after the one that settles an AND or an OR. Every look at an input goes through input(),
/// which notes it. A scan is thus a decision tree over the inputs that it notes, and flipping any
/// other input cannot lead to another branch.
class Evaluator {
  public:
    Evaluator(const Grafcet& grafcet, const EvolutionTables& tables, const EvolutionState& state,
              const EvolutionInputs& inputs)
        : grafcet_(grafcet), tables_(tables), state_(state), inputs_(inputs) {}

    bool value(ExprId id) const;
    ExactSum sum(const Sum& terms) const;
    /// The value of an input, declared inputs first, then the control inputs.
    bool input(std::size_t index) const {
        if (inputs_.consulted != nullptr) (*inputs_.consulted)[index] = 1;
        return inputs_.values[index] != 0;
    }

  private:
    bool variable(Variable variable) const;
    bool comparison(const Comparison& comparison) const;

    const Grafcet& grafcet_;
    const EvolutionTables& tables_;
    const EvolutionState& state_;
    const EvolutionInputs& inputs_;
};

}  // namespace grafwire
