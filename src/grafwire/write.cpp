// Texts made of a chart or a netlist: equations, netlists, programs.

#include "grafwire/write.h"

#include <fmt/format.h>

#include "grafwire/messages.h"
#include "grafwire/parts.h"
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
    return error(
        messages::library::unknown_format(name, fmt::format("{}", fmt::join(names, ", "))));
}

}  // namespace

Result<std::string> write_netlist(const Netlist& netlist, std::string_view format,
                                  std::chrono::nanoseconds period) {
    const NetlistFormat* row = netlist_format_named(format);
    if (row == nullptr) return {std::nullopt, {no_format(format, netlist_format_names())}};
    const CheckedPeriod checked = period_from(period);
    if (checked.is_wrong) return {std::nullopt, {wrong_period()}};
    const Netlist::Parts& parts = netlist.parts();
    WrittenNetlist written = grafwire::write_netlist(parts.chart.parts().chart, parts.netlist, *row,
                                                     nullptr, *checked.value, DelayModel());
    return {std::move(written.text), {}};
}

Result<std::string> write_program(const Chart& chart, std::string_view format, bool modes) {
    const PlcFormat* row = plc_format_named(format);
    if (row == nullptr) return {std::nullopt, {no_format(format, plc_format_names())}};
    Diagnostics diagnostics;
    auto written =
        grafwire::write_program(chart.parts().chart, *row, PlcOptions(), modes, diagnostics);
    Result<std::string> result{std::nullopt, messages_from(diagnostics)};
    if (written) result.value = std::move(written->text);
    return result;
}

}  // namespace grafwire::api
