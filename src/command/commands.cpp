#include "command/commands.h"

#include "command/help.h"

namespace grafwire {

namespace {

namespace help = messages::help;

constexpr Command commands[] = {
    {"info", help::info, "grafwire info examples/manipulator.grafcet", declare_info},
    {"equations", help::equations, "grafwire equations examples/nine-steps.grafcet --to markdown",
     declare_equations},
    {"run", help::run,
     "grafwire run examples/manipulator.grafcet examples/manipulator.stim --vcd run.vcd",
     declare_run},
    {"netlist", help::netlist,
     "grafwire netlist examples/manipulator.grafcet --style nand --to verilog", declare_netlist},
    {"simulate", help::simulate,
     "grafwire simulate examples/manipulator.grafcet examples/manipulator.stim --style nand",
     declare_simulate},
    {"check", help::check,
     "grafwire check examples/manipulator.grafcet --style nand --witness out/", declare_check},
    {"plc", help::plc,
     "grafwire plc examples/manipulator.grafcet --to s7-200 --io examples/s7-200/manipulator.io",
     declare_plc},
    {"s7", help::s7,
     "grafwire s7 run examples/s7-200/manipulator.awl --stim examples/manipulator.stim --scan 10ms "
     "--io examples/s7-200/manipulator.io -o trace.csv",
     declare_s7},
    {"draw", help::draw, "grafwire draw examples/nine-steps.grafcet -o nine-steps.svg",
     declare_draw},
    {"report", help::report,
     "grafwire report examples/manipulator.grafcet examples/manipulator.stim -o manipulator.html",
     declare_report},
    {"fmt", help::fmt, "grafwire fmt examples/manipulator.grafcet --lang fr", declare_fmt},
};

}  // namespace

std::span<const Command> all_commands() {
    return commands;
}

}  // namespace grafwire
