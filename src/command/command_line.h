#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "command/description.h"
#include "command/help.h"
#include "text/diagnostics.h"
#include "text/message.h"

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

/// Of two, the one that work on several files ends with: a wrong request or input comes before no,
/// that before undecided, and that before done.
constexpr ExitStatus worse_of(ExitStatus a, ExitStatus b) {
    for (const ExitStatus worst :
         {ExitStatus::bad_request, ExitStatus::answer_is_no, ExitStatus::out_of_bounds}) {
        if (a == worst || b == worst) return worst;
    }
    return ExitStatus::done;
}

/// What a command does once its options have been read.
using Task = std::function<ExitStatus()>;

/// An option, or an argument without a name, that has just been added to a command line.
class AddedOption {
  public:
    AddedOption(CLI::Option* option, OptionDescription& description, Language language)
        : option_(option), description_(&description), language_(language) {}

    AddedOption required() const;
    /// Its value is the name of a file, which should end with one of these; none: of any file.
    AddedOption names_file(std::vector<std::string> extensions) const;
    /// Its value is the name of a folder.
    AddedOption names_folder() const;
    /// Its value is one of the names in a table, which the command looks up itself.
    template <typename Rows>
    AddedOption names_row(const Rows& rows) const {
        std::vector<std::string> names;
        for (const auto& row : rows) names.emplace_back(row.name);
        return offers(std::move(names));
    }
    AddedOption one_of(const std::vector<std::string>& values) const;
    /// One of the names in a table.
    template <typename Rows>
    AddedOption one_of_names(const Rows& rows) const {
        std::vector<std::string> names;
        for (const auto& row : rows) names.emplace_back(row.name);
        return one_of(names);
    }
    /// A word that passes a check; `words` say what does.
    AddedOption one_that(const std::function<bool(std::string_view)>& passes,
                         const std::vector<std::string_view>& words) const;
    /// The help says the value that its target has now.
    AddedOption shows_default() const;

  private:
    AddedOption offers(std::vector<std::string> words) const;

    CLI::Option* option_;
    OptionDescription* description_;
    Language language_;
};

/// What may be written after a command. CLI11 reads it; the commands only see this, for that
/// library takes long to compile wherever it is included. All that is added is described as well.
class CommandLine {
  public:
    /// `shared`: the options that come from a file and were not written.
    using Names = std::set<std::string, std::less<>>;
    CommandLine(CLI::App& app, CommandDescription& description, Language language,
                std::shared_ptr<const Names> shared)
        : app_(app), description_(description), language_(language), shared_(std::move(shared)) {}

    /// What help, messages and reports are in.
    Language language() const { return language_; }

    /// An argument `FILE`, which must be written: what is written there goes into the target, which
    /// must live until the command line has been read.
    AddedOption add_argument(const Message<>& name, std::string& target,
                             const Localized& help) const;
    /// The same, which may be left out.
    AddedOption add_optional_argument(const Message<>& name, std::string& target,
                                      const Localized& help) const;
    /// One `FILE` or several.
    AddedOption add_arguments(const Message<>& name, std::vector<std::string>& targets,
                              const Localized& help) const;
    /// An option `--scan`, likewise.
    AddedOption add(const char* name, std::string& target, const Localized& help) const;
    /// An option that may be repeated.
    AddedOption add(const char* name, std::vector<std::string>& target,
                    const Localized& help) const;
    /// Of 64 bits; more, or a sign, is refused.
    AddedOption add(const char* name, std::uint64_t& target, const Localized& help) const;
    /// Not negative.
    AddedOption add(const char* name, double& target, const Localized& help) const;
    void add_flag(const char* name, bool& target, const Localized& help) const;
    /// `--strict`, of commands that read charts: warnings about these are errors.
    void add_strict() const;
    bool is_strict() const;

    /// A command below this one; one of those must be given. `example` stands at the end of its
    /// help.
    CommandLine add_command(const std::string& name, const Localized& help,
                            const std::string& example) const;

    /// Whether an option was written on the command line; once that has been read.
    bool has(std::string_view option) const;

  private:
    OptionDescription& described(std::string_view names, const Localized& help) const;

    CLI::App& app_;
    CommandDescription& description_;
    Language language_;
    std::shared_ptr<const Names> shared_;
};

/// What the help says of an option, and below it the rows of the table that it takes a name of:
///
///     output format
///     verilog: structural Verilog (IEEE 1364-2005)
template <typename Rows>
Localized with_rows(const Localized& help, const Rows& rows) {
    std::vector<Localized> lines{help};
    for (const auto& row : rows) lines.push_back(messages::help::row(row.name, row.description()));
    return joined(lines, "\n");
}

/// One row of the table of commands: adds its options to the parser and returns what to do once
/// they have been read.
struct Command {
    std::string_view name;
    Message<> summary;
    std::string_view example;
    Task (*declare)(const CommandLine& line);
};

Task declare_info(const CommandLine& line);
Task declare_equations(const CommandLine& line);
Task declare_run(const CommandLine& line);
Task declare_netlist(const CommandLine& line);
Task declare_simulate(const CommandLine& line);
Task declare_check(const CommandLine& line);
Task declare_plc(const CommandLine& line);
Task declare_s7(const CommandLine& line);
Task declare_draw(const CommandLine& line);
Task declare_report(const CommandLine& line);
Task declare_fmt(const CommandLine& line);

/// What came of reading a command line: one of these.
struct ReadCommandLine {
    Task action;                       ///< what was asked for
    std::string help;                  ///< a text to show instead: help, version
    std::optional<Localized> problem;  ///< what is wrong, with a suggestion and where to find help
    /// What is wrong with shared options, and the file that they are in.
    Diagnostics config_messages;
    SourceFile config;
    /// What the action asks whether options were written.
    std::shared_ptr<CLI::App> app;
    std::shared_ptr<CommandDescription> description;
};

/// What `--lang` says, wherever it stands; else `other`. It is looked up before the command line is
/// read, since help and errors of the command line are in that language too.
Language language_asked_for(std::span<char* const> words, Language other);

/// Reads the command line of the program, and the shared options of the charts in it
/// (grafwire.toml), which count where the command line says nothing else; all texts are in
/// `language`.
ReadCommandLine read_command_line(int argc, char** argv, std::span<const Command> commands,
                                  Language language);

}  // namespace grafwire
