#pragma once

#include "text/message.h"

namespace grafwire {

/// Why the system has refused something, by the number of its error (errno).
Localized reason_of(int error);

}  // namespace grafwire
