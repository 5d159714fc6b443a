#pragma once

#include <doctest/doctest.h>

#include <string>

#include "random/read_text.h"

namespace grafwire::testing {

/// Two graphs of three steps each, 1 to 3 and 11 to 13, with these transitions and inputs a and b.
inline std::string two_graphs(const std::string& first, const std::string& second) {
    return "input a, b\ngraph G {\ninitial 1\nstep 2\nstep 3\n" + first +
           "\n}\ngraph H {\ninitial 11\nstep 12\nstep 13\n" + second + "\n}\n";
}

/// The GRAFCET of a text without errors; the test fails otherwise.
inline Grafcet chart_of(const std::string& text) {
    std::string messages;
    std::optional<Grafcet> grafcet = read_grafcet(text, &messages);
    if (!grafcet) FAIL(messages);
    return std::move(*grafcet);
}

}  // namespace grafwire::testing
