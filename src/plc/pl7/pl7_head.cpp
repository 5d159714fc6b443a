#include "plc/pl7/pl7_head.h"

#include <fmt/format.h>

#include "grafcet/write_grafcet.h"
#include "plc/pl7/messages.h"
#include "program/bit_names.h"

namespace grafwire {

namespace say = messages::plc_pl7;

std::string pl7_head(const Grafcet& grafcet, Pl7Objects& objects, Language language) {
    std::string text =
        fmt::format("PL7-2   {}\n\n{}\n\n{}", titled_name(grafcet.name, grafcet.title, language),
                    say::what_it_is.in(language), say::conventions.in(language));
    if (!objects.source_step().empty()) text += say::source_convention.in(language);
    if (!objects.sink_step().empty()) text += say::sink_convention.in(language);
    text += fmt::format("\n{}\n\n", say::assignment.in(language));
    for (const auto& [object, name] : objects.assignment()) {
        text += fmt::format("   {:<8} {}\n", object, name);
    }
    return text;
}

std::string pl7_steps(const Grafcet& grafcet, Pl7Objects& objects, Language language) {
    std::string text;
    for (std::uint32_t s = 0; s < grafcet.steps.size(); ++s) {
        const Step& step = grafcet.steps[StepId{s}];
        text += fmt::format("   {} {:<4} {}\n", step.initial ? '#' : ' ',
                            objects.of(Bit{BitKind::step, s}), quoted_where_needed(step.name));
    }
    if (!objects.source_step().empty()) {
        text +=
            fmt::format("   # {:<4} {}\n", objects.source_step(), say::source_step.in(language));
    }
    if (!objects.sink_step().empty()) {
        text += fmt::format("     {:<4} {}\n", objects.sink_step(), say::sink_step.in(language));
    }
    return text;
}

}  // namespace grafwire
