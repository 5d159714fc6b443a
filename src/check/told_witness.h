#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grafwire {

/// A witness as the reports tell it.
struct ToldWitness {
    std::string text;   ///< for people, in their language, of a length to be read
    std::string cause;  ///< the identifier of a known cause (`two-step-loop`), or empty
    std::vector<std::string> story;  ///< for programs: all of it, in English, line by line
    /// What memories hold at power-up, by the names of their nets, where the difference needs it.
    std::vector<std::pair<std::string, bool>> power_up;
};

/// The lines of a text, without their ends.
std::vector<std::string> lines_of(std::string_view text);

}  // namespace grafwire
