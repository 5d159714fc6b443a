// PL7-2.
//
// The controller has a GRAFCET of its own: it tests the transitions on the situation the scan
// begins with and clears all that can be cleared, as SBR 4 does. So only the rest of the scan is
// written out: edges before the chart is evolved, in the preliminary processing; stored actions,
// times and outputs after it, in the posterior processing. What that GRAFCET does not have is made
// of what it has: a source transition hangs on a step that is always active, a sink transition
// leads to a step that nothing leaves, and the situation that forcing orders and enclosures demand
// is worked out beforehand and preset (pl7_situation.cpp).
//
// AUdur empties the chart by SY22, but where steps are preset: there it is one more preset
// situation, which leaves the always active step alone.
//
// PL7-2 is drawn, not written. The listing keeps the heads of rungs that the printouts of its
// programming tool have (`** LABEL 10`, `** X0 --> X1`) and writes a rung on one line; its head
// says how.

#include "plc/pl7/write_pl7.h"

#include <fmt/format.h>

#include <set>

#include "grafcet/write_grafcet.h"
#include "plc/pl7/messages.h"
#include "plc/pl7/pl7_objects.h"
#include "plc/pl7/pl7_rungs.h"
#include "plc/pl7/pl7_situation.h"
#include "plc/shared/program_needs.h"
#include "program/bit_names.h"
#include "program/messages.h"

namespace grafwire {

namespace {

namespace say = messages::plc_pl7;

/// What a listing begins with: the title, its conventions, the assignment of objects.
std::string pl7_head(const Grafcet& grafcet, Pl7Objects& objects, const PlcOptions& options) {
    const Language language = options.language;
    std::string text =
        fmt::format("PL7-2   {}\n\n", titled_name(grafcet.name, grafcet.title, language));
    if (!options.made_by.empty()) text += options.made_by + "\n\n";
    text += fmt::format("{}\n\n{}", say::what_it_is.in(language), say::conventions.in(language));
    if (!objects.source_step().empty()) text += say::source_convention.in(language);
    if (!objects.sink_step().empty()) text += say::sink_convention.in(language);
    text += fmt::format("\n{}\n\n", say::assignment.in(language));
    for (const auto& [object, name] : objects.assignment()) {
        text += fmt::format("   {:<8} {}\n", object, name);
    }
    return text;
}

/// The steps of the chart and those that source and sink transitions need, a line each; `#` marks
/// the initial ones, as in the printouts.
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

/// Whether the condition is written as one contact, or as a wire.
bool is_contact(const Condition& condition) {
    const Condition& inner =
        condition.kind == Condition::Kind::negation ? condition.operands.front() : condition;
    return inner.kind == Condition::Kind::bit || inner.kind == Condition::Kind::constant;
}

class Pl7Writer {
  public:
    Pl7Writer(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
              Diagnostics& diagnostics)
        : grafcet_(grafcet),
          program_(program),
          options_(options),
          language_(options.language),
          diagnostics_(diagnostics),
          objects_(grafcet, program_),
          preliminary_(objects_),
          posterior_(objects_),
          statements_(grafcet, program_, objects_, posterior_, language_, diagnostics),
          has_orders_(has_orders(grafcet_)) {}

    std::string write();

