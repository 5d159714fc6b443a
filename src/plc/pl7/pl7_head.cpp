#include "plc/pl7/pl7_head.h"

#include <fmt/format.h>

#include "grafcet/write_grafcet.h"

namespace grafwire {

namespace {

constexpr std::string_view conventions = R"(
Conventions of this listing: the program is entered with its charts and rungs drawn.
   ** LABEL 3         a rung, or several; contacts in series are joined by . and in parallel by +,
                      /I0,1 is a contact that is closed while the bit is 0, =1 is a wire, =0 none
   --( ) --(S) --(R)  a coil; --(#) ends the rung of a transition
   [W0 < 5]           a COMPAR block; --[W0 + 1 -> W0] an OPERATE block
   --T0 TB=1s P=3     a timer block, E and C both driven by the rung; T0,D is 1 once 3 s are over
   SY0                1 in the first scan after a cold start; the chart is initialised before it
   SY21, SY22, SY23   1 in the preliminary processing: in this scan the chart is initialised, has no
                      step, or keeps the steps that were set and reset there, and does not evolve
)";
constexpr std::string_view source_convention =
    R"(   always active      a step of this listing alone; a source transition leaves and enters it
)";
constexpr std::string_view sink_convention =
    R"(   sink               a step of this listing alone, where sink transitions lead
)";

}  // namespace

std::string pl7_head(const Grafcet& grafcet, Pl7Objects& objects) {
    std::string text = fmt::format(
        "PL7-2   {}{}{}\n\nA GRAFCET (IEC 60848) for Telemecanique TSX 17-20, TSX 27 and TSX 47.\n",
        grafcet.name, grafcet.title.empty() ? "" : ": ", grafcet.title);
    text += conventions;
    if (!objects.source_step().empty()) text += source_convention;
    if (!objects.sink_step().empty()) text += sink_convention;
    text += "\nASSIGNMENT\n\n";
    for (const auto& [object, name] : objects.assignment()) {
        text += fmt::format("   {:<8} {}\n", object, name);
    }
    return text;
}

std::string pl7_steps(const Grafcet& grafcet, Pl7Objects& objects) {
    std::string text;
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        const Step& step = grafcet.steps[StepId{s}];
        text += fmt::format("   {} {:<4} {}\n", step.initial ? '#' : ' ',
                            objects.of(Bit{BitKind::step, s}), quoted_where_needed(step.name));
    }
    if (!objects.source_step().empty()) {
        text += fmt::format("   # {:<4} always active, for source transitions\n",
                            objects.source_step());
    }
    if (!objects.sink_step().empty()) {
        text += fmt::format("     {:<4} sink, for sink transitions\n", objects.sink_step());
    }
    return text;
}

}  // namespace grafwire
