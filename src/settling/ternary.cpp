// What does not depend on delays: ternary simulation (E. B. Eichelberger, "Hazard detection in
// combinational and sequential switching circuits", IBM J. Res. Dev. 9, 1965).
//
// Two passes. The first lets every gate that is excited become unknown beside what it was, until no
// more do: then every value that a net can have on the way, in any order of firings, is one that
// the state allows. The second lets gates take what their inputs ask for where that is known: what
// has become known in the end is so in every order, once all gates have had their time. Both take
// as many steps as there are gates, where going through the orders may take exponentially many.
//
// It is a safe answer for gates of any delay, and an exact one for gates and wires of any delay (J.
// A. Brzozowski, C.-J. H. Seger, "Asynchronous Circuits", 1995, chapter 7; from a state that is not
// at rest: the same, UBC TR-94-02, 1994).

#include "settling/ternary.h"

#include <algorithm>

namespace grafwire {

namespace {

class TwoPasses {
  public:
    TwoPasses(const Circuit& circuit, const CircuitState& start)
        : circuit_(circuit), state_(start), becomes_unclear_(circuit.netlist().cells.size()) {}

    CircuitState make() {
        spread();
        settle();
        return std::move(state_);
    }

  private:
    Logic shown(std::uint32_t cell) const { return state_.values[index_of(circuit_.output(cell))]; }

    /// A net can have either value; what timers and pulse cells make of it is not known.
    void make_unknown(std::uint32_t cell) {
        const NetId net = circuit_.output(cell);
        state_.values[index_of(net)] = Logic::unknown;
        for (const std::uint32_t reader : circuit_.readers(net)) {
            const CellType type = circuit_.type(reader);
            if (type == CellType::timer || is_pulse(type)) becomes_unclear_[reader] = 1;
            waiting_.push_back(reader);
        }
    }

    void spread() {
        waiting_ = circuit_.cells();
        std::vector<CellAction> actions;
        while (!waiting_.empty()) {
            const std::uint32_t cell = waiting_.back();
            waiting_.pop_back();
            if (shown(cell) == Logic::unknown) continue;
            actions.clear();
            circuit_.append_actions(state_, cell, actions);
            if (!actions.empty() || becomes_unclear_[cell] != 0) make_unknown(cell);
        }
    }

    void settle() {
        for (const std::uint32_t cell : circuit_.cells()) {
            if (becomes_unclear_[cell] != 0) {
                circuit_.lose(cell, state_);
            } else {
                circuit_.finish_pulse(cell, state_);
            }
        }
        waiting_ = circuit_.cells();
        while (!waiting_.empty()) {
            const std::uint32_t cell = waiting_.back();
            waiting_.pop_back();
            const NetId net = circuit_.output(cell);
            if (state_.values[index_of(net)] != Logic::unknown || becomes_unclear_[cell] != 0) {
                continue;
            }
            const Logic asked = circuit_.asked(state_, cell);
            if (asked == Logic::unknown) continue;
            state_.values[index_of(net)] = asked;
            const auto readers = circuit_.readers(net);
            waiting_.insert(waiting_.end(), readers.begin(), readers.end());
        }
    }

    const Circuit& circuit_;
    CircuitState state_;
    /// Per timer and pulse cell, 1 where its input has become unknown on the way.
    std::vector<std::uint8_t> becomes_unclear_;
    std::vector<std::uint32_t> waiting_;
};

}  // namespace

CircuitState ternary_rest(const Circuit& circuit, const CircuitState& start) {
    CircuitState state = TwoPasses(circuit, start).make();
    for (;;) {
        const std::vector<CellAction> ends = circuit.ending_delays(state);
        if (ends.empty()) return state;
        circuit.perform(ends, state);
        state = TwoPasses(circuit, state).make();
    }
}

bool is_known(const Circuit& circuit, const CircuitState& state) {
    return std::none_of(circuit.cells().begin(), circuit.cells().end(), [&](std::uint32_t cell) {
        return state.values[index_of(circuit.output(cell))] == Logic::unknown;
    });
}

std::optional<Rests> rest_of_all_delays(const Circuit& circuit, const CircuitState& start) {
    CircuitState rest = ternary_rest(circuit, start);
    if (!is_known(circuit, rest)) return std::nullopt;
    Rests rests;
    rests.rests.emplace_back().state = std::move(rest);
    rests.states = 1;
    return rests;
}

}  // namespace grafwire
