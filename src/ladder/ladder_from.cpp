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

#include <algorithm>

#include "ladder/ladder_build.h"

namespace grafwire::ladder {

namespace {

bool writes_bit_of(const Statement& statement, BitKind kind) {
    return std::any_of(statement.targets.begin(), statement.targets.end(),
                       [&](Bit bit) { return bit.kind == kind; });
}

}  // namespace

/// Drops what never changes anything: graphs that nothing freezes, transitions that are never
/// cleared, what nobody reads.
void LadderBuild::simplify_program() {
    std::set<Bit> frozen;
    for (const Statement& statement : program_.section(SectionKind::outputs)) {
        for (const Bit bit : statement.targets) frozen.insert(bit);
    }
    for (std::uint32_t g = 0; g < grafcet_.graphs.size(); ++g) {
        const Bit bit{BitKind::may_evolve, g};
        if (frozen.count(bit) == 0) constants_.emplace(bit, true);
    }
    note_cleared_transitions();
    for (std::size_t s = 0; s < section_count; ++s) {
        for (Statement statement : program_.sections[s]) {
            statement.condition = simplified(statement.condition);
            for (const Bit bit : statement.targets) comments_.emplace(bit, statement.comment);
            // The steps before a transition are read by its rung, in note_cleared_transitions.
            if (!writes_bit_of(statement, BitKind::deactivate) &&
                !writes_bit_of(statement, BitKind::activate)) {
                collect_reads(statement.condition, read_);
            }
            sections_[s].push_back(std::move(statement));
        }
    }
    for (const Condition& condition : cleared_) collect_reads(condition, read_);
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        if (read_.count({BitKind::pulse, s}) > 0) read_.insert({BitKind::previous, s});
    }
}

void LadderBuild::push(Rung rung, std::string comment, Location origin) {
    rung.number = static_cast<std::uint32_t>(ladder_.rungs.size() + 1);
    rung.heading = std::move(heading_);
    heading_.clear();
    rung.comment = std::move(comment);
    rung.origin = origin;
    ladder_.rungs.push_back(std::move(rung));
}

void LadderBuild::add_rung(Power power, CoilKind kind, const std::vector<Bit>& targets,
                           std::string comment, Location origin) {
    Rung rung;
    rung.power = std::move(power);
    for (const Bit bit : targets) rung.coils.push_back({kind, id_of(bit)});
    push(std::move(rung), std::move(comment), origin);
}

/// SBR 0, under a bit that is 0 in the first scan only. All bits are 0 then, so that an edge memory
/// need only be set.
void LadderBuild::make_start() {
    begin("First scan: the initial situation");
    const VariableId started =
        declare("started", Type::bit, Role::memory, "0 in the first scan only");
    const auto first_scan = [&](const Condition& condition) {
        std::vector<Power> parts;
        parts.push_back(contact(started, ContactKind::negated));
        parts.push_back(power(condition));
        return series(std::move(parts));
    };
    for (const Statement& statement : section(SectionKind::start)) {
        context_ = statement.comment;
        origin_ = statement.origin;
        if (statement.condition.is_constant(false)) continue;
        if (statement.kind == Statement::Kind::move) {
            const std::int64_t low = statement.low;
            if (low == 0) continue;
            Rung rung;
            rung.power = first_scan(statement.condition);
            rung.blocks.push_back(
                {BlockType::move, id_of(statement.integer), {{Operand::Kind::number, low, {}}}});
            push(std::move(rung), statement.comment, statement.origin);
            continue;
        }
        std::vector<Bit> targets;
        for (const Bit bit : statement.targets) {
            if (bit.kind != BitKind::previous && constants_.count(bit) == 0) targets.push_back(bit);
        }
        if (targets.empty()) continue;
        Power power = first_scan(statement.condition);
        add_rung(std::move(power), CoilKind::set, targets, statement.comment, statement.origin);
    }
    Rung last;
    last.coils.push_back({CoilKind::set, started});
    push(std::move(last), "the first scan is over", {});
}

/// SBR 1: what is asked of the situation before the scan.
void LadderBuild::make_previous() {
    begin("Situation at the start of the scan");
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        const Bit previous{BitKind::previous, s};
        if (read_.count(previous) == 0) continue;
        const Step& step = grafcet_.steps[StepId{s}];
        add_rung(contact(id_of(Bit{BitKind::step, s})), CoilKind::normal, {previous},
                 fmt::format("step {} before the scan", step.name), step.where);
    }
}

void LadderBuild::pulses() {
    for (std::uint32_t s = 0; s < grafcet_.steps.size(); ++s) {
        const Bit pulse{BitKind::pulse, s};
        if (read_.count(pulse) == 0) continue;
        const Step& step = grafcet_.steps[StepId{s}];
        std::vector<Power> parts;
        parts.push_back(contact(id_of(Bit{BitKind::step, s})));
        parts.push_back(contact(id_of(Bit{BitKind::previous, s}), ContactKind::negated));
        add_rung(series(std::move(parts)), CoilKind::normal, {pulse},
                 fmt::format("step {} has just been activated", step.name), step.where);
    }
}

