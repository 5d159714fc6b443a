// grafwire fmt: the text of a GRAFCET in its canonical layout, on standard output or in its place.

#include <algorithm>

#include "command/chart_files.h"
#include "command/command_line.h"
#include "command/help.h"
#include "command/inputs.h"
#include "command/messages.h"
#include "text/utf8.h"
#include "workflow/orders.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

/// What may be written after `grafwire fmt`.
struct FmtArguments {
    std::vector<std::string> files;
    bool in_place = false;
    bool check = false;
    bool interlock = false;

    std::optional<Localized> conflict(const ChartFiles& charts) const;
};

std::optional<Localized> FmtArguments::conflict(const ChartFiles& charts) const {
    if (in_place && check) return say::replace_or_check();
    if (in_place && std::find(files.begin(), files.end(), "-") != files.end()) {
        return say::standard_input_in_place();
    }
    if (!in_place && !check && charts.are_several) return say::one_file_to_standard_output();
    return std::nullopt;
}

/// A file as it is, and as it should be.
struct Formatted {
    SourceFile before;
    std::string after;
};

/// The text of a chart without errors with its interlocks, which are shown, and what they leave.
std::optional<std::string> with_interlocks_written(const SourceFile& source, Language language) {
    Diagnostics said_elsewhere;
    const auto chart = read_chart(source, said_elsewhere);
    if (!chart) return std::nullopt;
    const OrderFindings findings = find_orders(*chart, true);
    show_diagnostics(interlock_warnings(*chart, findings), source);
    show_lines(told_interlocks(findings));
    return format_chart({source.name, interlocked_text(*chart, findings)}, language,
                        said_elsewhere);
}

/// Empty after an error, which is shown. Warnings are not: the layout is right or wrong whatever
/// the chart means, and `grafwire info` has them.
std::optional<Formatted> format_file(const ChartFile& file, bool interlocks, Language language) {
    Diagnostics diagnostics;
    SourceFile source = read_source(file, diagnostics);
    std::optional<std::string> text;
    if (!diagnostics.has_errors()) text = format_chart(source, language, diagnostics);
    if (text && interlocks) text = with_interlocks_written(source, language);
    if (!text) {
        show_diagnostics(diagnostics, source);
        return std::nullopt;
    }
    return Formatted{std::move(source), std::move(*text)};
}

/// Each file by itself: one that is wrong or cannot be replaced does not stop the others, and the
/// status is the worst.
ExitStatus format_files(const FmtArguments& request, const ChartFiles& charts, Language language) {
    ExitStatus status = ExitStatus::done;
    std::string otherwise;
    for (const ChartFile& file : charts.files) {
        ExitStatus of_file = ExitStatus::bad_request;
        if (auto text = format_file(file, request.interlock, language)) {
            const bool differs = text->before.text != text->after;
            of_file = request.check && differs ? ExitStatus::answer_is_no : ExitStatus::done;
            if (request.check && differs) otherwise += visible(text->before.name) + '\n';
            if (!request.check && (differs || !request.in_place)) {
                // The input is what is to be replaced.
                OutputFiles files({});
                files.add(request.in_place ? file.path : "-", std::move(text->after));
                of_file = finish(files, of_file);
            }
        }
        status = worse_of(status, of_file);
    }
    if (!otherwise.empty()) {
        OutputFiles files({});
        files.add("-", std::move(otherwise));
        status = finish(files, status);
    }
    return status;
}

}  // namespace

Task declare_fmt(const CommandLine& line) {
    const auto request = std::make_shared<FmtArguments>();
    line.add_arguments(help::file_name, request->files, help::fmt_files()).names_file({".grafcet"});
    line.add_flag("-i", request->in_place, help::in_place());
    line.add_flag("--check", request->check, help::fmt_check());
    line.add_flag("--interlock", request->interlock, help::fmt_interlock());
    return [request, language = line.language()] {
        const ChartFiles charts = find_chart_files(request->files);
        if (const auto conflict = request->conflict(charts)) {
            complain(*conflict);
            return ExitStatus::bad_request;
        }
        return format_files(*request, charts, language);
    };
}

}  // namespace grafwire
