#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "text/language.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace grafwire {

/// What the program ends with.
enum class ExitStatus : int {
    done = 0,
    answer_is_no = 1,
    bad_request = 2,
    out_of_bounds = 3,
};

/// What a command does once its options have been read.
using Task = std::function<ExitStatus()>;

/// An option, or an argument without a name, that has just been added to a command line.
class AddedOption {
  public:
    explicit AddedOption(CLI::Option* option) : option_(option) {}

    AddedOption required() const;
    AddedOption one_of(const std::vector<std::string>& values) const;
    /// One of the names in a table.
    template <typename Rows>
    AddedOption one_of_names(const Rows& rows) const {
        std::vector<std::string> names;
        for (const auto& row : rows) names.emplace_back(row.name);
        return one_of(names);
    }
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

    /// Whether an option was written; once the command line has been read.
    bool has(std::string_view option) const;

  private:
    CLI::App& app_;
};

struct Command;

/// What came of reading a command line: one of these.
struct ReadCommandLine {
    Task action;          ///< what was asked for
    std::string help;     ///< a text to show instead: help, version
    std::string problem;  ///< what is wrong, with a suggestion and where to find help
    /// What the action asks whether options were written.
    std::shared_ptr<CLI::App> app;
};

/// Reads the command line of the program. `language` is what the reports are in unless the command
/// line says otherwise; it is set before any action runs.
ReadCommandLine read_command_line(int argc, char** argv, std::span<const Command> commands,
                                  Language& language);

}  // namespace grafwire
