#include "referee/scanned_program.h"

#include "referee/pair_run.h"
#include "referee/random_walk.h"

namespace grafwire::testing {

namespace {

/// One scan of both; says in words where they differ.
std::string differ_in_scan(const Grafcet& grafcet, ReferenceRun& reference, ScannedProgram& program,
                           Time now, const InputValues& inputs) {
    reference.scan(now, inputs);
    program.scan(now, inputs);
    const std::vector<bool> expected = reference.shown(inputs);
    const std::vector<bool> got = program.shown();
    if (expected == got) return {};
    return "at " + format_milliseconds(now) + " ms" + differences(grafcet, expected, got);
}

}  // namespace

ScanWalk random_scans(const Grafcet& grafcet, ScannedProgram& program, Time period, bool controls,
                      RandomSource& random, std::size_t length) {
    ScanWalk walk;
    ReferenceRun reference(grafcet, random.one_in(4));
    RandomInputs inputs(grafcet, random, controls);
    if (!inputs.begin()) return walk;
    InputValues before(inputs.values().size(), 0);
    reference.start(inputs.values());
    program.start();
    for (Time now = 0; walk.scans < length && walk.contradiction.empty(); now += period) {
        if (walk.scans != 0 && random.flip()) inputs.change(Happens::many_things);
        Stimuli::Change change = change_between(before, inputs.values(), now);
        if (!change.assignments.empty()) walk.stimuli.changes.push_back(std::move(change));
        before = inputs.values();
        walk.contradiction = differ_in_scan(grafcet, reference, program, now, before);
        walk.stimuli.end = now;
        ++walk.scans;
    }
    return walk;
}

ScanWalk replayed_scans(const Grafcet& grafcet, ScannedProgram& program, const Stimuli& stimuli,
                        Time period, bool is_plain) {
    ScanWalk walk{stimuli, 0, {}};
    ReferenceRun reference(grafcet, is_plain);
    InputValues inputs(grafcet.all_input_count(), 0);
    std::size_t next = 0;
    program.start();
    for (Time now = 0; now <= stimuli.end && walk.contradiction.empty(); now += period) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& set : stimuli.changes[next].assignments) {
                inputs[set.input] = set.value ? 1 : 0;
            }
        }
        if (now == 0) reference.start(inputs);
        walk.contradiction = differ_in_scan(grafcet, reference, program, now, inputs);
        ++walk.scans;
    }
    return walk;
}

}  // namespace grafwire::testing
