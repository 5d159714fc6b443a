#include "support/chart_files.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace grafwire::testing {

namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    REQUIRE_MESSAGE(file, path.string());
    return text.str();
}

std::vector<ChartFiles> read_charts() {
    std::vector<std::filesystem::path> paths;
    const std::filesystem::path folder = std::filesystem::path(GRAFWIRE_ROOT) / "examples";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() == ".grafcet") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<ChartFiles> charts;
    for (std::filesystem::path path : paths) {
        const std::string chart = text_of(path);
        charts.push_back({path.stem().string(), chart, text_of(path.replace_extension(".stim"))});
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
