// grafwire: from a GRAFCET (IEC 60848) to checked wiring.

#include <cstdlib>
#include <string_view>

#include "command/command.h"
#include "command/files.h"
#include "command/messages.h"

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
    Language language = language_of_locale();
    const ReadCommandLine line = read_command_line(argc, argv, commands, language);
    show_messages_in(language);
    ExitStatus status = ExitStatus::bad_request;
    if (line.action) {
        status = line.action();
    } else if (line.problem.empty()) {
        // Help and version are no errors, but results like any other.
        OutputFiles files({});
        files.add("-", line.help);
        status = finish(files, ExitStatus::done);
    } else {
        complain(line.problem);
    }
    return static_cast<int>(status);
}
