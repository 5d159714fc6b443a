#include "command/inputs.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "command/exit_status.h"
#include "equations/wiring_hazards.h"
#include "formats/blif/read_blif.h"
#include "formats/yosys/read_yosys_json.h"
#include "grafcet/parse_grafcet.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// A broken file can have very many errors; nobody reads more than these.
constexpr std::size_t most_errors = 100;

/// Messages may hold a list of all steps, say.
constexpr std::size_t most_of_message = 4000;

/// Who keeps the messages, if anybody does. Any part of a command may have one to show, so they are
/// caught where they leave the program.
std::string* kept_messages = nullptr;

}  // namespace

MessageRecord::MessageRecord() {
    kept_messages = &text_;
}

MessageRecord::~MessageRecord() {
    kept_messages = nullptr;
}

void show(std::string_view text) {
    fmt::print(stderr, "{}", text);
    if (kept_messages != nullptr) *kept_messages += text;
}

void show_diagnostics(const Diagnostics& diagnostics, const SourceFile& source) {
    show(format_diagnostics(diagnostics, source, most_errors));
}

void complain(std::string_view message) {
    show(
        fmt::format("grafwire: error: {}\n", visible(shortened(message, most_of_message), "\t\n")));
}

void warn(std::string_view message) {
    show(fmt::format("grafwire: warning: {}\n", visible(message, "\t\n")));
}

std::optional<LoadedGrafcet> load_grafcet(const std::string& path) {
    Diagnostics diagnostics;
    SourceFile source = read_source(path, diagnostics);
    std::optional<Grafcet> grafcet;
    if (!diagnostics.has_errors()) grafcet = parse_grafcet(source, diagnostics);
    show_diagnostics(diagnostics, source);
    if (!grafcet) return std::nullopt;
    return LoadedGrafcet{std::move(source), std::move(*grafcet), diagnostics.items()};
}

void show_wiring_warnings(const LoadedGrafcet& loaded, CdxForm cdx) {
    Diagnostics diagnostics;
    warn_of_wiring(loaded.grafcet, cdx, diagnostics);
    diagnostics.sort_by_place();
    show_diagnostics(diagnostics, loaded.source);
}

std::optional<Stimuli> load_stimuli(const std::string& path, const Grafcet& grafcet) {
    Diagnostics diagnostics;
    const SourceFile source = read_source(path, diagnostics);
    std::optional<Stimuli> stimuli;
    if (!diagnostics.has_errors()) stimuli = parse_stimuli(source, grafcet, diagnostics);
    show_diagnostics(diagnostics, source);
    return stimuli;
}

bool share_standard_input(const std::string& path, const std::string& stimuli) {
    if (path != "-" || stimuli != "-") return false;
    complain("GRAFCET and stimuli cannot both come from standard input: give a file for one");
    return true;
}

std::optional<Netlist> load_netlist(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension();
    if (extension != ".blif" && extension != ".json") {
        complain(
            fmt::format("{}: a netlist to compare with is a .blif or a .json (Yosys) file", path));
        return std::nullopt;
    }
    Diagnostics diagnostics;
    const SourceFile source = read_source(path, diagnostics);
    std::optional<Netlist> netlist;
    if (!diagnostics.has_errors()) {
        netlist = extension == ".blif" ? read_blif(source, diagnostics)
                                       : read_yosys_json(source, diagnostics);
    }
    show_diagnostics(diagnostics, source);
    return netlist;
}

std::optional<Time> parse_period(const std::string& text) {
    const auto period = parse_duration(text);
    if (!period || *period <= 0) {
        complain(fmt::format("'{}' is no period: write a positive duration such as 10ms", text));
        return std::nullopt;
    }
    return period;
}

int finish(OutputFiles& files, int status) {
    if (const auto problem = files.write()) {
        complain(*problem);
        return bad_request;
    }
    return status;
}

}  // namespace grafwire
