#pragma once

#include <optional>
#include <vector>

#include "s7/listing.h"
#include "s7/machine/binding.h"

namespace grafwire {

/// Where a listing keeps the tables of the method: at Cordier's addresses (section 3.2), where Ts
/// is VB20 … VB29 and the other tables of steps lie at fixed distances from it.
struct MethodTables {
    static constexpr std::int32_t first_byte_of_ts = 20;
    static constexpr std::int32_t bytes = 10;
    enum Distance : std::int32_t {
        previous = -10,
        activate = 20,
        deactivate = 30,
        forced_on = 40,
        forced_off = 50,
    };
    /// The bit of a step in another table, given its bit in Ts.
    static s7::Operand in(Distance table, s7::Operand step);
};

/// Whether the steps and transitions of a binding lie where the method has Ts and Tt.
bool keeps_method_tables(const s7::Binding& binding);

/// Whether an instruction writes into a bit, byte, word or double word, or into bytes of V.
bool may_write(const s7::Instruction& instruction, const s7::Operand& place);
bool may_write_bytes(const s7::Instruction& instruction, std::int32_t first, std::int32_t count);
/// Whether an instruction reads a bit by itself.
bool loads(const s7::Instruction& instruction, const s7::Operand& bit);

/// The networks (indices) of which one instruction is as asked for, in order.
template <typename Predicate>
std::vector<std::uint32_t> networks_where(const s7::Listing& listing, const Predicate& predicate) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t n = 0; n < listing.networks.size(); ++n) {
        for (const s7::Instruction& instruction : listing.networks[n].instructions) {
            if (!predicate(instruction)) continue;
            found.push_back(n);
            break;
        }
    }
    return found;
}

}  // namespace grafwire
