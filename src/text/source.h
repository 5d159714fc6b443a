#pragma once

#include <cstdint>
#include <string>

namespace grafwire {

/// The text of one input, with the name to show in messages ("-" is shown as "<stdin>").
struct SourceFile {
    std::string name;
    std::string text;
};

/// A place in a source file. Lines and columns count from 1; columns count characters (Unicode code
/// points), not bytes. Line 0 stands for "no particular place".
///
/// Forms made from a text (a GRAFCET, a netlist, a listing) keep the places of their parts, so that
/// what is found out much later can still be shown where it stands.
struct Location {
    std::uint32_t line = 0;
    std::uint32_t column = 0;

    bool is_known() const { return line != 0; }
};

}  // namespace grafwire
