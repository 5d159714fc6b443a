#include "support/chart_files.h"

#include <doctest/doctest.h>

#include "support/files.h"

namespace grafwire::testing {

namespace {

std::vector<ChartFiles> read_charts() {
    std::vector<ChartFiles> charts;
    for (const std::string& name : example_names()) {
        charts.push_back({name, example_text(name + ".grafcet"), example_text(name + ".stim")});
    }
    REQUIRE(charts.size() >= 13);
    return charts;
}

}  // namespace

const std::vector<ChartFiles>& example_charts() {
    static const std::vector<ChartFiles> charts = read_charts();
    return charts;
}

}  // namespace grafwire::testing
