#pragma once

#include <string>
#include <vector>

#include "sfc/structured_text.h"
#include "text/message.h"

namespace grafwire::sfc {

/// One action of an action block: a qualifier, a duration (of L and D), and either the name of a
/// bit or statements.
struct ActionBlockEntry {
    std::string qualifier;
    std::string duration;
    std::string reference;
    std::string statements;
};

/// The actions of a step, as far as SFC can express them.
std::vector<ActionBlockEntry> actions_of(const Plan& plan, const Names& names, StepId step);

/// What the step `observe` assigns for a step, a line each: `lamp if v: assigned by observe`.
std::string notes_of(const Plan& plan, const Names& names, StepId step, Language language);

/// The statements of the step `observe`, to be executed after all other actions of a scan; empty
/// where there is nothing to observe. Comments are in the language.
std::string observer_text(const Plan& plan, const Names& names, Language language);

}  // namespace grafwire::sfc
