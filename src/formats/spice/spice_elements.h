#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/shared/append.h"
#include "netlist/cell_types.h"

namespace grafwire {

/// The elements of a deck, one after the other, and the nodes between them that no net of the
/// netlist stands for. Names of such nodes begin with `__`.
class SpiceElements {
  public:
    static constexpr std::size_t widest = 48;  ///< nodes in one list; ngspice has room for no more

    explicit SpiceElements(std::string& out) : out_(out) {}

    /// One element, its nodes and model as they stand in the deck.
    template <typename... Parts>
    void add(const Parts&... parts) {
        append(out_, 'a', ++element_count_, ' ', parts..., '\n');
    }

    /// A gate of any number of inputs. `speed` is `slow_`, `held_` or `fast_` (spice_models.h).
    void add_gate(std::string_view speed, CellType type, std::vector<std::string_view> pins,
                  std::string_view output);

    /// Quick gates for groups of the nodes, and the nodes they drive.
    std::vector<std::string_view> gather(std::span<const std::string_view> nodes,
                                         std::string_view model);

    /// The name of a further node.
    std::string_view inner_node();

    /// Keeps a name for as long as the elements are written.
    std::string_view keep(std::string name) { return names_.emplace_back(std::move(name)); }

  private:
    std::string& out_;
    std::size_t element_count_ = 0;
    std::size_t inner_count_ = 0;
    std::deque<std::string> names_;
};

/// A list of nodes in brackets, over as many lines as it takes.
std::string spice_list(std::span<const std::string_view> nodes);

}  // namespace grafwire
