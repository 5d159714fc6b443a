// libFuzzer target: the readers of what people write. The first byte chooses the reader; whatever
// the rest is, there must be no crash, and what is accepted must come back unchanged when it is
// written and read again.

#include <cstddef>
#include <cstdint>
#include <string>

#include "equations/equations.h"
#include "equations/report/write_equations.h"
#include "formats/netlist_formats.h"
#include "grafcet/describe_grafcet.h"
#include "grafcet/format_grafcet.h"
#include "grafcet/parse_grafcet.h"
#include "grafcet/write_grafcet.h"
#include "ladder/draw/write_drawings.h"
#include "ladder/machine.h"
#include "plcopen/read_ladder.h"
#include "require.h"
#include "s7/addresses/io_assignment.h"
#include "s7/machine/machine.h"
#include "s7/parse_listing.h"
#include "s7/write_listing.h"
#include "schedule/delays_text.h"
#include "trace/stimuli.h"

namespace grafwire {

namespace {

std::optional<Grafcet> read_grafcet(std::string text) {
    const SourceFile source{"fuzz.grafcet", std::move(text)};
    Diagnostics diagnostics;
    std::optional<Grafcet> grafcet = parse_grafcet(source, diagnostics);
    require(grafcet.has_value() != diagnostics.has_errors(), "errors and a result, or neither",
            source.text);
    format_diagnostics(diagnostics, source);
    return grafcet;
}

/// Laying out a chart leaves it the same; doing so once more changes nothing.
void try_layout(const std::string& text, const Grafcet& grafcet) {
    for (const Language language : {Language::english, Language::french}) {
        Diagnostics diagnostics;
        const auto laid_out = format_grafcet({"fuzz.grafcet", text}, language, diagnostics);
        require(laid_out.has_value(), "has no layout", text);
        const std::optional<Grafcet> again = read_grafcet(*laid_out);
        require(again.has_value(), "cannot be read back", *laid_out);
        require(write_grafcet(*again) == write_grafcet(grafcet), "another chart", *laid_out);
        require(format_grafcet({"fuzz.grafcet", *laid_out}, language, diagnostics) == laid_out,
                "laid out otherwise the second time", *laid_out);
    }
}

void try_grafcet(const std::string& text) {
    const std::optional<Grafcet> grafcet = read_grafcet(text);
    if (!grafcet) return;
    try_layout(text, *grafcet);
    const std::string written = write_grafcet(*grafcet);
    const std::optional<Grafcet> again = read_grafcet(written);
    require(again.has_value(), "cannot be read back", written);
    require(write_grafcet(*again) == written, "written differently the second time", written);
    describe_grafcet(*grafcet, Language::french);
    if (grafcet->steps.size() > 50 || grafcet->expressions.size() > 500) return;
    for (const CdxForm form : {CdxForm::successor, CdxForm::transition}) {
        const Equations equations = equations_from(*grafcet, {form, true});
        write_equations(*grafcet, equations, {EquationFormat::text, false, Language::english});
    }
}

void try_stimuli(std::string text) {
    static const Grafcet grafcet =
        *read_grafcet("input a, b, \"c d\", été graph G { initial 0 0 -> 0 : a.b.\"c d\".été }");
    const SourceFile source{"fuzz.stim", std::move(text)};
    Diagnostics diagnostics;
    const std::optional<Stimuli> stimuli = parse_stimuli(source, grafcet, diagnostics);
    require(stimuli.has_value() != diagnostics.has_errors(), "errors and a result, or neither",
            source.text);
    format_diagnostics(diagnostics, source);
    if (!stimuli) return;
    const std::string written = write_stimuli(*stimuli, grafcet);
    const SourceFile copy{"written.stim", written};
    Diagnostics of_copy;
    const std::optional<Stimuli> again = parse_stimuli(copy, grafcet, of_copy);
    require(again.has_value(), "cannot be read back", written);
    require(write_stimuli(*again, grafcet) == written, "written differently the second time",
            written);
}

void try_listing(std::string text) {
    const auto read = [](std::string from) {
        const SourceFile source{"fuzz.awl", std::move(from)};
        Diagnostics diagnostics;
        auto listing = s7::parse_listing(source, {}, diagnostics);
        require(listing.has_value() != diagnostics.has_errors(), "errors and a result, or neither",
                source.text);
        format_diagnostics(diagnostics, source);
        return listing;
    };
    const auto listing = read(std::move(text));
    if (!listing) return;
    const std::string written = s7::write_listing(*listing, {});
    const auto again = read(written);
    require(again.has_value(), "cannot be read back", written);
    require(s7::write_listing(*again, {}) == written, "written differently the second time",
            written);
    s7::Machine machine(*listing, s7::Cpu::cpu_214);
    s7::MachineState state = machine.start();
    for (Time now = 0; now < 3 * second; now += second) machine.scan(state, {}, now);
}

void try_plcopen(std::string text) {
    const SourceFile source{"fuzz.xml", std::move(text)};
    Diagnostics diagnostics;
    const std::optional<ladder::Ladder> diagram = plcopen::read_ladder(source, diagnostics);
    require(diagram.has_value() != diagnostics.has_errors(), "errors and a result, or neither",
            source.text);
    format_diagnostics(diagnostics, source);
    if (!diagram) return;
    ladder::write_text(*diagram);
    ladder::write_svg(*diagram);
    const ladder::Machine machine(*diagram);
    ladder::MachineState state = machine.start();
    for (Time now = 0; now < 3 * second; now += second) machine.scan(state, now);
    const std::string memory = machine.save(state);
    require(machine.save(machine.load(memory)) == memory, "remembered differently", source.text);
}

/// What a reader makes of a text, once it is either that or an error.
template <typename Read>
auto read_or_refuse(std::string text, const Read& read) {
    const SourceFile source{"fuzz", std::move(text)};
    Diagnostics diagnostics;
    auto result = read(source, diagnostics);
    require(result.has_value() != diagnostics.has_errors(), "errors and a result, or neither",
            source.text);
    format_diagnostics(diagnostics, source);
    return result;
}

/// Written in its own format, read back and written again, a netlist stays the same.
void try_netlist(const char* format_name, std::string text) {
    const NetlistFormat& format = *netlist_format_named(format_name);
    const auto netlist = read_or_refuse(std::move(text), format.read);
    if (!netlist) return;
    const std::string written = write_netlist(format, *netlist);
    const auto again = read_or_refuse(written, format.read);
    require(again.has_value(), "cannot be read back", written);
    require(write_netlist(format, *again) == written, "written differently the second time",
            written);
}

void try_assignment(std::string text) {
    const auto assignment = read_or_refuse(std::move(text), s7::parse_io_assignment);
    if (!assignment) return;
    const std::string written = s7::write_io_assignment(*assignment);
    const auto again = read_or_refuse(written, s7::parse_io_assignment);
    require(again.has_value(), "cannot be read back", written);
    require(s7::write_io_assignment(*again) == written, "written differently the second time",
            written);
}

void try_assumption(std::string text) {
    static const Grafcet chart =
        *read_grafcet("input a, b, \"c d\", été graph G { initial 0 0 -> 0 : a.b.\"c d\".été }");
    Grafcet grafcet = chart;
    const SourceFile source{"--assume", std::move(text)};
    Diagnostics diagnostics;
    parse_assumption(source, grafcet, diagnostics);
    const std::size_t added = diagnostics.has_errors() ? 0 : 1;
    require(grafcet.assumptions.size() == added, "an assumption in spite of errors, or none",
            source.text);
    format_diagnostics(diagnostics, source);
    const std::string written = write_grafcet(grafcet);
    require(read_grafcet(written).has_value(), "cannot be read back", written);
}

void try_delays(std::string text) {
    static const Netlist netlist = *read_or_refuse(
        ".model m\n.inputs a \"b c\n.outputs x y\n.names a x y\n11 1\n.names a y x\n00 1\n.end\n",
        netlist_format_named("blif")->read);
    const auto read = [](const SourceFile& source, Diagnostics& diagnostics) {
        return read_delays(source, netlist, diagnostics);
    };
    const auto schedule = read_or_refuse(std::move(text), read);
    if (!schedule) return;
    const std::string written = write_delays(*schedule, netlist);
    const auto again = read_or_refuse(written, read);
    require(again.has_value(), "cannot be read back", written);
    require(write_delays(*again, netlist) == written, "written differently the second time",
            written);
}

}  // namespace

}  // namespace grafwire

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0]) {
        case 's':
            grafwire::try_stimuli(std::move(text));
            break;
        case 'a':
            grafwire::try_listing(std::move(text));
            break;
        case 'x':
            grafwire::try_plcopen(std::move(text));
            break;
        case 'b':
            grafwire::try_netlist("blif", std::move(text));
            break;
        case 'j':
            grafwire::try_netlist("json", std::move(text));
            break;
        case 'i':
            grafwire::try_assignment(std::move(text));
            break;
        case 'u':
            grafwire::try_assumption(std::move(text));
            break;
        case 'd':
            grafwire::try_delays(std::move(text));
            break;
        default:
            grafwire::try_grafcet(text);
    }
    return 0;
}
