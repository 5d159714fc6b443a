#pragma once

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace grafwire::testing {

/// The contents of a file of tests/formats/golden.
inline std::string golden(const std::string& file) {
    std::ifstream in(std::string(GRAFWIRE_ROOT) + "/tests/formats/golden/" + file,
                     std::ios::binary);
    REQUIRE(in.good());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace grafwire::testing
