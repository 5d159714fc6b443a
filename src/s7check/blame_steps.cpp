// Tables of steps that are wrong: Ta, Td and Tp, Tf0 and Tf1. A deviation counts only if the result
// for its step, `Tp . /Td + Ta` or `Ts . /Tf0 + Tf1`, is another one.
//
// The network to blame is the one that wrote the bit last. But where a bit is 0 and should be 1
// that is mostly the one that clears the table; then it is the one that should have set it: it
// reads the transition (of Ta and Td) or the forcing step (of Tf0 and Tf1), and sets something.

#include <algorithm>

#include "s7check/investigation.h"

namespace grafwire {

namespace {

constexpr Suspects::Bytes ta_and_td{40, 20};
constexpr Suspects::Bytes tf1_and_tf0{60, 20};

}  // namespace

Investigation::Deviation Investigation::in_evolution() {
    for (std::size_t s = 0; s < binding_.steps.size(); ++s) {
        const bool previous = got_in(MethodTables::previous, s);
        const bool on = got_in(MethodTables::activate, s);
        const bool off = got_in(MethodTables::deactivate, s);
        if (((previous && !off) || on) == expected_.evolved.test(s)) continue;
        if (on != expected_.activate.test(s)) {
            return set_by_transition(Kind::activate, MethodTables::activate, s, !on);
        }
        if (off != expected_.deactivate.test(s)) {
            return set_by_transition(Kind::deactivate, MethodTables::deactivate, s, !off);
        }
        const Operand place = MethodTables::in(MethodTables::previous, step_place(s));
        return suspects_.written(Kind::previous, step_name(s), place, !previous);
    }
    return std::nullopt;
}

Finding Investigation::set_by_transition(Kind kind, MethodTables::Distance distance,
                                         std::size_t step, bool expected) {
    const Operand place = MethodTables::in(distance, step_place(step));
    Finding finding = suspects_.written(kind, step_name(step), place, expected);
    if (!expected) return finding;
    for (std::size_t t = 0; t < binding_.transitions.size(); ++t) {
        const Transition& transition = grafcet_.transitions[static_cast<TransitionId>(t)];
        const auto steps = kind == Kind::activate ? grafcet_.following(transition)
                                                  : grafcet_.preceding(transition);
        const bool concerns =
            std::find(steps.begin(), steps.end(), static_cast<StepId>(step)) != steps.end();
        if (!expected_.cleared.test(t) || !concerns) continue;
        // The network that reads the transition, then those that work for its preceding steps.
        for (const StepId before : grafcet_.preceding(transition)) {
            suspects_.blame_instead(finding,
                                    suspects_.setters_for_step(index_of(before), ta_and_td));
        }
        suspects_.blame_instead(finding, suspects_.setters_for(*binding_.transitions[t]));
    }
    return finding;
}

Investigation::Deviation Investigation::in_forcing() {
    for (std::size_t s = 0; s < binding_.steps.size(); ++s) {
        const bool on = got_in(MethodTables::forced_on, s);
        const bool off = got_in(MethodTables::forced_off, s);
        const bool evolved = expected_.evolved.test(s);
        const bool expected =
            (evolved && !expected_.forced_off.test(s)) || expected_.forced_on.test(s);
        if (((evolved && !off) || on) == expected) continue;
        if (on != expected_.forced_on.test(s)) {
            return set_by_order(Kind::forced_on, MethodTables::forced_on, s, !on);
        }
        return set_by_order(Kind::forced_off, MethodTables::forced_off, s, !off);
    }
    return std::nullopt;
}

Finding Investigation::set_by_order(Kind kind, MethodTables::Distance distance, std::size_t step,
                                    bool expected) {
    const Operand place = MethodTables::in(distance, step_place(step));
    Finding finding = suspects_.written(kind, step_name(step), place, expected);
    if (!expected) return finding;
    const GraphId graph = grafcet_.steps[static_cast<StepId>(step)].graph;
    for (const Order& order : grafcet_.orders) {
        const std::size_t giving = index_of(order.step);
        if (order.graph != graph || order.kind == OrderKind::freeze ||
            !expected_.evolved.test(giving)) {
            continue;
        }
        const auto setters = suspects_.setters_for_step(giving, tf1_and_tf0);
        // They cannot have set it where they found the forcing step inactive: then Ts had not been
        // worked out.
        for (const std::uint32_t network : setters) {
            if (suspects_.read_as(step_place(giving), network).value_or(true)) continue;
            Finding earlier =
                suspects_.written(Kind::situation, step_name(giving), step_place(giving), true);
            suspects_.blame_instead(earlier, suspects_.silent_writers_of_ts());
            return earlier;
        }
        suspects_.blame_instead(finding, setters);
    }
    return finding;
}

}  // namespace grafwire
