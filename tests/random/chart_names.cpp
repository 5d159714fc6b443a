#include "random/chart_names.h"

namespace grafwire::testing {

std::string random_name(RandomSource& random, const Features& features, const std::string& stem,
                        std::size_t number) {
    const std::string plain = stem + std::to_string(number);
    if (!features.odd_names || random.below(3) != 0) return plain;
    switch (random.below(6)) {
        case 0:
            return "é" + plain;
        case 1:
            return "\"" + plain + "\"";  // the same as without quotes
        case 2:
            return "\"the " + plain + "\"";
        case 3:
            return "\"" + plain + "+ # $\\\"";
        case 4:
            return "温度_" + plain;
        default:
            return "\"step." + plain + "\"";
    }
}

std::string random_step_name(RandomSource& random, const Features& features, std::size_t number) {
    if (!random.one_in(4)) return std::to_string(number);
    return random_name(random, features, "s", number);
}

std::string x_variable(const std::string& name) {
    if (name.front() == '"') return "\"X" + name.substr(1);
    return "X" + name;
}

}  // namespace grafwire::testing
