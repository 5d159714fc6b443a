#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/files.h"

namespace grafwire::testing {

/// What a program left behind.
struct Ran {
    int status = -1;  ///< the exit status; 128 and the number of the signal where one ended it
    std::string out;
    std::string err;
};

/// Runs a program (found on the PATH where it has no slash) to its end, with LC_ALL=C unless
/// `environment` (NAME=VALUE) says otherwise. A program that cannot be run is a test failure.
Ran run_program(const std::vector<std::string>& command, const std::string& input = {},
                const std::vector<std::string>& environment = {});

/// Runs grafwire with these arguments.
Ran grafwire_with(std::vector<std::string> arguments, const std::string& input = {},
                  const std::vector<std::string>& environment = {});

/// What an option of a command may be, as its help lists it: the styles of `netlist --style`, the
/// formats of `netlist --to`, …
std::vector<std::string> choices_of(const std::string& command, const std::string& option);

/// An empty folder that goes with the object.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    /// Makes a file and says where it stands.
    std::string file(const std::string& name, const std::string& text) const;
    /// The names of all that is in the folder, in order.
    std::vector<std::string> names() const;

  private:
    std::filesystem::path folder_;
};

bool contains(const std::string& text, const std::string& part);

}  // namespace grafwire::testing
