// A feedback loop is a strongly connected component of the netlist with more than one cell, or a
// cell that reads itself (R. Tarjan, "Depth-first search and linear graph algorithms", SIAM J.
// Comput. 1, 1972). The components come in reverse topological order, so one pass over them from
// the last to the first gives the depth of the logic outside. What reaches a flip-flop waits there
// for the clock, so loops and paths end at it.

#include "formats/stats/write_stats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "netlist/netlist_graph.h"

namespace grafwire {

namespace {

/// The text, part by part.
class Stats {
  public:
    explicit Stats(const Netlist& netlist)
        : netlist_(netlist), graph_(netlist, NetlistGraph::Edges::between_clocks) {}

    std::string write();

  private:
    void write_cells();
    void find_components();
    void write_loops();
    void write_loop(std::size_t component);
    void write_fan_out();
    void write_depth();
    /// Whether the output changes at the clock only.
    bool is_clocked(std::uint32_t cell) const {
        const CellTypeRow& row = row_of(netlist_.cells.items()[cell].type);
        return row.is_clocked && row.has_memory;
    }

    const Netlist& netlist_;
    NetlistGraph graph_;
    std::vector<std::uint32_t> component_;     ///< per cell
    std::vector<std::uint32_t> first_member_;  ///< per component: ranges of `members_`
    std::vector<std::uint32_t> members_;
    std::vector<std::uint8_t> is_loop_;  ///< per component
    std::string out_;
};

std::string Stats::write() {
    out_ = fmt::format("{}: {} cells, {} nets, {} pins, {} inputs, {} outputs\n", netlist_.name,
                       netlist_.cells.size(), netlist_.net_count(), netlist_.pins.size(),
                       netlist_.inputs.size(), netlist_.outputs.size());
    write_cells();
    find_components();
    write_loops();
    write_fan_out();
    write_depth();
    return std::move(out_);
}

void Stats::write_cells() {
    std::array<std::size_t, cell_table.size()> counts{};
    for (const Cell& cell : netlist_.cells) ++counts[static_cast<std::size_t>(cell.type)];
    out_ += "\ncells by type\n";
    for (const CellTypeRow& row : cell_table) {
        const std::size_t count = counts[static_cast<std::size_t>(row.type)];
        if (count != 0)
            out_ += fmt::format("{:10} {}\n", count, row.description.in(Language::english));
    }
}

/// Members of each component lie side by side (a counting sort by component).
void Stats::find_components() {
    const std::size_t count = netlist_.cells.size();
    component_ = strong_components(graph_);
    std::size_t component_count = 0;
    for (const std::uint32_t component : component_) {
        component_count = std::max<std::size_t>(component_count, component + 1);
    }
    first_member_.assign(component_count + 1, 0);
    for (const std::uint32_t component : component_) ++first_member_[component + 1];
    for (std::size_t i = 0; i < component_count; ++i) first_member_[i + 1] += first_member_[i];
    members_.resize(count);
    std::vector<std::uint32_t> next(first_member_.begin(), first_member_.end() - 1);
    for (std::uint32_t cell = 0; cell < count; ++cell) members_[next[component_[cell]]++] = cell;
    is_loop_.resize(component_count);
    for (std::size_t i = 0; i < component_count; ++i) {
        const std::uint32_t first = members_[first_member_[i]];
        const auto readers = graph_.readers(first);
        is_loop_[i] = first_member_[i + 1] - first_member_[i] > 1 ||
                      std::find(readers.begin(), readers.end(), first) != readers.end();
    }
}

/// A loop is named by the steps in it, or by its nets where it has none.
void Stats::write_loop(std::size_t component) {
    constexpr std::size_t most_names = 8;
    std::vector<std::uint32_t> origins;
    std::vector<NetId> nets;
    for (std::uint32_t i = first_member_[component]; i < first_member_[component + 1]; ++i) {
        const Cell& cell = netlist_.cells.items()[members_[i]];
        nets.push_back(cell.output);
        if (netlist_.origin_of(cell).kind == Origin::Kind::step) origins.push_back(cell.origin);
    }
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    out_ += fmt::format("  {} cells: ", nets.size());
    const std::size_t count = origins.empty() ? nets.size() : origins.size();
    out_ += origins.empty() ? "nets " : "steps ";
    for (std::size_t i = 0; i < std::min(count, most_names); ++i) {
        out_ += fmt::format("{}{}", i == 0 ? "" : ", ",
                            origins.empty() ? netlist_.names[nets[i]]
                                            : std::string_view(netlist_.origins[origins[i]].name));
    }
    if (count > most_names) out_ += fmt::format(" and {} more", count - most_names);
    out_ += '\n';
}

void Stats::write_loops() {
    // In the order of their first cells.
    std::vector<std::uint32_t> loops;
    for (std::uint32_t i = 0; i < is_loop_.size(); ++i) {
        if (is_loop_[i] != 0) loops.push_back(i);
    }
    std::sort(loops.begin(), loops.end(), [&](std::uint32_t a, std::uint32_t b) {
        return members_[first_member_[a]] < members_[first_member_[b]];
    });
    constexpr std::size_t most_loops = 100;
    out_ += fmt::format("\nfeedback loops: {}\n", loops.size());
    for (std::size_t i = 0; i < std::min(loops.size(), most_loops); ++i) write_loop(loops[i]);
    if (loops.size() > most_loops) {
        out_ += fmt::format("  and {} more\n", loops.size() - most_loops);
    }
}

/// The net with the most pins; of several the first.
void Stats::write_fan_out() {
    std::vector<std::uint32_t> pins(netlist_.net_count());
    for (const NetId pin : netlist_.pins) ++pins[index_of(pin)];
    const auto most = std::max_element(pins.begin(), pins.end());
    if (most == pins.end()) return;
    out_ += fmt::format("\nlargest fan-out: {} pins, of {}\n", *most,
                        netlist_.names[static_cast<NetId>(most - pins.begin())]);
}

/// The longest way through cells that are in no loop, counted from inputs, constants and clocked
/// cells.
void Stats::write_depth() {
    std::vector<std::uint32_t> depth(netlist_.cells.size());
    std::uint32_t deepest = 0;
    for (std::size_t i = is_loop_.size(); i-- != 0;) {
        if (is_loop_[i] != 0) continue;
        const std::uint32_t cell = members_[first_member_[i]];
        const Cell& item = netlist_.cells.items()[cell];
        const bool is_source = is_clocked(cell) || item.pin_count == 0;
        if (!is_source) deepest = std::max(deepest, ++depth[cell]);
        if (is_source) depth[cell] = 0;
        for (const std::uint32_t reader : graph_.readers(cell)) {
            if (is_loop_[component_[reader]] != 0) continue;
            depth[reader] = std::max(depth[reader], depth[cell]);
        }
    }
    out_ += fmt::format("\ndepth outside the loops: {} cells\n", deepest);
}

}  // namespace

std::string write_stats(const Netlist& netlist) {
    return Stats(netlist).write();
}

}  // namespace grafwire
