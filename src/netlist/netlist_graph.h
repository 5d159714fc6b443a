#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "netlist/netlist.h"

namespace grafwire {

/// The netlist as a graph: a vertex per cell, an edge from each cell to every pin it drives. The
/// netlist itself is not copied, only its fan-out lists are built. netlist_in_boost.h shows it to
/// the algorithms of Boost.Graph.
class NetlistGraph {
  public:
    /// Which edges the graph has.
    enum class Edges {
        all,      ///< one per pin
        at_once,  ///< none from cells with a memory, whose outputs do not follow their inputs at
                  ///< once
        between_clocks,  ///< none to flip-flops, whose outputs change at the clock only
    };
    explicit NetlistGraph(const Netlist& netlist, Edges edges = Edges::all);

    struct Edge {
        std::uint32_t source = 0;
        std::uint32_t target = 0;
        bool operator==(const Edge&) const = default;
    };
    std::size_t cell_count() const { return first_reader_.size() - 1; }
    /// The cells that read the output of a cell, in the order of cells; one entry per pin.
    std::span<const std::uint32_t> readers(std::uint32_t cell) const {
        return {readers_.data() + first_reader_[cell], readers_.data() + first_reader_[cell + 1]};
    }

  private:
    std::vector<std::uint32_t> first_reader_;
    std::vector<std::uint32_t> readers_;
};

/// The number of the strongly connected component of each cell. Edges lead from a component to
/// itself or to one with a lower number.
std::vector<std::uint32_t> strong_components(const NetlistGraph& graph);

}  // namespace grafwire
