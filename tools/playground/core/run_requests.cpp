// A chart stepped live: inputs as switches, time as play, pause and step.

#include <cmath>

#include "core/asked_chart.h"
#include "core/messages.h"
#include "core/requests.h"
#include "core/run_state.h"
#include "core/runs.h"
#include "workflow/drawings.h"

namespace grafwire::playground {

Runs::OpenRun& Runs::open(std::unique_ptr<LiveRun> run, Language language) {
    ++last_;
    return runs_[last_] = OpenRun{last_, language, std::move(run)};
}

Runs::OpenRun* Runs::find(double number) {
    const auto found = runs_.find(static_cast<std::uint32_t>(number));
    return found != runs_.end() ? &found->second : nullptr;
}

std::unique_ptr<Runs> make_runs() {
    return std::make_unique<Runs>();
}

namespace {

/// The run that a request names; nullptr, with the reason in `answer`, where there is none.
Runs::OpenRun* asked_run(const Arguments& arguments, const Asked& asked, Json& answer) {
    const double number = arguments.number("run").value_or(0);
    Runs::OpenRun* open = number > 0 && number < 1e9 ? asked.runs.find(number) : nullptr;
    if (open == nullptr) {
        answer = error_answer(say::unknown_run(), arguments.language());
    } else if (arguments.has("lang")) {
        open->language = arguments.language();
    }
    return open;
}

std::optional<Time> time_from(std::optional<double> milliseconds) {
    constexpr double most = 9e9;  // a hundred days
    if (!milliseconds || !(*milliseconds >= 0 && *milliseconds <= most)) return std::nullopt;
    return static_cast<Time>(std::llround(*milliseconds * 1e6)) * nanosecond;
}

/// `set`, as numbers of inputs; false, with the reason in `answer`, where it cannot be.
bool read_assignments(const Arguments& arguments, const Runs::OpenRun& open,
                      std::vector<Stimuli::Assignment>& assignments, Json& answer) {
    const Grafcet& grafcet = open.run->chart().grafcet;
    for (const auto& [name, value] : arguments.object("set").items()) {
        std::uint32_t input = 0;
        while (input < grafcet.all_input_count() && input_name(grafcet, input) != name) ++input;
        if (input == grafcet.all_input_count()) {
            answer = error_answer(say::unknown_input(name), open.language);
            return false;
        }
        const bool is_one = value.is_boolean() ? value.get<bool>() : value == 1;
        assignments.push_back({input, is_one});
    }
    return true;
}

/// A step of a run: where it leads, and whether there is an instant at its end in any case.
struct AskedStep {
    Time to = 0;
    bool has_instant = false;
};

/// The step that was asked for, or why it cannot be taken.
std::optional<Localized> read_step(const Arguments& arguments, const LiveRun& run,
                                   bool changes_inputs, AskedStep& step) {
    const SteppedRun& reference = run.reference();
    const bool by_scans = reference.period().has_value();
    step.has_instant = !by_scans;
    if (reference.is_stuck()) return say::no_way_on();
    if (!run.gates_are_settled()) return say::gates_do_not_settle();
    if (arguments.flag("next", false) || arguments.flag("scan", false)) {
        step = {reference.next_instant(), by_scans || !reference.has_begun()};
        if (step.to == never) return say::no_delay_runs();
        return std::nullopt;
    }
    const std::optional<Time> at = time_from(arguments.number("at_ms"));
    const std::optional<Time> by = time_from(arguments.number("advance_ms"));
    const bool begins = !reference.has_begun();
    step.to = reference.now();
    if (at) {
        step.to = *at;
    } else if (by) {
        step.to = add_times(reference.now(), *by);
        // Time that passes is an instant where something happens.
        step.has_instant = !by_scans && (begins || changes_inputs);
    } else if (!begins && !by_scans) {
        step.to += millisecond;
    }
    if (step.to < reference.now()) return say::time_goes_on();
    if (step.to == reference.now() && !begins && !by_scans) return say::instant_is_over();
    return std::nullopt;
}

}  // namespace

Json open_run(const Arguments& arguments, const Asked& asked) {
    Json answer;
    auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const AskedPeriod period = asked_period(arguments, "period", answer);
    if (!period.is_good) return answer;
    std::optional<WiredChart> wiring;
    if (arguments.has("style")) {
        const auto options = asked_options(arguments, answer);
        if (!options) return answer;
        auto netlist = asked_netlist(arguments, *chart, *options, answer);
        if (!netlist) return answer;
        wiring = WiredChart{std::move(*netlist), options->delays};
    }
    const Runs::OpenRun& open = asked.runs.open(
        std::make_unique<LiveRun>(std::move(*chart), std::move(wiring), period.value),
        arguments.language());
    return state_answer(open, {});
}

Json do_in_run(const Arguments& arguments, const Asked& asked) {
    Json answer;
    Runs::OpenRun* open = asked_run(arguments, asked, answer);
    if (open == nullptr) return answer;
    std::vector<Stimuli::Assignment> assignments;
    if (!read_assignments(arguments, *open, assignments, answer)) return answer;
    AskedStep step;
    const auto refusal = read_step(arguments, *open->run, !assignments.empty(), step);
    if (refusal) return error_answer(*refusal, open->language);
    if (!arguments.fault().empty()) return answer;  // refused as soon as this returns
    const bool begins = !open->run->reference().has_begun();
    const LiveRun::Way way = open->run->advance(step.to, assignments, step.has_instant);
    answer = state_answer(*open, way.instants);
    if (!way.is_done) answer["error"] = say::too_long_way.in(open->language);
    if (begins && open->run->netlist() != nullptr) {
        answer["gates"]["power_up"] = power_up_answer(*open->run);
    }
    return answer;
}

Json take_back_in_run(const Arguments& arguments, const Asked& asked) {
    Json answer;
    Runs::OpenRun* open = asked_run(arguments, asked, answer);
    if (open == nullptr) return answer;
    if (!open->run->reference().can_go_back()) {
        return error_answer(say::nothing_to_take_back(), open->language);
    }
    open->run->go_back();
    return state_answer(*open, {});
}

Json answer_state_of_run(const Arguments& arguments, const Asked& asked) {
    Json answer;
    const Runs::OpenRun* open = asked_run(arguments, asked, answer);
    return open != nullptr ? state_answer(*open, {}) : answer;
}

Json draw_run(const Arguments& arguments, const Asked& asked) {
    Json answer;
    const Runs::OpenRun* open = asked_run(arguments, asked, answer);
    if (open == nullptr) return answer;
    const LiveRun& run = *open->run;
    const ToldRun whole = run.whole();
    const Trace& trace = whole.result.trace;
    const auto causes = causes_of(trace, run.chart().grafcet, whole);
    for (const TraceFormat& format : trace_formats()) {
        if (format.name != "svg") continue;
        answer["svg"] = trace_in_format(trace, run.chart(), format, open->language, causes);
    }
    return answer;
}

Json answer_stimuli_of_run(const Arguments& arguments, const Asked& asked) {
    Json answer;
    const Runs::OpenRun* open = asked_run(arguments, asked, answer);
    if (open == nullptr) return answer;
    const LiveRun& run = *open->run;
    return Json{{"text", write_stimuli(run.reference().stimuli(), run.chart().grafcet)}};
}

Json close_run(const Arguments& arguments, const Asked& asked) {
    Json answer;
    const Runs::OpenRun* open = asked_run(arguments, asked, answer);
    if (open == nullptr) return answer;
    asked.runs.close(open->number);
    return Json::object();
}

}  // namespace grafwire::playground
