#include "ladder/sfc_machine.h"

#include <algorithm>

namespace grafwire::testing {

namespace {

bool share(const std::set<std::string>& a, const std::set<std::string>& b) {
    return std::any_of(a.begin(), a.end(), [&](const auto& name) { return b.count(name) > 0; });
}

bool share(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
    return std::any_of(a.begin(), a.end(), [&](std::size_t item) {
        return std::find(b.begin(), b.end(), item) != b.end();
    });
}

/// What one writes and the other reads or writes.
std::set<std::string> common(const StAccess& a, const StAccess& b) {
    std::set<std::string> names;
    for (const std::string& name : a.writes) {
        if (b.writes.count(name) + b.reads.count(name) > 0) names.insert(name);
    }
    for (const std::string& name : b.writes) {
        if (a.reads.count(name) > 0) names.insert(name);
    }
    return names;
}

}  // namespace

SfcMachine::SfcMachine(const SfcPou& sfc, const SfcDialect& dialect)
    : sfc_(sfc), dialect_(dialect), states_(sfc.actions.size()) {
    for (const SfcPou::Variable& item : sfc.variables) {
        IecVariable variable;
        variable.type = iec_type_named(item.type, 0);
        variable.is_input = item.is_input;
        variable.values = {item.initial};
        block_.declare(item.name, variable, 0);
    }
    for (const SfcPou::Step& step : sfc.steps) {
        IecVariable variable;
        variable.type = IecType::step;
        variable.values = {step.initial ? 1 : 0};
        block_.declare(step.name, variable, 0);
        active_.push_back(step.initial);
    }
    for (std::size_t t = 0; t < sfc.transitions.size(); ++t) {
        from_left_.push_back(t);
        conditions_.emplace_back(block_, IecTokenCursor(iec_tokens(sfc.transitions[t].condition)));
    }
    std::stable_sort(from_left_.begin(), from_left_.end(), [&](std::size_t a, std::size_t b) {
        return sfc.transitions[a].x < sfc.transitions[b].x;
    });
    read_actions();
}

void SfcMachine::read_actions() {
    std::set<std::string> timed;
    for (const SfcPou::Action& action : sfc_.actions) {
        static const std::set<std::string> names{"N", "D", "L", "S", "R", "P1", "P0"};
        const std::string& qualifier = action.qualifier;
        if (names.count(qualifier) == 0) throw PlcError(0, "the qualifier " + qualifier);
        const bool is_pulse = qualifier == "P1" || qualifier == "P0";
        if (action.reference.empty() ? !is_pulse && qualifier != "N" : is_pulse) {
            throw PlcError(0, "the qualifier " + qualifier + " of an action of this kind");
        }
        // One control of an action has one timer (2.6.4.5).
        const bool is_timed = qualifier == "D" || qualifier == "L";
        if (is_timed && !timed.insert(action.reference).second) {
            throw PlcError(0, "several delays of " + action.reference);
        }
        bodies_.emplace_back(block_, IecTokenCursor(iec_tokens(action.statements)));
        if (action.reference.empty()) continue;
        if (block_.variable(action.reference, 0).type != IecType::boolean) {
            throw PlcError(0, "an action that is no BOOL");
        }
        controlled_.insert(action.reference);
    }
}

void SfcMachine::set_input(const std::string& name, bool value) {
    const auto found = block_.variables.find(lower_case(name));
    if (found != block_.variables.end()) found->second.values.front() = value ? 1 : 0;
}

std::int64_t SfcMachine::value(const std::string& name) const {
    const auto found = block_.variables.find(lower_case(name));
    return found == block_.variables.end() ? 0 : found->second.values.front();
}

SfcScanReport SfcMachine::scan(Time now) {
    SfcScanReport report;
    evolve(now, report);
    std::vector<Executed> executed;
    control_variables(now, executed);
    execute(now, executed);
    for (std::size_t i = 0; i < executed.size(); ++i) {
        for (std::size_t j = i + 1; j < executed.size(); ++j) {
            const auto variables = common(executed[i].access, executed[j].access);
            if (variables.empty()) continue;
            std::set<std::string> both;
            for (const std::string& name : executed[i].access.writes) {
                if (executed[j].access.writes.count(name) > 0) both.insert(name);
            }
            report.meetings.push_back({executed[i].action, executed[j].action, variables, both});
        }
    }
    is_first_ = false;
    return report;
}

void SfcMachine::evolve(Time now, SfcScanReport& report) {
    was_active_ = active_;
    entered_.assign(active_.size(), false);
    std::vector<std::size_t> cleared;
    for (const std::size_t t : from_left_) {
        const SfcPou::Transition& transition = sfc_.transitions[t];
        // Looked at in any case: the text is checked by that.
        const bool holds = conditions_[t].condition(now);
        const bool is_enabled =
            std::all_of(transition.preceding.begin(), transition.preceding.end(),
                        [&](std::size_t step) { return was_active_[step]; });
        if (!holds || !is_enabled) continue;
        const auto rival = std::find_if(cleared.begin(), cleared.end(), [&](std::size_t other) {
            return share(sfc_.transitions[other].preceding, transition.preceding);
        });
        if (rival == cleared.end()) {
            cleared.push_back(t);
        } else {
            report.selections.emplace_back(*rival, t);
        }
    }
    for (const std::size_t t : cleared) {
        for (const std::size_t step : sfc_.transitions[t].preceding) active_[step] = false;
    }
    for (const std::size_t t : cleared) {
        for (const std::size_t step : sfc_.transitions[t].following) {
            active_[step] = true;
            entered_[step] = true;
        }
    }
    for (std::size_t s = 0; s < active_.size(); ++s) {
        block_.variables.at(sfc_.steps[s].name).values.front() = active_[s] ? 1 : 0;
    }
}

/// The timer of a D or L action.
bool SfcMachine::is_time_over(std::size_t a, Time now) {
    const SfcPou::Action& action = sfc_.actions[a];
    ActionState& state = states_[a];
    if (dialect_.restarts_time && entered_[action.step]) state.is_timing = false;
    if (!state.is_timing) state.since = now;
    state.is_timing = active_[action.step];
    return now - state.since >= action.duration;
}

void SfcMachine::control_variables(Time now, std::vector<Executed>& executed) {
    std::set<std::string> on;
    std::set<std::string> reset;
    for (std::size_t a = 0; a < sfc_.actions.size(); ++a) {
        const SfcPou::Action& action = sfc_.actions[a];
        if (action.reference.empty()) continue;
        const bool is_timed = action.qualifier == "D" || action.qualifier == "L";
        const bool is_over = is_timed && is_time_over(a, now);
        if (!active_[action.step]) continue;
        if (action.qualifier == "R") {
            reset.insert(action.reference);
        } else if (action.qualifier == "S") {
            latched_.insert(action.reference);
        } else if (!is_timed || is_over == (action.qualifier == "D")) {
            on.insert(action.reference);
        }
        if (action.qualifier == "S" || action.qualifier == "R") {
            executed.push_back({a, {{}, {action.reference}}});
        }
    }
    for (const std::string& name : reset) latched_.erase(name);
    for (const std::string& name : controlled_) {
        const bool is_on =
            (on.count(name) > 0 || latched_.count(name) > 0) && reset.count(name) == 0;
        block_.variables.at(name).values.front() = is_on ? 1 : 0;
    }
}

bool SfcMachine::is_executed(const SfcPou::Action& action) const {
    const bool is_active = active_[action.step];
    const bool was_active = was_active_[action.step];
    if (action.qualifier == "P0") return was_active && !is_active;
    if (action.qualifier == "N") return is_active || (dialect_.final_scan && was_active);
    return is_active && (!was_active || (is_first_ && dialect_.pulse_at_start));
}

void SfcMachine::execute(Time now, std::vector<Executed>& executed) {
    for (std::size_t a = 0; a < sfc_.actions.size(); ++a) {
        const SfcPou::Action& action = sfc_.actions[a];
        if (!action.reference.empty() || !is_executed(action)) continue;
        StAccess access;
        const IecTokenCursor rest = bodies_[a].run(now, &access);
        if (rest.peek().kind != IecToken::Kind::end) rest.fail("text after the statements");
        if (share(access.writes, controlled_)) {
            throw PlcError(0, "statements write what an action block controls");
        }
        executed.push_back({a, access});
    }
}

}  // namespace grafwire::testing
