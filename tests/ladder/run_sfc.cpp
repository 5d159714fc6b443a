#include "ladder/run_sfc.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

#include "ladder/ladder_from.h"
#include "plcopen/write_project.h"

namespace grafwire::testing {

WrittenSfc::WrittenSfc(const Grafcet& grafcet) {
    const ScanProgram program = program_from(grafcet, {});
    Diagnostics diagnostics;
    const ladder::Ladder ladder = ladder::ladder_from(grafcet, program, diagnostics);
    REQUIRE(!diagnostics.has_errors());
    xml = plcopen::write_sfc_project(grafcet);
    // Both have the same names.
    const std::vector<std::string> identifiers = plcopen::identifiers_of(ladder);
    for (std::size_t v = 0; v < ladder.declared; ++v) {
        names.emplace_back(ladder.variables[v].name, identifiers[v]);
    }
    const std::size_t name = xml.find("<pou name=\"") + 11;
    sfc = read_sfc(xml, xml.substr(name, xml.find('"', name) - name));
}

SfcRun run_sfc(const Grafcet& grafcet, const WrittenSfc& written, const SfcDialect& dialect,
               const Stimuli& stimuli, Time period) {
    SfcRun run{empty_trace(grafcet), {}};
    SfcMachine machine(written.sfc, dialect);
    const std::map<std::string, std::string> names(written.names.begin(), written.names.end());
    const std::size_t last = written.sfc.actions.size() - 1;
    std::vector<bool> inputs(grafcet.all_input_count(), false);
    std::size_t next = 0;
    for (Time now = 0; now <= stimuli.end; now += period) {
        for (; next < stimuli.changes.size() && stimuli.changes[next].at <= now; ++next) {
            for (const auto& [input, value] : stimuli.changes[next].assignments) {
                inputs[input] = value;
                machine.set_input(names.at(std::string(input_name(grafcet, input))), value);
            }
        }
        SfcScanReport report = machine.scan(now);
        // The last action reads what others have written, as the file says.
        for (SfcScanReport::Meeting& meeting : report.meetings) {
            if (meeting.second == last) meeting.variables = meeting.written_by_both;
        }
        std::erase_if(report.meetings,
                      [](const auto& meeting) { return meeting.variables.empty(); });
        if (!report.selections.empty() || !report.meetings.empty()) {
            run.left_open = report;
            return run;
        }
        run.trace.times.push_back(now);
        for (std::size_t c = 0; c < run.trace.columns.size(); ++c) {
            const bool is_input = c < inputs.size();
            run.trace.values.push_back(
                is_input ? inputs[c] : machine.value(names.at(run.trace.columns[c].name)));
        }
    }
    return run;
}

Stimuli without_modes(Stimuli stimuli, const Grafcet& grafcet) {
    for (Stimuli::Change& change : stimuli.changes) {
        std::erase_if(change.assignments, [&](const Stimuli::Assignment& assignment) {
            return assignment.input >= grafcet.inputs.size();
        });
    }
    return stimuli;
}

}  // namespace grafwire::testing
