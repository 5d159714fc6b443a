// The types and functions of a program in C: the steps as an enumeration, inputs and outputs as
// structs of their own, one struct for the state; and a function for each section of the scan, with
// the subroutine of the method that it is beside it.
//
// Whole tables are worked on word by word, `Ts[w] = (Tp[w] & ~Td[w]) | Ta[w]`, which is what makes
// the table method fast.

#include "plc/computer/c_core.h"

#include <fmt/format.h>

#include <cassert>

#include "plc/computer/c_blocks.h"
#include "plc/computer/language_parts.h"
#include "plc/computer/messages.h"
#include "plc/shared/program_needs.h"
#include "plc/shared/source_text.h"
#include "program/bit_names.h"

namespace grafwire {

namespace {

namespace say = messages::plc_computer;

ConditionSpelling spelling(bool wide) {
    ConditionSpelling result;
    result.negation = "!";
    result.conjunction = " && ";
    result.disjunction = " || ";
    result.exclusive_or = " ^ ";
    result.one = "true";
    result.zero = "false";
    result.relations = {"==", "!=", "<", "<=", ">", ">="};
    result.before_first_number = wide ? "INT64_C(" : "INT32_C(";
    result.after_first_number = ")";
    return result;
}

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

CCore::CCore(const Grafcet& grafcet, const ScanProgram& program, const NameRules& rules,
             Language language)
    : grafcet_(grafcet),
      program_(without_idle_tables(program)),
      names_(grafcet, program_, rules),
      wide_(integer_bits(grafcet_, program_).value_or(64) > 32),
      conditions_(
          spelling(wide_), [this](Bit bit) { return name(bit); },
          [this](IntegerCell cell) { return name(cell); }),
      language_(language) {}

std::string CCore::name(Bit bit) const {
    if (bit.kind == BitKind::scratch) return names_[bit];
    const std::string_view holder = holder_name(bit.kind);
    if (is_step_table(bit.kind)) return fmt::format("is(g->{}, {})", holder, names_[bit]);
    return fmt::format("g->{}.{}{}", holder, names_[bit],
                       bit.kind == BitKind::time_value ? ".value" : "");
}

std::string CCore::name(IntegerCell cell) const {
    return cell.is_scratch ? names_[cell] : "g->counters." + names_[cell];
}

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

std::string CCore::functions() const {
    SourceText sections("//");
    for (std::size_t s = 1; s < section_count; ++s) {
        write_section(sections, static_cast<SectionKind>(s));
    }
    write_entry_points(sections);
    std::string called = sections.take();
    // What calls a helper comes before it in the list, so that one pass finds all; in the program
    // it comes behind it.
    std::string text;
    for (const c::Helper& helper : c::helpers) {
        if (!calls(called, helper.name) && !calls(text, helper.name)) continue;
        text.insert(0, with_texts(helper.text, {{"INTEGER", std::string(integer_type())}}));
    }
    return text + called;
}

void CCore::write_section(SourceText& out, SectionKind section) const {
    if (program_.section(section).empty()) return;
    out.blank();
    out.comment(section_title(section).in(language_));
    out.line(
        fmt::format("static void {}({}_grafcet *g) {{", section_function(section), names_.chart()));
    out.indent();
    for (const Statement& statement : program_.section(section)) write(out, statement);
    out.outdent();
    out.line("}");
}

void CCore::write_entry_points(SourceText& out) const {
    const std::string& chart = names_.chart();
    out.blank();
    out.comment(section_title(SectionKind::start).in(language_));
    out.line(fmt::format("void {0}_start({0}_grafcet *g, const {0}_inputs *in) {{", chart));
    out.indent();
    out.line("memset(g, 0, sizeof *g);");
    out.line("g->inputs = *in;");
    for (const Statement& statement : program_.section(SectionKind::start)) write(out, statement);
    out.outdent();
    out.line("}");
    out.blank();
    out.comment(say::one_scan_clocked.in(language_));
    out.line(
        fmt::format("void {0}_scan({0}_grafcet *g, const {0}_inputs *in, int64_t now) {{", chart));
    out.indent();
    out.line("g->inputs = *in;");
    out.line("g->now = now;");
    for (std::size_t s = 1; s < section_count; ++s) {
        const auto section = static_cast<SectionKind>(s);
        if (program_.section(section).empty()) continue;
        out.line(fmt::format("{}(g);", section_function(section)));
    }
    out.outdent();
    out.line("}");
}

void CCore::write(SourceText& out, const Statement& statement) const {
    if (says_more(statement)) out.comment(statement.comment.in(language_));
    switch (statement.kind) {
        case Statement::Kind::assign:
            write_assignment(out, statement);
            return;
        case Statement::Kind::table:
            write_table(out, statement.operation);
            return;
        case Statement::Kind::time:
            out.line(fmt::format("observe(&g->time.{}, {}, {}, {}, g->now);",
                                 names_[statement.targets[0]], conditions_.of(statement.condition),
                                 microseconds(statement.on_delay),
                                 microseconds(statement.off_delay)));
            return;
        case Statement::Kind::set:
        case Statement::Kind::reset:
        case Statement::Kind::move:
            break;
    }
    const bool always = statement.condition.is_constant(true);
    const bool moves = statement.kind == Statement::Kind::move;
    if (moves && always) {
        out.line(move_text(statement));
        return;
    }
    if (!always) {
        out.line(fmt::format("if ({}) {{", conditions_.of(statement.condition)));
        out.indent();
    }
    if (moves) {
        out.line(move_text(statement));
    } else {
        write_targets(out, statement);
    }
    if (!always) {
        out.outdent();
        out.line("}");
    }
}

void CCore::write_assignment(SourceText& out, const Statement& statement) const {
    const Bit target = statement.targets[0];
    assert(!is_step_table(target.kind));
    const std::string_view type = target.kind == BitKind::scratch ? "const bool " : "";
    out.line(fmt::format("{}{} = {};", type, name(target), conditions_.of(statement.condition)));
}

void CCore::write_targets(SourceText& out, const Statement& statement) const {
    const bool sets = statement.kind == Statement::Kind::set;
    const std::string_view operation = sets ? "set" : "reset";
    const auto step = [&](std::uint32_t index) { return names_[Bit{BitKind::step, index}]; };
    for (const StepRange& range : step_ranges(statement.targets)) {
        const std::string table = fmt::format("g->{}", holder_name(range.table));
        if (range.first == range.last) {
            out.line(fmt::format("{}({}, {});", operation, table, step(range.first)));
        } else {
            out.line(fmt::format("{}_all({}, {}, {});", operation, table, step(range.first),
                                 step(range.last)));
        }
    }
    for (const Bit bit : single_bits(statement.targets)) {
        out.line(fmt::format("{} = {};", name(bit), sets ? "true" : "false"));
    }
}

std::string CCore::move_text(const Statement& statement) const {
    const std::string type =
        statement.integer.is_scratch ? fmt::format("const {} ", integer_type()) : "";
    const bool is_number =
        statement.sum.size() == 1 && statement.sum.front().counter == SumTerm::no_counter;
    const std::string value =
        statement.sum.empty() ? name(statement.source) : conditions_.of(statement.sum);
    const std::int64_t number =
        is_number ? (statement.sum.front().negative ? -1 : 1) * statement.sum.front().value : 0;
    // What was worked out beforehand, and a number in the range, needs no holding within it.
    if (statement.sum.empty() ||
        (is_number && number >= statement.low && number <= statement.high)) {
        return fmt::format("{}{} = {};", type, name(statement.integer), value);
    }
    return fmt::format("{}{} = within({}, {}, {});", type, name(statement.integer), statement.low,
                       value, statement.high);
}

void CCore::write_table(SourceText& out, TableOperation operation) const {
    std::string text;
    switch (operation) {
        case TableOperation::remember:
            text = "g->Tp[w] = g->Ts[w];";
            break;
        case TableOperation::clear:
            text = uses(program_, BitKind::forced_off)
                       ? "g->Ta[w] = g->Td[w] = g->Tf1[w] = g->Tf0[w] = 0;"
                       : "g->Ta[w] = g->Td[w] = 0;";
            break;
        case TableOperation::evolve:
            text = "g->Ts[w] = (g->Tp[w] & ~g->Td[w]) | g->Ta[w];";
            break;
        case TableOperation::force:
            text = "g->Ts[w] = (g->Ts[w] & ~g->Tf0[w]) | g->Tf1[w];";
            break;
        case TableOperation::pulse:
            text = "g->Tpulse[w] = g->Ts[w] & ~g->Tp[w];";
            break;
    }
    out.line("for (int w = 0; w < STEP_WORDS; ++w) " + text);
}

}  // namespace grafwire
