#pragma once

#include <string>
#include <vector>

namespace grafwire::testing {

/// The text of a file; one that cannot be read is a test failure.
std::string text_of(const std::string& path);

/// The path of a file of examples/, as `example("press.stim")`, and its text.
std::string example(const std::string& name);
std::string example_text(const std::string& name);

/// The names of all examples, in order.
std::vector<std::string> example_names();

}  // namespace grafwire::testing
