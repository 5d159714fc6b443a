// The set-priority latch of NAND gates, which the course "Mise en œuvre du GRAFCET" (section 2.2)
// retains for GRAFCET: S = R = 1 gives 1, as rule 5 demands.
//
//     X  = NAND(s1, s2, …, Q)       s: one NAND per transition into the step, 0 while it is cleared
//     Q  = NAND(r1, r2, …, X)       r: one NAND per term of CDX, 0 while it holds
//
// Every r also takes in all s: the reset is blocked while the latch is being set. Without that (see
// style_rs.cpp) the two halves of the latch would both be 1 while S = R = 1, and race when S and R
// end together (in a loop of two steps one X is at once what sets and what resets). A step with one
// transition before and one after it takes four NAND gates.

#include "netlist/styles/nand_latch.h"
#include "netlist/styles/styles.h"

namespace grafwire {

namespace {

void make_nand_step(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates) {
    make_nand_latch(build, step, gates, ResetWhileSet::blocked);
}

}  // namespace

Netlist make_nand(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays) {
    return make_asynchronous(grafcet, equations,
                             {make_nand_step, {CellType::nand_gate, CellType::nand_gate}}, delays);
}

}  // namespace grafwire
