// The types of a program in C: the steps as an enumeration, inputs and outputs as structs of their
// own, and one struct for the state.

#include <fmt/format.h>

#include "plc/computer/c_blocks.h"
#include "plc/computer/c_core.h"
#include "plc/computer/language_parts.h"
#include "plc/computer/messages.h"
#include "plc/shared/program_needs.h"

namespace grafwire {

namespace say = messages::plc_computer;

namespace {

/// What a control input does.
const Message<>& meaning_of(ControlInput control) {
    switch (control) {
        case ControlInput::init:
            return say::init;
        case ControlInput::au_dur:
            return say::au_dur;
        case ControlInput::au_doux:
            break;
    }
    return say::au_doux;
}

}  // namespace

std::string CCore::types() const {
    SourceText out("//");
    out.comment(say::steps_in_order.in(language_));
    std::string steps;
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        steps += names_[Bit{BitKind::step, s}] + ", ";
    }
    out.line(fmt::format("enum {{ {}STEPS, STEP_WORDS = STEPS / 32 + 1 }};", steps));
    if (uses(program_, BitKind::time_value)) {
        out.block(
            with_texts(c::time_type, {{"@time_condition", say::time_condition_1.in(language_)},
                                      {"@e_differs", say::e_differs.in(language_)},
                                      {"@differs_since", say::differs_since.in(language_)}}));
    }
    out.blank();
    write_inputs(out);
    out.blank();
    write_outputs(out);
    out.blank();
    write_state(out);
    return out.take();
}

void CCore::write_inputs(SourceText& out) const {
    out.line("typedef struct {");
    out.indent();
    for (const Bit bit : names_.inputs()) {
        std::string line = fmt::format("bool {};", names_[bit]);
        if (bit.kind == BitKind::control) {
            line += fmt::format("  // {}",
                                meaning_of(static_cast<ControlInput>(bit.index)).in(language_));
        }
        out.line(line);
    }
    if (names_.inputs().empty()) out.line("bool none;");
    out.outdent();
    out.line(fmt::format("}} {}_inputs;", names_.chart()));
}

void CCore::write_outputs(SourceText& out) const {
    const auto count = static_cast<std::uint32_t>(grafcet_.outputs.size());
    out.line("typedef struct {");
    out.indent();
    for (std::uint32_t o = 0; o < count; ++o) {
        out.line(fmt::format("bool {};", names_[Bit{BitKind::output, o}]));
    }
    if (count == 0) out.line("bool none;");
    out.outdent();
    out.line(fmt::format("}} {}_outputs;", names_.chart()));
}

void CCore::write_group(SourceText& out, BitKind kind, std::size_t count,
                        const Message<>& comment) const {
    // Variables that nothing uses stand in the trace all the same.
    if (count == 0 || (kind != BitKind::var && !uses(program_, kind))) return;
    std::string members;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!members.empty()) members += ", ";
        members += names_[Bit{kind, i}];
    }
    out.comment(comment.in(language_));
    const std::string_view type = kind == BitKind::time_value ? "time_condition" : "bool";
    out.line(fmt::format("struct {{ {} {}; }} {};", type, members, holder_name(kind)));
}

void CCore::write_state(SourceText& out) const {
    const auto line = [&](std::string_view declaration, const Message<>& comment) {
        out.line(fmt::format("{}  // {}", declaration, comment.in(language_)));
    };
    out.comment(say::state.in(language_));
    out.line("typedef struct {");
    out.indent();
    out.line(fmt::format("{}_inputs inputs;", names_.chart()));
    out.line(fmt::format("{}_outputs outputs;", names_.chart()));
    line("int64_t now;", say::moment_of_scan);
    out.comment(say::step_tables.in(language_));
    line("uint32_t Ts[STEP_WORDS];", say::situation);
    line("uint32_t Tp[STEP_WORDS];", say::situation_before);
    line("uint32_t Ta[STEP_WORDS], Td[STEP_WORDS];", say::to_activate);
    if (uses(program_, BitKind::forced_off)) {
        line("uint32_t Tf1[STEP_WORDS], Tf0[STEP_WORDS];", say::forced);
    }
    if (uses(program_, BitKind::pulse)) {
        line("uint32_t Tpulse[STEP_WORDS];", say::just_activated);
    }
    write_group(out, BitKind::transition, grafcet_.transitions.size(), say::transition_conditions);
    write_group(out, BitKind::may_evolve, grafcet_.graphs.size(), say::graphs_0_frozen);
    const std::size_t edges = grafcet_.expressions.edges().size();
    write_group(out, BitKind::edge, edges, say::edges_1);
    write_group(out, BitKind::edge_memory, edges, say::edge_memories);
    write_group(out, BitKind::time_value, grafcet_.expressions.time_conditions().size(),
                say::time_conditions);
    write_group(out, BitKind::var, grafcet_.vars.size(), say::vars);
    if (!grafcet_.counters.empty()) {
        std::string members;
        for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
            if (!members.empty()) members += ", ";
            members += names_[IntegerCell{false, c}];
        }
        out.comment(say::counters.in(language_));
        out.line(fmt::format("struct {{ {} {}; }} counters;", integer_type(), members));
    }
    out.outdent();
    out.line(fmt::format("}} {}_grafcet;", names_.chart()));
}

}  // namespace grafwire
