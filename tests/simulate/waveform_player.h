#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "simulate/delay_ends.h"
#include "support/small_netlist.h"

namespace grafwire::testing {

/// The values of the inputs at one position of a waveform.
using InputRow = std::vector<Logic>;
/// Row 0 is what the inputs are at rest, before the first instant; a position is a nanosecond, or
/// the beginning of the next instant.
using Waveforms = std::vector<InputRow>;
/// Row after row, such as "01 1x ".
std::string text_of(const Waveforms& waveforms);

/// What a net has been seen at, one bit for each nanosecond of each instant; both where unknown.
struct Seen {
    std::uint64_t zero = 0;
    std::uint64_t one = 0;
    bool allows(const Seen& other) const {
        return (other.zero & ~zero) == 0 && (other.one & ~one) == 0;
    }
    bool operator==(const Seen&) const = default;
};

/// How the positions are spread over instants: 1 or more to each. The instants are a millisecond
/// apart.
struct Spread {
    std::vector<std::size_t> positions;  ///< per instant, row 0 not counted
    std::size_t moments = 0;             ///< nanoseconds of every instant that are looked at
    bool delays_end = true;              ///< delays of timers end by themselves
    bool restored = false;               ///< each instant begins from a state saved and restored
    std::size_t rows() const;
};

/// Plays waveforms on a netlist: inputs that change while the gates are at work. settle() does not
/// stop on the way; so a chain of buffers is added to the netlist, and as an edge runs along it,
/// the observer moves the inputs with it.
class WaveformPlayer {
  public:
    /// The inputs of the netlist play; `watched` nets are looked at.
    WaveformPlayer(SmallNetlist& small, CellDelays delays, const std::vector<std::string>& watched,
                   Spread spread);

    struct Played {
        std::vector<Seen> seen;      ///< per watched net
        std::vector<Logic> at_rest;  ///< per watched net, after the last instant
        /// Up to the first that did not settle, that one included; none if the rest before did not.
        std::size_t instants = 0;
        bool settled = true;
    };
    Played play(const Waveforms& waveforms);

  private:
    bool come_to_rest(const InputRow& inputs);
    void set_inputs(const InputRow& inputs);
    void play_instant(std::size_t first_row, std::size_t instant, const Waveforms& waveforms,
                      Played& played);

    Spread spread_;
    std::vector<NetId> inputs_;
    std::vector<NetId> watched_;
    std::vector<std::pair<NetId, Logic>> held_;  ///< at first: memories and other initial values
    NetId start_ = no_net;
    std::vector<NetId> beats_;
    Logic beat_ = zero;
    Simulator simulator_;
    DelayEnds delay_ends_;
};

}  // namespace grafwire::testing
