#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace grafwire {

/// An option, or an argument without a name, that has just been added to a command line.
class AddedOption {
  public:
    explicit AddedOption(CLI::Option* option) : option_(option) {}

    AddedOption required() const;
    AddedOption one_of(const std::vector<std::string>& values) const;
    /// The help says the value that its target has now.
    AddedOption shows_default() const;

  private:
    CLI::Option* option_;
};

/// What may be written after a command. CLI11 reads it; the commands only see this, for that
/// library takes long to compile wherever it is included.
class CommandLine {
  public:
    explicit CommandLine(CLI::App& app) : app_(app) {}

    /// An option `--scan` or an argument `FILE`: what is written there goes into the target, which
    /// must live until the command line has been read.
    AddedOption add(const char* name, std::string& target, const std::string& help) const;
    /// An option that may be repeated.
    AddedOption add(const char* name, std::vector<std::string>& target,
                    const std::string& help) const;
    /// Of 64 bits; more, or a sign, is refused.
    AddedOption add(const char* name, std::uint64_t& target, const std::string& help) const;
    /// Not negative.
    AddedOption add(const char* name, double& target, const std::string& help) const;
    void add_flag(const char* name, bool& target, const std::string& help) const;

    /// A command below this one; one of those must be given. `example` stands at the end of its
    /// help.
    CommandLine add_command(const std::string& name, const std::string& help,
                            const std::string& example) const;
    /// What is done once this command and all that belongs to it have been read.
    void when_read(std::function<void()> action) const;

    /// Whether an option was written; once the command line has been read.
    bool has(const std::string& option) const;

  private:
    CLI::App& app_;
};

}  // namespace grafwire
