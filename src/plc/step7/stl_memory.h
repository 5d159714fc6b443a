#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plc/shared/plc_options.h"
#include "program/program.h"
#include "text/diagnostics.h"

namespace grafwire {

/// A bit of the process images (E, A; I, Q in international mnemonics) or of bit memory (M) of a
/// SIMATIC S7-300 or S7-400.
struct StlAddress {
    char area = 'M';  ///< 'E', 'A', 'M'
    std::uint32_t byte = 0;
    std::uint32_t bit = 0;
    auto operator<=>(const StlAddress&) const = default;
};

/// Where the bits, tables and integers of a program live. Inputs and outputs are where an
/// assignment puts them, else from E 0.0 and A 4.0 on, where the first modules of a rack are.
/// Everything else is bit memory from MB 10 on: the tables as words of one bit per step, so that
/// their formulas are operations on words, then the integers, then the single bits.
class StlMemory {
  public:
    /// Errors: an address that an input or output cannot have.
    StlMemory(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
              bool wide_integers, Diagnostics& diagnostics);

    static constexpr std::uint32_t first_byte = 10;
    static constexpr std::uint32_t last_byte = 8191;  ///< of an S7-400's M at most

    StlAddress of(Bit bit) const;
    /// The first byte of an integer.
    std::uint32_t of(IntegerCell cell) const;
    /// The first byte of a table of steps; it goes on for table_bytes(), a multiple of
    /// word_bytes().
    std::uint32_t table(BitKind kind) const { return tables_[static_cast<std::size_t>(kind)]; }
    std::uint32_t table_bytes() const { return table_bytes_; }
    /// 2 or 4: tables are worked on in words, or in double words where there are more than 16
    /// steps.
    std::uint32_t word_bytes() const { return table_bytes_ == 2 ? 2 : 4; }
    /// Where the bits, tables and integers of the program end: what lies before is 0 at the start.
    std::uint32_t program_end() const { return program_end_; }

    /// A bit that nothing has yet.
    StlAddress new_bit();
    /// A bit, or an integer, that holds a value for a few instructions.
    Bit auxiliary_bit(std::uint32_t number);
    std::uint32_t auxiliary_integer();
    std::uint32_t end() const { return end_; }
    /// An error where more memory is in use than there is.
    void check_size(Diagnostics& diagnostics) const;

    /// What a bit is called in comments: `start`, `X10`, `Ta[10]`, `↑start`, `memory of ↑start`.
    std::string symbol(Bit bit) const;
    std::string symbol(IntegerCell cell) const;
    /// The same of auxiliary bits and integers.
    std::string auxiliary_name() const;

  private:
    void place_interface(const s7::IoAssignment* io, Diagnostics& diagnostics);
    void place_tables();
    void place_integers(bool wide);
    void place_bits();
    std::uint32_t take_bytes(std::uint32_t count, std::uint32_t alignment);
    void take_bits(BitKind kind, std::size_t count);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Language language_;
    std::array<std::uint32_t, bit_kind_count> tables_{};
    std::uint32_t table_bytes_ = 0;
    std::map<Bit, StlAddress> bits_;
    std::map<IntegerCell, std::uint32_t> integers_;
    std::optional<StlAddress> last_new_bit_;
    std::optional<std::uint32_t> auxiliary_integer_;
    std::uint32_t integer_bytes_ = 2;
    std::uint32_t program_end_ = first_byte;
    std::uint32_t end_ = first_byte;
};

}  // namespace grafwire
