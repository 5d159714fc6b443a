// A step module of AND, OR and NOT gates: the "module de phase" of the course "Mise en œuvre du
// GRAFCET", section 2.1:
//
//     X = CAX + /CDX . X
//
// four gates for a step with one transition before and one after it: AND (CAX), NOT and AND (the
// feedback), OR. With modes a last AND takes in /Init and /AUdur. Forcing is one more input to the
// OR (the step is listed) and one more to the last AND (the graph is forced, unless the step is
// listed), which is Ts./Tf0 + Tf1 and keeps every module equally deep.

#include <algorithm>

#include "netlist/styles/asynchronous.h"
#include "netlist/styles/styles.h"

namespace grafwire {

namespace {

/// /CDX, as one net.
NetId not_cdx(const StepSignals& step, const GateMaker& gates) {
    std::vector<NetId> terms;
    for (std::size_t i = 0; i < step.cdx.size(); ++i) {
        terms.push_back(gates.joined(CellType::and_gate, step.cdx[i], "cdx" + std::to_string(i)));
    }
    return gates.inverted(gates.joined(CellType::or_gate, terms, "cdx"));
}

/// What an order that lists the step makes 1, as late as what the order to its graph makes 0: both
/// come from the same X, and are to go through the same number of gates.
NetId forced_on_in_time(const AsynchronousBuild& build, const StepSignals& step,
                        const GateMaker& gates) {
    const auto latency = [&](const LogicBuilder::Signal& signal) {
        return signal.since_step == 0 ? 0 : build.delays.of(CellType::or_gate);  // or an X alone
    };
    const Time permit = latency(step.forced_off) + build.delays.of(CellType::inverter);
    return build.logic.delayed(step.forced_on.net, permit - latency(step.forced_on), gates);
}

void make_gates_step(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates) {
    std::vector<NetId> causes;
    for (const TransitionId into : step.into) causes.push_back(build.clearing_net(into, gates));
    if (step.cdx.empty()) {
        causes.push_back(step.x);
    } else {
        const NetId stays = not_cdx(step, gates);
        causes.push_back(gates.gate(CellType::and_gate, {stays, step.x}, "hold"));
    }
    if (step.initial && step.init != no_net) causes.push_back(step.init);

    // An input reaches the last AND through its transition condition, the AND of CAX and the OR;
    // Init and AUdur must not get there before it.
    Time latency = 0;
    for (const TransitionId into : step.into) {
        latency =
            std::max(latency, build.logic.input_latency(build.equations.clearing[into], gates));
    }
    latency += build.delays.of(CellType::and_gate) + build.delays.of(CellType::or_gate) -
               build.delays.of(CellType::inverter);
    const auto in_time = [&](NetId complement) {
        return build.logic.delayed(complement, latency, gates);
    };
    std::vector<NetId> permits;
    NetId forced_on = no_net;
    if (step.forced_off.net != no_net) {
        NetId permit = gates.inverted(step.forced_off.net);
        if (step.forced_on.net != no_net) {
            forced_on = forced_on_in_time(build, step, gates);
            permit = gates.gate(CellType::or_gate, {permit, forced_on}, "free");
        }
        permits.push_back(permit);
    }
    if (!step.initial && step.init != no_net) {
        // An order that lists the step outweighs Init.
        NetId permit = in_time(step.not_init);
        if (forced_on != no_net) {
            permit = gates.gate(CellType::or_gate, {permit, forced_on}, "free_of_init");
        }
        permits.insert(permits.begin(), permit);
    }
    if (forced_on != no_net) causes.push_back(forced_on);
    if (!step.link.empty()) {
        causes.push_back(gates.joined(CellType::and_gate, step.link, "link"));
    }
    if (step.enclosing != no_net) permits.push_back(step.enclosing);
    if (step.not_au_dur != no_net) permits.push_back(in_time(step.not_au_dur));

    if (permits.empty()) {
        gates.drive(step.x, CellType::or_gate, causes);
        return;
    }
    permits.insert(permits.begin(), gates.joined(CellType::or_gate, causes, "or"));
    gates.drive(step.x, CellType::and_gate, permits);
}

}  // namespace

Netlist make_gates(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays) {
    std::vector<CellType> path_of_set{CellType::and_gate, CellType::or_gate};
    if (equations.options.modes) path_of_set.push_back(CellType::and_gate);
    return make_asynchronous(grafcet, equations, {make_gates_step, std::move(path_of_set)}, delays);
}

}  // namespace grafwire
