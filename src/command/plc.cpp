#include <fmt/format.h>

#include "command/command.h"
#include "plc/formats.h"
#include "program/program.h"

namespace grafwire {

namespace {

struct Request {
    std::string path;
    std::string format;
    std::string modes = "on";
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

}  // namespace

std::function<int()> declare_plc(CLI::App& app, const Language&) {
    const auto request = std::make_shared<Request>();
    app.add_option("FILE", request->path, "the GRAFCET, - for standard input")->required();
    app.add_option("--to", request->format,
                   fmt::format("language: {}", fmt::join(plc_format_names(), ", ")))
        ->required();
    app.add_option("--modes", request->modes, "with Init, AUdur and AUdoux")
        ->check(CLI::IsMember({"on", "off"}))
        ->capture_default_str();
    app.add_option("-o", request->output, "output file (default: standard output)");
    return [request] {
        // Read the request and the GRAFCET.
        const PlcFormat* format = find_format(request->format);
        if (format == nullptr) return static_cast<int>(bad_request);
        const auto loaded = load_grafcet(request->path);
        if (!loaded) return static_cast<int>(bad_request);
        // Make the program of one scan, and write it.
        const ScanProgram program = program_from(loaded->grafcet, {request->modes == "on"});
        PlcOptions options;
        Diagnostics diagnostics;
        std::string text = format->write(program, options, diagnostics);
        if (diagnostics.has_errors()) {
            std::fputs(format_diagnostics(diagnostics, loaded->source).c_str(), stderr);
            return static_cast<int>(bad_request);
        }
        OutputFiles files;
        files.add(request->output, std::move(text));
        return finish(files, done);
    };
}

}  // namespace grafwire
