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
#include <map>
#include <string>
#include <vector>

#include "grafcet/grafcet.h"
#include "grafcet/write_grafcet.h"
#include "ladder/chart_variables.h"
#include "ladder/messages.h"
#include "ladder/rung_writer.h"
#include "ladder/simplified_scan.h"

namespace grafwire::ladder {

namespace {

namespace say = messages::ladder;

/// What sets or resets each step, beside the transitions.
struct Causes {
    std::vector<Condition> set;
    std::vector<Condition> reset;
};

std::vector<std::vector<Condition>> by_step(std::size_t steps) {
    return std::vector<std::vector<Condition>>(steps);
}

/// Makes a ladder diagram, section by section.
class LadderBuild {
  public:
    LadderBuild(const Grafcet& grafcet, const ScanProgram& program, Language language,
                Diagnostics& diagnostics);

    Ladder make();

  private:
    /// The rungs that `make_rungs` makes, under a heading.
    template <typename MakeRungs>
    void section(const Message<>& heading, const MakeRungs& make_rungs);

    // The scan in its order.
    void make_start();
    void make_previous();
    void translate(SectionKind section);
    void translate(const Statement& statement);
    void move(const Statement& statement);
    void time(const Statement& statement);
    void pulses();

    // What the transitions, steps and orders become.
    void make_transitions();
    void make_steps();
    void make_orders();
    std::size_t force(std::size_t first);

