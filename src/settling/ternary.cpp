// What does not depend on delays: ternary simulation (E. B. Eichelberger, "Hazard detection in
// combinational and sequential switching circuits", IBM J. Res. Dev. 9, 1965).
//
// Two passes. The first lets every gate that is excited become unknown beside what it was, until no
// more do (reach.h). The second lets gates take what their inputs ask for where that is known: what
// has become known in the end is so in every order, once all gates have had their time. Both take
// as many steps as there are gates, where going through the orders may take exponentially many.
//
// It is a safe answer for gates of any delay, and an exact one for gates and wires of any delay (J.
// A. Brzozowski, C.-J. H. Seger, "Asynchronous Circuits", 1995, chapter 7; from a state that is not
// at rest: the same, UBC TR-94-02, 1994).

#include "settling/ternary.h"

#include <algorithm>

#include "settling/reach.h"

namespace grafwire {

namespace {

class TwoPasses {
  public:
    TwoPasses(const Circuit& circuit, const CircuitState& start)
        : circuit_(circuit), reach_(circuit), state_(start) {}

    CircuitState make() {
        std::vector<std::uint32_t> excited;
        for (const CellAction& action : circuit_.actions(state_)) excited.push_back(action.cell);
        reach_.make(state_, excited, std::vector<std::uint8_t>(circuit_.netlist().cells.size()));
        state_ = reach_.state();
        settle();
        return std::move(state_);
    }

  private:
    void settle() {
        for (const std::uint32_t cell : circuit_.cells()) {
            if (reach_.is_unclear(cell)) {
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
            if (state_.values[index_of(net)] != Logic::unknown || reach_.is_unclear(cell)) {
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
    Reach reach_;
    CircuitState state_;
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
