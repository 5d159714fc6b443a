#include "referee/charts.h"

#include <sstream>

#include "random/random_grafcet.h"
#include "support/files.h"

namespace grafwire::testing {

std::map<std::string, std::string> texts_of_examples() {
    std::map<std::string, std::string> texts;
    for (const std::string& name : example_names()) {
        texts[name] = example_text(name + ".grafcet");
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

std::string altered(const std::string& chart, RandomSource& random) {
    std::vector<std::string> lines;
    std::vector<std::size_t> transitions;
    std::istringstream text(chart);
    for (std::string line; std::getline(text, line);) {
        if (line.find("->") != std::string::npos) transitions.push_back(lines.size());
        lines.push_back(line);
    }
    if (transitions.empty()) return chart;
    std::string& line = lines[random.pick(transitions)];
    std::string& other = lines[random.pick(transitions)];
    const std::size_t at = line.find(" : ");
    const std::size_t other_at = other.find(" : ");
    if (random.flip() && &line != &other && at != std::string::npos &&
        other_at != std::string::npos) {
        const std::string condition = line.substr(at);
        line.replace(at, std::string::npos, other.substr(other_at));
        other.replace(other_at, std::string::npos, condition);
    } else {
        line.clear();
    }
    std::string result;
    for (const std::string& part : lines) result += part + "\n";
    return result;
}

}  // namespace grafwire::testing
