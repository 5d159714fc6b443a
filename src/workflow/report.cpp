// All that the other use cases know of a chart, put onto one page. A style that cannot hold the
// chart stands there with its reason.

#include "workflow/report.h"

#include <fmt/format.h>

#include <utility>

#include "draw/timing_diagram.h"
#include "draw/write_drawing.h"
#include "equations/report/write_equations.h"
#include "grafcet/write_grafcet.h"
#include "report/report.h"
#include "text/joined.h"
#include "workflow/check.h"
#include "workflow/drawings.h"
#include "workflow/messages.h"
#include "workflow/netlists.h"
#include "workflow/runs.h"
#include "workflow/schematics.h"

namespace grafwire {

namespace {

namespace say = messages::workflow;

/// Line number `number` of a text, from 1.
std::string_view line_of(std::string_view text, std::size_t number) {
    for (; number > 1 && !text.empty(); --number) {
        const std::size_t end = text.find('\n');
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return text.substr(0, text.find('\n'));
}

/// The comment behind what stands in a line; `#` within quotes begins none.
std::string comment_in(std::string_view line) {
    bool is_quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"') is_quoted = !is_quoted;
        if (line[i] != '#' || is_quoted) continue;
        const std::size_t begin = line.find_first_not_of("# \t", i);
        if (begin == std::string_view::npos) return {};
        const std::size_t end = line.find_last_not_of(" \t\r");
        return std::string(line.substr(begin, end + 1 - begin));
    }
    return {};
}

template <typename Table>
std::vector<ReportedName> names_of(const Chart& chart, const Table& table) {
    std::vector<ReportedName> names;
    for (const auto& item : table) {
        names.push_back({item.name, comment_in(line_of(chart.source.text, item.where.line))});
    }
    return names;
}

std::vector<std::string> texts_of(const std::vector<Diagnostic>& messages, Language language) {
    std::vector<std::string> texts;
    for (const Diagnostic& message : messages) {
        texts.push_back(message.where.is_known()
                            ? say::at_line(message.where.line, message.message).in(language)
                            : message.message.in(language));
    }
    return texts;
}

ReportedRun run_of(const Chart& chart, const ReportRequest& request) {
    const Stimuli& stimuli = *request.stimuli;
    const ToldRun run = tell_reference(chart, stimuli, std::nullopt);
    ReportedRun reported;
    reported.file = request.stimuli_file;
    for (const RunResult::BrokenAssumption& broken : run.result.broken_assumptions) {
        reported.remarks.push_back(
            broken_assumption_text(chart.grafcet, broken).in(request.language));
    }
    TimingDrawing how;
    how.title = title_of(chart.grafcet);
    how.language = request.language;
    how.causes = causes_of(run.result.trace, chart.grafcet, run);
    reported.pictures =
        write_svg_sheets(draw_timing(run.result.trace, how), how.title, request.language, "run");
    reported.story = explain_run(chart, run, request.language);
    return reported;
}

ReportedStyle::Outcome outcome_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::equivalent:
            return ReportedStyle::Outcome::equivalent;
        case Verdict::different:
            return ReportedStyle::Outcome::different;
        case Verdict::undecided:
            break;
    }
    return ReportedStyle::Outcome::undecided;
}

CheckRequest check_request(const StyleRow& row, const ReportRequest& request) {
    CheckRequest asked;
    asked.subject.file = request.file;
    asked.subject.style = row.name;
    asked.subject.cdx = name_of(row.default_cdx);
    asked.changes = request.changes;
    asked.max_cases = request.max_cases;
    asked.workers = request.workers;
    asked.progress = request.progress;
    asked.keep_going = request.keep_going;
    asked.language = request.language;
    asked.with_files = true;
    return asked;
}

ReportedStyle style_of(const Chart& chart, const StyleRow& row, const ReportRequest& request) {
    ReportedStyle style;
    style.name = row.name;
    style.description = row.description.in(request.language);
    Diagnostics messages;
    const auto netlist = make_netlist(chart, {.style = row.style, .cdx = {}}, messages);
    std::optional<Judgement> judgement;
    if (netlist) {
        judgement = check_netlist(chart, *netlist, check_request(row, request), messages);
    }
    if (!judgement) {
        style.outcome = ReportedStyle::Outcome::not_made;
        style.remarks =
            fmt::format("{}\n", joined(texts_of(messages.items(), request.language), "\n"));
        return style;
    }
    style.outcome = outcome_of(judgement->result.verdict);
    CheckParts parts = check_parts(judgement->subject, chart.grafcet, judgement->result,
                                   judgement->explained, request.language);
    style.basis = std::move(parts.basis);
    style.compared = std::move(parts.coverage);
    style.remarks = std::move(parts.remarks);
    style.witness = std::move(parts.witness);
    style.pictures = write_svg_sheets(judgement->witness_picture, title_of(chart.grafcet),
                                      request.language, fmt::format("style-{}", row.name));
    return style;
}

/// Empty where the style cannot hold the chart: the verdicts say why.
std::vector<std::string> schematic_of(const Chart& chart, const ReportRequest& request) {
    Diagnostics messages;
    const auto netlist = make_netlist(chart, {.style = request.style, .cdx = {}}, messages);
    if (!netlist) return {};
    SchematicDrawing how;
    how.title = schematic_title(chart, request.style, std::nullopt, request.language);
    how.shapes = request.shapes;
    how.language = request.language;
    return write_svg_sheets(draw_schematic(*netlist, how), how.title, request.language,
                            "schematic");
}

}  // namespace

std::string report_of(const Chart& chart, const ReportRequest& request) {
    const Grafcet& grafcet = chart.grafcet;
    Report report;
    report.title = title_of(grafcet);
    report.name = grafcet.name;
    report.file = request.file;
    ChartDrawing how;
    how.language = request.language;
    report.chart =
        write_svg_sheets(draw_chart(grafcet, how), report.title, request.language, "chart");
    report.inputs = names_of(chart, grafcet.inputs);
    report.outputs = names_of(chart, grafcet.outputs);
    EquationReport equations;
    equations.format = EquationFormat::html;
    equations.language = request.language;
    report.equations = equation_report(chart, {}, equations);
    report.wired_style = style_table[static_cast<std::size_t>(request.style)].name;
    report.schematic = schematic_of(chart, request);
    if (request.stimuli != nullptr) report.runs.push_back(run_of(chart, request));
    for (const StyleRow& row : style_table) report.styles.push_back(style_of(chart, row, request));
    for (const Assumption& assumption : grafcet.assumptions) {
        report.assumptions.push_back(
            write_expression(grafcet, grafcet.expressions, assumption.expression));
    }
    report.warnings = texts_of(chart.warnings, request.language);
    report.hazards = texts_of(wiring_warnings(chart, CdxForm::successor).items(), request.language);
    report.source = chart.source.text;
    report.picture_style = svg_style();
    return write_report(report, request.language);
}

}  // namespace grafwire
