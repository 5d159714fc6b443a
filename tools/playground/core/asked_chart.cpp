#include "core/asked_chart.h"

#include "core/messages.h"
#include "core/places.h"
#include "core/requests.h"
#include "netlist/delay_model.h"

namespace grafwire::playground {

namespace {

void add_place(Json& object, Location where, const Places& places) {
    const Span span = places.at(where);
    object["line"] = where.line;
    object["column"] = where.column;
    object["from"] = span.from;
    object["to"] = span.to;
}

}  // namespace

Json error_answer(const Localized& why, Language language) {
    return Json{{"error", why.in(language)}};
}

Json diagnostics_answer(const Diagnostics& diagnostics, std::string_view text, Language language) {
    Json list = Json::array();
    if (diagnostics.items().empty()) return list;
    const Places places(text);
    for (const Diagnostic& item : diagnostics.items()) {
        Json object{{"severity", item.severity == Severity::error ? "error" : "warning"},
                    {"code", item.code.name}};
        add_place(object, item.where, places);
        object["message"] = item.message.in(language);
        Json notes = Json::array();
        for (const Diagnostic::Note& note : item.notes) {
            Json shown = Json::object();
            add_place(shown, note.where, places);
            shown["message"] = note.message.in(language);
            notes.push_back(std::move(shown));
        }
        object["notes"] = std::move(notes);
        list.push_back(std::move(object));
    }
    return list;
}

std::string texts_of(const Diagnostics& diagnostics, Language language) {
    std::string text;
    for (const Diagnostic& item : diagnostics.items()) {
        if (!text.empty()) text += '\n';
        text += item.message.in(language);
    }
    return text;
}

std::optional<Chart> asked_chart(const Arguments& arguments, Json& answer) {
    const Language language = arguments.language();
    const SourceFile source{arguments.text("file", "chart.grafcet"), arguments.text("text")};
    Diagnostics diagnostics;
    auto chart = read_chart(source, diagnostics);
    if (!chart) {
        answer = error_answer(say::bad_chart(), language);
        answer["diagnostics"] = diagnostics_answer(diagnostics, source.text, language);
        return std::nullopt;
    }
    for (const std::string& text : arguments.texts("assume")) {
        Diagnostics of_assumption;
        if (add_assumption({"--assume", text}, *chart, of_assumption)) continue;
        answer = error_answer(say::bad_assumption(), language);
        answer["messages"] = texts_of(of_assumption, language);
        return std::nullopt;
    }
    return chart;
}

Json unknown_value_answer(const Arguments& arguments, std::string_view name) {
    return error_answer(say::unknown_value(name, arguments.text(name)), arguments.language());
}

std::optional<NetlistOptions> asked_options(const Arguments& arguments, Json& answer) {
    NetlistOptions options;
    if (arguments.has("style")) {
        const StyleRow* style = asked_row(arguments, "style", style_table, answer);
        if (style == nullptr) return std::nullopt;
        options.style = style->style;
    }
    if (arguments.has("cdx")) {
        const CdxRow* cdx = asked_row(arguments, "cdx", cdx_table, answer);
        if (cdx == nullptr) return std::nullopt;
        options.cdx = cdx->form;
    }
    const std::string delay = arguments.text("delay", options.delays.name);
    const auto delays = delay_model_of(delay);
    if (!delays) {
        answer = unknown_value_answer(arguments, "delay");
        return std::nullopt;
    }
    options.delays = *delays;
    options.modes = arguments.flag("modes", true);
    if (const auto conflict = conflict_in(options)) {
        answer = error_answer(*conflict, arguments.language());
        return std::nullopt;
    }
    return options;
}

std::optional<Netlist> asked_netlist(const Arguments& arguments, const Chart& chart,
                                     const NetlistOptions& options, Json& answer) {
    Diagnostics diagnostics;
    auto netlist = make_netlist(chart, options, diagnostics);
    if (!netlist) {
        const Language language = arguments.language();
        answer = Json{{"error", texts_of(diagnostics, language)}};
        answer["diagnostics"] = diagnostics_answer(diagnostics, chart.source.text, language);
    }
    return netlist;
}

std::optional<Stimuli> asked_stimuli(const Arguments& arguments, const Chart& chart, Json& answer) {
    const SourceFile source{arguments.text("stimuli_file", "chart.stim"),
                            arguments.text("stimuli")};
    Diagnostics diagnostics;
    auto stimuli = parse_stimuli(source, chart.grafcet, diagnostics);
    if (!stimuli) {
        answer = error_answer(say::bad_stimuli(), arguments.language());
        answer["diagnostics"] = diagnostics_answer(diagnostics, source.text, arguments.language());
    }
    return stimuli;
}

std::optional<Time> asked_moment(const Arguments& arguments, Json& answer) {
    const std::string text = arguments.text("at");
    const std::optional<Time> moment = text == "0" ? Time{0} : parse_duration(text);
    if (!moment) answer = error_answer(say::no_duration(text), arguments.language());
    return moment;
}

AskedPeriod asked_period(const Arguments& arguments, std::string_view name, Json& answer) {
    const std::string text = arguments.text(name);
    if (text.empty()) return {};
    const auto period = parse_duration(text);
    if (!period || *period <= 0) {
        answer = error_answer(say::no_duration(text), arguments.language());
        return {std::nullopt, false};
    }
    return {period};
}

}  // namespace grafwire::playground
