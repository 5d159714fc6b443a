// A command line, read by CLI11: once as it was written, and where the charts in it have shared
// options (grafwire.toml) once more with these. Each option of such a file is tried by itself
// first, so that what is wrong with it is told at its place.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <sstream>

#include "command/command_line.h"
#include "command/command_line_problems.h"
#include "command/config_file.h"
#include "command/files.h"
#include "command/help.h"
#include "command/messages.h"
#include "command/parser_words.h"
#include "command/wrapped_help.h"
#include "text/joined.h"
#include "text/utf8.h"
#include "text/version.h"

namespace grafwire {

namespace say = messages::command;
namespace help = messages::help;

Language language_asked_for(std::span<char* const> words, Language other) {
    Language language = other;
    const auto read = [&](std::string_view name) {
        if (name == "fr") language = Language::french;
        if (name == "en") language = Language::english;
    };
    constexpr std::string_view option = "--lang";
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word == option && i + 1 < words.size()) read(words[i + 1]);
        if (word.starts_with(option) && word.substr(option.size()).starts_with('=')) {
            read(word.substr(option.size() + 1));
        }
    }
    return language;
}

namespace {

using Names = std::vector<std::string>;

/// The words of CLI11 itself.
void translate(CLI::App& app, CommandDescription& description, Language language) {
    constexpr const char* version_name = "--version";
    app.option_defaults()->group(label(help::options, language));
    app.set_help_flag(help_names, help::help.in(language));
    app.set_version_flag(version_name, program_and_version(), help::version.in(language));
    description.options.push_back(help_option(language));
    description.options.push_back({{version_name}, "", help::version.in(language)});
    const auto formatter = app.get_formatter();
    for (const Message<>& heading :
         {help::usage, help::a_command, help::positionals, help::required}) {
        formatter->label(label(heading, Language::english), label(heading, language));
    }
}

/// Declares all that may be written; `chosen` becomes the action of the command that was.
void declare(CLI::App& app, CommandDescription& description, std::span<const Command> commands,
             Task& chosen, Language language,
             const std::shared_ptr<const CommandLine::Names>& shared) {
    description.name = "grafwire";
    description.summary = help::program.in(language);
    translate(app, description, language);
    app.footer(help::exit_statuses.in(language, help::statuses[0](), help::statuses[1](),
                                      help::statuses[2](), help::statuses[3]()));
    // language_asked_for() has read it; here it is checked, each time that it stands there.
    constexpr const char* lang_name = "--lang";
    CLI::Option* lang = app.add_option_function<std::string>(
        lang_name, [](const std::string&) {}, help::language.in(language));
    description.options.push_back({{lang_name}, "", help::language.in(language)});
    typed_option(lang, help::text, description.options.back(), language).one_of({"en", "fr"});
    lang->trigger_on_parse();
    constexpr const char* no_config_name = "--no-config";
    app.add_flag(no_config_name)->description(help::no_config.in(language));
    description.options.push_back({{no_config_name}, "", help::no_config.in(language)});
    app.fallthrough();

    const CommandLine line(app, description, language, shared);
    for (const Command& command : commands) {
        const std::string name(command.name);
        const Task action = command.declare(
            line.add_command(name, command.summary(), std::string(command.example)));
        app.get_subcommand(name)->final_callback([&chosen, action] { chosen = action; });
    }
}

/// A command line read once.
struct Attempt {
    ReadCommandLine read;
    std::optional<Localized> problem;  ///< without where to find help
    bool is_incomplete = false;        ///< the problem is that something is missing
};

/// What may be written, and in which language it is told.
struct Grammar {
    std::span<const Command> commands;
    Language language;
};

/// `shared`: names of options among the words that the user has not written.
Attempt read_words(const Names& words, const Grammar& grammar,
                   const std::shared_ptr<const CommandLine::Names>& shared) {
    Attempt attempt;
    attempt.read.app = std::make_shared<CLI::App>(help::program.in(grammar.language), "grafwire");
    attempt.read.description = std::make_shared<CommandDescription>();
    CLI::App& app = *attempt.read.app;
    Task action;
    declare(app, *attempt.read.description, grammar.commands, action, grammar.language, shared);
    try {
        app.parse(Names(words.rbegin(), words.rend()));
        attempt.read.action = action;
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            std::ostringstream text;
            app.exit(error, text, text);
            attempt.read.help = wrapped_help(text.str(), grammar.language);
        } else {
            const std::vector<CLI::App*> chosen = app.get_subcommands();
            attempt.problem = problem_of(app, chosen.empty() ? app : *chosen.front(), error);
            attempt.read.problem = with_help(app, *attempt.problem);
            attempt.is_incomplete = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
        }
    }
    return attempt;
}

// Shared options.

/// Options that say what a single call reads or writes, or of which run.
constexpr std::string_view options_of_one_call[] = {
    "-o",    "-i",          "--against", "--program", "--io",    "--stim", "--at",     "--zoom",
    "--vcd", "--addresses", "--witness", "--shard",   "--check", "--help", "--delays", "--bench"};

