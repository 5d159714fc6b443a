#include "referee/charts.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "random/random_grafcet.h"

namespace grafwire::testing {

std::map<std::string, std::string> example_charts() {
    std::map<std::string, std::string> texts;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(GRAFWIRE_ROOT) + "/examples")) {
        if (entry.path().extension() != ".grafcet") continue;
        std::ifstream file(entry.path(), std::ios::binary);
        std::stringstream text;
        text << file.rdbuf();
        texts[entry.path().stem().string()] = text.str();
    }
    return texts;
}

std::string chart_of(std::uint64_t seed) {
    Features features = Features::small();
    switch (seed % 4) {
        case 0:
            features.counters = 0;
            break;
        case 1:
            features.counters = 0;
            features.time_conditions = 3;
            features.edges = 1;
            break;
        case 2:
            features = Features::plain_chart();
            features.steps = 7;
            features.inputs = 3;
            break;
        default:
            break;
    }
    RandomSource random(seed);
    return random_grafcet(random, features);
}

}  // namespace grafwire::testing
