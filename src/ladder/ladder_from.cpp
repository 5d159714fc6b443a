// From the program of one scan to a ladder diagram.
//
// The steps are written as the course "Mise en œuvre du GRAFCET", section 3.1, writes them: a
// memory per step, set by its condition of activation and reset by its condition of deactivation,
// and set below reset, so that activation wins (rule 5). Taken literally that form is wrong
// wherever two transitions follow one another: the first rung has already changed the step that the
// second one asks for, and a token runs through the chart within one scan. So all transitions are
// worked out into bits before the first step is touched; only these bits set and reset steps.
// Everything else is the program of the table method, statement by statement.

#include "ladder/ladder_from.h"

#include <fmt/format.h>

#include "grafcet/grafcet.h"
#include "ladder/ladder_build.h"
#include "ladder/messages.h"

namespace grafwire::ladder {

namespace say = messages::ladder;

/// SBR 0, under a bit that is 0 in the first scan only. All bits are 0 then, so that an edge memory
/// need only be set.
void LadderBuild::make_start() {
    const VariableId started =
        variables_.declare("started", Type::bit, Role::memory, say::started());
    const auto first_scan = [&](const Condition& condition, const Purpose& purpose) {
        std::vector<Power> parts;
        parts.push_back(contact(started, ContactKind::negated));
        parts.push_back(rungs_.power(condition, purpose));
        return series(std::move(parts));
    };
    for (const Statement& statement : scan_.section(SectionKind::start)) {
        const Purpose purpose{statement.comment, statement.origin};
        if (statement.condition.is_constant(false)) continue;
        if (statement.kind == Statement::Kind::move) {
            const std::int64_t low = statement.low;
            if (low == 0) continue;
            Rung rung;
            rung.power = first_scan(statement.condition, purpose);
            rung.blocks.push_back({BlockType::move,
                                   variables_[statement.integer],
                                   {{Operand::Kind::number, low, {}}}});
            rungs_.add(std::move(rung), purpose);
            continue;
        }
        std::vector<Bit> targets;
        for (const Bit bit : statement.targets) {
            if (bit.kind != BitKind::previous && !scan_.is_constant(bit)) targets.push_back(bit);
        }
        if (targets.empty()) continue;
        Power power = first_scan(statement.condition, purpose);
        rungs_.add(std::move(power), CoilKind::set, targets, purpose);
    }
    Rung last;
    last.coils.push_back({CoilKind::set, started});
    rungs_.add(std::move(last), {say::first_scan_over(), {}});
}

/// SBR 1: what is asked of the situation before the scan.
void LadderBuild::make_previous() {
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        const Bit previous{BitKind::previous, s};
        if (!scan_.is_read(previous)) continue;
        const Step& step = grafcet_.steps[StepId{s}];
        rungs_.add(contact(variables_[Bit{BitKind::step, s}]), CoilKind::normal, {previous},
                   {say::step_before(step.name), step.where});
    }
}

void LadderBuild::pulses() {
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        const Bit pulse{BitKind::pulse, s};
        if (!scan_.is_read(pulse)) continue;
        const Step& step = grafcet_.steps[StepId{s}];
        std::vector<Power> parts;
        parts.push_back(contact(variables_[Bit{BitKind::step, s}]));
        parts.push_back(contact(variables_[Bit{BitKind::previous, s}], ContactKind::negated));
        rungs_.add(series(std::move(parts)), CoilKind::normal, {pulse},
                   {say::just_activated(step.name), step.where});
    }
}

void LadderBuild::translate(SectionKind section) {
    for (const Statement& statement : scan_.section(section)) translate(statement);
}

void LadderBuild::translate(const Statement& statement) {
    const Purpose purpose{statement.comment, statement.origin};
    const bool never = statement.condition.is_constant(false);
    switch (statement.kind) {
        case Statement::Kind::assign: {
            // A bit that is never 1 is never written: all bits begin as 0.
            if (never) return;
            if (scan_.is_constant(statement.targets.front())) return;
            Power cause = rungs_.power(statement.condition, purpose);
            rungs_.add(std::move(cause), CoilKind::normal, statement.targets, purpose);
            return;
        }
        case Statement::Kind::set:
        case Statement::Kind::reset: {
            if (never) return;
            Power cause = rungs_.power(statement.condition, purpose);
            rungs_.add(std::move(cause),
                       statement.kind == Statement::Kind::set ? CoilKind::set : CoilKind::reset,
                       statement.targets, purpose);
            return;
        }
        case Statement::Kind::move:
            if (!never) move(statement);
            return;
        case Statement::Kind::time:
            time(statement);
            return;
        case Statement::Kind::table:
            return;
    }
}

