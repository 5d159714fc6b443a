#include <fmt/format.h>

#include "command/command.h"
#include "command/exit_status.h"
#include "command/inputs.h"
#include "plc/formats.h"
#include "program/program.h"

namespace grafwire {

namespace {

struct Request {
    std::string path;
    std::string format;
    std::string modes = "on";
    std::string io;
    std::string mnemonics = "simatic";
    std::string offsets = "on";
    std::string tables = "standard";
    std::string cpu;
    std::string addresses;
    std::string output;
};

const PlcFormat* find_format(const std::string& name) {
    if (const PlcFormat* format = plc_format_named(name)) return format;
    std::string message = fmt::format("there is no format '{}'", name);
    const auto nearest = nearest_name(name, plc_format_names());
    if (!nearest.empty()) message += fmt::format("; did you mean '{}'?", nearest);
    complain(message);
    return nullptr;
}

/// Options that only some formats heed.
constexpr std::string_view special_options[] = {"--io",      "--addresses", "--mnemonics",
                                                "--offsets", "--tables",    "--cpu"};

/// Whether one of them has been given for a format that has no use for it; shows it if so.
bool has_idle_option(const CommandLine& line, const PlcFormat& format) {
    for (const std::string_view option : special_options) {
        if (!line.has(std::string(option))) continue;
        if (format.options.find(option) != std::string_view::npos) continue;
        std::vector<std::string_view> others;
        for (const PlcFormat& other : plc_formats()) {
            if (other.options.find(option) != std::string_view::npos) others.push_back(other.name);
        }
        complain(fmt::format("{} has no {}; it is for {}", format.name, option,
                             fmt::join(others, ", ")));
        return true;
    }
    return false;
}

PlcOptions options_from(const Request& request) {
    PlcOptions options;
    options.mnemonics =
        request.mnemonics == "simatic" ? Mnemonics::simatic : Mnemonics::international;
    options.offsets = request.offsets == "on";
    options.wide_tables = request.tables == "wide";
    if (!request.cpu.empty()) {
        options.cpu = request.cpu == "212" ? s7::Cpu::cpu_212 : s7::Cpu::cpu_214;
    }
    return options;
}

/// An assignment that suits chart and format, with messages shown; empty after an error.
std::optional<s7::IoAssignment> load_assignment(const Request& request, const PlcFormat& format,
                                                const Grafcet& grafcet) {
    Diagnostics diagnostics;
    const SourceFile source = read_source(request.io, diagnostics);
    std::optional<s7::IoAssignment> assignment;
    if (!diagnostics.has_errors()) assignment = s7::parse_io_assignment(source, diagnostics);
    if (assignment) {
        PlcOptions options = options_from(request);
        options.io = &*assignment;
        format.check_io(grafcet, options, diagnostics);
    }
    show_diagnostics(diagnostics, source);
    if (diagnostics.has_errors()) return std::nullopt;
    return assignment;
}

}  // namespace

std::function<int()> declare_plc(const CommandLine& line, const Language&) {
    const auto request = std::make_shared<Request>();
    line.add("FILE", request->path, "the GRAFCET, - for standard input").required();
    line.add("--to", request->format,
             fmt::format("language: {}", fmt::join(plc_format_names(), ", ")))
        .required();
    line.add("--modes", request->modes, "with Init, AUdur and AUdoux")
        .one_of({"on", "off"})
        .shows_default();
    line.add("--io", request->io, "addresses of names, one a line: E0.0 = start");
    line.add("--addresses", request->addresses,
             "file for the addresses of all names, in the form of --io");
    line.add("--mnemonics", request->mnemonics, "spelling of instructions")
        .one_of({"simatic", "iec", "en"})
        .shows_default();
    line.add("--offsets", request->offsets, "byte offsets before instructions")
        .one_of({"on", "off"})
        .shows_default();
    line.add("--tables", request->tables, "80 steps, or as many as the chart has")
        .one_of({"standard", "wide"})
        .shows_default();
    line.add("--cpu", request->cpu, "controller whose memory has to hold the program")
        .one_of({"212", "214"});
    line.add("-o", request->output, "output file (default: standard output)");
    return [request, line] {
        // Read the request and the GRAFCET.
        const PlcFormat* format = find_format(request->format);
        if (format == nullptr || has_idle_option(line, *format)) {
            return static_cast<int>(bad_request);
        }
        if (request->path == "-" && request->io == "-") {
            complain("GRAFCET and assignment cannot both come from standard input");
            return static_cast<int>(bad_request);
        }
        const auto loaded = load_grafcet(request->path);
        if (!loaded) return static_cast<int>(bad_request);
        PlcOptions options = options_from(*request);
        std::optional<s7::IoAssignment> assignment;
        if (!request->io.empty()) {
            assignment = load_assignment(*request, *format, loaded->grafcet);
            if (!assignment) return static_cast<int>(bad_request);
            options.io = &*assignment;
        }
        // Make the program of one scan, and write it.
        const ScanProgram program = program_from(loaded->grafcet, {request->modes == "on"});
        Diagnostics diagnostics;
        std::string text = format->write(program, options, diagnostics);
        show_diagnostics(diagnostics, loaded->source);
        if (diagnostics.has_errors()) return static_cast<int>(bad_request);
        OutputFiles files({request->path, request->io});
        files.add(request->output, std::move(text));
        if (!request->addresses.empty()) {
            Diagnostics already_shown;
            files.add(request->addresses, format->write_addresses(program, options, already_shown));
        }
        return finish(files, done);
    };
}

}  // namespace grafwire
