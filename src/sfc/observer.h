#pragma once

#include <string>

#include "sfc/structured_text.h"
#include "text/message.h"

namespace grafwire::sfc {

/// The statements of the step `observe`, to be executed after all other actions of a scan; empty
/// where there is nothing to observe. Comments are in the language.
std::string observer_text(const Plan& plan, const Names& names, Language language);

}  // namespace grafwire::sfc