  private:
    void note_uses();
    void note_uses(const Condition& condition);
    void write_start();
    void write_previous();
    void write_edges();
    void write_transitions();
    Condition write_condition(const Statement& statement);
    void write_modes();
    void write_posterior();
    std::string steps(std::span<const StepId> ids, const std::string& otherwise);
    std::string control(ControlInput input) {
        return objects_.of(Bit{BitKind::control, static_cast<std::uint32_t>(input)});
    }

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    const PlcOptions& options_;
    Language language_;
    Diagnostics& diagnostics_;
    Pl7Objects objects_;
    Pl7Rungs preliminary_;
    Pl7Rungs posterior_;
    Pl7Statements statements_;
    bool has_orders_ = false;
    std::string transitions_;
    std::vector<Condition> conditions_;  ///< per transition, as the chart has them
    std::set<std::uint32_t> previous_;   ///< steps whose Tp is read
    std::set<std::uint32_t> tested_;     ///< transitions whose Tt is read after the evolution
};

/// What of the tables is read outside the evolution, which is the controller's own.
void Pl7Writer::note_uses(const Condition& condition) {
    if (condition.kind == Condition::Kind::bit) {
        const Bit bit = condition.bit;
        if (bit.kind == BitKind::previous || bit.kind == BitKind::pulse)
            previous_.insert(bit.index);
        if (bit.kind == BitKind::transition) tested_.insert(bit.index);
    }
    for (const Condition& operand : condition.operands) note_uses(operand);
}

void Pl7Writer::note_uses() {
    for (const SectionKind kind : {SectionKind::stored, SectionKind::times, SectionKind::outputs}) {
        for (const Statement& statement : program_.section(kind)) note_uses(statement.condition);
    }
}

/// Internal bits are 0 after a cold start, so only what is 1 is set.
void Pl7Writer::write_start() {
    for (const Statement& statement : program_.section(SectionKind::start)) {
        const Bit target = statement.targets.empty() ? Bit{} : statement.targets.front();
        if (target.kind == BitKind::step || target.kind == BitKind::previous) continue;
        preliminary_.label(say::cold_start.in(language_, statement.comment));
        if (statement.kind == Statement::Kind::move) {
            const std::string value = preliminary_.value(statement.sum);
            preliminary_.line("SY0",
                              fmt::format("[{} -> {}]", value, objects_.of(statement.integer)));
            continue;
        }
        const Bit first_scan{BitKind::auxiliary, 0};
        objects_.name(first_scan, "SY0");
        const Condition condition = and_condition({bit_condition(first_scan), statement.condition});
        for (const Bit bit : statement.targets) {
            preliminary_.rung(condition, "(S) " + objects_.of(bit));
        }
    }
}

void Pl7Writer::write_previous() {
    for (const std::uint32_t step : previous_) {
        preliminary_.label(say::step_before.in(language_, grafcet_.steps[StepId{step}].name));
        preliminary_.rung(bit_condition({BitKind::step, step}),
                          "( ) " + objects_.of(Bit{BitKind::previous, step}));
    }
}

void Pl7Writer::write_edges() {
    for (const Statement& statement : program_.section(SectionKind::edges)) {
        preliminary_.label(statement.comment.in(language_));
        preliminary_.rung(statement.condition, "( ) " + objects_.of(statement.targets.front()));
    }
}

/// A transition condition that is read again, by a stored action or for the situation to be
/// reached, has a bit of its own, or is one contact.
Condition Pl7Writer::write_condition(const Statement& statement) {
    const Bit bit = statement.targets.front();
    if (tested_.count(bit.index) != 0 || (has_orders_ && !is_contact(statement.condition))) {
        preliminary_.label(say::transition_condition.in(language_, statement.comment));
        preliminary_.rung(statement.condition, "( ) " + objects_.of(bit));
        return bit_condition(bit);
    }
    if (Pl7Rungs::has_sums(statement.condition)) {
        preliminary_.label(say::sums.in(language_, statement.comment));
    } else if (Pl7Rungs::has_long_exclusive_ors(statement.condition)) {
        preliminary_.label(say::parts.in(language_, statement.comment));
    }
    return statement.condition;
}

void Pl7Writer::write_transitions() {
    const std::string source = objects_.source_step();
    const std::string sink = objects_.sink_step();
    for (const Statement& statement : program_.section(SectionKind::conditions)) {
        const Transition& transition =
            grafcet_.transitions[TransitionId{statement.targets.front().index}];
        std::string after = steps(grafcet_.following(transition), sink);
        if (transition.preceding.count == 0) after = source + " " + after;
        transitions_ +=
            fmt::format("\n** {} --> {}   {}\n", steps(grafcet_.preceding(transition), source),
                        after, statement.comment.in(language_));
        conditions_.push_back(write_condition(statement));
        transitions_ += fmt::format("   {} --(#)\n", preliminary_.contacts(conditions_.back()));
    }
}

/// The objects of steps, or another where there are none.
std::string Pl7Writer::steps(std::span<const StepId> ids, const std::string& otherwise) {
    if (ids.empty()) return otherwise;
    std::string text;
    for (const StepId id : ids) {
        if (!text.empty()) text += " ";
        text += objects_.of(Bit{BitKind::step, static_cast<std::uint32_t>(index_of(id))});
    }
    return text;
}

/// Init and AUdur. Presetting comes last, for every other rung reads the steps as the scan begins.
void Pl7Writer::write_modes() {
    const bool presets_au_dur = has_orders_ || !objects_.source_step().empty();
    if (program_.has_modes) {
        const std::string au_dur = control(ControlInput::au_dur);
        if (!has_orders_) {
            preliminary_.label(say::au_dur.in(language_));
            preliminary_.line(au_dur, presets_au_dur ? "( ) SY23" : "( ) SY22");
        }
        preliminary_.label(say::init.in(language_));
        preliminary_.line(control(ControlInput::init) + (presets_au_dur ? " . /SY23" : " . /SY22"),
                          "( ) SY21");
    }
    if (has_orders_) {
        write_presets(grafcet_, language_, objects_, preliminary_);
    } else if (program_.has_modes && presets_au_dur) {
        preliminary_.label(say::presetting.in(language_));
        for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
            preliminary_.line("SY23", "(R) " + objects_.of(Bit{BitKind::step, s}));
        }
    }
}

void Pl7Writer::write_posterior() {
    for (const SectionKind kind : {SectionKind::stored, SectionKind::times, SectionKind::outputs}) {
        for (const Statement& statement : program_.section(kind)) statements_.write(statement);
    }
}

std::string Pl7Writer::write() {
    note_uses();
    statements_.name_timers();
    write_start();
    write_previous();
    write_edges();
    write_transitions();
    if (has_orders_) {
        write_situation(grafcet_, program_, conditions_, language_, objects_, preliminary_);
    }
    write_modes();
    write_posterior();
    objects_.check_limits(diagnostics_);
    if (diagnostics_.has_errors()) return {};
    return fmt::format("{}\n{}\n{}\n{}\n\n{}{}\n{}\n{}", pl7_head(grafcet_, objects_, options_),
                       say::preliminary.in(language_), preliminary_.text(),
                       say::sequential.in(language_), pl7_steps(grafcet_, objects_, language_),
                       transitions_, say::posterior.in(language_), posterior_.text());
}

}  // namespace

std::string write_pl7(const Grafcet& grafcet, const ScanProgram& program, const PlcOptions& options,
                      Diagnostics& diagnostics) {
    const ScanProgram needed = without_idle_tables(program);
    if (integer_bits(grafcet, needed) != 16U) {
        diagnostics.error(code::unsupported_by_language, wide_integer(grafcet, needed, 16),
                          say::integer_too_wide());
    }
    if (diagnostics.has_errors()) return {};
    return Pl7Writer(grafcet, needed, options, diagnostics).write();
}

}  // namespace grafwire
