#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "text/source.h"

namespace grafwire::playground {

/// A part of a text as an editor in a browser counts it: in units of UTF-16.
struct Span {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
};

/// Finds what stands at the places of a chart that messages and declarations have.
class Places {
  public:
    explicit Places(std::string_view text);

    /// The token that begins there; where none does the character, and empty without a place.
    Span at(Location where) const;

  private:
    struct Token {
        std::size_t begin = 0;
        std::size_t end = 0;
        Location where;
    };
    std::size_t byte_of(Location where) const;

    std::string_view text_;
    std::vector<std::size_t> lines_;    ///< where they begin
    std::vector<std::uint32_t> utf16_;  ///< by byte: the units before it
    std::vector<Token> tokens_;         ///< in the order of the text
};

}  // namespace grafwire::playground
