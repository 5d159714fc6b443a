// An option that has no effect with what was asked for is refused rather than ignored: it was
// written because somebody thought it had one. The table has a row for everything an option needs
// to have an effect; an option without a row always has one.

#include "command/option_uses.h"

#include "command/messages.h"
#include "command/standard_error.h"
#include "text/joined.h"
#include "text/words.h"

namespace grafwire {

namespace {

namespace say = messages::command;

/// An option of a command needs one of these facts, or else has no effect, for that reason. In the
/// place of facts, and without a reason: what the format says.
struct OptionUse {
    std::string_view command;
    std::string_view option;
    unsigned facts;
    const Message<>* reason = nullptr;
};

constexpr unsigned by_format = fact::none;

constexpr OptionUse option_uses[] = {
    {"equations", "--karnaugh", by_format},
    {"equations", "--standalone", by_format},

    {"netlist", "--interlock", fact::handshake, &say::only_handshake},
    {"netlist", "--at", by_format},
    {"netlist", "--at", fact::stimuli, &say::values_need_stimuli},
    {"netlist", "--symbols", by_format},
    {"netlist", "--paper", by_format},
    {"netlist", "--standalone", by_format},
    {"netlist", "--scan", by_format},
    {"netlist", "--scan", fact::clocked, &say::only_clocked},
    {"netlist", "--stim", by_format},
    {"netlist", "--stim", fact::bench | fact::drawing, &say::stimuli_by_bench},
    {"netlist", "--stim", fact::moment | fact::text, &say::stimuli_by_moment},
    {"netlist", "--bench", by_format},
    {"netlist", "--bench", fact::stimuli, &say::bench_needs_stimuli},
    {"netlist", "--bench", fact::output, &say::bench_needs_output},

    {"run", "--explain", fact::stimuli, &say::needs_stimuli},
    {"run", "--to", fact::stimuli, &say::needs_stimuli},
    {"run", "-o", fact::stimuli, &say::needs_stimuli},
    {"run", "--vcd", fact::stimuli, &say::needs_stimuli},

    {"simulate", "--style", fact::generated, &say::only_generated},
    {"simulate", "--cdx", fact::generated, &say::only_generated},
    {"simulate", "--modes", fact::generated, &say::only_generated},
    {"simulate", "--interlock", fact::handshake, &say::only_handshake},
    {"simulate", "--power-up", fact::elsewhere, &say::only_netlist_from_file},
    {"simulate", "--power-up", fact::open_start, &say::only_open_start},
    {"simulate", "--scan", fact::clocked, &say::only_clocked},
    {"simulate", "--delays", fact::asynchronous, &say::only_asynchronous},
    {"simulate", "--zoom", by_format},

    {"check", "--style", fact::generated, &say::only_generated},
    {"check", "--cdx", fact::generated, &say::only_generated},
    {"check", "--modes", fact::generated, &say::only_generated},
    {"check", "--interlock", fact::handshake, &say::only_handshake},
    {"check", "--program", fact::ladder, &say::only_ladder},
    {"check", "--io", fact::listing, &say::only_listing},
    {"check", "--cpu", fact::listing, &say::only_listing},
    {"check", "--delay", fact::generated | fact::elsewhere, &say::program_has_no_gates},
    {"check", "--delay", fact::asynchronous | fact::listing | fact::ladder,
     &say::only_asynchronous},
    {"check", "--tolerance", fact::generated | fact::elsewhere, &say::program_has_no_gates},
    {"check", "--tolerance", fact::asynchronous | fact::listing | fact::ladder,
     &say::only_asynchronous},
    {"check", "--pulses", fact::generated | fact::elsewhere, &say::program_has_no_gates},
    {"check", "--pulses", fact::asynchronous | fact::listing | fact::ladder,
     &say::only_asynchronous},
    {"check", "--changes", fact::asynchronous, &say::inputs_are_sampled},
    {"check", "--power-up", fact::open_start, &say::only_open_start},
    {"check", "--scan", fact::clocked | fact::listing | fact::ladder, &say::nothing_is_scanned},

    {"draw", "--at", fact::stimuli, &say::moment_needs_stimuli},
    {"draw", "--standalone", by_format},

    {"plc", "--io", by_format},
    {"plc", "--addresses", by_format},
    {"plc", "--mnemonics", by_format},
    {"plc", "--offsets", by_format},
    {"plc", "--tables", by_format},
    {"plc", "--cpu", by_format},
    {"plc", "--pull-up", by_format},
};

/// What the format chosen does not heed, and which formats do.
Localized refusal(const ChosenFormat& format, std::string_view option) {
    std::vector<std::string_view> others;
    for (const FormatOptions& other : format.all) {
        if (has_word(other.options, option)) others.push_back(other.name);
    }
    return say::format_has_no_option(format.chosen.name, option, joined(others, ", "));
}

}  // namespace

bool refuse_idle_options(const CommandLine& line, std::string_view command, unsigned facts,
                         const ChosenFormat* format) {
    for (const OptionUse& use : option_uses) {
        if (use.command != command || !line.has(use.option)) continue;
        if (use.facts != by_format) {
            if ((use.facts & facts) != 0) continue;
            complain(say::has_no_effect(use.option, (*use.reason)()));
            return true;
        }
        if (format == nullptr || has_word(format->chosen.options, use.option)) continue;
        complain(refusal(*format, use.option));
        return true;
    }
    return false;
}

}  // namespace grafwire
