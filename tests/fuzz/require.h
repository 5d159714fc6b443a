#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace grafwire {

/// Ends the program, which a fuzzer takes for a find, where something that must hold does not.
inline void require(bool condition, const char* what, const std::string& text) {
    if (condition) return;
    std::fprintf(stderr, "%s\n%s\n", what, text.c_str());
    std::abort();
}

}  // namespace grafwire
