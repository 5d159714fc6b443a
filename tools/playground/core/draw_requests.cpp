#include <algorithm>

#include "core/asked_chart.h"
#include "core/asked_drawing.h"
#include "core/messages.h"
#include "core/requests.h"

namespace grafwire::playground {

namespace {

/// A page can be scrolled: nothing has to be cut or made smaller.
constexpr Paper screen{"screen", 4000, 4000};

/// Which of the parts stand in a list of names; `name_of` is how the page calls a part.
template <typename Parts, typename NameOf>
std::vector<bool> marked(const Parts& parts, const std::vector<std::string>& names,
                         const NameOf& name_of) {
    std::vector<bool> marks;
    for (const auto& part : parts) {
        marks.push_back(std::find(names.begin(), names.end(), name_of(part)) != names.end());
    }
    return marks;
}

ShownSituation situation_from(const Arguments& named, const Grafcet& grafcet) {
    const auto step_name = [](const Step& step) { return step.name; };
    const auto transition_name = [](const Transition& transition) {
        return '(' + transition.name + ')';
    };
    return {marked(grafcet.steps, named.texts("active"), step_name),
            marked(grafcet.transitions, named.texts("enabled"), transition_name),
            marked(grafcet.transitions, named.texts("clearable"), transition_name),
            named.text("caption")};
}

/// The moment `at` of a run; false, with the reason in `answer`, where there is none.
bool add_moment(const Arguments& arguments, const Chart& chart, ChartDrawing& how, Json& answer) {
    const auto stimuli = asked_stimuli(arguments, chart, answer);
    if (!stimuli) return false;
    const std::optional<Time> moment = asked_moment(arguments, answer);
    if (!moment) return false;
    auto situation = situation_at(chart, *stimuli, *moment, how.language);
    if (!situation) {
        answer = error_answer(say::no_situation_at(arguments.text("at")), how.language);
        return false;
    }
    how.situation = std::move(*situation);
    return true;
}

}  // namespace

std::optional<ChartDrawing> asked_drawing(const Arguments& arguments, const Chart& chart,
                                          Json& answer) {
    ChartDrawing how;
    how.language = arguments.language();
    const NotationRow* notation = asked_row(arguments, "notation", notation_table, answer);
    if (notation == nullptr) return std::nullopt;
    how.sign = notation->sign;
    const Paper* paper = asked_row(arguments, "paper", papers, answer);
    if (paper == nullptr) return std::nullopt;
    how.paper = *paper;
    how.animated = arguments.flag("animated", false);
    if (how.animated) how.paper = screen;
    if (arguments.has("situation")) {
        how.situation = situation_from(Arguments(arguments.object("situation")), chart.grafcet);
    } else if (arguments.has("at") && !add_moment(arguments, chart, how, answer)) {
        return std::nullopt;
    }
    return how;
}

Json answer_draw(const Arguments& arguments, const Asked&) {
    Json answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const auto how = asked_drawing(arguments, *chart, answer);
    if (!how) return answer;
    return Json{{"svg", chart_drawing(*chart, *how, drawing_formats().front(), false)}};
}

}  // namespace grafwire::playground
