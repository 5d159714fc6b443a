#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "logic/logic.h"
#include "netlist/cell_types.h"
#include "text/message.h"
#include "text/source.h"
#include "text/table.h"
#include "text/time.h"

namespace grafwire {

enum class NetId : std::uint32_t {};
enum class CellId : std::uint32_t {};
inline constexpr NetId no_net{0xffffffffU};
inline constexpr CellId no_cell{0xffffffffU};

/// What a cell was made for, so that every message about a gate can speak of the GRAFCET.
struct Origin {
    enum class Kind : std::uint8_t {
        other,
        input,
        step,
        transition,
        output,
        var,
        counter,
        graph,
        edge,
        time_condition,
    };
    Kind kind = Kind::other;
    std::string name;  ///< the step, transition, … as written; an expression for edges and times
    Location where;    ///< in the GRAFCET; of kind other: in the file the netlist was read from
};

/// The parameters of cells that know of time.
struct Timing {
    Time rise = 0;  ///< timer: on-delay; pulse: unused
    Time fall = 0;  ///< timer: off-delay, 0 for at once; pulse: width
    /// Timers: the number of the time condition in the GRAFCET; `no_ordinal` in a netlist from
    /// elsewhere that does not say.
    std::uint32_t ordinal = no_ordinal;
    static constexpr std::uint32_t no_ordinal = 0xffffffffU;
    bool operator==(const Timing&) const = default;
};

/// One gate, latch, flip-flop, … Input pins are a range of Netlist::pins; their meaning per type
/// stands in the cell table.
struct Cell {
    CellType type = CellType::buffer;
    Logic initial = Logic::unknown;  ///< what a cell with a memory holds at power-up
    std::uint32_t first_pin = 0;
    std::uint32_t pin_count = 0;
    NetId output = no_net;
    /// Index into Netlist::origins. A cell without one is a fault of the netlist (fault_of);
    /// NetlistBuilder makes none.
    std::uint32_t origin = no_origin;
    std::uint32_t timing = 0;  ///< index into Netlist::timings, for types that have timing
    static constexpr std::uint32_t no_origin = 0xffffffffU;
};

struct Port {
    std::string name;
    NetId net = no_net;
};

/// A run of cells that belong together: the module of a step, the logic of an output, … A
/// netlist is cut into modules without gaps.
struct Module {
    std::string name;     ///< `X7`, `V+`, `inputs`, … unique
    std::string comment;  ///< its equation, one line; may be empty
    std::uint32_t first_cell = 0;
    std::uint32_t cell_count = 0;
};

/// A var or counter as the netlist keeps it, for traces: the value is `offset` plus the number its
/// bits spell, least significant first.
struct Observed {
    std::string name;
    std::vector<NetId> bits;
    std::int64_t offset = 0;
};

/// The names of all nets in one text.
class NetNames {
  public:
    NetId add(std::string_view name);
    /// Makes room for so many names of so many bytes in all.
    void reserve(std::size_t names, std::size_t bytes);
    std::string_view operator[](NetId net) const;
    std::size_t size() const { return ends_.size(); }
    /// Of all names together, in bytes.
    std::size_t length() const { return text_.size(); }

  private:
    std::string text_;
    std::vector<std::uint64_t> ends_;
};

/// Cells and the nets between them. Every net has exactly one driver: a cell or an input port.
struct Netlist {
    std::string name;
    std::vector<Port> inputs;  ///< declared inputs, Init, AUdur, AUdoux (with modes), clk (clocked)
    std::vector<Port> outputs;  ///< X of every step, then the declared outputs
    Table<CellId, Cell> cells;
    std::vector<NetId> pins;
    NetNames names;
    /// Nets driven by gates that start at a known value (a latch made of gates, without modes).
    struct InitialValue {
        NetId net = no_net;
        bool value = false;
    };
    std::vector<InitialValue> initial_values;
    std::vector<Origin> origins;  ///< number 0 is of kind other
    std::vector<Timing> timings;
    std::vector<Module> modules;
    std::vector<Observed> vars;
    std::vector<Observed> counters;
    NetId clock = no_net;  ///< the clock input of a clocked netlist
    bool has_modes = true;
    /// Without modes: its steps are in the initial situation when it starts. Where not, they are in
    /// whatever power-up leaves them in.
    bool starts_initially = true;
    std::size_t step_count = 0;  ///< the first so many outputs are the X of the steps

    std::size_t net_count() const { return names.size(); }
    std::span<const NetId> pins_of(const Cell& cell) const {
        return {pins.data() + cell.first_pin, cell.pin_count};
    }
    const Origin& origin_of(const Cell& cell) const { return origins[cell.origin]; }
    bool is_clocked() const { return clock != no_net; }
};

/// The driver of every net, no_cell for input ports.
Table<NetId, CellId> drivers_of(const Netlist& netlist);

/// Per cell, 1 where it lies on a loop of cells without a memory of their own: a latch made of
/// gates, a ring of inverters. Cells with a memory cut loops, as their outputs do not follow their
/// inputs at once. So the outputs of cells with a memory and of those on loops are all that a
/// settled netlist remembers; every other net follows from them and the inputs.
std::vector<std::uint8_t> cells_on_loops(const Netlist& netlist);

/// Whether the netlist is whole: pins and ports in range, every net driven once, pin counts as the
/// cell table says, modules without gaps, names unique. Empty if so, else the first fault in words.
std::string fault_of(const Netlist& netlist);

/// "NAND gate X7$set of step 7", "porte NON-ET X7$set de l'étape 7": a cell as messages name it.
std::string cell_description(const Netlist& netlist, CellId cell,
                             Language language = Language::english);

/// The netlist as plain text, one cell a line, for tests and people.
std::string write_netlist_text(const Netlist& netlist);

}  // namespace grafwire
