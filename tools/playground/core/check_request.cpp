#include "core/asked_chart.h"
#include "core/asked_check.h"
#include "core/messages.h"
#include "core/requests.h"
#include "core/script.h"

namespace grafwire::playground {

namespace {

/// What the reports say of the request.
CheckSubject subject_of(const Arguments& arguments, const NetlistOptions& options) {
    CheckSubject subject;
    subject.file = arguments.text("file", "chart.grafcet");
    subject.delays = options.delays;
    if (arguments.has("against")) {
        subject.against = Arguments(arguments.object("against")).text("name");
        subject.name = subject.against;
    } else {
        subject.style = style_table[static_cast<std::size_t>(options.style)].name;
        subject.cdx = name_of(cdx_form(options));
        subject.name = subject.style + " " + subject.cdx;
    }
    for (const std::string_view asked : {"changes", "power_up", "period"}) {
        if (arguments.has(asked)) subject.name += " " + arguments.text(asked);
    }
    return subject;
}

/// A netlist from elsewhere, if its ports allow a comparison.
std::optional<Netlist> asked_file(const Arguments& arguments, const Chart& chart, Json& answer) {
    const Language language = arguments.language();
    const Arguments file(arguments.object("against"));
    const SourceFile source{file.text("name"), file.text("text")};
    const NetlistFormat* format = readable_format_of(source.name);
    if (format == nullptr) {
        answer = error_answer(say::no_netlist_file(source.name), language);
        return std::nullopt;
    }
    Diagnostics diagnostics;
    auto netlist = format->read(source, diagnostics);
    if (!netlist) {
        answer = error_answer(say::bad_netlist(), language);
        answer["messages"] = format_diagnostics(diagnostics, source, language);
        return std::nullopt;
    }
    const PortComparison ports =
        fit_netlist(chart, *netlist, arguments.text("power_up") == "initial");
    if (ports.can_compare()) return netlist;
    answer = error_answer(say::ports_do_not_fit(), language);
    answer["messages"] = port_table(ports).in(language);
    return std::nullopt;
}

Json witness_answer(const Checked& checked) {
    const Witness& witness = *checked.judgement.result.witness;
    const Grafcet& grafcet = checked.chart.grafcet;
    Json answer{{"stimuli", write_stimuli(witness.stimuli, grafcet)}};
    answer.update(script_answer(witness.stimuli, grafcet));
    if (witness.scan_period != 0) answer["period"] = format_duration(witness.scan_period);
    Json files = Json::array();
    for (const NamedText& file : checked.judgement.witness_files) {
        files.push_back({{"name", file.name}, {"text", file.text}});
        if (file.name == "witness.svg") answer["svg"] = file.text;
    }
    answer["files"] = std::move(files);
    return answer;
}

}  // namespace

std::optional<Checked> asked_judgement(const Arguments& arguments, const CheckProgress& progress,
                                       bool with_files, Json& answer) {
    const Language language = arguments.language();
    auto chart = asked_chart(arguments, answer);
    if (!chart) return std::nullopt;
    const auto options = asked_options(arguments, answer);
    if (!options) return std::nullopt;
    const auto netlist = arguments.has("against")
                             ? asked_file(arguments, *chart, answer)
                             : asked_netlist(arguments, *chart, *options, answer);
    if (!netlist) return std::nullopt;
    const AskedPeriod period = asked_period(arguments, "period", answer);
    if (!period.is_good) return std::nullopt;
    CheckRequest request;
    request.subject = subject_of(arguments, *options);
    if (arguments.text("changes", "one") == "many") request.changes = Changes::many;
    request.period = period.value;
    request.max_cases = arguments.count("max_cases");
    request.language = language;
    request.with_files = with_files;
    bool goes_on = true;
    if (progress) {
        request.progress = [&](const Coverage& coverage) { goes_on = progress(coverage); };
        request.keep_going = [&] { return goes_on; };
    }
    Diagnostics messages;
    auto judgement = check_netlist(*chart, *netlist, request, messages);
    if (!judgement) {
        answer = Json{{"error", texts_of(messages, language)}};
        return std::nullopt;
    }
    return Checked{std::move(*chart), std::move(*judgement)};
}

Json answer_check(const Arguments& arguments, const Asked& asked) {
    Json answer;
    const auto checked =
        asked_judgement(arguments, asked.progress, arguments.flag("with_files", true), answer);
    if (!checked) return answer;
    const Judgement& judgement = checked->judgement;
    const Grafcet& grafcet = checked->chart.grafcet;
    answer = Json{{"verdict", name_of(judgement.result.verdict)},
                  {"report", Json::parse(write_check_json(judgement.subject, grafcet,
                                                          judgement.result, judgement.explained),
                                         nullptr, false)},
                  {"text", write_check_text(judgement.subject, grafcet, judgement.result,
                                            judgement.explained, arguments.language())},
                  {"explanation", judgement.explained.text}};
    if (judgement.result.witness) answer["witness"] = witness_answer(*checked);
    return answer;
}

}  // namespace grafwire::playground
