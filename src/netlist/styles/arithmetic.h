#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "grafcet/expression.h"
#include "netlist/netlist_builder.h"

namespace grafwire {

/// Wide enough for sums of 64-bit numbers.
__extension__ typedef __int128 WideInteger;

/// A whole number as nets: two's complement, least significant bit first.
using Word = std::vector<NetId>;

/// Adders, comparators and selectors of gates, with constants folded away. For the counters of the
/// clocked style. Words are signed: an operand that is shorter than another is extended by its
/// sign, and a sum is one bit wider than its longer operand, so that nothing overflows.
class Arithmetic {
  public:
    explicit Arithmetic(GateMaker gates) : gates_(std::move(gates)) {}

    NetId and_of(NetId a, NetId b);
    NetId or_of(NetId a, NetId b);
    NetId xor_of(NetId a, NetId b);
    /// `chosen ? a : b`
    NetId choose(NetId chosen, NetId a, NetId b);
    Word choose(NetId chosen, const Word& a, const Word& b);

    /// The low bits of a number.
    Word constant(WideInteger value, std::size_t width);
    Word extended(Word word, std::size_t width) const;
    /// `a + b + carry`.
    Word add(const Word& a, const Word& b, NetId carry);
    Word subtract(const Word& a, const Word& b);

    /// The sum, wide enough never to overflow. Counter k is `counters[k]`, a signed word.
    Word sum(const Sum& terms, const std::vector<Word>& counters);
    /// The net of `left relation right`, read off the sign and the zeros of the difference.
    NetId compare(const Word& left, Relation relation, const Word& right);
    NetId is_negative(const Word& word) const { return word.back(); }
    NetId is_zero(const Word& word);

  private:
    NetId gate(CellType type, NetId a, NetId b);

    GateMaker gates_;
    std::uint32_t next_ = 0;
};

}  // namespace grafwire
