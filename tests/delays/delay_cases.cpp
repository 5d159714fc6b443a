#include "delays/delay_cases.h"

#include <deque>
#include <unordered_set>

namespace grafwire::testing {

std::string key_of(const EvolutionState& state) {
    std::string key;
    const auto add = [&](const BitTable& table) {
        for (std::size_t i = 0; i < table.size(); ++i) key += table.test(i) ? '1' : '0';
        key += ' ';
    };
    for (const BitTable* table : {&state.situation, &state.may_evolve, &state.stored_outputs,
                                  &state.vars, &state.edge_memory, &state.time_values}) {
        add(*table);
    }
    for (const Time due : state.due) key += due == never ? '-' : 'r';
    return key;
}

bool reference_after(const Evolution& evolution, EvolutionState& state, const InputValues& after,
                     DelayEvent event) {
    const Time now = second;
    if (!event.is_input) state.due[event.index] = now;
    evolution.end_delays(state, {after}, now);
    const bool stable = evolution.settle(state, {after}, now).stable;
    for (Time& due : state.due) {
        if (due != never) due = far_away;
    }
    return stable;
}

namespace {

class Explorer {
  public:
    Explorer(const Grafcet& grafcet, const Netlist& netlist, const DelayOptions& options)
        : grafcet_(grafcet),
          netlist_(netlist),
          options_(options),
          evolution_(grafcet),
          orders_(netlist) {}

    DelayReport explore() {
        start();
        while (!open_.empty()) {
            const Product product = std::move(open_.front());
            open_.pop_front();
            for (const DelayEvent& event : events_of(product)) {
                if (report_.cases >= options_.most_cases) {
                    report_.is_complete = false;
                    return report_;
                }
                take(product, event);
            }
        }
        return report_;
    }

  private:
    struct Product {
        InputValues inputs;
        EvolutionState state;
        NetValues nets;
    };

    std::string name_of(NetId net) const { return std::string(netlist_.names[net]); }

    void apply_inputs(const InputValues& inputs, NetValues& nets) const {
        for (std::size_t i = 0; i < netlist_.inputs.size(); ++i) {
            nets.set(netlist_.inputs[i].net, inputs[i] != 0);
        }
    }

    /// With modes a netlist starts with Init, without in its initial values.
    void start() {
        InputValues inputs(grafcet_.all_input_count(), 0);
        if (netlist_.has_modes) inputs[grafcet_.inputs.size()] = 1;
        EvolutionState state = evolution_.start({inputs});
        if (!reference_after(evolution_, state, inputs, {})) return;
        NetValues nets;
        apply_inputs(inputs, nets);
        std::vector<NetId> unknown;
        nets = orders_.power_up(nets, unknown);
        if (!unknown.empty()) {
            report_.first_wrong = "unknown at power-up: " + name_of(unknown[0]);
            return;
        }
        settle({inputs, state, nets}, "at power-up");
    }

    std::vector<DelayEvent> events_of(const Product& product) const {
        std::vector<DelayEvent> events;
        const std::size_t inputs = netlist_.has_modes && options_.with_controls
                                       ? grafcet_.all_input_count()
                                       : grafcet_.inputs.size();
        for (std::size_t i = 0; i < inputs; ++i) events.push_back({true, i});
        if (netlist_.has_modes && !options_.with_controls &&
            product.inputs[grafcet_.inputs.size()] != 0) {
            events = {{true, grafcet_.inputs.size()}};  // only the Init of power-up ends
        }
        for (std::size_t i = 0; i < product.state.due.size(); ++i) {
            if (product.state.due[i] != never) events.push_back({false, i});
        }
        return events;
    }

    std::string words_for(const Product& product, DelayEvent event) const {
        std::string text = "in {";
        for (std::size_t i = 0; i < grafcet_.steps.size(); ++i) {
            if (product.state.situation.test(i)) {
                text += " " + grafcet_.steps[grafcet_.steps.id_at(i)].name;
            }
        }
        text += " }";
        for (std::size_t i = 0; i < product.inputs.size(); ++i) {
            if (product.inputs[i] != 0) text += " " + std::string(input_name(grafcet_, i));
        }
        if (!event.is_input) return text + ", time condition " + std::to_string(event.index);
        return text + ", " + std::string(input_name(grafcet_, event.index)) + " changes";
    }

