#include "formats/spice/spice_models.h"

#include <algorithm>
#include <string_view>

#include "formats/shared/append.h"

namespace grafwire {

void append_spice_models(std::string& out, const SpiceModels& models) {
    constexpr std::pair<std::string_view, std::string_view> gates[] = {
        {"buffer", "d_buffer"}, {"not", "d_inverter"}, {"and", "d_and"}, {"or", "d_or"},
        {"nand", "d_nand"},     {"nor", "d_nor"},      {"xor", "d_xor"}, {"xnor", "d_xnor"}};
    out += '\n';
    for (const auto& [name, model] : gates) {
        for (const auto& [speed, delay] :
             {std::pair("slow", 1000), std::pair("held", 999), std::pair("fast", 1)}) {
            append(out, ".model ", speed, '_', name, ' ', model, "(rise_delay=", delay,
                   " fall_delay=", delay, ")\n");
        }
    }
    out += R"(.model late_or d_or(rise_delay=998 fall_delay=998)
.model zero d_pulldown
.model one d_pullup
.model hold_0 d_dlatch(data_delay=1000 enable_delay=1000 ic=0)
.model hold_1 d_dlatch(data_delay=1000 enable_delay=1000 ic=1)
.model hold_x d_dlatch(data_delay=1000 enable_delay=1000 ic=2)
.model flip_flop_0 d_dff(clk_delay=1000 ic=0)
.model flip_flop_1 d_dff(clk_delay=1000 ic=1)
.model flip_flop_x d_dff(clk_delay=1000 ic=2)
.model one_shot_rise d_dff(clk_delay=1000 reset_delay=1 ic=0)
.model one_shot_fall d_dff(clk_delay=999 reset_delay=1 ic=0)
.model sampler d_dff(clk_delay=1 ic=2)
.model bridge adc_bridge(in_low=0.5 in_high=0.5 rise_delay=1 fall_delay=1)
)";
    for (const auto& [width, number] : models.pulses) {
        // The gate that gathers the resets and the flip-flop take a picosecond each.
        append(out, ".model pulse", number, " d_buffer(rise_delay=", std::max<Time>(1, width - 2),
               " fall_delay=1)\n");
    }
    for (const auto& [delays, number] : models.timers) {
        const auto delay = [](Time time) { return time == 0 ? nanosecond - 1 : time - 1; };
        append(out, ".model timer", number, " d_buffer(rise_delay=", delay(delays.first),
               " fall_delay=", delay(delays.second), ")\n");
    }
}

}  // namespace grafwire
