// Every file is read in the same way: its text, then what the workflow makes of it, then the
// messages about either, with their places. After an error there is no value, and the command ends.

#include "command/inputs.h"

#include <algorithm>
#include <filesystem>

#include "command/fst_file.h"
#include "command/help.h"
#include "command/messages.h"
#include "command/terminal.h"
#include "netlist/passes/wire_delays.h"
#include "schedule/delays_text.h"
#include "text/joined.h"
#include "text/nearest_name.h"
#include "trace/trace.h"
#include "workflow/orders.h"

namespace grafwire {

namespace {

namespace say = messages::command;
namespace help = messages::help;

/// Reads a file, then what `read` makes of its text; shows what is to be said of either.
template <typename File, typename Read>
auto load(const File& file, SourceFile& source, const Read& read) {
    Diagnostics diagnostics;
    source = read_source(file, diagnostics);
    decltype(read(source, diagnostics)) result;
    if (!diagnostics.has_errors()) result = read(source, diagnostics);
    show_diagnostics(diagnostics, source);
    return result;
}

}  // namespace

Diagnostics as_asked(Diagnostics diagnostics, const CommandLine& line) {
    if (!line.is_strict()) return diagnostics;
    Diagnostics errors;
    for (const Diagnostic& item : diagnostics.items()) {
        errors.error(item.code, item.where, item.message).notes = item.notes;
    }
    return errors;
}

std::optional<Chart> load_chart(const std::string& path) {
    SourceFile source;
    return load(path, source, [](const SourceFile& text, Diagnostics& diagnostics) {
        return read_chart(text, diagnostics);
    });
}

std::optional<Chart> load_chart(const std::string& path, const CommandLine& line) {
    return load_chart(ChartFile{path}, line);
}

std::optional<Chart> load_chart(const ChartFile& file, const CommandLine& line) {
    SourceFile source;
    return load(file, source,
                [&](const SourceFile& text, Diagnostics& diagnostics) -> std::optional<Chart> {
                    auto chart = read_chart(text, diagnostics);
                    diagnostics = as_asked(std::move(diagnostics), line);
                    if (diagnostics.has_errors()) return std::nullopt;
                    return chart;
                });
}

bool show_wiring_warnings(const Chart& chart, CdxForm cdx, const CommandLine& line) {
    const Diagnostics diagnostics = as_asked(wiring_warnings(chart, cdx), line);
    show_diagnostics(diagnostics, chart.source);
    return !diagnostics.has_errors();
}

std::optional<Stimuli> load_stimuli(const std::string& path, const Grafcet& grafcet) {
    SourceFile source;
    return load(path, source, [&](const SourceFile& text, Diagnostics& diagnostics) {
        return parse_stimuli(text, grafcet, diagnostics);
    });
}

std::optional<DelaySchedule> load_delays(const std::string& path, Netlist& netlist) {
    SourceFile source;
    return load(path, source, [&](const SourceFile& text, Diagnostics& diagnostics) {
        const std::vector<Wire> wires = wires_named_in(text, netlist);
        if (!wires.empty()) netlist = with_wire_delays(netlist, wires);
        return read_delays(text, netlist, diagnostics);
    });
}

bool share_standard_input(const std::string& path, const std::string& stimuli) {
    return share_standard_input(std::vector{path}, stimuli);
}

bool share_standard_input(const std::vector<std::string>& paths, const std::string& stimuli) {
    if (stimuli != "-" || std::find(paths.begin(), paths.end(), "-") == paths.end()) return false;
    complain(say::stimuli_share_standard_input());
    return true;
}

std::optional<Netlist> load_netlist(const std::string& path) {
    const NetlistFormat* format = readable_format_of(path);
    if (format == nullptr) {
        complain(say::no_netlist_file(path));
        return std::nullopt;
    }
    SourceFile source;
    return load(path, source, format->read);
}

std::optional<LoadedAssignment> load_assignment(const std::string& path) {
    SourceFile source;
    auto assignment = load(path, source, [](const SourceFile& text, Diagnostics& diagnostics) {
        return read_assignment(text, diagnostics);
    });
    if (!assignment) return std::nullopt;
    return LoadedAssignment{std::move(source), std::move(*assignment)};
}

std::optional<s7::Listing> load_listing(const std::string& path, s7::Cpu cpu,
                                        const s7::IoAssignment* io) {
    SourceFile source;
    return load(path, source, [&](const SourceFile& text, Diagnostics& diagnostics) {
        return read_listing(text, cpu, io, diagnostics);
    });
}

/// No text is no period, which is right where a period may be left out.
std::optional<Time> parse_moment(const std::string& text) {
    if (text == "0") return 0;
    const std::optional<Time> at = parse_duration(text);
    if (!at) complain(say::no_moment(text));
    return at;
}

Period parse_period(const std::string& text) {
    if (text.empty()) return {};
    const auto period = parse_duration(text);
    if (!period || *period <= 0) {
        complain(say::no_period(text));
        return {std::nullopt, true};
    }
    return {period, false};
}

bool has_too_many_scans(const Grafcet& grafcet, const Stimuli& stimuli, const Period& period) {
    constexpr std::size_t most_values = 100'000'000;  // of 8 bytes each
    if (!period.value) return false;
    const std::size_t columns = empty_trace(grafcet).columns.size();
    const Time scans = stimuli.end / *period.value + 1;
    if (static_cast<std::size_t>(scans) <= most_values / columns) return false;
    complain(say::too_many_scans(scans, columns, most_values));
    return true;
}

void complain_of_format(std::string_view name, const std::vector<std::string_view>& names) {
    const std::string_view nearest = nearest_name(name, names);
    complain(nearest.empty() ? say::unknown_format(name, joined(names, ", "))
                             : say::unknown_format_near(name, nearest));
}

/// A style is required where the netlist is all there is to the command.
void NetlistRequest::declare(const CommandLine& line, bool style_is_required) {
    const AddedOption option =
        line.add("--style", style, with_rows(help::style(), style_table)).one_of_names(style_table);
    if (style_is_required) {
        option.required();
    } else {
        style = "nand";
        option.shows_default();
    }
    declare_equations(line);
}

void NetlistRequest::declare_equations(const CommandLine& line) {
    line.add("--cdx", cdx, help::cdx_by_style()).one_of_names(cdx_table);
    line.add("--modes", modes, help::modes()).one_of({"on", "off"}).shows_default();
    line.add_flag("--interlock", interlock, help::interlock());
}

void NetlistRequest::declare_delay(const CommandLine& line) {
    line.add("--delay", delay, help::delay())
        .one_that([](std::string_view text) { return delay_model_of(text).has_value(); },
                  delay_model_names())
        .shows_default();
}

DelayModel NetlistRequest::delays() const {
    return delay_model_of(delay).value_or(DelayModel());
}

NetlistOptions NetlistRequest::options() const {
    NetlistOptions options;
    if (const StyleRow* row = row_named(style_table, style)) options.style = row->style;
    if (const CdxRow* row = row_named(cdx_table, cdx)) options.cdx = row->form;
    options.modes = modes == "on";
    options.delays = delays();
    return options;
}

ChartToWire to_wire(Chart chart, const NetlistRequest& request) {
    if (!request.interlock) return {std::move(chart)};
    const OrderFindings findings = find_orders(chart, request.options().modes);
    show_diagnostics(interlock_warnings(chart, findings), chart.source);
    show_lines(told_interlocks(findings));
    return {interlocked_chart(chart, findings), interlock_sentences(findings)};
}

void warn_of_order(const Chart& chart, const NetlistRequest& request) {
    if (request.interlock || !request.is_handshake()) return;
    const OrderFindings findings = find_orders(chart, request.options().modes);
    show_diagnostics(order_warnings(chart, findings), chart.source);
}

std::optional<Netlist> make_netlist(const Chart& chart, const NetlistRequest& request) {
    if (const auto conflict = conflict_in(request.options())) {
        complain(*conflict);
        return std::nullopt;
    }
    Diagnostics diagnostics;
    auto netlist = make_netlist(chart, request.options(), diagnostics);
    show_diagnostics(diagnostics, chart.source);
    return netlist;
}

void TraceOutput::declare(const CommandLine& line) {
    line.add("-o", csv, help::trace()).names_file({});
    line.add("--vcd", vcd, help::waveform()).names_file({".vcd", ".fst"});
}

namespace {

bool is_fst(std::string_view path) {
    return path.ends_with(".fst");
}

}  // namespace

/// A viewer would take a waveform by its name for what it is not.
bool TraceOutput::is_refused() const {
    if (format_named(trace_formats(), format) == nullptr) return true;
    if (!is_fst(vcd) || can_write_fst()) return false;
    complain(say::no_fst(vcd.substr(0, vcd.size() - 4)));
    return true;
}

void TraceOutput::declare_format(const CommandLine& line) {
    line.add("--to", format, with_rows(help::trace_to(), trace_formats()))
        .names_row(trace_formats())
        .shows_default();
}

ChosenFormat TraceOutput::chosen() const {
    return chosen_format(trace_formats(), *row_named(trace_formats(), format));
}

bool TraceOutput::is_picture() const {
    return row_named(trace_formats(), format)->is_picture;
}

std::string TraceOutput::text_of(const ShownRun& run, const Chart& chart, Language language) const {
    if (format == "csv") return trace_text(run.trace, chart.grafcet, csv, language);
    return row_named(trace_formats(), format)->write(run, language);
}

bool TraceOutput::add_files(OutputFiles& files, std::string trace, const Waveform& waveform,
                            bool explained) const {
    if (!explained || !csv.empty()) files.add(csv, std::move(trace));
    if (vcd.empty()) return true;
    if (is_fst(vcd)) {
        std::string fst;
        if (const auto problem = make_fst(waveform.vcd, fst)) {
            complain(say::cannot_write(shown_place(vcd), *problem));
            return false;
        }
        files.add(vcd, std::move(fst));
    } else {
        files.add(vcd, waveform.vcd);
    }
    // A device, a pipe, standard output have nothing beside them.
    if (!is_fst(vcd) && !vcd.ends_with(".vcd")) return true;
    const std::string base = vcd.substr(0, vcd.size() - 4);
    const std::string name = std::filesystem::path(vcd).filename().string();
    files.add_unless_there(base + ".gtkw", write_gtkw(waveform, name));
    return true;
}

}  // namespace grafwire
