#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "program/program.h"
#include "s7/generate/addresses.h"
#include "s7/generate/network_list.h"

namespace grafwire::s7 {

/// Writes conditions as instructions that leave their value on top of the stack (see
/// condition_writer.cpp).
class ConditionWriter {
  public:
    ConditionWriter(Addresses& addresses, NetworkList& networks)
        : addresses_(addresses), networks_(networks) {}

    /// The condition in a form that load() can write: whatever takes networks of its own (exclusive
    /// or, sums, a stack too deep) goes into networks before, which leave it in a working bit.
    /// `comment` says what the condition is for. Working bits of earlier calls are reused.
    Condition prepare(const Condition& condition, const Localized& comment);

    /// The instructions that load a prepared condition.
    std::vector<Instruction> load(const Condition& condition) const;

    /// The instructions that put a sum into a word or double word.
    std::vector<Instruction> work_out(const Sum& sum, const Operand& target) const;
    /// The operand that a sum of one term is: the address of a counter, or a constant.
    Operand operand_of(const Sum& sum) const;

  private:
    void load(const Condition& condition, std::vector<Instruction>& out) const;
    void combine(Condition::Kind kind, const Condition& operand,
                 std::vector<Instruction>& out) const;

    Addresses& addresses_;
    NetworkList& networks_;
};

/// Whether a sum is one counter, not negated, or one number.
bool is_operand(const Sum& sum);
/// The number that a sum of one constant term is.
std::int64_t constant_of(const SumTerm& term);

}  // namespace grafwire::s7
