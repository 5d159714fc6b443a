// The report of a check for programs. Its keys and values do not depend on the language. Each is
// described in report.schema.json, against which the tests hold every report.

#include <nlohmann/json.hpp>

#include "check/report.h"
#include "grafcet/write_grafcet.h"
#include "text/version.h"

namespace grafwire {

std::string_view name_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::equivalent:
            return "equivalent";
        case Verdict::different:
            return "different";
        case Verdict::undecided:
            return "undecided";
    }
    return "";
}

std::string_view name_of(DifferenceKind kind) {
    switch (kind) {
        case DifferenceKind::situation:
            return "situation";
        case DifferenceKind::output:
            return "output";
        case DifferenceKind::oscillation:
            return "oscillation";
        case DifferenceKind::race:
            return "race";
        case DifferenceKind::power_up:
            return "power-up";
    }
    return "";
}

namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(PowerUp power_up) {
    switch (power_up) {
        case PowerUp::init:
            return "Init";
        case PowerUp::initial_values:
            return "initial values";
        case PowerUp::given:
            return "given";
        case PowerUp::unknown:
            return "unknown";
    }
    return "";
}

/// Picoseconds to nanoseconds, which is what a band is told in.
Json bounds(DelayBand band) {
    const auto in_nanoseconds = [](Time time) {
        return static_cast<double>(time) / static_cast<double>(nanosecond);
    };
    return {in_nanoseconds(band.min), in_nanoseconds(band.max)};
}

Json figures(const std::vector<UsedFigures>& used) {
    Json list = Json::array();
    for (const UsedFigures& one : used) {
        Json json = {{"cell", row_of(one.type).name},
                     {"inputs", one.inputs},
                     {"rise", bounds(one.bands.rise)},
                     {"fall", bounds(one.bands.fall)},
                     {"part", nullptr},
                     {"source", nullptr}};
        if (one.part != nullptr) {
            json["part"] = one.part->part;
            json["source"] = one.part->source;
        }
        list.push_back(std::move(json));
    }
    return list;
}

/// What was compared, and what the verdict rests on.
void put_subject(Json& json, const CheckSubject& subject, const Grafcet& grafcet) {
    if (subject.is_program) {
        json["device"] = subject.against;
    } else if (!subject.against.empty()) {
        json["against"] = subject.against;
    } else {
        json["style"] = subject.style;
        json["cdx"] = subject.cdx;
    }
    if (!subject.is_program) json["delay"] = subject.delays.name;
    if (!subject.figures.empty()) json["figures"] = figures(subject.figures);
    if (subject.changes) json["changes"] = *subject.changes == Changes::one ? "one" : "many";
    if (subject.is_scanned()) json["period"] = subject.period;
    json["power_up"] = name_of(subject.power_up);
    json["assumptions"] = Json::array();
    for (const Assumption& assumption : grafcet.assumptions) {
        json["assumptions"].push_back(
            write_expression(grafcet, grafcet.expressions, assumption.expression));
    }
    json["method"] = "exploration";
}

void put_together(Json& json, const Grafcet& grafcet, const CheckResult& result) {
    json["together"] = nullptr;
    if (!result.together || result.together->verdict == Verdict::undecided) return;
    const Together& together = *result.together;
    json["together"] = together.verdict == Verdict::equivalent;
    if (together.verdict == Verdict::equivalent) return;
    json["together_inputs"] = Json::array();
    for (const std::uint32_t input : together.inputs) {
        json["together_inputs"].push_back(input_name(grafcet, input));
    }
    json["together_stimuli"] = write_stimuli(together.witness->stimuli, grafcet);
    json["together_assume"] = nullptr;
    if (!together.assumption.empty()) json["together_assume"] = together.assumption;
}

Json place(std::uint32_t number) {
    return number == 0 ? Json(nullptr) : Json(number);
}

Json diagnostics(const std::vector<Diagnostic>& items) {
    Json list = Json::array();
    for (const Diagnostic& item : items) {
        list.push_back({{"severity", item.severity == Severity::error ? "error" : "warning"},
                        {"line", place(item.where.line)},
                        {"column", place(item.where.column)},
                        {"message", item.message.english}});
    }
    return list;
}

Json never_exercised(const NeverExercised& never, const Grafcet& grafcet) {
    Json json = {{"steps", Json::array()},
                 {"transitions", Json::array()},
                 {"inputs", Json::array()},
                 {"outputs", Json::array()}};
    for (const StepId id : never.steps) json["steps"].push_back(grafcet.steps[id].name);
    for (const TransitionId id : never.transitions) {
        json["transitions"].push_back(grafcet.transitions[id].name);
    }
    for (const std::uint32_t input : never.inputs) {
        json["inputs"].push_back(input_name(grafcet, input));
    }
    for (const OutputId id : never.outputs) json["outputs"].push_back(grafcet.outputs[id].name);
    return json;
}

Json value_of(Logic value) {
    if (value == Logic::unknown) return "x";
    return value == Logic::one ? 1 : 0;
}

