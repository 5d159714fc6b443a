// grafwire: from a GRAFCET (IEC 60848) to checked wiring.

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "command/command.h"
#include "command/exit_status.h"
#include "command/inputs.h"
#include "command/request_error.h"

namespace {

using namespace grafwire;

constexpr Command commands[] = {
    {"info", "check a GRAFCET; print its size, graphs, forcing hierarchy and warnings",
     "grafwire info examples/manipulator.grafcet", declare_info},
    {"equations", "derive CAX, CDX, X and the equations of the actions",
     "grafwire equations examples/nine-steps.grafcet --to markdown", declare_equations},
    {"run", "run the reference evolution over stimuli",
     "grafwire run examples/manipulator.grafcet examples/manipulator.stim --vcd run.vcd",
     declare_run},
    {"netlist", "make a netlist and write it in one of many formats",
     "grafwire netlist examples/manipulator.grafcet --style nand --to verilog", declare_netlist},
    {"simulate", "simulate the gates of a netlist over stimuli",
     "grafwire simulate examples/manipulator.grafcet examples/manipulator.stim --style nand",
     declare_simulate},
    {"check", "prove a netlist equivalent to the reference evolution, or show a difference",
     "grafwire check examples/manipulator.grafcet --style nand --witness out/", declare_check},
    {"plc", "write the GRAFCET as a program for a PLC or in a programming language",
     "grafwire plc examples/manipulator.grafcet --to s7-200 --io examples/s7-200/manipulator.io",
     declare_plc},
    {"s7", "execute an instruction list of a Siemens S7-200",
     "grafwire s7 run LISTING.awl --stim FILE.stim --scan 10ms --io TABLE.io -o trace.csv",
     declare_s7},
};

Language language_of_locale() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        if (value == nullptr || *value == '\0') continue;
        return std::string_view(value).starts_with("fr") ? Language::french : Language::english;
    }
    return Language::english;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"From a GRAFCET (IEC 60848) to wiring, and a proof that the wiring is right.",
                 "grafwire"};
    app.set_version_flag("--version", "grafwire " GRAFWIRE_VERSION);
    app.footer(
        "Exit status: 0 done or equivalent; 1 the answer is no; 2 wrong request or input; "
        "3 undecided.\n'grafwire COMMAND --help' shows the options of a command.");
    Language language = language_of_locale();
    app.add_option_function<std::string>(
           "--lang",
           [&](const std::string& name) {
               language = name == "fr" ? Language::french : Language::english;
           },
           "language of reports: en or fr (default: from the locale)")
        ->check(CLI::IsMember({"en", "fr"}))
        ->trigger_on_parse();
    app.fallthrough();

    std::function<int()> chosen;
    for (const Command& command : commands) {
        const CommandLine line = CommandLine(app).add_command(
            std::string(command.name), std::string(command.summary), std::string(command.example));
        const std::function<int()> action = command.declare(line, language);
        line.when_read([&chosen, action] { chosen = action; });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // Help and version are no errors, but results like any other.
        if (error.get_exit_code() == 0) {
            std::ostringstream text;
            app.exit(error, text, text);
            OutputFiles files({});
            files.add("-", text.str());
            return finish(files, done);
        }
        complain(explain(app, error));
        return bad_request;
    }
    return chosen();
}
