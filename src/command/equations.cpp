#include <CLI/CLI.hpp>

#include "command/command.h"
#include "command/exit_status.h"
#include "command/netlist_request.h"
#include "equations/write_equations.h"

namespace grafwire {

namespace {

struct Request {
    std::string path;
    std::string cdx = "successor";
    std::string modes = "on";
    std::string format = "text";
    std::string output;
    bool karnaugh = false;
};

EquationFormat format_named(const std::string& name) {
    if (name == "markdown") return EquationFormat::markdown;
    if (name == "latex") return EquationFormat::latex;
    if (name == "csv") return EquationFormat::csv;
    if (name == "json") return EquationFormat::json;
    return EquationFormat::text;
}

}  // namespace

std::function<int()> declare_equations(CLI::App& app, const Language& language) {
    const auto request = std::make_shared<Request>();
    app.add_option("FILE", request->path, "the GRAFCET, - for standard input")->required();
    app.add_option("--cdx", request->cdx, "form of CDX")
        ->check(CLI::IsMember({"successor", "transition"}))
        ->capture_default_str();
    app.add_option("--modes", request->modes, "with Init, AUdur and AUdoux, or without")
        ->check(CLI::IsMember({"on", "off"}))
        ->capture_default_str();
    app.add_option("--to", request->format, "output form")
        ->check(CLI::IsMember({"text", "markdown", "latex", "csv", "json"}))
        ->capture_default_str();
    app.add_flag("--karnaugh", request->karnaugh,
                 "with the truth table, Karnaugh map and minimised form of every step");
    app.add_option("-o", request->output, "output file (default: standard output)");
    return [request, &language] {
        // Read the GRAFCET.
        const auto loaded = load_grafcet(request->path);
        if (!loaded) return static_cast<int>(bad_request);
        // Derive the equations.
        const CdxForm cdx = request->cdx == "successor" ? CdxForm::successor : CdxForm::transition;
        const Equations equations = equations_from(loaded->grafcet, {cdx, request->modes == "on"});
        // Write them down.
        OutputFiles files;
        files.add(request->output, write_equations(equations, {format_named(request->format),
                                                               request->karnaugh, language}));
        return finish(files, done);
    };
}

}  // namespace grafwire
