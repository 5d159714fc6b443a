#pragma once

#include <string>

#include "draw/scene.h"
#include "text/message.h"

namespace grafwire {

/// A sheet in words, for those who hear a picture and do not see it: what is written above it, then
/// the names of its steps and transitions, of its modules or of its signals, each once.
std::string describe_sheet(const Sheet& sheet, Language language);

}  // namespace grafwire
