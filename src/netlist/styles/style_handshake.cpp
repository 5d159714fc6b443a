// NAND gates that answer each other: right whatever the delays of the gates are, as long as they
// are finite and every signal reaches all gates that it is wired to at the same time.
//
// The step modules of the course race: a step is set by a product of its predecessor, which is
// reset by the step, and whichever path is slow decides whether the token arrives once, twice or
// not at all. Here each change waits for the one before it. A transition from p to f takes four
// firings:
//
//     T   = NAND(X_p, receptivity, G_p)   falls: the token is given
//     X_f = NAND(T, B_f)                  rises, as T is 0
//     B_f = NAND(X_f, B_g)                falls, as X_f is 1: f holds by itself
//     B_p = NAND(X_p, B_f)                rises, as B_f is 0; then X_p falls, and T rises again
//
// and the next transition, out of f, must not begin before T has risen: its own product takes T in.
// That is G_f, "the arrival in f is complete". A step in a sequence has three gates, where the
// module of the course has four.
//
// The shapes, with G and H ("the step has gone": what a reader of /X waits for) as lists of inputs:
//
//     one follower   B_f resets p;  G_f = T;  H_p = T
//     divergence     a chain: T sets f1, U_j = NAND(X_p, X_f(j-1), T or U before, B_fj unless last)
//                    sets f_j, B_fm resets p;  T takes B_f1;  G_fm = U_m, G_fj = U_m, B_p;
//                    H_p = U_m
//     convergence    B_h resets p1, R_i = NAND(X_h, T, X_pi) resets p_i;  G_h = T, R_i, B_pi;
//                    H_p1 = T, H_pi = R_i
//     sink           T resets p;  H_p = T
//     merge          from a hidden step d into f, which may be active: A = NAND(X_d, G_d, B_f) sets
//                    f, S = NAND(X_d, G_d, X_f, A) resets d;  G_f = B_d, S, A;  H_d = S
//
// A receptivity has one T per product. It reads a step as X, G, its absence as B, H; an input that
// is read both ways as itself and, behind its inverter, once more. Hidden steps keep every circle
// at three steps or more (handover_chart.cpp).
//
//     Init, AUdur    into every T and U, into X of what starts, into B of the others
//     freezing       B_s, H_s of the freezing step into every T of the graph
//     forcing        B_s, H_s into every T and U of the graph; B_s into X of what is forced on,
//                    into B of the others. Where s may be left as soon as it is entered, it waits
//                    until all is done: Q_m = NAND(X_s, G_s, X_m) resets a step m instead; V_n =
//                    NAND(X_s, G_s, B_n, B_m, Q_m of all m) sets a step n once those are off; who
//                    leaves or reads s waits for all of that
//     time t/X_n     the timer takes the place of X_n in the T of an exit of n, so that T stays 0
//                    until the timer has fallen; read elsewhere, together with its operand
//     stored actions each transition that writes stops in a hidden step w: A = NAND(X_w, G_w, the
//                    gate of the variable that is still 1) turns the variable over; w is left once
//                    that is done (handshake_writes.cpp)
//     enclosing      the links are further followers of what leads to s; X_s into every T and U of
//                    the graph, and into B of its steps, which empties it
//
// What it does not do: two transitions that can be cleared at once are cleared in either order, as
// no clock keeps them in step. So the netlist is right for charts in which that makes no
// difference; a step that is active for a moment only, read by another graph, is the usual case in
// which it does.
//
// The module was found, and is held in the tests, by exploring all orders in which the gates can
// fire, from every stable situation (tests/delays). It belongs to the family of D. E. Muller's
// speed-independent circuits: "A theory of asynchronous circuits" (Muller and Bartky, 1959). A
// one-hot wiring that stands any delay of the *wires* as well does not exist.

#include "netlist/styles/handover_chart.h"
#include "netlist/styles/handover_gates.h"
#include "netlist/styles/handshake_facts.h"
#include "netlist/styles/handshake_limits.h"
#include "netlist/styles/styles.h"

namespace grafwire {

void refuse_handshake(const Grafcet& grafcet, const Equations& equations,
                      Diagnostics& diagnostics) {
    const HandshakeFacts facts = read_for_handshake(grafcet, equations, diagnostics);
    if (!diagnostics.has_errors()) refuse_constructs(facts, diagnostics);
    if (!diagnostics.has_errors()) handover_chart(facts, diagnostics);
}

Netlist make_handshake(const Grafcet& grafcet, const Equations& equations,
                       const DelayModel& /*delays*/) {
    Diagnostics none_left;
    const HandshakeFacts facts = read_for_handshake(grafcet, equations, none_left);
    return handover_netlist(grafcet, equations, handover_chart(facts, none_left));
}

}  // namespace grafwire
