#include "examples/example.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "equations/equations.h"
#include "grafcet/parse_grafcet.h"
#include "simulate/simulate.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, '|');) {
        const std::size_t first = cell.find_first_not_of(" `");
        const std::size_t last = cell.find_last_not_of(" `");
        cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return cells;
}

std::vector<std::string> styles_in(std::string cell) {
    std::replace(cell.begin(), cell.end(), ',', ' ');
    std::istringstream words(cell);
    std::vector<std::string> styles;
    for (std::string word; words >> word;) styles.push_back(word);
    return styles;
}

Example load_example(const std::string& name) {
    Example result;
    result.name = name;
    result.grafcet = load_grafcet(example(name + ".grafcet"));
    result.stimuli = load_stimuli(example(name + ".stim"), result.grafcet);
    result.reference = run_until_stable(result.grafcet, result.stimuli);
    return result;
}

std::vector<Example> load_examples() {
    std::vector<Example> examples;
    std::istringstream readme(text_of(example("README.md")));
    std::size_t sound_in = 0;
    std::size_t one_at_a_time = 0;
    for (std::string line; std::getline(readme, line);) {
        if (line.rfind('|', 0) != 0) sound_in = one_at_a_time = 0;  // the table is over
        const std::vector<std::string> cells = cells_of(line);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (cells[i] == "sound in") sound_in = i;
            if (cells[i] == "one at a time") one_at_a_time = i;
        }
        if (sound_in == 0 || one_at_a_time == 0 || line.rfind("| `", 0) != 0) continue;
        REQUIRE(cells.size() > std::max(sound_in, one_at_a_time));
        examples.push_back(load_example(cells[1]));
        examples.back().sound_in = styles_in(cells[sound_in]);
        examples.back().sound_one_at_a_time = styles_in(cells[one_at_a_time]);
    }
    REQUIRE(examples.size() == 13);
    return examples;
}

std::vector<AgreeingNetlist> find_agreeing_netlists() {
    std::vector<AgreeingNetlist> found;
    for (const Example& example : examples()) {
        for (const StyleRow& row : style_table) {
            auto netlist = netlist_of(example.grafcet, row);
            if (!netlist) continue;
            const SimulateResult result =
                simulate(example.grafcet, *netlist, cell_delays(*netlist, {}), example.stimuli, {});
            if (result.unsettled_at ||
                write_csv(result.trace) != write_csv(example.reference.trace)) {
                continue;
            }
            found.push_back({&example, &row, std::move(*netlist)});
        }
    }
    return found;
}

}  // namespace

const std::vector<Example>& examples() {
    static const std::vector<Example> all = load_examples();
    return all;
}

const Example& example_named(const std::string& name) {
    const auto found = std::find_if(examples().begin(), examples().end(),
                                    [&](const Example& item) { return item.name == name; });
    REQUIRE_MESSAGE(found != examples().end(), "there is no example " << name);
    return *found;
}

Grafcet load_grafcet(const std::string& path) {
    Diagnostics diagnostics;
    const SourceFile source{path, text_of(path)};
    auto grafcet = parse_grafcet(source, diagnostics);
    REQUIRE_MESSAGE(grafcet.has_value(), format_diagnostics(diagnostics, source));
    return std::move(*grafcet);
}

Stimuli load_stimuli(const std::string& path, const Grafcet& grafcet) {
    Diagnostics diagnostics;
    const SourceFile source{path, text_of(path)};
    auto stimuli = parse_stimuli(source, grafcet, diagnostics);
    REQUIRE_MESSAGE(stimuli.has_value(), format_diagnostics(diagnostics, source));
    return std::move(*stimuli);
}

std::optional<Netlist> netlist_of(const Grafcet& grafcet, const StyleRow& row) {
    const Equations equations = equations_from(grafcet, {row.default_cdx, true});
    Diagnostics diagnostics;
    auto netlist = netlist_from(grafcet, equations, row.style, diagnostics);
    CHECK(netlist.has_value() != diagnostics.has_errors());
    if (!netlist) {
        CHECK(row.style != Style::clocked);
        CHECK((!grafcet.counters.empty() || row.style == Style::handshake));
    }
    return netlist;
}

const std::vector<AgreeingNetlist>& agreeing_netlists() {
    static const std::vector<AgreeingNetlist> all = find_agreeing_netlists();
    return all;
}

Trace reference_for(const AgreeingNetlist& item) {
    if (!item.netlist.is_clocked()) return item.example->reference.trace;
    return run_scans(item.example->grafcet, item.example->stimuli, scan_period).trace;
}

std::string ones_of(const Grafcet& grafcet, const Trace& trace, std::size_t row) {
    const std::size_t first = grafcet.all_input_count();
    const std::size_t count = grafcet.steps.size() + grafcet.outputs.size();
    std::string ones;
    for (std::size_t i = first; i < first + count; ++i) {
        if (trace.values[row * trace.columns.size() + i] != 0) ones += trace.columns[i].name + ' ';
    }
    return ones;
}

}  // namespace grafwire::testing
