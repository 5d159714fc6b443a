#include "command/command.h"
#include "command/exit_status.h"
#include "command/netlist_request.h"
#include "equations/report/write_equations.h"

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

std::function<int()> declare_equations(const CommandLine& line, const Language& language) {
    const auto request = std::make_shared<Request>();
    line.add("FILE", request->path, "the GRAFCET, - for standard input").required();
    line.add("--cdx", request->cdx, "form of CDX")
        .one_of({"successor", "transition"})
        .shows_default();
    line.add("--modes", request->modes, "with Init, AUdur and AUdoux, or without")
        .one_of({"on", "off"})
        .shows_default();
    line.add("--to", request->format, "output form")
        .one_of({"text", "markdown", "latex", "csv", "json"})
        .shows_default();
    line.add_flag("--karnaugh", request->karnaugh,
                  "with the truth table, Karnaugh map and minimised form of every step");
    line.add("-o", request->output, "output file (default: standard output)");
    return [request, &language] {
        // Read the GRAFCET.
        const auto loaded = load_grafcet(request->path);
        if (!loaded) return static_cast<int>(bad_request);
        // Derive the equations.
        const CdxForm cdx = request->cdx == "successor" ? CdxForm::successor : CdxForm::transition;
        show_wiring_warnings(*loaded, cdx);
        const Equations equations = equations_from(loaded->grafcet, {cdx, request->modes == "on"});
        // Write them down.
        OutputFiles files({request->path});
        files.add(request->output, write_equations(equations, {format_named(request->format),
                                                               request->karnaugh, language}));
        return finish(files, done);
    };
}

}  // namespace grafwire
