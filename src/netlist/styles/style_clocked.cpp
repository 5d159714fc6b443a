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

#include <fmt/format.h>

#include <cstdlib>

#include "equations/equation_text.h"
#include "netlist/styles/asynchronous.h"
#include "netlist/styles/clocked_build.h"

namespace grafwire {

void ClockedBuild::make_ports() {
    const std::size_t controls = grafcet_.inputs.size();
    for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
        if (i >= controls && !equations_.options.modes) {
            inputs_.push_back(no_net);
            continue;
        }
        const std::string name(input_name(grafcet_, i));
        inputs_.push_back(builder_.add_port_net(name));
        builder_.add_input(name, inputs_.back());
    }
    clock_ = builder_.add_port_net("clk");
    builder_.add_input("clk", clock_);
    if (inputs_[controls] != no_net) {
        not_init_ = builder_.inverted(inputs_[controls]);
        not_au_dur_ = builder_.inverted(inputs_[controls + 1]);
    }
    for (const Step& step : grafcet_.steps) {
        const std::string name = "X" + step.name;
        now_.steps.push_back(builder_.add_port_net(name));
        builder_.add_output(name, now_.steps.back());
    }
    for (const Output& output : grafcet_.outputs) {
        now_.outputs.push_back(builder_.add_port_net(output.name));
        builder_.add_output(output.name, now_.outputs.back());
    }
    for (const Var& var : grafcet_.vars) {
        now_.vars.push_back(builder_.add_port_net(var.name));
        builder_.add_var({var.name, {now_.vars.back()}, 0});
    }
    make_counters();
    for (std::size_t i = 0; i < pool_.time_conditions().size(); ++i) {
        times_.push_back(builder_.add_net("timer", std::to_string(i)));
    }
    for (const Step& step : grafcet_.steps) {
        writing_.steps.push_back(builder_.add_net("X" + step.name, "next"));
    }
    writing_.outputs = now_.outputs;
    writing_.vars = now_.vars;
    writing_.counters = now_.counters;
    after_ = writing_;
    after_.is_after = true;
}

/// A register holds how far its counter stands above the low end.
void ClockedBuild::make_counters() {
    for (const Counter& counter : grafcet_.counters) {
        std::size_t width = 0;
        while ((counter.high - counter.low) >> width != 0) ++width;
        Observed observed{counter.name, {}, counter.low};
        for (std::size_t bit = 0; bit < width; ++bit) {
            observed.bits.push_back(builder_.add_net(counter.name, "q" + std::to_string(bit)));
        }
        Word position = observed.bits;
        position.push_back(builder_.low());
        Arithmetic arithmetic(builder_, counter.name + "$value");
        const Sum offset{{counter.low < 0, SumTerm::no_counter, std::abs(counter.low)},
                         {false, 0, 0}};
        now_.counters.push_back(arithmetic.sum(offset, {position}));
        builder_.add_counter(std::move(observed));
    }
}

/// Continuous outputs read everything as the flip-flops hold it once the scan is over.
void ClockedBuild::make_outputs() {
    for (const OutputEquation& equation : equations_.outputs) {
        const Output& output = grafcet_.outputs[equation.output];
        work_on(output.name, builder_.add_origin(Origin::Kind::output, output.name, output.where),
                fmt::format("{} = {}", output.name, equation_text(equations_, equation.value)));
        role_ = 0;
        const NetId source = net(now_, equation.value);
        builder_.add_cell(CellType::buffer, now_.outputs[index_of(equation.output)], {&source, 1});
    }
}

Netlist make_clocked(Equations& equations) {
    return ClockedBuild(equations).make();
}

}  // namespace grafwire
