#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evolution/bit_table.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"

namespace grafwire {

/// Appends the bits of a table to an encoding, all of them. States are compared by their encodings,
/// which hold the whole of what counts and never a digest: a collision would be a wrong verdict.
void encode(std::string& encoding, const BitTable& bits);

/// What of a state of the reference an X or an output can ever depend on. The rest (a counter that
/// nothing reads, a delay that only such a counter waits for) is carried along by the evolution,
/// but two states that differ in nothing else are the same to a check.
class Relevance {
  public:
    explicit Relevance(const Grafcet& grafcet);

    /// Per time condition, 1 where it is relevant.
    const std::vector<std::uint8_t>& time_conditions() const { return times_; }

    /// Appends a state to an encoding, as far as it is relevant, without what remains of its
    /// delays.
    void encode(std::string& encoding, const EvolutionState& state) const;

  private:
    void read(const Grafcet& grafcet, ExprId id);
    void make_relevant(Variable variable);
    void read_sum(const Sum& sum);
    void read_writes_to_relevant(const Grafcet& grafcet);
    bool writes_relevant(const Write& write) const;
    void read_write(const Grafcet& grafcet, const Write& write);

    std::vector<std::uint8_t> expressions_;  ///< per node, whether it has been read
    BitTable vars_;
    BitTable edges_;
    BitTable times_bits_;
    std::vector<std::uint8_t> times_;
    std::vector<std::uint8_t> counters_;
    bool grew_ = false;
};

}  // namespace grafwire
