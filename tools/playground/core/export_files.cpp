// The files that are made of a chart alone, and the names of all of them.

#include "core/export_files.h"

#include "core/asked_chart.h"
#include "core/asked_drawing.h"
#include "core/asked_schematic.h"
#include "core/messages.h"
#include "core/requests.h"
#include "workflow/heads.h"
#include "workflow/programs.h"

namespace grafwire::playground {

std::string file_beside(const Arguments& arguments, std::string_view end) {
    std::string name = arguments.text("file", "chart.grafcet");
    name.erase(0, name.find_last_of('/') + 1);
    constexpr std::string_view own = ".grafcet";
    if (name.ends_with(own)) name.resize(name.size() - own.size());
    return name.append(end);
}

void FilesAnswer::add(const std::string& name, std::string text) {
    answer_["files"].push_back(
        {{"name", name}, {"text", std::move(text)}, {"mime", media_type_of(name)}});
}

Json file_answer(const Arguments& arguments, std::string_view extension, std::string text) {
    FilesAnswer files;
    files.add(file_beside(arguments, extension), std::move(text));
    return files.answer();
}

std::string_view media_type_of(std::string_view name) {
    struct Row {
        std::string_view extension;
        std::string_view type;
    };
    constexpr Row rows[] = {{".svg", "image/svg+xml"}, {".json", "application/json"},
                            {".csv", "text/csv"},      {".xml", "application/xml"},
                            {".md", "text/markdown"},  {".tex", "application/x-tex"}};
    for (const Row& row : rows) {
        if (name.ends_with(row.extension)) return row.type;
    }
    return "text/plain";
}

Json export_chart(const Arguments& arguments) {
    Json answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    Diagnostics diagnostics;
    auto text = format_chart(chart->source, arguments.language(), diagnostics);
    return file_answer(arguments, ".grafcet", text.value_or(std::string()));
}

Json export_drawing(const Arguments& arguments) {
    Json answer;
    const DrawingFormat* format = asked_row(arguments, "format", drawing_formats(), answer);
    if (format == nullptr) return answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const auto how = asked_drawing(arguments, *chart, answer);
    if (!how) return answer;
    return file_answer(arguments, format->extension,
                       chart_drawing(*chart, *how, *format, arguments.flag("standalone", false)));
}

Json export_equations(const Arguments& arguments) {
    Json answer;
    const auto* format = asked_row(arguments, "format", equation_format_table, answer);
    if (format == nullptr) return answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const CdxRow* cdx = asked_row(arguments, "cdx", cdx_table, answer);
    if (cdx == nullptr) return answer;
    return file_answer(
        arguments, format->extension,
        equation_report(*chart, {cdx->form, arguments.flag("modes", true)},
                        {format->format, arguments.flag("karnaugh", false), arguments.language(),
                         arguments.flag("standalone", false)}));
}

namespace {

/// A netlist in a format, and its bench.
Json netlist_files(const Arguments& arguments, const NetlistFormat& format, const Chart& chart,
                   const NetlistOptions& options, const Netlist& netlist) {
    Json answer;
    std::optional<Stimuli> stimuli;
    std::string stimuli_file;
    if (arguments.has("stimuli")) {
        stimuli = asked_stimuli(arguments, chart, answer);
        if (!stimuli) return answer;
        stimuli_file = arguments.text("stimuli_file", "chart.stim");
    }
    const AskedPeriod period = asked_period(arguments, "scan", answer);
    if (!period.is_good) return answer;
    const Time scan_period = period.value.value_or(10 * millisecond);
    const std::string file = file_beside(arguments, format.extension);
    WrittenNetlist written = write_netlist(
        chart, netlist, format, stimuli ? &*stimuli : nullptr, scan_period, options.delays,
        netlist_heads(chart, options, format, {scan_period, stimuli_file, file},
                      arguments.flag("bench", false)));
    FilesAnswer files;
    files.add(file, std::move(written.text));
    if (!written.bench.empty()) {
        files.add(file_beside(arguments, "_bench" + std::string(format.extension)),
                  std::move(written.bench));
    }
    return files.answer();
}

}  // namespace

Json export_netlist(const Arguments& arguments) {
    Json answer;
    const NetlistTarget* target = asked_row(arguments, "format", netlist_targets(), answer);
    if (target == nullptr) return answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    const auto options = asked_options(arguments, answer);
    if (!options) return answer;
    const auto netlist = asked_netlist(arguments, *chart, *options, answer);
    if (!netlist) return answer;
    if (target->format != nullptr) {
        return netlist_files(arguments, *target->format, *chart, *options, *netlist);
    }
    const auto how = asked_schematic(arguments, *chart, *netlist, *options, answer);
    if (!how) return answer;
    return file_answer(
        arguments, target->drawing->extension,
        schematic_drawing(*netlist, *how, *target->drawing, arguments.flag("standalone", false)));
}

namespace {

PlcOptions asked_plc_options(const Arguments& arguments) {
    PlcOptions options;
    if (arguments.text("mnemonics", "simatic") != "simatic") {
        options.mnemonics = s7::Mnemonics::international;
    }
    options.offsets = arguments.text("offsets", "on") == "on";
    options.wide_tables = arguments.text("tables") == "wide";
    options.cpu = cpu_of_number(arguments.text("cpu"));
    options.pull_up = arguments.flag("pull_up", false);
    options.language = arguments.language();
    return options;
}

/// The table of assignment in `io`; `assignment` stays empty where there is none.
bool read_asked_assignment(const Arguments& arguments, const Chart& chart, const PlcFormat& format,
                           const PlcOptions& options, std::optional<s7::IoAssignment>& assignment,
                           Json& answer) {
    if (!arguments.has("io")) return true;
    const SourceFile source{arguments.text("io_file", "chart.io"), arguments.text("io")};
    Diagnostics diagnostics;
    assignment = read_assignment(source, format, options, chart, diagnostics);
    if (assignment) return true;
    answer = error_answer(say::bad_assignment(), arguments.language());
    answer["messages"] = format_diagnostics(diagnostics, source, arguments.language());
    return false;
}

}  // namespace

Json export_program(const Arguments& arguments) {
    Json answer;
    const PlcFormat* format = asked_row(arguments, "format", plc_formats(), answer);
    if (format == nullptr) return answer;
    const auto chart = asked_chart(arguments, answer);
    if (!chart) return answer;
    PlcOptions options = asked_plc_options(arguments);
    std::optional<s7::IoAssignment> assignment;
    if (!read_asked_assignment(arguments, *chart, *format, options, assignment, answer)) {
        return answer;
    }
    if (assignment) options.io = &*assignment;
    const bool modes = arguments.flag("modes", true);
    options.made_by = program_head(*chart, *format, options, modes,
                                   assignment ? arguments.text("io_file", "chart.io") : "");
    Diagnostics diagnostics;
    auto written = write_program(*chart, *format, options, modes, diagnostics);
    if (!written) {
        answer = Json{{"error", texts_of(diagnostics, arguments.language())}};
        answer["diagnostics"] =
            diagnostics_answer(diagnostics, chart->source.text, arguments.language());
        return answer;
    }
    FilesAnswer files;
    files.add(file_beside(arguments, format->extension), std::move(written->text));
    if (arguments.flag("addresses", false) && !written->addresses.empty()) {
        files.add(file_beside(arguments, ".io"), std::move(written->addresses));
    }
    return files.answer();
}

}  // namespace grafwire::playground
