#pragma once

#include <cstdint>

namespace grafwire {

/// A place in a source file. Lines and columns count from 1; columns count characters (Unicode code
/// points), not bytes. Line 0 stands for "no particular place".
struct Location {
    std::uint32_t line = 0;
    std::uint32_t column = 0;

    bool is_known() const { return line != 0; }
};

}  // namespace grafwire
