#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

#include "command/files.h"
#include "equations/equations.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist_from.h"
#include "s7/machine/binding.h"
#include "text/language.h"
#include "trace/stimuli.h"

namespace grafwire {

/// What the program ends with.
enum ExitStatus : int {
    done = 0,
    answer_is_no = 1,
    bad_request = 2,
    out_of_bounds = 3,
};

/// One row of the table of commands: adds its options to the parser and returns what to do once
/// they have been read.
struct Command {
    std::string_view name;
    std::string_view summary;
    std::string_view example;
    std::function<int()> (*declare)(CLI::App& app, const Language& language);
};

std::function<int()> declare_info(CLI::App& app, const Language& language);
std::function<int()> declare_equations(CLI::App& app, const Language& language);
std::function<int()> declare_run(CLI::App& app, const Language& language);
std::function<int()> declare_netlist(CLI::App& app, const Language& language);
std::function<int()> declare_simulate(CLI::App& app, const Language& language);
std::function<int()> declare_check(CLI::App& app, const Language& language);
std::function<int()> declare_plc(CLI::App& app, const Language& language);
std::function<int()> declare_s7(CLI::App& app, const Language& language);

/// A GRAFCET read from a file, with every message about it shown; empty after an error.
struct LoadedGrafcet {
    SourceFile source;
    Grafcet grafcet;
};
std::optional<LoadedGrafcet> load_grafcet(const std::string& path);

/// Stimuli for a GRAFCET, likewise.
std::optional<Stimuli> load_stimuli(const std::string& path, const Grafcet& grafcet);

/// Whether both are to come from standard input, which can be read only once; shows it if so.
bool share_standard_input(const std::string& path, const std::string& stimuli);

/// The options that say which netlist to make; shared by several commands.
struct NetlistRequest {
    std::string style;
    std::string cdx;
    std::string modes = "on";
    void declare(CLI::App& app, bool style_is_required);
    /// The form of CDX that results.
    CdxForm cdx_form() const;
    std::string_view cdx_name() const;
    Style style_id() const;
};

/// The generated netlist, with messages shown; empty after an error.
std::optional<Netlist> make_netlist(const LoadedGrafcet& loaded, const NetlistRequest& request);

/// A netlist from a `.blif` or `.json` file, with messages shown; empty after an error.
std::optional<Netlist> load_netlist(const std::string& path);

/// A table of assignment, an S7-200 listing for a controller (`212` or `214`), and where it keeps
/// what a GRAFCET names, likewise.
struct LoadedAssignment {
    SourceFile source;
    s7::IoAssignment assignment;
};
std::optional<LoadedAssignment> load_assignment(const std::string& path);
s7::Cpu cpu_named(const std::string& name);
std::optional<s7::Listing> load_listing(const std::string& path, const std::string& cpu,
                                        const s7::IoAssignment* io);
std::optional<s7::Binding> bind_listing(const Grafcet& grafcet, const s7::IoAssignment& io,
                                        const SourceFile& source);

/// Shows messages about a source file on standard error.
void show_diagnostics(const Diagnostics& diagnostics, const SourceFile& source);

/// `fits` a duration option: parses it, or says why not on standard error.
std::optional<Time> parse_period(const std::string& text);

/// Shows a message of the program itself on standard error.
void complain(std::string_view message);
void warn(std::string_view message);

/// Writes the files; a problem is shown, and turns `status` into bad_request.
int finish(OutputFiles& files, int status);

}  // namespace grafwire
