#include "s7/machine/run_listing.h"

#include "trace/input_values.h"

namespace grafwire::s7 {

namespace {

class ListingRunner {
  public:
    ListingRunner(Machine& machine, const Grafcet& grafcet, const Binding& binding,
                  const Stimuli& stimuli)
        : machine_(machine),
          binding_(binding),
          state_(machine.start()),
          player_(stimuli, grafcet.all_input_count()) {
        run_.trace = empty_trace(grafcet);
    }

    ListingRun run(Time end_of_run, Time period) {
        for (Time now = 0; now <= end_of_run; now += period) {
            player_.advance(now);
            const InputImage image = image_of(binding_, player_.inputs());
            const Machine::ScanEnd end = machine_.scan(state_, image, now);
            if (end.error) {
                run_.failure = {now, *end.error};
                break;
            }
            add_row(now);
            if (period > end_of_run - now) break;
        }
        return std::move(run_);
    }

  private:
    void add_row(Time now) {
        Trace& trace = run_.trace;
        trace.times.push_back(now);
        const InputValues& inputs = player_.inputs();
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            trace.values.push_back(binding_.inputs[i] ? inputs[i] : 0);
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
    StimuliPlayer player_;
    ListingRun run_;
};

}  // namespace

ListingRun run_listing(Machine& machine, const Grafcet& grafcet, const Binding& binding,
                       const Stimuli& stimuli, Time period) {
    return ListingRunner(machine, grafcet, binding, stimuli).run(stimuli.end, period);
}

}  // namespace grafwire::s7
