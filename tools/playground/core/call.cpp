#include "core/call.h"

#include "core/arguments.h"
#include "core/messages.h"
#include "core/requests.h"
#include "core/runs.h"

namespace grafwire::playground {

namespace {

struct RequestRow {
    std::string_view name;
    Json (*answer)(const Arguments& arguments, const Asked& asked);
};

constexpr RequestRow requests[] = {
    {"version", answer_version},
    {"words", answer_words},
    {"chart", answer_chart},
    {"format", answer_format},
    {"draw", answer_draw},
    {"schematic", answer_schematic},
    {"equations", answer_equations},
    {"exports", answer_exports},
    {"export", answer_export},
    {"script", answer_script},
    {"check", answer_check},
    {"run.open", open_run},
    {"run.do", do_in_run},
    {"run.back", take_back_in_run},
    {"run.state", answer_state_of_run},
    {"run.timing", draw_run},
    {"run.stimuli", answer_stimuli_of_run},
    {"run.close", close_run},
};

Json answer_to(const Json& request, const Asked& asked) {
    if (!request.is_object()) return error_answer(say::bad_request(), Language::english);
    static const Json none = Json::object();
    const auto given = request.find("args");
    const Arguments arguments(given == request.end() ? none : *given);
    const std::string name = Arguments(request).text("name");
    for (const RequestRow& row : requests) {
        if (row.name != name) continue;
        Json answer = row.answer(arguments, asked);
        if (!arguments.fault().empty()) {
            return error_answer(say::wrong_type(arguments.fault()), arguments.language());
        }
        return answer;
    }
    return error_answer(say::unknown_request(name), arguments.language());
}

}  // namespace

Core::Core() : runs_(make_runs()) {}
Core::~Core() = default;

std::string Core::call(std::string_view request, const CheckProgress& progress) {
    const Json parsed = Json::parse(request, nullptr, false);
    return answer_to(parsed, {*runs_, progress})
        .dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace grafwire::playground
