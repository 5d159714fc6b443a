#pragma once

#include <string>
#include <vector>

namespace grafwire::testing {

/// Runs a compiler; throws a std::runtime_error with what it says where it fails or says anything.
void compile(const std::vector<std::string>& command);

/// Runs a program once per text of scans and gives what it writes; throws a std::runtime_error
/// where it fails or complains.
std::vector<std::string> run_on(const std::vector<std::string>& command,
                                const std::vector<std::string>& scans);

}  // namespace grafwire::testing