void LadderBuild::make_section(SectionKind kind, std::string heading) {
    begin(std::move(heading));
    for (const Statement& statement : section(kind)) translate(statement);
}

void LadderBuild::translate(const Statement& statement) {
    context_ = statement.comment;
    origin_ = statement.origin;
    const bool never = statement.condition.is_constant(false);
    switch (statement.kind) {
        case Statement::Kind::assign: {
            // A bit that is never 1 is never written: all bits begin as 0.
            if (never) return;
            if (constants_.count(statement.targets.front()) > 0) return;
            Power cause = power(statement.condition);
            add_rung(std::move(cause), CoilKind::normal, statement.targets, statement.comment,
                     statement.origin);
            return;
        }
        case Statement::Kind::set:
        case Statement::Kind::reset: {
            if (never) return;
            Power cause = power(statement.condition);
            add_rung(std::move(cause),
                     statement.kind == Statement::Kind::set ? CoilKind::set : CoilKind::reset,
                     statement.targets, statement.comment, statement.origin);
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
    Rung rung;
    rung.power = power(statement.condition);
    const VariableId target = id_of(statement.integer);
    const Operand low{Operand::Kind::number, statement.low, {}};
    const Operand high{Operand::Kind::number, statement.high, {}};
    if (statement.sum.empty()) {
        const Operand source{Operand::Kind::variable, 0, id_of(statement.source)};
        rung.blocks.push_back({BlockType::move, target, {source}});
    } else {
        const auto range = range_of(grafcet_, statement.sum);
        const bool fits = range && range->low >= statement.low && range->high <= statement.high &&
                          statement.sum.size() <= 2 && !statement.sum.front().negative;
        const VariableId sum = fits ? target : new_integer();
        add_up(statement.sum, sum, rung.blocks);
        if (!fits) {
            const Operand so_far{Operand::Kind::variable, 0, sum};
            rung.blocks.push_back({BlockType::limit, target, {low, so_far, high}});
        }
    }
    push(std::move(rung), statement.comment, statement.origin);
}

/// A TON or TOF where there is one delay. With two, a TON runs while the operand and the value
/// differ, one for either change: a return of the operand before the end stops it, as it must,
/// while a TON followed by a TOF would start the first delay anew.
void LadderBuild::time(const Statement& statement) {
    const Bit value = statement.targets.front();
    const std::string comment = statement.comment;
    if (read_.count(value) == 0 || statement.condition.is_constant(false)) return;
    const auto add_timer = [&](BlockType type, Power power, Time delay, CoilKind coil) {
        Rung rung;
        rung.power = std::move(power);
        if (delay != 0) {
            const Operand preset{Operand::Kind::time, delay, {}};
            const VariableId timer = instance(type, fmt::format("timer{}", value.index));
            rung.blocks.push_back({type, timer, {preset}});
        }
        rung.coils.push_back({coil, id_of(value)});
        push(std::move(rung), comment, statement.origin);
    };
    const auto while_differs = [&](bool operand) {
        std::vector<Power> parts;
        parts.push_back(power(statement.condition, operand));
        parts.push_back(
            contact(id_of(value), operand ? ContactKind::negated : ContactKind::normal));
        return series(std::move(parts));
    };
    if (statement.off_delay == 0) {
        add_timer(BlockType::on_delay, power(statement.condition), statement.on_delay,
                  CoilKind::normal);
    } else if (statement.on_delay == 0) {
        add_timer(BlockType::off_delay, power(statement.condition), statement.off_delay,
                  CoilKind::normal);
    } else {
        add_timer(BlockType::on_delay, while_differs(true), statement.on_delay, CoilKind::set);
        if (statement.condition.is_constant(true)) return;
        add_timer(BlockType::on_delay, while_differs(false), statement.off_delay, CoilKind::reset);
    }
}

Ladder LadderBuild::make() {
    ladder_.name = grafcet_.name;
    ladder_.title = grafcet_.title;
    next_work_ = program_.scratch_bits;
    ladder_.remarks.emplace_back(
        "Executed from top to bottom, once a scan. The transitions (T...) are worked out first; "
        "then "
        "every step (X...) is reset by those out of it and set by those into it.");
    if (program_.has_modes) {
        ladder_.remarks.emplace_back(
            "Inputs of the modes: Init = 1 holds the initial situation, AUdur = 1 deactivates "
            "every "
            "step, AUdoux = 1 switches off every continuous output.");
    }
    simplify_program();
    declare_names();
    ladder_.declared = ladder_.variables.size();
    make_start();
    make_previous();
    make_section(SectionKind::edges, "Edges");
    make_transitions();
    make_steps();
    make_orders();
    make_section(SectionKind::stored, "Stored actions");
    make_section(SectionKind::times, "Time conditions");
    make_section(SectionKind::outputs, "Outputs");
    return std::move(ladder_);
}

Ladder ladder_from(const ScanProgram& program, Diagnostics& diagnostics) {
    return LadderBuild(program, diagnostics).make();
}

}  // namespace grafwire::ladder
