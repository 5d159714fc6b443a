#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "logic/logic.h"
#include "netlist/netlist.h"
#include "text/time.h"

namespace grafwire {

/// What the delay of a timer is doing.
enum class TimerRun : std::uint8_t {
    idle,
    goes_on,  ///< it ran before the instant, and still does
    ends,     ///< likewise, and it is due: it ends once the gates rest, if they still ask for it
    begun,    ///< it began within the instant
    lost,     ///< it is not known whether it runs, or since when: the output becomes unknown
};

struct TimerState {
    TimerRun run = TimerRun::idle;
    Logic towards = Logic::zero;  ///< what the output becomes when it ends
    bool operator==(const TimerState&) const = default;
};

/// A netlist within an instant.
struct CircuitState {
    std::vector<Logic> values;       ///< per net
    std::vector<TimerState> timers;  ///< in the order of the timer cells
    /// Per pulse cell, in their order: how many edges of its input it has not answered yet.
    std::vector<std::uint8_t> unanswered;
    /// There may have been edges, or there are too many to be counted: the output is unknown.
    static constexpr std::uint8_t unclear = 7;
    bool operator==(const CircuitState&) const = default;
};

/// One thing that a cell can do next.
struct CellAction {
    enum class Kind : std::uint8_t {
        take,    ///< the output takes the value that the inputs ask for
        answer,  ///< a pulse begins, or begins anew
        end_pulse,
        end_delay,  ///< of a timer that is due
    };
    std::uint32_t cell = 0;
    Kind kind = Kind::take;
    bool operator==(const CellAction&) const = default;
};

/// A netlist without a clock as a machine of gates: which of them are *excited* in a state (ask for
/// another value than they show), and what becomes of the state when one of them *fires*. Nothing
/// is said of when. Three values: an unknown one stands for either.
///
/// The cells that nothing which counts depends on are left out: they never fire. The netlist must
/// outlive it.
class Circuit {
  public:
    /// `is_relevant`: per net, whether it counts.
    Circuit(const Netlist& netlist, const std::vector<std::uint8_t>& is_relevant);

    const Netlist& netlist() const { return netlist_; }
    /// The length of the delay that a timer, by number, has begun.
    Time length_of(std::size_t timer, const CircuitState& state) const;

    /// The edges that pulse cells have to answer as an instant begins, where these were the values
    /// before. One whose input or output is unknown may do anything.
    std::vector<std::uint8_t> edges_between(const std::vector<Logic>& before,
                                            const std::vector<Logic>& values) const;

    /// What a timer or pulse cell makes of its input is not known from now on.
    void lose(std::uint32_t cell, CircuitState& state) const;
    /// A pulse cell has answered all edges, and its pulse is over; other cells are left alone.
    void finish_pulse(std::uint32_t cell, CircuitState& state) const;

    /// What the cell can do next, in a fixed order; nothing where it is at rest.
    void append_actions(const CircuitState& state, std::uint32_t cell,
                        std::vector<CellAction>& actions) const;
    /// All that the gates can do next, in the order of cells.
    std::vector<CellAction> actions(const CircuitState& state) const;
    /// The delays that are due and whose operands still ask for it; they end together once nothing
    /// else can happen.
    std::vector<CellAction> ending_delays(const CircuitState& state) const;
    /// All at once.
    void perform(std::span<const CellAction> actions, CircuitState& state) const;

    /// The value that the inputs of a cell ask for; for a pulse cell what it shows.
    Logic asked(const CircuitState& state, std::uint32_t cell) const;
    /// A pin that decides by itself what the gate asks for, if one does, other than `except`.
    NetId deciding_pin(const CircuitState& state, std::uint32_t cell, NetId except) const;

    std::span<const NetId> pins(std::uint32_t cell) const {
        return netlist_.pins_of(netlist_.cells.items()[cell]);
    }
    NetId output(std::uint32_t cell) const { return netlist_.cells.items()[cell].output; }
    CellType type(std::uint32_t cell) const { return netlist_.cells.items()[cell].type; }
    /// The relevant cells that read a net, each once.
    std::span<const std::uint32_t> readers(NetId net) const {
        const std::size_t i = index_of(net);
        return {readers_.data() + first_reader_[i], readers_.data() + first_reader_[i + 1]};
    }
    std::uint32_t pulse_cell(std::size_t pulse) const { return pulses_[pulse]; }
    static constexpr std::uint32_t none = 0xffffffffU;
    /// The relevant cell that drives a net, or none.
    std::uint32_t driver(NetId net) const { return drivers_[index_of(net)]; }
    const std::vector<std::uint32_t>& cells() const { return cells_; }

    /// Everything in which two states of one instant can differ.
    std::string encoded(const CircuitState& state) const;
    /// The inverse; what is not encoded is taken from `like`.
    void decode(std::string_view encoding, CircuitState& like) const;

  private:
    void set_net(NetId net, Logic value, CircuitState& state) const;
    void set_output(std::uint32_t cell, Logic value, CircuitState& state) const;
    void update_timer(std::uint32_t cell, CircuitState& state, bool by_itself) const;
    void see_edge(std::uint32_t cell, Logic from, Logic to, std::uint8_t& unanswered) const;
    Logic asked_by_timer(const CircuitState& state, std::uint32_t cell) const;

    const Netlist& netlist_;
    std::vector<std::uint32_t> cells_;       ///< the relevant ones
    std::vector<std::uint32_t> drivers_;     ///< per net
    std::vector<std::size_t> first_reader_;  ///< per net, and one more
    std::vector<std::uint32_t> readers_;
    std::vector<std::uint32_t> timers_;  ///< all timer cells
    std::vector<std::uint32_t> pulses_;  ///< all pulse cells
    std::vector<std::uint32_t> number_;  ///< per cell: its place in one of these
};

}  // namespace grafwire