    void take(const Product& product, DelayEvent event) {
        Product next = product;
        if (event.is_input) next.inputs[event.index] ^= 1U;
        if (broken_assumption(grafcet_, next.inputs) != grafcet_.assumptions.size()) return;
        if (!reference_after(evolution_, next.state, next.inputs, event)) {
            ++report_.unstable;
            return;
        }
        if (options_.is_ordered &&
            options_.is_ordered({product.state, product.inputs, next.inputs, event})) {
            ++report_.ordered;
            return;
        }
        apply_inputs(next.inputs, next.nets);
        const std::string words = words_for(product, event);
        if (!event.is_input && !fire_timer(event.index, next.nets)) {
            wrong(words + ": the timer does not run");
            return;
        }
        settle(std::move(next), words);
    }

    /// A condition that nothing in the netlist reads has no timer.
    bool fire_timer(std::size_t condition, NetValues& nets) const {
        for (const GateOrders::Timer& timer : orders_.timers()) {
            if (timer.condition != condition) continue;
            if (!nets.get(timer.operand) || nets.get(timer.output)) return false;
            nets.set(timer.output, true);
        }
        return true;
    }

    void wrong(const std::string& words) {
        ++report_.cases;
        if (report_.first_wrong.empty()) report_.first_wrong = words;
    }

    void settle(Product product, const std::string& words) {
        const GateOrders::Outcomes outcomes =
            orders_.outcomes(product.nets, options_.firing, options_.most_states);
        report_.most_states = std::max(report_.most_states, outcomes.states);
        if (!outcomes.is_complete) {
            ++report_.too_large;
            report_.is_complete = false;
            return;
        }
        if (outcomes.may_oscillate) return wrong(words + ": may oscillate");
        for (const NetValues& nets : outcomes.stable) {
            const std::string fault = difference(product, nets);
            if (!fault.empty()) return wrong(words + ": " + fault);
        }
        ++report_.cases;
        ++report_.right;
        for (const NetValues& nets : outcomes.stable) {
            product.nets = nets;
            if (seen_.insert(key(product)).second) open_.push_back(product);
        }
    }

    std::string difference(const Product& product, const NetValues& nets) const {
        const OutputValues outputs = evolution_.outputs(product.state, {product.inputs});
        for (std::size_t i = 0; i < netlist_.outputs.size(); ++i) {
            const Port& port = netlist_.outputs[i];
            const bool expected = i < netlist_.step_count ? product.state.situation.test(i)
                                                          : outputs.test(i - netlist_.step_count);
            if (nets.get(port.net) != expected) {
                return port.name + " can be " + (expected ? "0, expected 1" : "1, expected 0");
            }
        }
        for (const Observed& var : netlist_.vars) {
            for (std::size_t i = 0; i < grafcet_.vars.size(); ++i) {
                const VarId id = grafcet_.vars.id_at(i);
                if (grafcet_.vars[id].name == var.name &&
                    nets.get(var.bits[0]) != evolution_.var(id, product.state, {product.inputs})) {
                    return var.name + " can be wrong";
                }
            }
        }
        return {};
    }

    static std::string key(const Product& product) {
        std::string key(product.inputs.begin(), product.inputs.end());
        key += key_of(product.state);
        for (const std::uint64_t word : product.nets.words) key += std::to_string(word) + " ";
        return key;
    }

    const Grafcet& grafcet_;
    const Netlist& netlist_;
    const DelayOptions& options_;
    Evolution evolution_;
    GateOrders orders_;
    std::deque<Product> open_;
    std::unordered_set<std::string> seen_;
    DelayReport report_;
};

}  // namespace

DelayReport explore_delays(const Grafcet& grafcet, const Netlist& netlist,
                           const DelayOptions& options) {
    return Explorer(grafcet, netlist, options).explore();
}

}  // namespace grafwire::testing