Json explained_witness(const Witness& witness, const CheckSubject& subject, const Grafcet& grafcet,
                       const ExplainedWitness& explained) {
    Json json;
    json["kind"] = name_of(witness.kind);
    json["stimuli"] = write_stimuli(witness.stimuli, grafcet);
    json["expected"] = Json::object();
    json["got"] = Json::object();
    for (const Witness::Value& value : witness.values) {
        json["expected"][value.name] = value_of(value.expected);
        json["got"][value.name] = value_of(value.got);
    }
    if (!explained.power_up.empty()) {
        for (const auto& [net, value] : explained.power_up) json["power_up"][net] = value ? 1 : 0;
    }
    if (witness.scan_period != 0) json["scan"] = format_duration(witness.scan_period);
    json["cause"] = nullptr;
    if (!explained.cause.empty()) json["cause"] = explained.cause;
    json["story"] = explained.lines;
    json["files"] = subject.witness_files;
    return json;
}

Json ratio(int tenths) {
    return tenths == 0 ? Json(nullptr) : Json(tenths / 10.0);
}

Json tolerance(const Tolerance& tolerance, const CheckSubject& subject, const Grafcet& grafcet,
               const ExplainedWitness& explained) {
    Json json;
    json["holds"] = ratio(tolerance.holds);
    json["unlimited"] = tolerance.is_unlimited;
    json["fails"] = ratio(tolerance.fails);
    json["witness"] = nullptr;
    if (tolerance.witness && !explained.at_tolerance.empty()) {
        CheckSubject without_files = subject;
        without_files.witness_files.clear();
        json["witness"] = explained_witness(*tolerance.witness, without_files, grafcet,
                                            explained.at_tolerance[0]);
    }
    return json;
}

Json pulse(const Pulse& pulse, const ExplainedPulse& explained, const Grafcet& grafcet) {
    Json json;
    json["name"] = pulse.name;
    json["expected"] = pulse.expected;
    json["got"] = pulse.got;
    json["stimuli"] = write_stimuli(pulse.stimuli, grafcet);
    json["delays"] = nullptr;
    if (!explained.delays.empty()) json["delays"] = explained.delays;
    json["sooner"] = explained.sooner;
    json["later"] = explained.later;
    json["story"] = explained.lines;
    return json;
}

void put_pulses(Json& json, const Pulses& pulses, const Grafcet& grafcet,
                const ExplainedWitness& explained) {
    json["pulses"] = Json::array();
    for (std::size_t i = 0; i < pulses.found.size() && i < explained.pulses.size(); ++i) {
        json["pulses"].push_back(pulse(pulses.found[i], explained.pulses[i], grafcet));
    }
    json["pulses_open"] = Json::array();
    for (const Pulses::Open& open : pulses.open) {
        json["pulses_open"].push_back({{"name", open.name}, {"cases", open.cases}});
    }
    json["pulses_cases"] = pulses.cases;
    json["pulses_complete"] = pulses.complete;
}

/// Where the chart depends on the order in which its transitions clear, and what was added to it.
Json orders(const OrderRemarks& remarks) {
    Json json;
    json["complete"] = remarks.is_complete;
    json["cases"] = remarks.cases;
    json["races"] = Json::array();
    for (const OrderRemarks::Race& race : remarks.races) {
        Json item;
        item["kind"] = race.kind;
        item["first"] = nullptr;
        if (!race.first.empty()) item["first"] = race.first;
        item["second"] = race.second;
        item["stimuli"] = race.stimuli;
        json["races"].push_back(std::move(item));
    }
    json["interlocks"] = Json::array();
    for (const OrderRemarks::Interlock& interlock : remarks.interlocks) {
        Json item;
        item["transition"] = interlock.transition;
        item["awaited"] = interlock.awaited;
        item["condition"] = interlock.condition;
        item["receptivity"] = interlock.receptivity;
        json["interlocks"].push_back(std::move(item));
    }
    return json;
}

}  // namespace

std::string write_unchecked_json(const CheckSubject& subject, bool is_skipped,
                                 const std::vector<Diagnostic>& messages) {
    Json json;
    json["grafwire"] = version();
    json["file"] = subject.file;
    json["verdict"] = is_skipped ? "skipped" : "error";
    if (!subject.against.empty()) {
        json["against"] = subject.against;
    } else {
        json["style"] = subject.style;
        json["cdx"] = subject.cdx;
    }
    json["diagnostics"] = diagnostics(messages);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string write_check_json(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ExplainedWitness& explained) {
    Json json;
    json["grafwire"] = version();
    json["chart"] = grafcet.name;
    json["file"] = subject.file;
    json["verdict"] = name_of(result.verdict);
    put_subject(json, subject, grafcet);
    put_together(json, grafcet, result);
    if (subject.orders) json["orders"] = orders(*subject.orders);
    json["situations"] = result.coverage.situations;
    json["cases"] = result.coverage.cases;
    json["unstable"] = result.coverage.unstable;
    json["complete"] = result.complete;
    json["diagnostics"] = diagnostics(subject.warnings);
    json["never"] = never_exercised(result.never, grafcet);
    json["witness"] = nullptr;
    if (result.witness)
        json["witness"] = explained_witness(*result.witness, subject, grafcet, explained);
    if (result.tolerance) {
        json["tolerance"] = tolerance(*result.tolerance, subject, grafcet, explained);
    }
    if (result.pulses) put_pulses(json, *result.pulses, grafcet, explained);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grafwire
