#include "program/run_program.h"

#include <algorithm>
#include <map>

#include "support/evaluate_expression.h"

namespace grafwire::testing {

namespace {

class Machine {
  public:
    Machine(const Grafcet& grafcet, const ScanProgram& program, bool bit_by_bit)
        : grafcet_(grafcet), program_(program), bit_by_bit_(bit_by_bit) {}

    void execute(SectionKind section, Time now) {
        now_ = now;
        for (const Statement& statement : program_.section(section)) {
            if (!bit_by_bit_) {
                execute(statement);
                continue;
            }
            for (const Statement& part : expand_tables(grafcet_, statement)) execute(part);
        }
    }

    std::map<Bit, bool> bits;
    std::map<IntegerCell, std::int64_t> integers;

  private:
    struct Timer {
        bool waits = false;
        Time since = 0;
    };

    /// Reads the counters.
    auto counter() {
        return [this](std::uint32_t number) { return integers[{false, number}]; };
    }

    bool holds(const Condition& condition) {
        std::size_t ones = 0;
        for (const Condition& operand : condition.operands) ones += holds(operand) ? 1 : 0;
        switch (condition.kind) {
            case Condition::Kind::constant:
                return condition.value;
            case Condition::Kind::bit:
                return bits[condition.bit];
            case Condition::Kind::negation:
                return ones == 0;
            case Condition::Kind::conjunction:
                return ones == condition.operands.size();
            case Condition::Kind::disjunction:
                return ones != 0;
            case Condition::Kind::exclusive_or:
                return ones % 2 == 1;
            case Condition::Kind::comparison:
                return value_of(condition.comparison, counter());
        }
        return false;
    }

    void observe(const Statement& statement, bool operand) {
        bool& held = bits[statement.targets[0]];
        Timer& timer = timers_[statement.targets[0]];
        if (operand == held) {
            timer.waits = false;
            return;
        }
        if (!timer.waits) timer = {true, now_};
        const Time length = operand ? statement.on_delay : statement.off_delay;
        if (now_ - timer.since < length) return;
        held = operand;
        timer.waits = false;
    }

    void apply(TableOperation operation) {
        for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
            const auto bit = [&](BitKind table) -> bool& { return bits[Bit{table, s}]; };
            switch (operation) {
                case TableOperation::remember:
                    bit(BitKind::previous) = bit(BitKind::step);
                    break;
                case TableOperation::clear:
                    bit(BitKind::activate) = bit(BitKind::deactivate) = false;
                    bit(BitKind::forced_on) = bit(BitKind::forced_off) = false;
                    break;
                case TableOperation::evolve:
                    bit(BitKind::step) = (bit(BitKind::previous) && !bit(BitKind::deactivate)) ||
                                         bit(BitKind::activate);
                    break;
                case TableOperation::force:
                    bit(BitKind::step) = (bit(BitKind::step) && !bit(BitKind::forced_off)) ||
                                         bit(BitKind::forced_on);
                    break;
                case TableOperation::pulse:
                    bit(BitKind::pulse) = bit(BitKind::step) && !bit(BitKind::previous);
                    break;
            }
        }
    }

    void execute(const Statement& statement) {
        if (statement.kind == Statement::Kind::table) {
            apply(statement.operation);
            return;
        }
        const bool holds_now = holds(statement.condition);
        switch (statement.kind) {
            case Statement::Kind::assign:
                bits[statement.targets[0]] = holds_now;
                break;
            case Statement::Kind::set:
            case Statement::Kind::reset:
                if (!holds_now) break;
                for (const Bit bit : statement.targets) {
                    bits[bit] = statement.kind == Statement::Kind::set;
                }
                break;
            case Statement::Kind::move:
                if (holds_now) {
                    integers[statement.integer] =
                        std::clamp(statement.sum.empty() ? integers[statement.source]
                                                         : value_of(statement.sum, counter()),
                                   statement.low, statement.high);
                }
                break;
            case Statement::Kind::time:
                observe(statement, holds_now);
                break;
            case Statement::Kind::table:
                break;
        }
    }

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    bool bit_by_bit_;
    Time now_ = 0;
    std::map<Bit, Timer> timers_;
};

void add_row(const Grafcet& grafcet, Machine& machine, Time now, Trace& trace) {
    const auto add = [&](BitKind kind, std::size_t count) {
        for (std::uint32_t i = 0; i < count; ++i) {
            trace.values.push_back(machine.bits[Bit{kind, i}] ? 1 : 0);
        }
    };
    trace.times.push_back(now);
    add(BitKind::input, grafcet.inputs.size());
    add(BitKind::control, control_input_count);
    add(BitKind::step, grafcet.steps.size());
    add(BitKind::output, grafcet.outputs.size());
    add(BitKind::var, grafcet.vars.size());
    for (std::uint32_t c = 0; c < grafcet.counters.size(); ++c) {
        trace.values.push_back(machine.integers[{false, c}]);
    }
}

}  // namespace

Trace run_program(const Grafcet& grafcet, const ScanProgram& program, const Stimuli& stimuli,
                  Time period, bool bit_by_bit) {
    Machine machine(grafcet, program, bit_by_bit);
    Trace trace = empty_trace(grafcet);
    std::size_t next = 0;
    for (Time now = 0; now <= stimuli.end; now += period) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& [input, value] : stimuli.changes[next].assignments) {
                const auto declared = static_cast<std::uint32_t>(grafcet.inputs.size());
                const Bit bit = input < declared ? Bit{BitKind::input, input}
                                                 : Bit{BitKind::control, input - declared};
                machine.bits[bit] = value;
            }
        }
        if (now == 0) machine.execute(SectionKind::start, now);
        for (std::size_t s = 1; s < section_count; ++s) {
            machine.execute(static_cast<SectionKind>(s), now);
        }
        add_row(grafcet, machine, now, trace);
    }
    return trace;
}

}  // namespace grafwire::testing
