#include "s7/machine/run_listing.h"

namespace grafwire::s7 {

namespace {

class ListingRunner {
  public:
    ListingRunner(Machine& machine, const Grafcet& grafcet, const Binding& binding)
        : machine_(machine),
          binding_(binding),
          state_(machine.start()),
          inputs_(grafcet.all_input_count(), 0) {
        run_.trace = empty_trace(grafcet);
    }

    ListingRun run(const Stimuli& stimuli, Time period) {
        std::size_t next = 0;
        for (Time now = 0; now <= stimuli.end; now += period) {
            for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
                for (const Stimuli::Assignment& set : stimuli.changes[next].assignments) {
                    inputs_[set.input] = set.value ? 1 : 0;
                }
            }
            const Machine::ScanEnd end = machine_.scan(state_, image_of(binding_, inputs_), now);
            if (end.error) {
                run_.failure = {now, *end.error};
                break;
            }
            add_row(now);
            if (period > stimuli.end - now) break;
        }
        return std::move(run_);
    }

  private:
    void add_row(Time now) {
        Trace& trace = run_.trace;
        trace.times.push_back(now);
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            trace.values.push_back(binding_.inputs[i] ? inputs_[i] : 0);
        }
        add_bits(binding_.steps);
        add_bits(binding_.outputs);
        add_bits(binding_.vars);
        for (const auto& counter : binding_.counters) {
            trace.values.push_back(counter ? machine_.value(state_, *counter) : 0);
        }
    }

    void add_bits(const std::vector<std::optional<Operand>>& operands) {
        for (const auto& operand : operands) {
            run_.trace.values.push_back(operand && machine_.bit(state_, *operand).is_one() ? 1 : 0);
        }
    }

    Machine& machine_;
    const Binding& binding_;
    MachineState state_;
    InputValues inputs_;
    ListingRun run_;
};

}  // namespace

ListingRun run_listing(Machine& machine, const Grafcet& grafcet, const Binding& binding,
                       const Stimuli& stimuli, Time period) {
    return ListingRunner(machine, grafcet, binding).run(stimuli, period);
}

}  // namespace grafwire::s7
