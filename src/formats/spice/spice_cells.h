#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/shared/append.h"
#include "formats/shared/net_spelling.h"
#include "netlist/delay_model.h"
#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// The nets of a netlist as nodes of a deck. SPICE knows no difference between capital and small
/// letters, and only letters, digits and `_` are safe: a net keeps its name in small letters where
/// that is free, with `_` for what is not safe and a number where that is taken. No name begins
/// with `_` or a digit.
NetSpelling spice_nodes(const Netlist& netlist);

/// Whether a node is called otherwise than its net, the case of letters apart.
bool is_renamed(std::string_view node, std::string_view net);

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

    /// A gate of any number of inputs. `speed` is `slow_`, `held_` or `fast_`
    /// (append_spice_models()).
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

/// The models that depend on the netlist, with their numbers.
struct SpiceModels {
    std::map<std::pair<Time, Time>, std::size_t> timers;  ///< by their delays, rise and fall
    std::map<Time, std::size_t> pulses;                   ///< by their widths
};

/// Writes the cells of a netlist as elements of a deck. During the start (node `__start` at 1,
/// `__running` at 0) latches, timers and nets with initial values are held at these.
class SpiceCells {
  public:
    SpiceCells(const Netlist& netlist, const NetSpelling& nets, SpiceElements& elements);

    /// Writes one cell, of any type but those that count scans.
    void write(const Cell& cell);

    /// The models that the cells written so far need.
    const SpiceModels& models() const { return models_; }

  private:
    void write_driver(const Cell& cell, std::string_view output, std::string_view speed);
    void write_latch(const Cell& cell, std::string_view output);
    void write_memory(const Cell& cell, std::string_view model, std::string_view output);
    void write_pulse(const Cell& cell, std::string_view output);
    void write_timer(const Cell& cell, std::string_view output);

    std::string_view pin(const Cell& cell, std::size_t number) const {
        return nets_[netlist_.pins_of(cell)[number]];
    }

    const Netlist& netlist_;
    const NetSpelling& nets_;
    SpiceElements& elements_;
    std::vector<Logic> initial_;  ///< per net: Netlist::initial_values
    SpiceModels models_;
};

/// Writes the `.model` lines of a deck that counts in picoseconds: gates that take what the delay
/// model says (`slow_`), a picosecond less for those that a quick one follows (`held_`), and one
/// picosecond (`fast_`). Delays are multiples of the parameter `gate`.
void append_spice_models(std::string& out, const SpiceModels& models, const DelayModel& delays);

}  // namespace grafwire
