// The types of a program in C: the steps as an enumeration, inputs and outputs as structs of their
// own, and one struct for the state.

#include <fmt/format.h>

#include "plc/computer/c_blocks.h"
#include "plc/computer/c_core.h"
#include "plc/computer/language_parts.h"
#include "plc/shared/program_needs.h"

namespace grafwire {

namespace {

/// What a control input does.
std::string_view meaning_of(ControlInput control) {
    switch (control) {
        case ControlInput::init:
            return "1: the initial situation";
        case ControlInput::au_dur:
            return "1: no step is active";
        case ControlInput::au_doux:
            return "1: continuous actions are off, the steps stay";
    }
    return {};
}

}  // namespace

std::string CCore::types() const {
    SourceText out("//");
    out.comment("The steps, in the order of the tables.");
    std::string steps;
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        steps += names_[Bit{BitKind::step, s}] + ", ";
    }
    out.line(fmt::format("enum {{ {}STEPS, STEP_WORDS = STEPS / 32 + 1 }};", steps));
    if (uses(program_, BitKind::time_value)) out.block(c::time_type);
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
            line += fmt::format("  // {}", meaning_of(static_cast<ControlInput>(bit.index)));
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
                        std::string_view comment) const {
    // Variables that nothing uses stand in the trace all the same.
    if (count == 0 || (kind != BitKind::var && !uses(program_, kind))) return;
    std::string members;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!members.empty()) members += ", ";
        members += names_[Bit{kind, i}];
    }
    out.comment(comment);
    const std::string_view type = kind == BitKind::time_value ? "time_condition" : "bool";
    out.line(fmt::format("struct {{ {} {}; }} {};", type, members, holder_name(kind)));
}

void CCore::write_state(SourceText& out) const {
    out.comment("All that one scan hands to the next.");
    out.line("typedef struct {");
    out.indent();
    out.line(fmt::format("{}_inputs inputs;", names_.chart()));
    out.line(fmt::format("{}_outputs outputs;", names_.chart()));
    out.line("int64_t now;  // the moment of the scan, in us");
    out.comment("Tables of the steps, one bit each.");
    out.line("uint32_t Ts[STEP_WORDS];  // the situation");
    out.line("uint32_t Tp[STEP_WORDS];  // the situation that the scan began with");
    out.line("uint32_t Ta[STEP_WORDS], Td[STEP_WORDS];  // to activate, to deactivate");
    if (uses(program_, BitKind::forced_off)) {
        out.line("uint32_t Tf1[STEP_WORDS], Tf0[STEP_WORDS];  // forced to 1, forced to 0");
    }
    if (uses(program_, BitKind::pulse)) {
        out.line("uint32_t Tpulse[STEP_WORDS];  // activated in this scan");
    }
    write_group(out, BitKind::transition, grafcet_.transitions.size(),
                "The receptivities of the transitions.");
    write_group(out, BitKind::may_evolve, grafcet_.graphs.size(),
                "Whether a graph may evolve; 0: frozen.");
    const std::size_t edges = grafcet_.expressions.edges().size();
    write_group(out, BitKind::edge, edges, "Edges, 1 in the scan in which they occur, and");
    write_group(out, BitKind::edge_memory, edges, "what their operands were in the scan before.");
    write_group(out, BitKind::time_value, grafcet_.expressions.time_conditions().size(),
                "Time conditions.");
    write_group(out, BitKind::var, grafcet_.vars.size(), "Internal variables.");
    if (!grafcet_.counters.empty()) {
        std::string members;
        for (std::uint32_t c = 0; c < grafcet_.counters.size(); ++c) {
            if (!members.empty()) members += ", ";
            members += names_[IntegerCell{false, c}];
        }
        out.comment("Counters.");
        out.line(fmt::format("struct {{ {} {}; }} counters;", integer_type(), members));
    }
    out.outdent();
    out.line(fmt::format("}} {}_grafcet;", names_.chart()));
}

}  // namespace grafwire
