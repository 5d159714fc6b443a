#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "logic/logic.h"
#include "s7/addresses/cpu.h"
#include "s7/listing.h"
#include "text/message.h"
#include "text/source.h"
#include "text/time.h"

namespace grafwire::s7 {

/// The process image of the inputs as a scan reads it. A bit that is not known is 0 in `value`.
struct InputImage {
    static constexpr std::size_t bytes = 8;
    std::array<std::uint8_t, bytes> value{};
    std::array<std::uint8_t, bytes> known{0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff};
};

/// A timer or counter between two scans.
struct TimerState {
    std::int32_t current = 0;  ///< ticks, as of its last execution; the count
    bool bit = false;
    bool running = false;
    Time elapsed = 0;  ///< since it was enabled, up to now; while it is running
    bool operator==(const TimerState&) const = default;
};

/// Everything that one scan hands to the next.
struct MachineState {
    std::vector<std::uint8_t> memory;  ///< all areas, one behind the other
    std::vector<TimerState> timers;    ///< those the listing uses, in the order of their numbers
    std::vector<TimerState> counters;  ///< likewise
    std::vector<std::uint8_t> edges;   ///< of EU, ED and counters: the bit as they saw it last
    bool first_scan = true;
    Time last_scan = 0;  ///< the time of the last scan
    bool operator==(const MachineState&) const = default;
};

/// A bit, and where it is unknown, an open input that it depends on: byte · 8 + bit of the image.
using Signal = grafwire::Signal<std::uint16_t>;

/// Where a run ends that should not.
struct RunError {
    std::uint32_t network = 0;
    Location where;
    Localized message;
};

/// Executes a listing, scan by scan, as an S7-200 does:
///
/// - A stack of nine bits; a load pushes the lowest out. At the beginning of a scan all are 0; a
///   network begins with what the one before has left. CALL saves the stack and hands the
///   subroutine one whose top is 1, the rest 0; after the return the saved one is back. So what
///   Cordier's listings leave without `LD SM0.0` at the head of a subroutine works, and elsewhere
///   depends on the network before.
/// - Memory by bytes, words and double words with the high byte first. SM0.0 is 1, SM0.1 is 1 in
///   the first scan.
/// - What writes, calls or jumps does so where the top of the stack is 1; timers and counters are
///   executed in any case.
/// - A timer counts when it is executed: its current value is the whole ticks since the execution
///   that enabled it, at most 32767, its bit whether that has reached the preset. (The real timers
///   of 1 ms and 10 ms are brought up to date by the controller, between scans or within.)
///
/// Inputs may be open (not known). Logic goes on with three values as long as it can; where a jump,
/// a write or a timer depends on an open input, the scan stops and says on which.
class Machine {
  public:
    /// Of a listing that check_listing has accepted for this controller.
    Machine(const Listing& listing, Cpu cpu);
    ~Machine();
    /// A copy executes the same listing beside the other; the listing itself is decoded once.
    Machine(const Machine& other);
    Machine(Machine&&) noexcept;
    Machine& operator=(Machine&&) noexcept;

    /// The state before the first scan: all memory 0.
    MachineState start() const;

    struct ScanEnd {
        /// An open input (byte · 8 + bit of the image) without which the scan cannot go on; the
        /// state is then worth nothing.
        std::optional<std::uint32_t> needs;
        std::optional<RunError> error;
        bool is_done() const { return !needs && !error; }
    };
    /// One scan at time `now`, which does not precede the last.
    ScanEnd scan(MachineState& state, const InputImage& inputs, Time now);

    /// A bit of memory, timer or counter as the last scan (of this machine) has left it.
    Signal bit(const MachineState& state, const Operand& operand) const;
    /// A byte, word or double word, or the current value of a timer or counter, likewise; of bytes
    /// not known in full, with the known bits.
    std::int32_t value(const MachineState& state, const Operand& operand) const;

    /// The bit of a number (see memory_bit) likewise.
    Signal memory_bit_after(const MachineState& state, std::size_t memory_bit) const;

    /// Where a memory operand begins among the bits of `MachineState::memory`.
    std::size_t memory_bit(const Operand& operand) const;
    /// Bits that may be read before they are written in a scan, or that are observed at its end
    /// and may pass through it: two states that differ in other bits alone behave alike. One byte
    /// of mask per byte of memory. `observed`: operands read after each scan.
    std::vector<std::uint8_t> live_at_start(const std::vector<Operand>& observed) const;

    /// From now on scans note who reads and who writes.
    void record();
    /// The network (index into Listing::networks) that wrote a bit last.
    struct Writer {
        std::uint32_t network = 0;
        bool in_last_scan = false;  ///< else in an earlier one
    };
    std::optional<Writer> writer(const Operand& operand) const;
    /// Whether a network has written anything in the last scan.
    bool wrote_in_last_scan(std::uint32_t network) const;
    /// A bit of memory that was loaded in the last scan, or a byte, word or double word compared.
    struct Read {
        std::uint32_t network = 0;
        Operand operand;
        std::int32_t value = 0;
        std::optional<Writer> writer;  ///< the last of its bits, at that time
    };
    /// In the order of their execution.
    std::vector<Read> reads() const;

    /// The ticks of its timers, and their delays where the preset is a constant.
    std::vector<Time> delays() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace grafwire::s7
