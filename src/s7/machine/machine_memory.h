#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "logic/logic.h"
#include "s7/machine/decoded.h"
#include "s7/machine/machine.h"

namespace grafwire::s7 {

/// The memory during a scan: the bytes of a state, and beside them which bits are known, and an
/// open input on which each other bit depends.
class MachineMemory {
  public:
    explicit MachineMemory(std::size_t bytes) : known_(bytes, 0xff), causes_(bytes * 8) {}

    /// Begins a scan on the bytes of a state.
    void begin(std::vector<std::uint8_t>& bytes);
    /// An input byte as the scan reads it; `first_cause` is the number of its bit 0.
    void set_input(std::size_t at, std::uint8_t value, std::uint8_t known,
                   std::uint16_t first_cause);

    Signal bit(std::size_t at, std::uint8_t bit) const {
        const auto mask = static_cast<std::uint8_t>(1U << bit);
        if ((known_[at] & mask) != 0) return Signal::of(((*bytes_)[at] & mask) != 0);
        return {Logic::unknown, causes_[at * 8 + bit]};
    }
    void set_bit(std::size_t at, std::uint8_t bit, Signal value);
    /// The input on which a bit depends that is not known; nothing where it is.
    std::optional<std::uint16_t> open_cause(std::size_t at, std::uint8_t bit) const {
        if ((known_[at] >> bit & 1U) != 0) return std::nullopt;
        return causes_[at * 8 + bit];
    }

    /// High byte first.
    LogicWord word(std::size_t at, Width width) const;
    /// The input on which a bit (0 is the lowest) of a word depends that is not known.
    std::uint16_t cause(std::size_t at, Width width, std::uint32_t bit) const {
        return causes_[memory_bit(at, width, bit)];
    }
    /// `causes[i]` for bit i, where it is not known; may be null where all are.
    void set_word(std::size_t at, Width width, LogicWord value, const std::uint16_t* causes);

    /// Copies bytes that may overlap.
    void copy(std::size_t from, std::size_t to, std::size_t count);

    /// Reads and writes from now on are by this network.
    void set_network(std::uint32_t network) { network_ = network; }
    void record();
    bool is_recording() const { return !writers_.empty(); }
    /// Who wrote a bit last, in which scan, and as which of all writes (both counted from 1).
    struct Writer {
        std::uint32_t network = 0;
        std::uint32_t scan = 0;  ///< 0: nobody
        std::uint32_t order = 0;
    };
    Writer writer(std::size_t memory_bit) const {
        return writers_.empty() ? Writer() : writers_[memory_bit];
    }
    std::uint32_t scan() const { return scan_; }
    bool wrote_in_last_scan(std::uint32_t network) const {
        return network < wrote_.size() && wrote_[network] == scan_;
    }
    /// A bit, byte, word or double word that decided something in the last scan.
    struct Read {
        std::uint32_t network = 0;
        std::size_t memory_bit = 0;  ///< the first
        Width width = Width::bit;
        std::uint32_t value = 0;
        Writer writer;  ///< the last of those who wrote its bits
    };
    const std::vector<Read>& reads() const { return reads_; }
    void note_read(std::size_t at, std::uint8_t bit, Width width);

  private:
    static std::size_t memory_bit(std::size_t at, Width width, std::uint32_t bit) {
        return (at + bytes_of(width) - 1 - bit / 8) * 8 + bit % 8;
    }
    void note_writer(std::size_t first_bit, std::size_t count);

    std::vector<std::uint8_t>* bytes_ = nullptr;
    std::vector<std::uint8_t> known_;
    std::vector<std::uint16_t> causes_;
    std::vector<Writer> writers_;       ///< empty: not asked for
    std::vector<std::uint32_t> wrote_;  ///< per network the scan of its last write
    std::vector<Read> reads_;
    std::uint32_t network_ = 0;
    std::uint32_t scan_ = 0;
    std::uint32_t writes_ = 0;
    bool all_known_ = true;
};

}  // namespace grafwire::s7