Names words_of(const SharedOption& option, bool is_repeated) {
    if (option.truth) return *option.truth ? Names{option.name} : Names{};
    Names words;
    const auto add = [&](const std::string& value) {
        if (option.name.starts_with("--")) {
            words.push_back(option.name + "=" + value);
        } else {
            words.insert(words.end(), {option.name, value});
        }
    };
    if (is_repeated) {
        for (const std::string& value : option.values) add(value);
    } else {
        add(joined(option.values, ","));
    }
    return words;
}

/// The charts that a command takes; nullptr where it takes none.
const CLI::Option* charts_of(const CLI::App& command, Language language) {
    return command.get_option_no_throw(help::file_name.in(language));
}

/// What keeps an option of a command from being shared.
std::optional<Localized> fault_of(const SharedOption& option, const CLI::App& command,
                                  const Grammar& grammar) {
    const CLI::Option* known = command.get_option_no_throw(option.name);
    if (known == nullptr) return unknown_option(command, option.name);
    const auto& single = options_of_one_call;
    if (std::find(std::begin(single), std::end(single), option.name) != std::end(single)) {
        return say::option_of_one_call(option.name);
    }
    const bool is_flag = known->get_items_expected_max() == 0;
    if (is_flag && !option.truth) return say::flag_is_true_or_false(option.name);
    if (!is_flag && option.truth) return say::option_has_value(option.name);
    Names words{command.get_name(), "-"};
    const Names more = words_of(option, known->get_items_expected_max() > 1);
    words.insert(words.end(), more.begin(), more.end());
    const Attempt attempt = read_words(words, grammar, nullptr);
    return attempt.is_incomplete ? std::nullopt : attempt.problem;
}

/// The file that all charts of a command share; empty where there is none, with the reason in
/// `problem` where there are several.
std::string shared_config(const CLI::Option& charts, std::optional<Localized>& problem) {
    std::set<std::string> files;
    for (const std::string& word : charts.results()) files.insert(config_file_for(word));
    if (files.size() > 1) {
        const auto shown = [](const std::string& file) {
            return file.empty() ? std::string("-") : visible(file);
        };
        problem = say::two_configs(shown(*files.begin()), shown(*std::next(files.begin())));
        return {};
    }
    return files.empty() ? std::string() : *files.begin();
}

/// Every option of the file is checked, of whichever command it is.
void check_config(const std::vector<SharedOptions>& tables, const CLI::App& app,
                  const Grammar& grammar, Diagnostics& diagnostics) {
    for (const SharedOptions& table : tables) {
        const auto is_it = [&](const CLI::App* any) { return any->get_name() == table.command; };
        const auto found = app.get_subcommands(is_it);
        const CLI::App* command = found.empty() ? nullptr : found.front();
        if (command == nullptr || charts_of(*command, grammar.language) == nullptr) {
            diagnostics.error(code::bad_config, table.where, unknown_command(app, table.command));
            continue;
        }
        for (const SharedOption& option : table.options) {
            if (const auto fault = fault_of(option, *command, grammar)) {
                diagnostics.error(code::bad_config, option.where, *fault);
            }
        }
    }
    diagnostics.sort_by_place();
}

/// The command line with what the file has for its command.
Attempt with_shared(Names words, const std::vector<SharedOptions>& tables, const CLI::App& command,
                    const Grammar& grammar) {
    const auto names = std::make_shared<CommandLine::Names>();
    for (const SharedOptions& table : tables) {
        if (table.command != command.get_name()) continue;
        for (const SharedOption& option : table.options) {
            const CLI::Option* known = command.get_option_no_throw(option.name);
            if (known->count() > 0) continue;
            const Names more = words_of(option, known->get_items_expected_max() > 1);
            // Behind `--` there are no options any more.
            words.insert(std::find(words.begin(), words.end(), "--"), more.begin(), more.end());
            names->insert(option.name);
        }
    }
    return read_words(words, grammar, names);
}

}  // namespace

ReadCommandLine read_command_line(int argc, char** argv, std::span<const Command> commands,
                                  Language language) {
    const Grammar grammar{commands, language};
    const Names words(argv + 1, argv + argc);
    Attempt written = read_words(words, grammar, nullptr);
    const CLI::App& app = *written.read.app;
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    if (!written.read.help.empty() || (written.problem && !written.is_incomplete) ||
        chosen.empty() || app.count("--no-config") > 0) {
        return std::move(written.read);
    }
    const CLI::Option* charts = charts_of(*chosen.front(), language);
    if (charts == nullptr || charts->count() == 0) return std::move(written.read);
    std::optional<Localized> several;
    const std::string config = shared_config(*charts, several);
    ReadCommandLine refused;
    refused.app = written.read.app;
    refused.problem = several;
    if (several) return refused;
    if (config.empty()) return std::move(written.read);
    // Read and check the file, and then all again.
    refused.config = read_source(config, refused.config_messages);
    if (refused.config_messages.has_errors()) return refused;
    const auto tables = read_config(refused.config, refused.config_messages);
    check_config(tables, app, grammar, refused.config_messages);
    if (refused.config_messages.has_errors()) return refused;
    return std::move(with_shared(words, tables, *chosen.front(), grammar).read);
}

CommandDescription describe_program(std::span<const Command> commands, Language language) {
    CLI::App app;
    CommandDescription description;
    Task chosen;
    declare(app, description, commands, chosen, language, nullptr);
    return description;
}

}  // namespace grafwire
