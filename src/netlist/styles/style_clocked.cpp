// The clocked style: one scan of the table method per clock cycle, in gates.
//
// X7 is the output of a flip-flop and stands for Ts at the start of a scan; `X7$next` is Ts at its
// end. In between the nets follow the scan: clearing of the transitions (Ta, Td), Ts = Tp./Td + Ta,
// forcing, enclosures, AUdur. Stored actions compare X7 with X7$next; their right-hand sides read
// steps as they are at the end of the scan and variables as they were, as the reference does, so
// every expression is built for the view in which it is read:
//
//     now      receptivities and edges: everything as the flip-flops hold it
//     writing  right-hand sides and events of stored actions: next steps, variables as held
//     after    operands of time conditions: next steps, next variables
//
// An edge is a flip-flop that remembers its operand and a gate; in the very first scan there are
// none, because a memory holds the present value at the start. The freeze bits are flip-flops that
// start at 1. A time condition is a clocked timer; where it stands in another one, that reads it as
// it will be after this scan, from a cell that looks ahead. All flip-flops have initial values, as
// those of an FPGA have.

#include <cstdlib>

#include "netlist/styles/clocked.h"
#include "netlist/styles/styles.h"

namespace grafwire {

ClockedBuild::ClockedBuild(const Grafcet& chart_of, const Equations& equations_of)
    : grafcet(chart_of), equations(equations_of), chart(grafcet), pool_(equations.expressions) {
    add_ports();
}

void ClockedBuild::add_ports() {
    NetlistBuilder& builder = chart.builder();
    inputs_ = chart.add_inputs(equations.options.modes);
    clock = builder.add_net("clk");
    builder.add_input("clk", clock);
    init = inputs_[grafcet.inputs.size()];
    if (init != no_net) {
        not_init = chart.at_inputs().inverted(init);
        not_au_dur = chart.at_inputs().inverted(inputs_[grafcet.inputs.size() + 1]);
    }
    now.steps = chart.add_steps();
    now.outputs = chart.add_outputs();
    now.vars = chart.add_vars();
    add_counters();
    for (std::size_t i = 0; i < pool_.time_conditions().size(); ++i) {
        times_.push_back(builder.add_inner_net("timer", std::to_string(i)));
    }
    writing = now;
    for (NetId& step : writing.steps) step = builder.add_inner_net(step, "next");
    after = writing;
    after.is_after = true;
}

/// A register holds how far its counter stands above the low end.
void ClockedBuild::add_counters() {
    for (const Counter& counter : grafcet.counters) {
        std::size_t width = 0;
        while ((counter.high - counter.low) >> width != 0) ++width;
        const GateMaker gates = chart.at_inputs().named(counter.name);
        Observed observed{counter.name, {}, counter.low};
        for (std::size_t bit = 0; bit < width; ++bit) {
            observed.bits.push_back(gates.add_net("q" + std::to_string(bit)));
        }
        Word position = observed.bits;
        position.push_back(gates.low());
        Arithmetic arithmetic(gates.named(counter.name + "$value"));
        const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)},
                         {false, 0, 0}};
        now.counters.push_back(arithmetic.sum(offset, {position}));
        chart.builder().add_counter(std::move(observed));
    }
}

namespace {

/// Continuous outputs read everything as the flip-flops hold it once the scan is over.
void make_outputs(ClockedBuild& build) {
    for (const OutputEquation& equation : build.equations.outputs) {
        NumberedGates at = build.add_module(build.grafcet.outputs[equation.output].name,
                                            build.chart.origin_of(equation.output));
        const NetId source = build.net(build.now, equation.value, at);
        at.gates.add_cell(CellType::buffer, build.now.outputs[index_of(equation.output)],
                          {&source, 1});
    }
}

}  // namespace

Netlist make_clocked(const Grafcet& grafcet, const Equations& equations, const DelayModel&) {
    ClockedBuild build(grafcet, equations);
    build.make_edges();
    make_evolution(build);
    make_registers(build);
    build.make_time_conditions();
    make_outputs(build);
    return build.chart.finish(equations.options.modes, build.clock);
}

}  // namespace grafwire
