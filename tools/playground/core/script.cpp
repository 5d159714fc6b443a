#include "core/script.h"

#include "core/asked_chart.h"
#include "core/requests.h"

namespace grafwire::playground {

double in_milliseconds(Time time) {
    return static_cast<double>(time) / static_cast<double>(millisecond);
}

Json script_answer(const Stimuli& stimuli, const Grafcet& grafcet) {
    Json instants = Json::array();
    for (const Stimuli::Change& change : stimuli.changes) {
        Json set = Json::object();
        for (const Stimuli::Assignment& item : change.assignments) {
            set[std::string(input_name(grafcet, item.input))] = item.value ? 1 : 0;
        }
        instants.push_back({{"at_ms", in_milliseconds(change.at)}, {"set", std::move(set)}});
    }
    return Json{{"instants", std::move(instants)}, {"end_ms", in_milliseconds(stimuli.end)}};
}

Json answer_script(const Arguments& arguments, const Asked&) {
    Json answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const auto stimuli = asked_stimuli(arguments, *chart, answer);
    if (!stimuli) return answer;
    return script_answer(*stimuli, chart->grafcet);
}

}  // namespace grafwire::playground
