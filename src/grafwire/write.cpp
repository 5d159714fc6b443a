// Texts made of a chart or a netlist: equations, netlists, programs.

#include "grafwire/write.h"

#include "grafwire/messages.h"
#include "grafwire/parts.h"
#include "text/joined.h"
#include "workflow/programs.h"

namespace grafwire::api {

std::string equations(const Chart& chart, EquationForm form, const EquationOptions& options) {
    const grafwire::EquationOptions derivation{form_from(options.cdx), options.modes};
    EquationReport report;
    switch (form) {
        case EquationForm::text:
            report.format = EquationFormat::text;
            break;
        case EquationForm::markdown:
            report.format = EquationFormat::markdown;
            break;
        case EquationForm::latex:
            report.format = EquationFormat::latex;
            break;
        case EquationForm::csv:
            report.format = EquationFormat::csv;
            break;
        case EquationForm::json:
            report.format = EquationFormat::json;
            break;
    }
    report.karnaugh = options.karnaugh;
    report.language = language_from(options.language);
    report.standalone = options.standalone;
    return equation_report(chart.parts().chart, derivation, report);
}

std::vector<std::string> netlist_formats() {
    return strings(netlist_format_names());
}

std::vector<std::string> program_formats() {
    return strings(plc_format_names());
}

namespace {

/// Names what there is.
Message no_format(std::string_view name, const std::vector<std::string_view>& names) {
    return error(messages::library::unknown_format(name, joined(names, ", ")));
}

}  // namespace

Result<NetlistFile> write_netlist(const Netlist& netlist, std::string_view format,
                                  const NetlistFileOptions& options) {
    const NetlistFormat* row = netlist_format_named(format);
    if (row == nullptr) return {std::nullopt, {no_format(format, netlist_format_names())}};
    const grafwire::Chart& chart = netlist.parts().chart.parts().chart;
    std::optional<std::string> stimuli;
    if (!options.stimuli.empty()) stimuli = options.stimuli;
    const Start start = begin(chart, stimuli, options.period);
    Result<NetlistFile> result{std::nullopt, start.messages};
    if (!start.is_good) return result;
    WrittenNetlist written =
        grafwire::write_netlist(chart, netlist.parts().netlist, *row,
                                start.stimuli ? &*start.stimuli : nullptr, *start.period, {});
    result.value = NetlistFile{std::move(written.text), std::move(written.bench)};
    return result;
}

Result<std::string> write_program(const Chart& chart, std::string_view format,
                                  const ProgramOptions& options) {
    const PlcFormat* row = plc_format_named(format);
    if (row == nullptr) return {std::nullopt, {no_format(format, plc_format_names())}};
    Diagnostics diagnostics;
    PlcOptions written_as;
    written_as.language = language_from(options.language);
    auto written =
        grafwire::write_program(chart.parts().chart, *row, written_as, options.modes, diagnostics);
    Result<std::string> result{std::nullopt, messages_from(diagnostics)};
    if (written) result.value = std::move(written->text);
    return result;
}

}  // namespace grafwire::api
