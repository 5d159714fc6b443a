// An option that has no effect with what was asked for is refused rather than ignored: it was
// written because somebody thought it had one. The table has a row for everything an option needs
// to have an effect; an option without a row always has one.

#include "command/option_uses.h"

#include <fmt/format.h>

#include "command/messages.h"

namespace grafwire {

namespace {

/// An option of a command needs one of these facts, or else has no effect, for that reason. In the
/// place of facts: what the format says.
struct OptionUse {
    std::string_view command;
    std::string_view option;
    unsigned facts;
    std::string_view reason;
};

constexpr unsigned by_format = fact::none;

constexpr std::string_view only_generated = "it is for a netlist made from the GRAFCET";
constexpr std::string_view only_clocked = "it is for the clocked style: the others have no scans";

constexpr OptionUse option_uses[] = {
    {"equations", "--karnaugh", fact::minimised, "CSV has no place for it"},

    {"netlist", "--scan", by_format, ""},
    {"netlist", "--scan", fact::clocked, only_clocked},
    {"netlist", "--stim", by_format, ""},
    {"netlist", "--stim", fact::bench, "this format takes stimuli with --bench, as a test bench"},
    {"netlist", "--bench", by_format, ""},
    {"netlist", "--bench", fact::stimuli, "it needs --stim, what the bench applies"},
    {"netlist", "--bench", fact::output, "it needs -o: the bench is written beside that file"},

    {"simulate", "--style", fact::generated, only_generated},
    {"simulate", "--cdx", fact::generated, only_generated},
    {"simulate", "--modes", fact::generated, only_generated},
    {"simulate", "--power-up", fact::elsewhere, "it is for a netlist given with --against"},
    {"simulate", "--power-up", fact::open_start,
     "it is for a netlist from elsewhere without an input Init"},
    {"simulate", "--scan", fact::clocked, only_clocked},

    {"check", "--style", fact::generated, only_generated},
    {"check", "--cdx", fact::generated, only_generated},
    {"check", "--modes", fact::generated, only_generated},
    {"check", "--program", fact::ladder, "it is for a ladder diagram given with --against"},
    {"check", "--io", fact::listing, "it is for an S7-200 listing given with --against"},
    {"check", "--cpu", fact::listing, "it is for an S7-200 listing given with --against"},
    {"check", "--delay", fact::generated | fact::elsewhere, "a program has no gates"},
    {"check", "--changes", fact::asynchronous,
     "inputs are sampled, and any of them change between two scans"},
    {"check", "--power-up", fact::open_start,
     "it is for a netlist from elsewhere without an input Init"},
    {"check", "--scan", fact::clocked | fact::listing | fact::ladder, "nothing is scanned"},

    {"plc", "--io", by_format, ""},
    {"plc", "--addresses", by_format, ""},
    {"plc", "--mnemonics", by_format, ""},
    {"plc", "--offsets", by_format, ""},
    {"plc", "--tables", by_format, ""},
    {"plc", "--cpu", by_format, ""},
};

/// Whether `--io` is among `--io --mnemonics`.
bool heeds(const FormatOptions& format, std::string_view option) {
    std::string_view rest = format.options;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (rest.substr(0, end) == option) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

std::string refusal(const ChosenFormat& format, std::string_view option) {
    std::vector<std::string_view> others;
    for (const FormatOptions& other : format.all) {
        if (heeds(other, option)) others.push_back(other.name);
    }
    return fmt::format("{} has no {}; it is for {}", format.chosen.name, option,
                       fmt::join(others, ", "));
}

}  // namespace

bool refuse_idle_options(const CommandLine& line, std::string_view command, unsigned facts,
                         const ChosenFormat* format) {
    for (const OptionUse& use : option_uses) {
        if (use.command != command || !line.has(use.option)) continue;
        if (use.facts != by_format) {
            if ((use.facts & facts) != 0) continue;
            complain(fmt::format("{} has no effect here: {}", use.option, use.reason));
            return true;
        }
        if (format == nullptr || heeds(format->chosen, use.option)) continue;
        complain(refusal(*format, use.option));
        return true;
    }
    return false;
}

}  // namespace grafwire
