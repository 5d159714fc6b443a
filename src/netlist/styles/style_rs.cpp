// The RS latch of two NAND gates as the course "Mise en œuvre du GRAFCET" draws it (section 2.2.1):
// CAX wired to SET, CDX to RESET, and nothing else.
//
//     X  = NAND(s1, s2, …, Q)       s: one NAND per transition into the step, 0 while it is cleared
//     Q  = NAND(r1, r2, …, X)       r: one NAND per term of CDX, 0 while it holds
//
// Set wins for as long as S = R = 1, as rule 5 demands. But Q is 1 then as well, so that whichever
// of S and R ends last decides, and which one that is the delays say: the style `nand` blocks the
// reset for that reason. This one is kept to show, and check, what the course has on paper.

#include "netlist/styles/nand_latch.h"
#include "netlist/styles/styles.h"

namespace grafwire {

namespace {

void make_rs_step(AsynchronousBuild& build, const StepSignals& step, const GateMaker& gates) {
    make_nand_latch(build, step, gates, ResetWhileSet::open);
}

}  // namespace

Netlist make_rs(const Grafcet& grafcet, const Equations& equations, const DelayModel& delays) {
    return make_asynchronous(grafcet, equations,
                             {make_rs_step, {CellType::nand_gate, CellType::nand_gate}}, delays);
}

}  // namespace grafwire
