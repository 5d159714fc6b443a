#pragma once

#include <string>

namespace grafwire::testing {

/// The sequential function chart of a PLCopen project as text (IEC 61131-3, tables 54 to 61), made
/// as the editor Beremiz does for its compiler. Throws a PlcError for what that editor fails on:
///
/// - A step or jump hangs on a transition, a convergence of transitions or the bar below a
///   transition; a transition hangs on a step, a divergence below one step or the bar of joined
///   steps. No two bars touch.
/// - Text begins at the initial steps, in the order of the file; what none of them leads to is left
///   out. Actions stand below their step, transitions below that, then the steps they lead to.
std::string sfc_as_text(const std::string& xml);

/// The first flag `X5.X` in such a text that stands above its step or has none; empty where there
/// is none. Compilers know a step only below its declaration.
std::string undeclared_step_in(const std::string& sfc_text);

}  // namespace grafwire::testing
