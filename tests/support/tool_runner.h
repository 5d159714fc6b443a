#pragma once

#include <string>
#include <string_view>

namespace grafwire::testing {

/// A directory of its own for the files of one test; gone at its end.
class ToolRunner {
  public:
    ToolRunner();
    ~ToolRunner();
    ToolRunner(const ToolRunner&) = delete;
    ToolRunner& operator=(const ToolRunner&) = delete;

    void write(const std::string& file, std::string_view text);
    std::string read(const std::string& file) const;

    struct Result {
        int status = 0;
        std::string output;  ///< standard output and error
    };
    /// Runs a shell command in the directory, for a minute at most. A missing program is a status
    /// other than 0, so that the test fails.
    Result run(const std::string& command) const;

  private:
    std::string directory_;
};

}  // namespace grafwire::testing
