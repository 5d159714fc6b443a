// Transitions, steps and forcing orders as set and reset coils.

#include <algorithm>
#include <map>

#include "grafcet/grafcet.h"
#include "grafcet/write_grafcet.h"
#include "ladder/ladder_build.h"
#include "ladder/messages.h"

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

}  // namespace

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

}  // namespace grafwire::ladder
