// A chart is a handle to what the workflow has read. Messages lose their source lines on the way: a
// program of others knows the text and can show them.

#include "grafwire/read.h"

#include <fmt/format.h>

#include "grafwire/messages.h"
#include "grafwire/parts.h"
#include "grafwire/version.h"
#include "text/messages.h"
#include "text/version.h"
#include "trace/stimuli.h"

namespace grafwire::api {

std::string version() {
    return std::string(grafwire::version());
}

std::string shown(const std::vector<Message>& messages, std::string_view file, Language language) {
    std::string text;
    for (const Message& message : messages) {
        text += file;
        if (message.line != 0) text += fmt::format(":{}:{}", message.line, message.column);
        const grafwire::Message<std::string>& labelled =
            message.severity == Message::Severity::error ? messages::text::error
                                                         : messages::text::warning;
        text += fmt::format(
            ": {}\n", labelled.in(language_from(language), std::string(message.text_in(language))));
    }
    return text;
}

std::vector<Message> messages_from(const Diagnostics& diagnostics) {
    std::vector<Message> messages;
    for (const Diagnostic& item : diagnostics.items()) {
        Message message;
        if (item.severity == grafwire::Severity::warning) {
            message.severity = Message::Severity::warning;
        }
        message.text = item.message.english;
        message.french = item.message.french;
        if (item.where.is_known()) {
            message.line = item.where.line;
            message.column = item.where.column;
        }
        messages.push_back(std::move(message));
    }
    return messages;
}

Message error(Localized text) {
    return {Message::Severity::error, std::move(text.english), std::move(text.french), 0, 0};
}

/// Nanoseconds beyond the range of Time would become another period.
CheckedPeriod period_from(std::optional<std::chrono::nanoseconds> period) {
    if (!period) return {};
    const std::int64_t count = period->count();
    if (count <= 0 || count > never / nanosecond) return {std::nullopt, true};
    return {count * nanosecond, false};
}

Message wrong_period() {
    return error(messages::library::wrong_period());
}

Start begin(const grafwire::Chart& chart, const std::optional<std::string>& stimuli,
            std::optional<std::chrono::nanoseconds> period) {
    Start start;
    if (stimuli) {
        Diagnostics diagnostics;
        start.stimuli = parse_stimuli({"stimuli", *stimuli}, chart.grafcet, diagnostics);
        start.messages = messages_from(diagnostics);
        start.is_good = start.stimuli.has_value();
    }
    const CheckedPeriod checked = period_from(period);
    start.period = checked.value;
    if (checked.is_wrong) {
        start.messages.push_back(wrong_period());
        start.is_good = false;
    }
    return start;
}

std::vector<std::string> strings(const std::vector<std::string_view>& names) {
    return {names.begin(), names.end()};
}

Result<Chart> read_chart(std::string text, std::string name) {
    Diagnostics diagnostics;
    auto chart = grafwire::read_chart({std::move(name), std::move(text)}, diagnostics);
    Result<Chart> result{std::nullopt, messages_from(diagnostics)};
    if (chart) {
        result.value = Chart(std::make_shared<const Chart::Parts>(Chart::Parts{std::move(*chart)}));
    }
    return result;
}

std::string Chart::name() const {
    return parts_->chart.grafcet.name;
}

std::vector<std::string> Chart::steps() const {
    std::vector<std::string> names;
    for (const Step& step : parts_->chart.grafcet.steps) names.push_back(step.name);
    return names;
}

std::vector<std::string> Chart::inputs() const {
    std::vector<std::string> names;
    for (const auto& input : parts_->chart.grafcet.inputs) names.push_back(input.name);
    return names;
}

std::vector<std::string> Chart::outputs() const {
    std::vector<std::string> names;
    for (const auto& output : parts_->chart.grafcet.outputs) names.push_back(output.name);
    return names;
}

}  // namespace grafwire::api