/// integer := sum, held within low..high by a LIMIT where the sum can leave that range. A sum of
/// several blocks is added up elsewhere, for its terms may read the integer.
void LadderBuild::move(const Statement& statement) {
    const Purpose purpose{statement.comment, statement.origin};
    Rung rung;
    rung.power = rungs_.power(statement.condition, purpose);
    const VariableId target = variables_[statement.integer];
    const Operand low{Operand::Kind::number, statement.low, {}};
    const Operand high{Operand::Kind::number, statement.high, {}};
    if (statement.sum.empty()) {
        const Operand source{Operand::Kind::variable, 0, variables_[statement.source]};
        rung.blocks.push_back({BlockType::move, target, {source}});
    } else {
        const auto range = range_of(grafcet_, statement.sum);
        const bool fits = range && range->low >= statement.low && range->high <= statement.high &&
                          statement.sum.size() <= 2 && !statement.sum.front().negative;
        const VariableId sum = fits ? target : variables_.new_integer();
        rungs_.add_up(statement.sum, sum, statement.origin, rung.blocks);
        if (!fits) {
            const Operand so_far{Operand::Kind::variable, 0, sum};
            rung.blocks.push_back({BlockType::limit, target, {low, so_far, high}});
        }
    }
    rungs_.add(std::move(rung), purpose);
}

/// A TON or TOF where there is one delay. With two, a TON runs while the operand and the value
/// differ, one for either change: a return of the operand before the end stops it, as it must,
/// while a TON followed by a TOF would restart the first delay.
void LadderBuild::time(const Statement& statement) {
    const Bit value = statement.targets.front();
    const Purpose purpose{statement.comment, statement.origin};
    if (!scan_.is_read(value) || statement.condition.is_constant(false)) return;
    const auto add_timer = [&](BlockType type, Power power, Time delay, CoilKind coil) {
        Rung rung;
        rung.power = std::move(power);
        if (delay != 0) {
            const Operand preset{Operand::Kind::time, delay, {}};
            const VariableId timer =
                variables_.new_instance(type, fmt::format("timer{}", value.index));
            rung.blocks.push_back({type, timer, {preset}});
        }
        rung.coils.push_back({coil, variables_[value]});
        rungs_.add(std::move(rung), purpose);
    };
    const auto while_differs = [&](bool operand) {
        std::vector<Power> parts;
        parts.push_back(rungs_.power(statement.condition, purpose, operand));
        parts.push_back(
            contact(variables_[value], operand ? ContactKind::negated : ContactKind::normal));
        return series(std::move(parts));
    };
    if (statement.off_delay == 0) {
        add_timer(BlockType::on_delay, rungs_.power(statement.condition, purpose),
                  statement.on_delay, CoilKind::normal);
    } else if (statement.on_delay == 0) {
        add_timer(BlockType::off_delay, rungs_.power(statement.condition, purpose),
                  statement.off_delay, CoilKind::normal);
    } else {
        add_timer(BlockType::on_delay, while_differs(true), statement.on_delay, CoilKind::set);
        if (statement.condition.is_constant(true)) return;
        add_timer(BlockType::on_delay, while_differs(false), statement.off_delay, CoilKind::reset);
    }
}

LadderBuild::LadderBuild(const Grafcet& grafcet, const ScanProgram& program, Language language,
                         Diagnostics& diagnostics)
    : grafcet_(grafcet),
      program_(program),
      language_(language),
      scan_(grafcet, program),
      variables_(grafcet, program, scan_, language, ladder_),
      rungs_(grafcet, variables_, language, ladder_, diagnostics) {
    ladder_.declared = ladder_.variables.size();
}

template <typename MakeRungs>
void LadderBuild::section(const Message<>& heading, const MakeRungs& make_rungs) {
    const std::size_t first = ladder_.rungs.size();
    make_rungs();
    if (ladder_.rungs.size() > first) ladder_.rungs[first].heading = heading.in(language_);
}

/// The order is that of the table method: each section reads what those before it have written.
Ladder LadderBuild::make() {
    ladder_.name = grafcet_.name;
    ladder_.title = grafcet_.title;
    ladder_.remarks.push_back(say::how_it_runs.in(language_));
    if (program_.has_modes) ladder_.remarks.push_back(say::modes.in(language_));
    section(say::first_scan, [&] { make_start(); });
    section(say::situation_before, [&] { make_previous(); });
    section(say::edges, [&] { translate(SectionKind::edges); });
    section(say::transitions, [&] { make_transitions(); });
    section(say::steps, [&] { make_steps(); });
    section(say::orders, [&] { make_orders(); });
    section(say::stored_actions, [&] { translate(SectionKind::stored); });
    section(say::times, [&] { translate(SectionKind::times); });
    section(say::outputs, [&] { translate(SectionKind::outputs); });
    return std::move(ladder_);
}

Ladder ladder_from(const Grafcet& grafcet, const ScanProgram& program, Diagnostics& diagnostics,
                   Language language) {
    return LadderBuild(grafcet, program, language, diagnostics).make();
}

}  // namespace grafwire::ladder
