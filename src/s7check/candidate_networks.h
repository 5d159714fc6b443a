#pragma once

#include <optional>
#include <string>
#include <vector>

#include "s7/listing.h"
#include "s7/machine/binding.h"
#include "s7/machine/machine.h"
#include "s7check/fault_localization.h"

namespace grafwire {

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

/// Finds out which networks made a bit what it is after the last scan of a machine that records.
class CandidateNetworks {
  public:
    /// Both must outlive it.
    CandidateNetworks(const s7::Listing& listing, const s7::Binding& binding)
        : listing_(listing), outline_(s7::outline_of(listing)), binding_(binding) {}

    /// What the machine has to say of its last scan.
    void look_at(const s7::Machine& machine, Time now) {
        machine_ = &machine;
        now_ = now;
        reads_ = machine.reads();
    }

    /// A deviation, with the network that wrote the bit, those that wrote what it read, and, where
    /// none wrote it in the last scan, those that could have.
    Diagnosis written(Diagnosis::Kind kind, std::string name, const s7::Operand& place,
                      bool expected) const;

    /// Puts networks that should have written the bit before the other candidates; does nothing
    /// without any.
    void put_first(Diagnosis& diagnosis, const std::vector<std::uint32_t>& networks) const;

    /// Some bytes of V.
    struct Bytes {
        std::int32_t first = 0;
        std::int32_t count = 0;
    };
    /// Networks that read the bit of a step, in Ts or in Tp, and set something in some bytes of V;
    /// where there are none, those that set something elsewhere in V.
    std::vector<std::uint32_t> setters_for_step(std::size_t step, Bytes bytes) const;
    /// Networks that read a bit and set something in V.
    std::vector<std::uint32_t> setters_for(const s7::Operand& bit) const;
    /// How a bit was read in the last scan, by a network or (no_network) by anyone, the first time.
    static constexpr std::uint32_t no_network = 0xffffffffU;
    std::optional<bool> read_as(const s7::Operand& bit, std::uint32_t network = no_network) const;
    /// The networks that run a timer.
    std::vector<std::uint32_t> runners_of(const s7::Operand& timer) const;
    /// The networks that write words of Ts and have not written anything in the last scan: they
    /// stand under a condition that was 0.
    std::vector<std::uint32_t> silent_writers_of_ts() const;

  private:
    std::uint32_t number(std::uint32_t network) const { return listing_.networks[network].number; }
    void add_networks(Diagnosis& diagnosis, const std::vector<std::uint32_t>& networks,
                      bool in_front) const;
    std::vector<std::uint32_t> writers_of(const s7::Operand& place) const;
    std::vector<std::uint32_t> jumps_over(std::uint32_t network) const;
    bool is_told_by_the_tables(const s7::Operand& place) const;
    void follow_reads(Diagnosis& diagnosis, std::uint32_t network, int depth) const;

    const s7::Listing& listing_;
    s7::Outline outline_;
    const s7::Binding& binding_;
    const s7::Machine* machine_ = nullptr;
    Time now_ = 0;
    std::vector<s7::Machine::Read> reads_;
};

}  // namespace grafwire
