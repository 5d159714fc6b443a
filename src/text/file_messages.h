#pragma once

#include <vector>

#include "text/diagnostics.h"
#include "text/source.h"

namespace grafwire {

/// Messages about a text, with it; about none, where it has no name.
struct FileMessages {
    SourceFile source;
    std::vector<Diagnostic> messages;
};

}  // namespace grafwire
