// Identifiers for a chart in SFC. What the chart declares comes first and keeps its name where that
// is an identifier; an edge, a time condition or a copy is named after its expression where that is
// short (`dcy_before`, `n5s_X13`), else after its number.

#include "sfc/names.h"

#include <fmt/format.h>

#include "grafcet/grafcet.h"
#include "grafcet/write_grafcet.h"
#include "iec/identifiers.h"
#include "text/utf8.h"

namespace grafwire::sfc {

namespace {

constexpr std::size_t longest_name = 16;  // that is made of an expression

class Namer {
  public:
    explicit Namer(const Plan& plan) : plan_(plan), grafcet_(*plan.grafcet) {}

    Names make() {
        name_declared();
        name_auxiliaries();
        names_.observer = one("observe");
        names_.started = one("started");
        name_edges();
        name_times();
        for (const Variable variable : plan_.copies) {
            names_.copies[variable] = one(variable_name(grafcet_, variable) + "_then");
        }
        for (const std::size_t i : plan_.time_copies) {
            names_.time_copies[i] = one(names_.times[i] + "_then");
        }
        return std::move(names_);
    }

  private:
    std::string one(const std::string& wish) { return identifiers_.add({wish}).front(); }
    /// The expression where it is short.
    std::string text_of(ExprId id, const std::string& otherwise) const {
        std::string text = write_expression(grafcet_, grafcet_.expressions, id);
        return count_code_points(text) <= longest_name ? text : otherwise;
    }
    void name_declared();
    void name_auxiliaries();
    void name_edges();
    void name_times();

    const Plan& plan_;
    const Grafcet& grafcet_;
    iec::Identifiers identifiers_;
    Names names_;
};

void Namer::name_declared() {
    const std::vector<std::string> made = identifiers_.add(declared_names(grafcet_));
    auto next = made.begin();
    const auto take = [&](std::vector<std::string>& list, std::size_t count) {
        list.assign(next, next + static_cast<std::ptrdiff_t>(count));
        next += static_cast<std::ptrdiff_t>(count);
    };
    take(names_.inputs, grafcet_.all_input_count());
    take(names_.outputs, grafcet_.outputs.size());
    take(names_.steps, grafcet_.steps.size());
    take(names_.vars, grafcet_.vars.size());
    take(names_.counters, grafcet_.counters.size());
}

void Namer::name_auxiliaries() {
    for (const Chart::Auxiliary& auxiliary : plan_.chart.auxiliaries()) {
        const bool is_idle = auxiliary.kind == Chart::Auxiliary::Kind::idle;
        const bool is_source = auxiliary.kind == Chart::Auxiliary::Kind::source;
        names_.steps.push_back(is_idle ? one("idle_" + grafcet_.graphs[auxiliary.graph].name)
                                       : one((is_source ? "source_" : "end_") +
                                             grafcet_.transitions[auxiliary.transition].name));
    }
}

void Namer::name_edges() {
    const Expressions& pool = grafcet_.expressions;
    for (std::size_t i = 0; i < pool.edges().size(); ++i) {
        const ExprId operand = pool.operands(pool.edges()[i]).front();
        if (!plan_.edges[i] || names_.before.count(operand) > 0) continue;
        const std::string text = pool.kind(operand) == ExprKind::variable
                                     ? variable_name(grafcet_, pool.variable_of(operand))
                                     : text_of(operand, fmt::format("edge{}", i));
        names_.before[operand] = one(text + "_before");
    }
}

void Namer::name_times() {
    const Expressions& pool = grafcet_.expressions;
    const std::size_t count = pool.time_conditions().size();
    names_.times.resize(count);
    names_.timers.resize(count);
    names_.off_timers.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        if (!plan_.times[i]) continue;
        const ExprId id = pool.time_conditions()[i];
        names_.times[i] = one(text_of(id, fmt::format("time{}", i)));
        names_.timers[i] = one(fmt::format("timer{}", i));
        if (pool.time_condition_of(id).off_delay == 0) continue;
        names_.off_timers[i] = one(fmt::format("timer{}_off", i));
    }
}

}  // namespace

Names names_of(const Plan& plan) {
    return Namer(plan).make();
}

}  // namespace grafwire::sfc
