#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/language.h"

namespace grafwire {

/// A known reason why wiring departs from its GRAFCET although its equations are right.
enum class CauseKind {
    two_step_loop,      ///< two steps follow each other, and CDX has the successor form
    two_tokens,         ///< a step is reset by a second token in front of it, in the successor form
    long_pulse,         ///< the pulse of an edge clears two transitions, one after the other
    fleeting_follower,  ///< what should reset a step goes on before the step has been set
    reset_priority,     ///< deactivation wins over activation
    set_and_reset,      ///< a memory of gates is set and reset at once, and both end together
    input_race,         ///< inputs that change together are read together
};

struct Cause {
    CauseKind kind = CauseKind::two_step_loop;
    std::string step;  ///< `X1`: the step that goes wrong; of input_race empty
    /// two_step_loop, two_tokens, fleeting_follower: the X that reset it; long_pulse: the edge;
    /// input_race: the inputs
    std::vector<std::string> others;
    std::vector<std::string> transitions;  ///< long_pulse: the two; two_tokens: the one not cleared
};

/// A name that does not change, for programs: `two-step-loop`.
std::string_view identifier_of(CauseKind kind);

/// What happens, as a sentence.
std::string cause_text(const Cause& cause, Language language);

/// What helps, as a sentence.
std::string remedy_text(const Cause& cause, Language language);

}  // namespace grafwire
