#include "random/random_stimuli.h"

#include "grafcet/write_grafcet.h"

namespace grafwire::testing {

std::string random_stimuli(RandomSource& random, const Grafcet& grafcet, std::size_t lines) {
    std::string text;
    const std::size_t declared = grafcet.inputs.size();
    for (std::size_t line = 0; line < lines; ++line) {
        // Now and then two lines of one instant, which are one change.
        text += line == 0 ? "0ms :" : "+" + std::to_string(random.below(5)) + "ms :";
        for (std::size_t i = 0; i < grafcet.all_input_count(); ++i) {
            if (!random.one_in(i < declared ? 3 : 15)) continue;
            text += " " + quoted_where_needed(input_name(grafcet, i));
            const bool value = i < declared ? random.flip() : random.one_in(3);
            text += value ? "=1" : "=0";
        }
        text += "\n";
    }
    return text + "+" + std::to_string(random.below(20)) + "ms : end\n";
}

}  // namespace grafwire::testing
