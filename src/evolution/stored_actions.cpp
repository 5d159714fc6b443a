// Stored actions (the end of SBR 5).
//
// All that is to be written is read first, with variables as they were, and put in a list in the
// order of writing: on deactivation, on clearing, on activation, on another event, each kind in
// table order. Then the list is written from front to back, so that the last write to a variable
// wins. Two `c := c + 1` in one scan therefore count one.

#include <algorithm>
#include <cassert>

#include "evolution/bits.h"
#include "evolution/scan_parts.h"

namespace grafwire {

namespace {

struct PendingWrite {
    Variable target;
    std::int64_t value = 0;
};
using PendingWrites = SmallList<PendingWrite, 32>;

std::int64_t value_of(const ScanContext& scan, const Write& write) {
    if (write.operation == WriteOperation::set) return 1;
    if (write.operation == WriteOperation::reset) return 0;
    if (write.target.kind == VariableKind::counter) {
        const Counter& counter = scan.grafcet.counters[CounterId{write.target.index}];
        return scan.read.sum(scan.grafcet.sums[write.sum]).held_within(counter.low, counter.high);
    }
    return scan.read.value(write.value) ? 1 : 0;
}

void list_actions_of(const ScanContext& scan, std::size_t s, Trigger trigger,
                     PendingWrites& writes) {
    const Step& step = scan.grafcet.steps[scan.grafcet.steps.id_at(s)];
    for (const Action& action : scan.grafcet.actions_of(step)) {
        if (action.kind != ActionKind::stored || action.trigger != trigger) continue;
        if (trigger == Trigger::event && !scan.read.value(action.expression)) continue;
        writes.push_back({action.write.target, value_of(scan, action.write)});
    }
}

/// The actions of the steps in `candidates` that are in `now` and not in `before`.
void list_changed(const ScanContext& scan, const BitTable& candidates, const BitTable& now,
                  const BitTable& before, Trigger trigger, PendingWrites& writes) {
    for (std::size_t w = 0; w < candidates.words().size(); ++w) {
        const std::uint64_t changed = candidates.words()[w] & now.words()[w] & ~before.words()[w];
        for_each_bit_of_word(
            changed, w, [&](std::size_t step) { list_actions_of(scan, step, trigger, writes); });
    }
}

void list_clearing(const ScanContext& scan, const ClearedList& cleared, PendingWrites& writes) {
    ClearedList with_actions;
    for (const TransitionId id : cleared) {
        if (scan.grafcet.transitions[id].clearing.count != 0) with_actions.push_back(id);
    }
    std::sort(with_actions.begin(), with_actions.end());
    for (const TransitionId id : with_actions) {
        for (const ClearingAction& action :
             scan.grafcet.clearing_actions_of(scan.grafcet.transitions[id])) {
            writes.push_back({action.write.target, value_of(scan, action.write)});
        }
    }
}

void write_all(const PendingWrites& writes, EvolutionState& state) {
    for (const PendingWrite& write : writes) {
        switch (write.target.kind) {
            case VariableKind::output:
                state.stored_outputs.assign(write.target.index, write.value != 0);
                break;
            case VariableKind::var:
                state.vars.assign(write.target.index, write.value != 0);
                break;
            case VariableKind::counter:
                state.counters[write.target.index] = write.value;
                break;
            default:
                assert(false);  // nothing else can be written
        }
    }
}

}  // namespace

void run_stored_actions(const ScanContext& scan, const ClearedList& cleared) {
    const EvolutionTables& tables = scan.tables;
    const BitTable& after = scan.state.situation;
    const BitTable& before = scan.state.previous;
    PendingWrites writes;
    if (tables.any_stored_step_action) {
        list_changed(scan, tables.on_deactivation, before, after, Trigger::deactivation, writes);
    }
    list_clearing(scan, cleared, writes);
    if (tables.any_stored_step_action) {
        list_changed(scan, tables.on_activation, after, before, Trigger::activation, writes);
        for_each_common_bit(after, tables.on_event, [&](std::size_t step) {
            list_actions_of(scan, step, Trigger::event, writes);
        });
    }
    write_all(writes, scan.state);
}

}  // namespace grafwire
