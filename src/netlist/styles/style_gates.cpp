// The phase module of AND, OR and NOT gates of the course "Mise en œuvre du GRAFCET", section 2.1:
//
//     X = CAX + /CDX . X
//
// four gates for a step with one transition before and one after it: AND (CAX), NOT and AND (the
// feedback), OR. With modes a last AND takes in /Init and /AUdur. Forcing is one more input to the
// OR (the step is listed) and one more to the last AND (the graph is forced, unless the step is
// listed), which is Ts./Tf0 + Tf1 and keeps every module equally deep.

#include <algorithm>

#include "netlist/styles/asynchronous.h"

namespace grafwire {

namespace {

/// /CDX, as one net.
NetId not_cdx(AsynchronousBuild& build, const PhaseSignals& phase, std::string_view name) {
    ChartNetlist& builder = build.builder;
    std::vector<NetId> terms;
    for (std::size_t i = 0; i < phase.cdx.size(); ++i) {
        terms.push_back(phase.cdx[i].size() == 1 ? phase.cdx[i][0]
                                                 : builder.gate(CellType::and_gate, phase.cdx[i],
                                                                name, "cdx" + std::to_string(i)));
    }
    if (terms.size() == 1) return builder.inverted(terms[0]);
    return builder.inverted(builder.gate(CellType::or_gate, terms, name, "cdx"));
}

/// What must be 1 for a step not to be forced off: /forced_off, or the step is listed by an order.
/// Both sides of the OR come from the same X through the same number of gates.
NetId may_stay(AsynchronousBuild& build, const PhaseSignals& phase, std::string_view name,
               NetId& forced_on) {
    ChartNetlist& builder = build.builder;
    const NetId not_off = builder.inverted(phase.forced_off);
    if (phase.forced_on == no_net) return not_off;
    // The nets of the X variables are numbered without a gap.
    const auto is_step = [&](NetId net) {
        return net >= build.logic.steps.front() && net <= build.logic.steps.back();
    };
    const unsigned off_depth = is_step(phase.forced_off) ? 0 : 1;
    const unsigned on_depth = is_step(phase.forced_on) ? 0 : 1;
    forced_on = builder.delayed(phase.forced_on, off_depth + 1 - on_depth);
    const NetId pins[] = {not_off, forced_on};
    return builder.gate(CellType::or_gate, pins, name, "free");
}

}  // namespace

void make_gates_phase(AsynchronousBuild& build, const PhaseSignals& phase) {
    ChartNetlist& builder = build.builder;
    const std::string name(build.step_name(phase.x));
    std::vector<NetId> causes;
    for (const TransitionId into : phase.into) causes.push_back(build.clearing_net(into));
    if (phase.cdx.empty()) {
        causes.push_back(phase.x);
    } else {
        const NetId pins[] = {not_cdx(build, phase, name), phase.x};
        causes.push_back(builder.gate(CellType::and_gate, pins, name, "hold"));
    }
    if (phase.initial && phase.init != no_net) causes.push_back(phase.init);

    // An input reaches the last AND through its receptivity, the AND of CAX and the OR; Init and
    // AUdur must not get there before it.
    unsigned latency = 0;
    for (const TransitionId into : phase.into) {
        latency = std::max(latency, build.logic.input_latency(build.equations.clearing[into]));
    }
    const auto in_time = [&](NetId complement) { return builder.delayed(complement, latency + 1); };
    std::vector<NetId> permits;
    NetId forced_on = no_net;
    if (phase.forced_off != no_net) permits.push_back(may_stay(build, phase, name, forced_on));
    if (!phase.initial && phase.init != no_net) {
        // An order that lists the step outweighs Init.
        NetId permit = in_time(phase.not_init);
        if (forced_on != no_net) {
            const NetId pins[] = {permit, forced_on};
            permit = builder.gate(CellType::or_gate, pins, name, "free_of_init");
        }
        permits.insert(permits.begin(), permit);
    }
    if (forced_on != no_net) causes.push_back(forced_on);
    if (!phase.link.empty()) {
        causes.push_back(phase.link.size() == 1
                             ? phase.link[0]
                             : builder.gate(CellType::and_gate, phase.link, name, "link"));
    }
    if (phase.enclosing != no_net) permits.push_back(phase.enclosing);
    if (phase.not_au_dur != no_net) permits.push_back(in_time(phase.not_au_dur));

    if (permits.empty()) {
        builder.drive(phase.x, CellType::or_gate, causes);
        return;
    }
    permits.insert(permits.begin(), causes.size() == 1
                                        ? causes[0]
                                        : builder.gate(CellType::or_gate, causes, name, "or"));
    builder.drive(phase.x, CellType::and_gate, permits);
}

}  // namespace grafwire
