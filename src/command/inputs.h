#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command/files.h"
#include "equations/equations.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "s7/machine/binding.h"
#include "trace/stimuli.h"

namespace grafwire {

/// A GRAFCET read from a file, with every message about it shown; empty after an error.
struct LoadedGrafcet {
    SourceFile source;
    Grafcet grafcet;
    std::vector<Diagnostic> warnings;
};
std::optional<LoadedGrafcet> load_grafcet(const std::string& path);

/// Shows what the structure of a GRAFCET puts at risk in asynchronous wiring with this form of CDX.
void show_wiring_warnings(const LoadedGrafcet& loaded, CdxForm cdx);

/// Stimuli for a GRAFCET, likewise.
std::optional<Stimuli> load_stimuli(const std::string& path, const Grafcet& grafcet);

/// Whether both are to come from standard input, which can be read only once; shows it if so.
bool share_standard_input(const std::string& path, const std::string& stimuli);

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

/// Keeps what is shown on standard error while it lives; one at a time.
class MessageRecord {
  public:
    MessageRecord();
    ~MessageRecord();
    MessageRecord(const MessageRecord&) = delete;
    MessageRecord& operator=(const MessageRecord&) = delete;

    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// Shows lines on standard error; so do all functions that show something.
void show(std::string_view text);

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
