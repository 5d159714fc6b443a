// The checks, from texts and options to the reports.

#include "grafwire/check.h"

#include <memory>

#include "grafwire/messages.h"
#include "grafwire/parts.h"
#include "workflow/check.h"

namespace grafwire::api {

namespace {

/// The messages of several texts and of the request, in the order in which they were read.
void append(std::vector<Message>& messages, const Diagnostics& diagnostics) {
    for (Message& message : messages_from(diagnostics)) messages.push_back(std::move(message));
}

/// Progress and the question whether to go on are one call outside, two inside: the latest figures
/// are kept in between.
CheckRequest request_from(const grafwire::Chart& chart, const CheckOptions& options,
                          std::optional<Time> period) {
    CheckRequest request;
    request.subject.file = chart.source.name;
    request.subject.name = chart.source.name;
    request.changes = options.many_changes ? Changes::many : Changes::one;
    request.period = period;
    request.max_cases = options.max_cases;
    if (options.keep_going) {
        const auto latest = std::make_shared<Coverage>();
        request.progress = [latest](const grafwire::Coverage& coverage) {
            *latest = {coverage.situations, coverage.cases, coverage.waiting};
        };
        request.keep_going = [&options, latest] { return options.keep_going(*latest); };
    }
    request.language = language_from(options.language);
    request.with_files = true;
    return request;
}

/// The enumeration outside has a type of its own, so that headers of the library need not be
/// installed.
Verdict verdict_from(grafwire::Verdict verdict) {
    switch (verdict) {
        case grafwire::Verdict::equivalent:
            return Verdict::equivalent;
        case grafwire::Verdict::different:
            return Verdict::different;
        case grafwire::Verdict::undecided:
            return Verdict::undecided;
    }
    return Verdict::undecided;
}

CheckResult result_from(const Judgement& judgement, const grafwire::Chart& chart,
                        const CheckOptions& options) {
    CheckResult result;
    result.verdict = verdict_from(judgement.result.verdict);
    const grafwire::Coverage& coverage = judgement.result.coverage;
    result.coverage = {coverage.situations, coverage.cases, coverage.waiting};
    result.report = write_check_text(judgement.subject, chart.grafcet, judgement.result,
                                     judgement.explained, language_from(options.language));
    result.json =
        write_check_json(judgement.subject, chart.grafcet, judgement.result, judgement.explained);
    for (const grafwire::NamedText& file : judgement.witness_files) {
        result.witness.push_back({file.name, file.text});
    }
    return result;
}

/// What a check of anything comes to; `judge` makes it, from a request and for messages.
template <typename Judge>
Result<CheckResult> checked(const grafwire::Chart& chart, const CheckOptions& options,
                            std::vector<Message> messages, const Judge& judge) {
    Result<CheckResult> result{std::nullopt, std::move(messages)};
    const CheckedPeriod period = period_from(options.period);
    if (period.is_wrong) {
        result.messages.push_back(wrong_period());
        return result;
    }
    Diagnostics diagnostics;
    const auto judgement = judge(request_from(chart, options, period.value), diagnostics);
    append(result.messages, diagnostics);
    if (judgement) result.value = result_from(*judgement, chart, options);
    return result;
}

}  // namespace

Result<CheckResult> check(const Netlist& netlist, const CheckOptions& options) {
    const Netlist::Parts& parts = netlist.parts();
    const grafwire::Chart& chart = parts.chart.parts().chart;
    if (options.period && !netlist.is_clocked()) {
        return {std::nullopt, {error(messages::library::period_without_clock())}};
    }
    return checked(chart, options, {}, [&](CheckRequest request, Diagnostics& diagnostics) {
        request.subject.style = parts.style;
        request.subject.cdx = parts.cdx;
        request.subject.against = parts.source;
        return check_netlist(chart, parts.netlist, request, diagnostics);
    });
}

Result<CheckResult> check_listing(const Chart& chart, std::string listing, std::string assignment,
                                  const std::string& cpu, const CheckOptions& options) {
    const grafwire::Chart& read = chart.parts().chart;
    const auto controller = cpu_of_number(cpu);
    if (!controller) return {std::nullopt, {error(messages::library::unknown_controller(cpu))}};
    std::vector<Message> messages;
    Diagnostics of_assignment;
    const auto io = read_assignment({"assignment", std::move(assignment)}, of_assignment);
    std::optional<s7::Binding> binding;
    if (io) binding = s7::bind(read.grafcet, *io, of_assignment);
    append(messages, of_assignment);
    if (!binding) return {std::nullopt, std::move(messages)};
    Diagnostics of_listing;
    const auto program =
        read_listing({"listing", std::move(listing)}, *controller, &*io, of_listing);
    append(messages, of_listing);
    if (!program) return {std::nullopt, std::move(messages)};
    return checked(read, options, std::move(messages),
                   [&](CheckRequest request, Diagnostics& diagnostics) {
                       request.subject.against = "listing";
                       return grafwire::check_listing(read, *program, *controller, *binding,
                                                      request, diagnostics);
                   });
}

Result<CheckResult> check_ladder(const Chart& chart, std::string project,
                                 const std::string& program, const CheckOptions& options) {
    const grafwire::Chart& read = chart.parts().chart;
    Diagnostics diagnostics;
    const auto ladder = read_ladder({"project", std::move(project)}, program, diagnostics);
    std::vector<Message> messages = messages_from(diagnostics);
    if (!ladder) return {std::nullopt, std::move(messages)};
    return checked(read, options, std::move(messages),
                   [&](CheckRequest request, Diagnostics& of_check) {
                       request.subject.against = "project";
                       return grafwire::check_ladder(read, *ladder, request, of_check);
                   });
}

}  // namespace grafwire::api
