#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "grafcet/grafcet.h"
#include "program/program.h"

namespace grafwire::s7 {

/// Where the tables of the method lie in the V memory (Cordier, section 3.2): a table per kind of
/// bit, of so many bytes each.
struct TableLayout {
    std::uint32_t graphs = 0;  ///< first byte of Tfig
    std::uint32_t graph_bytes = 2;
    std::uint32_t steps = 10;  ///< first byte of the seven tables of steps: Tp, Ts, Tpulse, Ta, …
    std::uint32_t step_bytes = 10;
    std::uint32_t transitions = 80;  ///< first byte of Tt
    std::uint32_t transition_bytes = 20;

    /// The first byte of a table of steps; `kind` is previous, step, pulse, activate, deactivate,
    /// forced_on or forced_off.
    std::uint32_t first_byte(BitKind kind) const;
    /// The first byte behind all tables.
    std::uint32_t end() const {
        return std::max(transitions + transition_bytes, graphs + graph_bytes);
    }
};

/// The document's addresses: VB0 … VB99.
TableLayout standard_tables();
/// The same order of tables with room for any chart: graphs of more than 16 move Tfig behind Tt.
TableLayout wide_tables(const Grafcet& grafcet);

/// The place of every step, transition and graph in its table, counted in bits from its beginning.
struct TablePlaces {
    std::vector<std::uint32_t> graphs;
    std::vector<std::uint32_t> steps;
    std::vector<std::uint32_t> transitions;
};

/// What an assignment has fixed; `free_place` elsewhere.
inline constexpr std::uint32_t free_place = 0xffffffffU;

/// Decimal numbering without 8 and 9, as the document has it: what bears a number nm with m <= 7
/// stands in byte n, bit m ("Adressage complémentaire"). The rest of a graph takes the free bits of
/// its bytes, then whole bytes of its own, then what is free. In wide tables everything stands in
/// the order of the chart, each graph from a byte of its own on. Expects that there is room.
TablePlaces place_in_tables(const Grafcet& grafcet, const TableLayout& layout, bool wide,
                            TablePlaces fixed);

}  // namespace grafwire::s7
