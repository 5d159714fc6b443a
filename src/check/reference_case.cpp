// Which inputs have to be varied.
//
// A GRAFCET with 15 inputs has 2^15 input vectors, hence 2^15 ways to leave every state; but in a
// given situation nothing reads nearly all of them. So inputs stay unassigned, as don't-cares,
// until something reads them: the reference runs with unassigned inputs as 0 and notes which of
// them it consulted. Its result is then that of every input vector that agrees on the consulted
// ones. The rest of the vectors are split by those: with a, b consulted, the run stands for /a./b,
// and a and /a.b are further cases, explored the same way. Together the cases are all vectors, each
// once (a cover by disjoint cubes, found as in a search that branches on demand).
//
// Sound for the reference because what was not consulted cannot have influenced the result (the
// evolution reads an input only where its value is used). It covers transient situations too: an
// input that is read only in a step passed on the way is consulted there. Inputs read by edges and
// time conditions are consulted in every scan, so their memories never depend on an unassigned
// input.
//
// Sound for the netlist because there the unassigned inputs are simulated as unknown, and whatever
// comes out known is the same for both values; where an X, an output or a memory comes out unknown,
// the exploration splits the case by the input it stems from and compares both halves
// (exploration.cpp). So a wrong netlist that reacts to an input where the GRAFCET does not is found
// as well.

#include "check/reference_case.h"

#include <algorithm>

namespace grafwire {

namespace {

/// What the reference reads in a case: unassigned inputs as 0, and which inputs it looks at.
struct CaseInputs {
    explicit CaseInputs(const PartialInputs& inputs)
        : partial(inputs), values(inputs.size()), consulted(inputs.size()) {
        for (std::size_t i = 0; i < inputs.size(); ++i) values[i] = inputs[i] == PartialInput::one;
    }
    EvolutionInputs read(std::vector<std::uint8_t>* cleared = nullptr) {
        return {values, &consulted, cleared};
    }

    /// Tells an outcome which unassigned inputs were looked at.
    void assign_consulted(ReferenceOutcome& outcome) const {
        outcome.inputs = partial;
        for (std::uint32_t i = 0; i < partial.size(); ++i) {
            if (consulted[i] == 0 || partial[i] != PartialInput::unassigned) continue;
            outcome.inputs[i] = PartialInput::zero;
            outcome.assigned.push_back(i);
        }
    }

    const PartialInputs& partial;
    InputValues values;
    std::vector<std::uint8_t> consulted;
};

/// A case of the reference from its beginning: the state it starts from, and what it reads.
struct Case {
    Case(const Evolution& evolution, const EvolutionState* start, const PartialInputs& inputs)
        : given(inputs), read(given.read(&outcome.cleared)) {
        outcome.cleared.resize(evolution.grafcet().transitions.size());
        outcome.state = start == nullptr ? evolution.start(read) : *start;
    }
    void fall_due(const std::vector<std::uint32_t>& conditions) {
        for (const std::uint32_t condition : conditions) outcome.state.due[condition] = 0;
    }
    ReferenceOutcome finish(const Evolution& evolution) {
        if (outcome.stable) outcome.outputs = evolution.outputs(outcome.state, read);
        given.assign_consulted(outcome);
        return std::move(outcome);
    }

    ReferenceOutcome outcome;
    CaseInputs given;
    EvolutionInputs read;
};

}  // namespace

ReferenceOutcome ReferenceCases::instant(const EvolutionState* start,
                                         const std::vector<std::uint32_t>& due,
                                         const PartialInputs& inputs) const {
    Case one(evolution_, start, inputs);
    one.fall_due(due);
    if (!due.empty()) evolution_.end_delays(one.outcome.state, one.read, 0);
    SettleResult result = evolution_.settle(one.outcome.state, one.read, 0, keep_going_);
    one.outcome.stable = result.stable;
    one.outcome.broken_off = result.broken_off;
    one.outcome.changing = std::move(result.changing);
    return one.finish(evolution_);
}

ReferenceCases::Changes ReferenceCases::changes(const EvolutionState& start,
                                                const std::vector<std::uint32_t>& due,
                                                const PartialInputs& inputs,
                                                const std::vector<Logic>& before) const {
    Case one(evolution_, &start, inputs);
    one.fall_due(due);
    EvolutionState& state = one.outcome.state;
    if (!due.empty()) evolution_.end_delays(state, one.read, 0);
    Changes changes{std::vector<std::uint8_t>(before.size()), {}};
    std::vector<Logic> values = before;
    const auto note = [&](std::size_t i, bool value) {
        if (values[i] == logic_of(value)) return;
        values[i] = logic_of(value);
        if (changes.counts[i] < most_changes) ++changes.counts[i];
    };
    const std::size_t steps = evolution_.grafcet().steps.size();
    EvolutionState last;
    do {
        last = state;
        evolution_.scan(state, one.read, 0);
        const OutputValues outputs = evolution_.outputs(state, one.read);
        for (std::size_t i = 0; i < before.size(); ++i) {
            note(i, i < steps ? state.situation.test(i) : outputs.test(i - steps));
        }
    } while (!Evolution::is_settled(last, state) && !(keep_going_ && !keep_going_()));
    one.given.assign_consulted(one.outcome);
    changes.assigned = std::move(one.outcome.assigned);
    return changes;
}

ReferenceOutcome ReferenceCases::scan_after(const EvolutionState* start,
                                            const std::vector<std::uint32_t>& due,
                                            const PartialInputs& inputs) const {
    Case one(evolution_, start, inputs);
    one.fall_due(due);
    evolution_.scan(one.outcome.state, one.read, 0);
    return one.finish(evolution_);
}

ReferenceOutcome ReferenceCases::scan(const EvolutionState* start, const PartialInputs& inputs,
                                      Time now) const {
    Case one(evolution_, start, inputs);
    evolution_.scan(one.outcome.state, one.read, now);
    return one.finish(evolution_);
}

std::vector<std::uint32_t> ReferenceCases::unread_inputs(const EvolutionState& state,
                                                         const PartialInputs& inputs) const {
    CaseInputs given(inputs);
    EvolutionState again = state;
    evolution_.scan(again, given.read(), 0);
    std::vector<std::uint32_t> unread;
    for (std::uint32_t i = 0; i < inputs.size(); ++i) {
        if (given.consulted[i] == 0 && inputs[i] != PartialInput::unassigned) unread.push_back(i);
    }
    return unread;
}

void for_each_case(const Assumptions& assumptions, const PartialInputs& inputs,
                   const std::function<ReferenceOutcome(const PartialInputs&)>& run,
                   const std::function<bool(const ReferenceOutcome&)>& visit) {
    std::vector<PartialInputs> remaining{inputs};
    while (!remaining.empty()) {
        const PartialInputs some = std::move(remaining.back());
        remaining.pop_back();
        if (!assumptions.can_hold(some)) continue;
        const ReferenceOutcome outcome = run(some);
        if (outcome.broken_off) {
            visit(outcome);
            return;
        }
        PartialInputs other = some;
        for (const std::uint32_t input : outcome.assigned) {
            other[input] = PartialInput::one;
            remaining.push_back(other);
            other[input] = PartialInput::zero;
        }
        if (assumptions.can_hold(outcome.inputs) && !visit(outcome)) return;
    }
}

}  // namespace grafwire
