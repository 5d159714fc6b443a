#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace grafwire::testing {

/// Whether the tests are to write their reviewed files anew instead of comparing with them:
/// `tools/bless --tables`.
inline bool renews_reviewed_files() {
    return std::getenv("GRAFWIRE_RENEW") != nullptr;
}

/// The lines of a file that says what a test expects and that a person has reviewed, `name` below
/// tests/.
inline std::vector<std::string> reviewed_lines(const std::string& name) {
    std::ifstream file(std::string(GRAFWIRE_ROOT) + "/tests/" + name, std::ios::binary);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

/// Compares a table with the one in the reviewed file, line by line, or renews it.
inline void check_reviewed(const std::string& name, const std::string& table) {
    if (renews_reviewed_files()) {
        std::ofstream(std::string(GRAFWIRE_ROOT) + "/tests/" + name, std::ios::binary) << table;
        return;
    }
    const std::vector<std::string> expected = reviewed_lines(name);
    std::istringstream text(table);
    std::size_t count = 0;
    for (std::string line; std::getline(text, line); ++count) {
        REQUIRE_MESSAGE(count < expected.size(), name << " has no line for: " << line);
        CHECK_MESSAGE(line == expected[count], name << ", line " << count + 1);
    }
    CHECK_MESSAGE(count == expected.size(), name << " has more lines than there should be");
}

}  // namespace grafwire::testing
