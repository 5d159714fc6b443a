// Everything that the command line writes, from the tables that it has its formats from.

#include "core/asked_chart.h"
#include "core/export_files.h"
#include "core/messages.h"
#include "core/requests.h"
#include "formats/netlist_formats.h"
#include "plc/formats.h"
#include "workflow/check.h"
#include "workflow/drawings.h"
#include "workflow/schematics.h"

namespace grafwire::playground {

namespace {

using Words = std::vector<std::string>;

/// One format of a kind, as `exports` lists it.
struct ListedFormat {
    std::string name;
    std::string extension;
    std::string description;
    std::string options;  ///< `--io --cpu`
};
using Formats = std::vector<ListedFormat>;

template <typename Rows>
Formats described(const Rows& rows, Language language) {
    Formats list;
    for (const auto& row : rows) {
        std::string options;
        if constexpr (requires { row.options; }) options = row.options;
        list.push_back({std::string(row.name), std::string(row.extension),
                        row.description.in(language), options});
    }
    return list;
}
template <typename Rows>
Formats named(const Rows& rows) {
    Formats list;
    for (const auto& row : rows) {
        std::string options;
        if constexpr (requires { row.options; }) options = row.options;
        list.push_back({std::string(row.name), std::string(row.extension), {}, options});
    }
    return list;
}
/// Netlists, and schematics.
Formats netlists(Language language) {
    Formats list;
    for (const NetlistTarget& target : netlist_targets()) {
        const std::string_view extension =
            target.format != nullptr ? target.format->extension : target.drawing->extension;
        list.push_back({std::string(target.name), std::string(extension),
                        target.description.in(language), target.options});
    }
    return list;
}
Formats one(std::string_view name, std::string_view extension, const Message<>& description,
            Language language) {
    return {{std::string(name), std::string(extension), description.in(language), {}}};
}

struct Kind {
    std::string_view name;
    Formats (*formats)(Language language);
    Json (*write)(const Arguments& arguments);
    std::string_view takes;  ///< by all formats, besides those that a format has for itself
};

constexpr Kind kinds[] = {
    {"chart",
     [](Language language) { return one("grafcet", ".grafcet", say::canonical_text, language); },
     export_chart, ""},
    {"drawing", [](Language language) { return described(drawing_formats(), language); },
     export_drawing, "notation paper stimuli at"},
    {"equations", [](Language) { return named(equation_format_table); }, export_equations,
     "cdx modes"},
    {"netlist", netlists, export_netlist, "style cdx modes delay"},
    {"program", [](Language language) { return described(plc_formats(), language); },
     export_program, "modes"},
    {"trace", [](Language language) { return described(trace_formats(), language); }, export_trace,
     "stimuli period"},
    {"gates", [](Language language) { return described(trace_formats(), language); }, export_gates,
     "stimuli period style cdx modes delay"},
    {"waveform", [](Language language) { return one("vcd", ".vcd", say::waveform, language); },
     export_waveform, "stimuli period"},
    {"gate-waveform",
     [](Language language) { return one("vcd", ".vcd", say::gate_waveform, language); },
     export_gate_waveform, "stimuli period style cdx modes delay"},
    {"story", [](Language language) { return one("text", ".txt", say::story, language); },
     export_story, "stimuli period"},
    {"gate-story", [](Language language) { return one("text", ".txt", say::gate_story, language); },
     export_gate_story, "stimuli period style cdx modes delay"},
    {"report", [](Language) { return named(report_forms()); }, export_report,
     "style cdx modes delay changes period assume max_cases"},
};

/// `stimuli period` and `--pull-up`, as names of arguments.
Words words_of(std::string_view list) {
    Words words;
    std::string word;
    for (const char c : std::string(list) + ' ') {
        if (c == ' ') {
            if (!word.empty()) words.push_back(word);
            word.clear();
        } else if (c != '-' || !word.empty()) {
            word += c == '-' ? '_' : c;
        }
    }
    for (std::string& each : words) {
        if (each == "stim") each = "stimuli";
    }
    return words;
}

}  // namespace

Json answer_exports(const Arguments& arguments, const Asked&) {
    Json list = Json::array();
    for (const Kind& kind : kinds) {
        for (const ListedFormat& format : kind.formats(arguments.language())) {
            Words takes = words_of(kind.takes);
            for (std::string& word : words_of(format.options)) takes.push_back(std::move(word));
            list.push_back({{"kind", kind.name},
                            {"format", format.name},
                            {"suffix", format.extension},
                            {"description", format.description},
                            {"mime", media_type_of(format.extension)},
                            {"takes", takes}});
        }
    }
    return Json{{"exports", std::move(list)}};
}

Json answer_export(const Arguments& arguments, const Asked&) {
    const std::string name = arguments.text("kind");
    for (const Kind& kind : kinds) {
        if (kind.name == name) return kind.write(arguments);
    }
    return unknown_value_answer(arguments, "kind");
}

}  // namespace grafwire::playground
