#include "random/random_stimuli.h"

#include <vector>

#include "grafcet/write_grafcet.h"

namespace grafwire::testing {

std::string random_stimuli(RandomSource& random, const Grafcet& grafcet, std::size_t lines) {
    std::string text;
    const std::size_t declared = grafcet.inputs.size();
    std::vector<bool> values(grafcet.all_input_count(), false);
    const auto set = [&](std::size_t input, bool value) {
        values[input] = value;
        text += " " + quoted_where_needed(input_name(grafcet, input)) + (value ? "=1" : "=0");
    };
    for (std::size_t line = 0; line < lines; ++line) {
        // Now and then two lines of one instant, which are one change.
        text += line == 0 ? "0ms :" : "+" + std::to_string(random.below(5)) + "ms :";
        for (std::size_t count = random.below(4); count != 0; --count) {
            const std::size_t input = random.below(declared);
            set(input, !values[input]);
        }
        for (std::size_t i = declared; i < values.size(); ++i) {
            if (values[i] ? !random.one_in(3) : random.one_in(40)) set(i, !values[i]);
        }
        text += "\n";
    }
    return text + "+" + std::to_string(random.below(20)) + "ms : end\n";
}

}  // namespace grafwire::testing