    const Grafcet& grafcet_;
    const ScanProgram& program_;
    Language language_;
    Ladder ladder_;
    SimplifiedScan scan_;
    ChartVariables variables_;
    RungWriter rungs_;
};

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

void LadderBuild::make_transitions() {
    for (const Statement& statement : scan_.section(SectionKind::conditions)) {
        const Bit bit = statement.targets.front();
        if (scan_.is_constant(bit)) continue;
        const Purpose purpose{statement.comment, statement.origin};
        Power cause = rungs_.power(scan_.cleared(bit.index), purpose);
        rungs_.add(std::move(cause), CoilKind::normal, {bit}, purpose);
    }
}

/// SBR 4 as the course has it: CDX resets, then CAX sets. What sets or resets a step after the
/// formula in the program (Init) stands in the same two rungs, as in the course's tables:
/// `CAX + Init` and `CDX . /Init` of an initial step, `CAX . /Init` and `CDX + Init` of another.
void LadderBuild::make_steps() {
    const std::size_t steps = grafcet_.steps.size();
    auto into = by_step(steps);
    auto out_of = by_step(steps);
    std::vector<Causes> otherwise(steps);
    const auto conjunct = [](const Condition& condition) {
        return condition.kind == Condition::Kind::conjunction ? condition.operands.back()
                                                              : condition;
    };
    for (const Statement& statement : scan_.section(SectionKind::evolution)) {
        for (const Bit bit : statement.targets) {
            // The transition is the last factor of a statement of SBR 4.
            if (bit.kind == BitKind::activate) {
                into[bit.index].push_back(conjunct(statement.condition));
            } else if (bit.kind == BitKind::deactivate) {
                out_of[bit.index].push_back(conjunct(statement.condition));
            } else if (bit.kind == BitKind::step) {
                Causes& causes = otherwise[bit.index];
                (statement.kind == Statement::Kind::set ? causes.set : causes.reset)
                    .push_back(statement.condition);
            }
        }
    }
    for (std::uint32_t s = 0; s < steps; ++s) {
        const Condition set = or_condition(otherwise[s].set);
        const Condition reset = or_condition(otherwise[s].reset);
        const auto changed_by = [&](std::vector<Condition> transitions, const Condition& as_well,
                                    const Condition& but_not) {
            std::vector<Condition> causes;
            causes.push_back(or_condition(std::move(transitions)));
            causes.push_back(as_well);
            std::vector<Condition> parts;
            parts.push_back(or_condition(std::move(causes)));
            parts.push_back(not_condition(but_not));
            return scan_.simplified(and_condition(std::move(parts)));
        };
        const Condition deactivation = changed_by(std::move(out_of[s]), reset, set);
        const Condition activation = changed_by(std::move(into[s]), set, reset);
        const Step& step = grafcet_.steps[StepId{s}];
        const std::string name = quoted_where_needed(step.name);
        const std::vector<Bit> bit{{BitKind::step, s}};
        const auto add_rung = [&](const Condition& cause, CoilKind coil,
                                  const Message<std::string>& what) {
            if (cause.is_constant(false)) return;
            const Purpose purpose{what(name), step.where};
            rungs_.add(rungs_.power(cause, purpose), coil, bit, purpose);
        };
        add_rung(deactivation, CoilKind::reset, say::deactivation);
        add_rung(activation, CoilKind::set, say::activation);
    }
}

/// SBR 5. The forcing orders, a run of statements that set Tf0 and Tf1, are taken together.
void LadderBuild::make_orders() {
    const std::vector<Statement>& statements = scan_.section(SectionKind::orders);
    for (std::size_t at = 0; at < statements.size();) {
        const Statement& statement = statements[at];
        const bool forces =
            !statement.targets.empty() && statement.targets.front().kind == BitKind::forced_off;
        if (forces) {
            at = force(at);
            continue;
        }
        if (statement.kind == Statement::Kind::table &&
            statement.operation == TableOperation::pulse) {
            pulses();
        }
        translate(statement);
        ++at;
    }
}

/// Forcing orders as set and reset coils, `Ts = Ts . /Tf0 + Tf1`: reset first, then set. All orders
/// are those of the steps active before any of them is obeyed (one pass, Cordier, section 5.6), so
/// the rungs begin with the steps that are deepest in the hierarchy of orders: a step is changed
/// only after all rungs that ask for it. Gives the index of the first statement after the orders.
std::size_t LadderBuild::force(std::size_t first) {
    const std::vector<Statement>& statements = scan_.section(SectionKind::orders);
    std::vector<std::vector<Bit>> off(grafcet_.steps.size());  // per step: who gives the orders
    std::vector<std::vector<Bit>> on(grafcet_.steps.size());
    std::size_t at = first;
    Location where;
    for (; statements[at].kind == Statement::Kind::set; ++at) {
        for (const Bit bit : statements[at].targets) {
            auto& orders = (bit.kind == BitKind::forced_off ? off : on)[bit.index];
            orders.push_back(statements[at].condition.bit);
        }
        if (!where.is_known()) where = statements[at].origin;
    }
    const std::vector<std::size_t> depths = forcing_depths(grafcet_);
    const auto rungs = [&](const std::vector<std::vector<Bit>>& orders, std::size_t level,
                           CoilKind kind, const Message<>& comment) {
        std::map<std::vector<Bit>, std::vector<Bit>> steps_of;
        for (std::uint32_t s = 0; s < orders.size(); ++s) {
            const GraphId graph = grafcet_.steps[StepId{s}].graph;
            if (depths[index_of(graph)] != level || orders[s].empty()) continue;
            steps_of[orders[s]].push_back({BitKind::step, s});
        }
        for (const auto& [givers, steps] : steps_of) {
            std::vector<Power> contacts;
            for (const Bit giver : givers) contacts.push_back(contact(variables_[giver]));
            rungs_.add(parallel(std::move(contacts)), kind, steps, {comment(), where});
        }
    };
    for (std::size_t level = *std::max_element(depths.begin(), depths.end()); level > 0; --level) {
        rungs(off, level, CoilKind::reset, say::forced_off);
        rungs(on, level, CoilKind::set, say::forced_on);
    }
    return at;
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

}  // namespace

Ladder ladder_from(const Grafcet& grafcet, const ScanProgram& program, Diagnostics& diagnostics,
                   Language language) {
    return LadderBuild(grafcet, program, language, diagnostics).make();
}

}  // namespace grafwire::ladder
