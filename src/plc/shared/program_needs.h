#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "program/program.h"

namespace grafwire {

/// The program without what its chart has no use for: where nothing is ever frozen, Tfig is always
/// 1 and vanishes; where nothing reads Tpulse, it is not worked out.
ScanProgram without_idle_tables(const ScanProgram& program);

/// Whether any statement other than the whole-table ones reads or writes a bit of this kind.
bool uses(const ScanProgram& program, BitKind kind);

/// Whether the program has statements of this kind.
bool has_statements(const ScanProgram& program, Statement::Kind kind);

/// Whether orders force steps, so that the tables Tf1 and Tf0 are needed.
bool has_forcing(const ScanProgram& program);

/// The widest integer the program works with, as the number of bits of a signed type that holds
/// every counter, every limit and every partial sum, and the negative of each: 16, 32 or 64; empty
/// where 64 are not enough.
std::optional<unsigned> integer_bits(const Grafcet& grafcet, const ScanProgram& program);

/// The place of the first statement whose integers need more than so many bits.
Location wide_integer(const Grafcet& grafcet, const ScanProgram& program, unsigned bits);

/// Steps `first` to `last`, both included, of one table.
struct StepRange {
    BitKind table = BitKind::step;
    std::uint32_t first = 0;
    std::uint32_t last = 0;
};

/// The targets of a statement that are bits of step tables, table by table, neighbours as ranges.
std::vector<StepRange> step_ranges(std::span<const Bit> targets);

/// The other targets.
std::vector<Bit> single_bits(std::span<const Bit> targets);

}  // namespace grafwire
