// One check: what is compared (a netlist made or read, a listing, a ladder diagram) is read or
// made, and compared within the bounds of the request.

#include "command/judge.h"

#include <new>
#include <stdexcept>

#include "command/messages.h"
#include "command/option_uses.h"
#include "command/standard_error.h"
#include "text/utf8.h"
#include "workflow/orders.h"

namespace grafwire {

namespace say = messages::command;

CheckArguments CheckArguments::of_one(const std::string& chart, const std::string& style) const {
    CheckArguments one = *this;
    one.path = chart;
    one.netlist.style = style;
    return one;
}

unsigned facts_of(const CheckArguments& request) {
    if (request.against.empty()) {
        return fact::generated | (request.netlist.is_handshake() ? fact::handshake : fact::none) |
               (request.netlist.options().style == Style::clocked ? fact::clocked
                                                                  : fact::asynchronous);
    }
    const std::optional<Against> against = against_of(request.against);
    if (against == Against::listing) return fact::listing;
    if (against == Against::ladder) return fact::ladder;
    return fact::elsewhere | fact::open_start | fact::asynchronous | fact::clocked;
}

namespace {

/// What is known of a netlist from elsewhere once it is there.
unsigned facts_of(const Chart& chart, const Netlist& netlist) {
    unsigned facts = fact::elsewhere;
    facts |= netlist.is_clocked() ? fact::clocked : fact::asynchronous;
    if (power_up_of(chart, netlist, true) != PowerUp::init) facts |= fact::open_start;
    return facts;
}

}  // namespace

CheckSubject subject_of(const CheckArguments& request) {
    CheckSubject subject;
    subject.file = request.path;
    subject.against = request.against;
    if (request.against.empty()) {
        subject.style = request.netlist.style;
        subject.cdx = name_of(cdx_form(request.netlist.options()));
    }
    subject.delays = request.netlist.delays();
    subject.name = request.against.empty() ? subject.style + " " + subject.cdx : request.against;
    if (request.netlist.interlock && request.netlist.is_handshake()) subject.name += " interlock";
    for (const std::string* asked : {&request.changes, &request.power_up, &request.scan}) {
        if (!asked->empty()) subject.name += " " + *asked;
    }
    return subject;
}

std::optional<CheckValues> values_of(const CheckArguments& request) {
    CheckValues values;
    if (!request.max_memory.empty()) {
        const auto bytes = parse_memory(request.max_memory);
        if (!bytes) return std::nullopt;
        values.max_memory = *bytes;
    }
    const Period period = parse_period(request.scan);
    if (period.is_wrong) return std::nullopt;
    values.period = period.value;
    return values;
}

namespace {

/// Runs a check within its bounds, and shows what it has to say.
template <typename Check>
std::optional<Judgement> within_bounds(const Session& session, const Check& check) {
    const CheckArguments& request = session.request;
    CheckRequest asked;
    asked.subject = subject_of(request);
    asked.subject.orders = session.orders;
    asked.changes = request.changes == "many" ? Changes::many : Changes::one;
    asked.period = session.values.period;
    asked.max_cases = request.max_cases;
    asked.workers = session.workers;
    asked.language = session.line.language();
    asked.with_files = !request.witness.empty();
    asked.looks_for_pulses = request.pulses;
    Diagnostics messages;
    CheckBounds bounds(request.max_seconds, session.values.max_memory);
    asked.progress = [&session](const Coverage& coverage) {
        session.progress.show(coverage, session.name);
    };
    asked.keep_going = [&bounds] { return bounds.goes_on(); };
    auto judgement = check(asked, messages);
    show_messages(messages);
    return judgement;
}

/// A netlist from elsewhere, if its ports allow a comparison.
std::optional<Netlist> load_fitting_netlist(const Session& session) {
    const CheckArguments& request = session.request;
    auto netlist = load_netlist(request.against);
    if (!netlist) return std::nullopt;
    const PortComparison ports =
        fit_netlist(session.chart, *netlist, request.power_up == "initial");
    if (!ports.fits()) {
        show(say::ports_do_not_fit(visible(request.against), visible(request.path),
                                   port_table(ports)));
    }
    if (!ports.can_compare()) return std::nullopt;
    if (refuse_idle_options(session.line, "check", facts_of(session.chart, *netlist))) {
        return std::nullopt;
    }
    return netlist;
}

/// What is compared under other delays: the netlist that is made for them, or the one from
/// elsewhere as it is.
NetlistFor netlist_by_delays(const Session& session, const Netlist& netlist) {
    if (!session.request.against.empty()) {
        return [&netlist](const DelayModel&) { return std::optional(netlist); };
    }
    return [&session](const DelayModel& delays) {
        NetlistOptions options = session.request.netlist.options();
        options.delays = delays;
        Diagnostics said_before;
        return make_netlist(session.chart, options, said_before);
    };
}

/// A netlist that is made of the GRAFCET, or one from elsewhere. Where it matters in which order
/// transitions clear, that is looked at; with interlocks, the chart is another one.
Judged judge_netlist(const Session& session) {
    const NetlistRequest& request = session.request.netlist;
    const bool is_made = session.request.against.empty();
    const bool order_matters = is_made && request.is_handshake();
    const auto orders = [&] { return find_orders(session.chart, request.options().modes); };
    std::optional<OrderFindings> findings;
    std::optional<Chart> interlocked;
    if (order_matters && request.interlock) {
        findings = orders();
        interlocked = interlocked_chart(session.chart, *findings);
    }
    const Chart& chart = interlocked ? *interlocked : session.chart;
    const auto netlist = is_made ? make_netlist(chart, request) : load_fitting_netlist(session);
    if (!netlist) return {std::nullopt, is_made};
    if (order_matters && !findings) findings = orders();
    std::optional<OrderRemarks> remarks;
    if (findings) remarks = order_remarks(session.chart, *findings, request.interlock);
    const Session whole{session.request, session.line,     chart,        session.values,
                        session.workers, session.progress, session.name, std::move(remarks)};
    return {within_bounds(whole, [&](CheckRequest asked, Diagnostics& messages) {
        if (session.request.tolerance) asked.tolerance_of = netlist_by_delays(whole, *netlist);
        return check_netlist(chart, *netlist, asked, messages);
    })};
}

/// An S7-200 listing. Its addresses say nothing by themselves, so a table of assignment is needed.
std::optional<Judgement> judge_listing(const Session& session) {
    const CheckArguments& request = session.request;
    if (request.io.empty()) {
        complain(say::listing_needs_io(request.against));
        return std::nullopt;
    }
    const auto io = load_assignment(request.io);
    if (!io) return std::nullopt;
    const s7::Cpu cpu = cpu_of_number(request.cpu).value_or(s7::Cpu::cpu_214);
    const auto listing = load_listing(request.against, cpu, &io->assignment);
    if (!listing) return std::nullopt;
    Diagnostics diagnostics;
    const auto binding = s7::bind(session.chart.grafcet, io->assignment, diagnostics);
    show_diagnostics(diagnostics, io->source);
    if (!binding) return std::nullopt;
    return within_bounds(session, [&](const CheckRequest& asked, Diagnostics& messages) {
        return check_listing(session.chart, *listing, cpu, *binding, asked, messages);
    });
}

/// A ladder diagram, whose variables have the names of the GRAFCET.
std::optional<Judgement> judge_ladder(const Session& session) {
    const CheckArguments& request = session.request;
    Diagnostics diagnostics;
    const SourceFile source = read_source(request.against, diagnostics);
    std::optional<ladder::Ladder> ladder;
    if (!diagnostics.has_errors()) ladder = read_ladder(source, request.program, diagnostics);
    show_diagnostics(diagnostics, source);
    if (!ladder) return std::nullopt;
    return within_bounds(session, [&](const CheckRequest& asked, Diagnostics& messages) {
        return check_ladder(session.chart, *ladder, asked, messages);
    });
}

/// One of these.
Judged judge_any(const Session& session) {
    const unsigned facts = facts_of(session.request);
    if ((facts & fact::listing) != 0) return {judge_listing(session)};
    if ((facts & fact::ladder) != 0) return {judge_ladder(session)};
    return judge_netlist(session);
}

}  // namespace

/// What the check held is free again where it is told that there was not enough.
Judged judge(const Session& session) {
    try {
        return judge_any(session);
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {  // more than any memory could hold
    }
    complain(say::check_takes_too_much_memory());
    return {};
}

std::optional<Chart> load_plant(const CheckArguments& request, const ChartFile& file,
                                const CommandLine& line) {
    auto chart = load_chart(file, line);
    if (!chart) return std::nullopt;
    bool is_good = true;
    for (const std::string& text : request.assumptions) {
        Diagnostics diagnostics;
        const SourceFile source{"--assume", text};
        is_good = add_assumption(source, *chart, diagnostics) && is_good;
        show_diagnostics(diagnostics, source);
    }
    if (!is_good) return std::nullopt;
    return chart;
}

}  // namespace grafwire
