#include "s7/run_generated.h"

#include <fmt/format.h>

#include <algorithm>

#include "s7/machine/machine.h"

namespace grafwire::testing {

namespace {

/// A generated program in the machine, with its inputs and what is to be seen of it.
class Run {
  public:
    Run(const s7::AssignedListing& generated, const Grafcet& grafcet)
        : generated_(generated),
          grafcet_(grafcet),
          machine_(generated.listing, s7::Cpu::cpu_214),
          state_(machine_.start()),
          inputs_(grafcet.all_input_count(), 0) {
        leave_traces();
    }

    void set(std::uint32_t input, bool value) {
        inputs_[input] = value ? 1 : 0;
        const s7::Operand* operand = find(input_name(grafcet_, input));
        if (operand == nullptr) return;  // a control input that the program does not read
        const auto mask = static_cast<std::uint8_t>(1U << operand->bit);
        std::uint8_t& byte = image_.value.at(static_cast<std::size_t>(operand->address));
        byte = static_cast<std::uint8_t>(value ? byte | mask : byte & ~mask);
    }

    std::string scan(Time now) {
        const auto end = machine_.scan(state_, image_, now);
        if (end.is_done()) return {};
        return end.error
                   ? fmt::format("network {}: {}", end.error->network, end.error->message.english)
                   : "an input is open";
    }

    void add_row(Time now, Trace& trace) {
        trace.times.push_back(now);
        for (const std::uint8_t value : inputs_) trace.values.push_back(value);
        for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
            add_bit(variable_name(grafcet_, {VariableKind::step, s}), trace);
        }
        for (const Output& output : grafcet_.outputs) add_bit(output.name, trace);
        for (const Var& var : grafcet_.vars) add_bit(var.name, trace);
        for (const Counter& counter : grafcet_.counters) {
            const s7::Operand& operand = *find(counter.name);
            const std::int32_t value = machine_.value(state_, operand);
            trace.values.push_back(
                operand.width == s7::Width::word ? static_cast<std::int16_t>(value) : value);
        }
    }

  private:
    /// The memory as an earlier program may have left it: nothing of it is 0.
    void leave_traces() {
        for (const s7::Area area : {s7::Area::output, s7::Area::variable}) {
            const s7::Operand first{area, s7::Width::bit, 0, 0, {}};
            const std::size_t from = machine_.memory_bit(first) / 8;
            const auto size =
                static_cast<std::size_t>(s7::size_of_area(s7::row_of(s7::Cpu::cpu_214), area));
            std::fill_n(state_.memory.begin() + static_cast<std::ptrdiff_t>(from), size,
                        std::uint8_t{0xff});
        }
        for (s7::TimerState& timer : state_.timers) timer.bit = true;
    }

    const s7::Operand* find(std::string_view name) const {
        return generated_.assignment.operand_of(name);
    }

    void add_bit(std::string_view name, Trace& trace) const {
        trace.values.push_back(machine_.bit(state_, *find(name)).is_one() ? 1 : 0);
    }

    const s7::AssignedListing& generated_;
    const Grafcet& grafcet_;
    s7::Machine machine_;
    s7::MachineState state_;
    s7::InputImage image_;
    std::vector<std::uint8_t> inputs_;
};

}  // namespace

Trace run_generated(const s7::AssignedListing& generated, const Grafcet& grafcet,
                    const Stimuli& stimuli, Time period, std::string& problem) {
    Run run(generated, grafcet);
    Trace trace = empty_trace(grafcet);
    std::size_t next = 0;
    for (Time now = 0; now <= stimuli.end; now += period) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& [input, value] : stimuli.changes[next].assignments) {
                run.set(input, value);
            }
        }
        problem = run.scan(now);
        if (!problem.empty()) return trace;
        run.add_row(now, trace);
    }
    return trace;
}

}  // namespace grafwire::testing
