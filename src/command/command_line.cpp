// The command line as CLI11 reads it; no other file knows that library.
//
// CLI11 tells what is wrong in English only, and an unknown word without the one that may have been
// meant. What it says is found out again here from what it has read, and told from the catalogue;
// there the English of CLI11's own errors is that of CLI11. Checks of our own (one of a set, a
// number) put their messages into CLI11's errors and need no translation.

#include "command/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

#include "command/config_file.h"
#include "command/files.h"
#include "command/help.h"
#include "command/messages.h"
#include "command/wrapped_help.h"
#include "text/joined.h"
#include "text/nearest_name.h"
#include "text/utf8.h"
#include "text/version.h"

namespace grafwire {

namespace say = messages::command;
namespace help = messages::help;

namespace {

/// A heading as CLI11 takes it, which puts the colon behind it.
std::string label(const Message<>& heading, Language language) {
    std::string text = heading.in(language);
    if (text.ends_with(':')) text.pop_back();
    return text;
}

/// The names of an option as CLI11 takes them: `-h,--help`.
std::vector<std::string> names_in(std::string_view names) {
    std::vector<std::string> result;
    for (std::size_t begin = 0; begin <= names.size();) {
        const std::size_t end = std::min(names.find(',', begin), names.size());
        result.emplace_back(names.substr(begin, end - begin));
        begin = end + 1;
    }
    return result;
}

/// Every command has it.
constexpr const char* help_names = "-h,--help";
OptionDescription help_option(Language language) {
    return {names_in(help_names), "", help::help.in(language)};
}

/// Shows the kind of value in help. `described` is complete but for what an AddedOption adds.
AddedOption typed_option(CLI::Option* option, const Message<>& type, OptionDescription& described,
                         Language language) {
    const std::string name = type.in(language);
    option->type_name(name);
    if (described.value.empty()) described.value = name;
    return {option, described, language};
}

}  // namespace

AddedOption AddedOption::required() const {
    option_->required();
    description_->is_required = true;
    return *this;
}

AddedOption AddedOption::names_file(std::vector<std::string> extensions) const {
    description_->kind = ValueKind::file;
    description_->extensions = std::move(extensions);
    return *this;
}

AddedOption AddedOption::names_folder() const {
    description_->kind = ValueKind::folder;
    return *this;
}

AddedOption AddedOption::offers(std::vector<std::string> words) const {
    description_->values = std::move(words);
    return *this;
}

AddedOption AddedOption::one_of(const std::vector<std::string>& values) const {
    const auto is_one = [values](std::string_view text) {
        return std::find(values.begin(), values.end(), text) != values.end();
    };
    return one_that(is_one, {values.begin(), values.end()});
}

AddedOption AddedOption::one_that(const std::function<bool(std::string_view)>& passes,
                                  const std::vector<std::string_view>& words) const {
    const std::string set = fmt::format("{{{}}}", joined(words, ","));
    const auto check = [passes, set, language = language_](const std::string& text) {
        return passes(text) ? std::string() : say::not_one_of.in(language, text, set);
    };
    option_->check(check, set);
    return offers({words.begin(), words.end()});
}

AddedOption AddedOption::shows_default() const {
    option_->capture_default_str();
    description_->default_value = option_->get_default_str();
    return *this;
}

AddedOption CommandLine::add_argument(const Message<>& name, std::string& target,
                                      const Localized& text) const {
    return add_optional_argument(name, target, text).required();
}

AddedOption CommandLine::add_optional_argument(const Message<>& name, std::string& target,
                                               const Localized& text) const {
    const std::string shown = name.in(language_);
    description_.arguments.push_back({{}, shown, text.in(language_)});
    return typed_option(app_.add_option(shown, target, text.in(language_)), help::text,
                        description_.arguments.back(), language_);
}

AddedOption CommandLine::add_arguments(const Message<>& name, std::vector<std::string>& targets,
                                       const Localized& text) const {
    const std::string shown = name.in(language_);
    description_.arguments.push_back({{}, shown, text.in(language_)});
    description_.arguments.back().may_be_repeated = true;
    return typed_option(app_.add_option(shown, targets, text.in(language_)), help::text,
                        description_.arguments.back(), language_)
        .required();
}

OptionDescription& CommandLine::described(std::string_view names, const Localized& text) const {
    return description_.options.emplace_back(
        OptionDescription{names_in(names), "", text.in(language_)});
}

AddedOption CommandLine::add(const char* name, std::string& target, const Localized& text) const {
    return typed_option(app_.add_option(name, target, text.in(language_)), help::text,
                        described(name, text), language_);
}

AddedOption CommandLine::add(const char* name, std::vector<std::string>& target,
                             const Localized& text) const {
    OptionDescription& description = described(name, text);
    description.may_be_repeated = true;
    return typed_option(app_.add_option(name, target, text.in(language_)), help::text, description,
                        language_);
}

AddedOption CommandLine::add(const char* name, std::uint64_t& target, const Localized& text) const {
    // CLI11 takes -1 for the largest number there is.
    const auto check = [language = language_](const std::string& word) -> std::string {
        std::uint64_t number = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (error == std::errc() && end == word.data() + word.size()) return {};
        return say::no_whole_number.in(language, word);
    };
    CLI::Option* option = app_.add_option(name, target, text.in(language_));
    option->check(check, help::of_64_bits.in(language_));
    return typed_option(option, help::whole, described(name, text), language_);
}

AddedOption CommandLine::add(const char* name, double& target, const Localized& text) const {
    const auto check = [language = language_](const std::string& word) -> std::string {
        double number = 0;
        if (CLI::detail::lexical_cast(word, number) && number >= 0) return {};
        return say::no_number.in(language, word);
    };
    CLI::Option* option = app_.add_option(name, target, text.in(language_));
    option->check(check, help::not_negative.in(language_));
    return typed_option(option, help::number, described(name, text), language_);
}

void CommandLine::add_flag(const char* name, bool& target, const Localized& text) const {
    app_.add_flag(name, target, text.in(language_));
    described(name, text);
}

void CommandLine::add_strict() const {
    app_.add_flag("--strict")->description(help::strict.in(language_));
    described("--strict", help::strict());
}

CommandLine CommandLine::add_command(const std::string& name, const Localized& text,
                                     const std::string& example) const {
    app_.require_subcommand(1);
    CLI::App* command = app_.add_subcommand(name, text.in(language_));
    command->group(label(help::commands, language_));
    command->get_help_ptr()->group(label(help::options, language_));
    command->footer(help::example.in(language_, example));
    CommandDescription& described = description_.commands.emplace_back();
    described.name = name;
    described.summary = text.in(language_);
    described.example = example;
    described.options.push_back(help_option(language_));
    return {*command, described, language_, shared_};
}

bool CommandLine::has(std::string_view option) const {
    return app_.count(std::string(option)) > 0 && !(shared_ && shared_->contains(option));
}

bool CommandLine::is_strict() const {
    return app_.count("--strict") > 0;
}

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

// Errors.

namespace {

using Names = std::vector<std::string>;

bool is_option(const std::string& word) {
    return word.size() > 1 && word.front() == '-';
}

std::string nearest(std::string_view mistyped, const Names& names) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    return std::string(nearest_name(mistyped, views));
}

/// The options that may be written after a command: its own, and those of the commands above it.
std::vector<const CLI::Option*> options_of(const CLI::App& command) {
    std::vector<const CLI::Option*> options;
    for (const CLI::App* level = &command; level != nullptr; level = level->get_parent()) {
        for (const CLI::Option* option : level->get_options()) options.push_back(option);
    }
    return options;
}

/// The command that was written last: `run` of `s7 run`.
const CLI::App& innermost(const CLI::App& app) {
    const CLI::App* command = &app;
    while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
    return *command;
}

Localized unknown_option(const CLI::App& command, const std::string& word) {
    const std::string option = word.substr(0, word.find('='));
    Names names;
    for (const CLI::Option* known : options_of(command)) {
        for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
    }
    const std::string near = nearest(option, names);
    return near.empty() ? say::unknown_option(option) : say::unknown_option_near(option, near);
}

Localized unknown_command(const CLI::App& app, const std::string& word) {
    Names names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    const std::string all = joined(names, ", ");
    const std::string near = nearest(word, names);
    return near.empty() ? say::unknown_command(word, all)
                        : say::unknown_command_near(word, near, all);
}

/// Something that must be written is not there.
Localized missing(const CLI::App& command) {
    for (const CLI::Option* option : options_of(command)) {
        if (option->get_required() && option->count() == 0) {
            return say::argument_required(option->get_name());
        }
    }
    return say::command_required();
}

/// An option, named at the beginning of what CLI11 says, has no value or too many.
Localized wrong_count(const CLI::App& command, const std::string& message) {
    const std::string name = message.substr(0, message.find(':'));
    for (const CLI::Option* option : options_of(command)) {
        if (!option->check_name(name)) continue;
        if (option->count() > static_cast<std::size_t>(option->get_items_expected_max())) {
            return say::given_too_often(name, option->count());
        }
        return say::value_missing(name, option->get_type_name());
    }
    return Localized::same_in_both(message);
}

/// Only a flag can be given a value that cannot be read: all others are checked before.
Localized wrong_flag(const CLI::App& command, const std::string& message) {
    for (const CLI::Option* option : options_of(command)) {
        if (option->get_items_expected_max() != 0 || option->count() == 0) continue;
        return say::flag_with_value(option->get_name(), joined(option->results(), ","));
    }
    return Localized::same_in_both(message);
}

/// What CLI11 has found itself.
Localized told_by_parser(const CLI::App& app, const CLI::ParseError& error) {
    const CLI::App& command = innermost(app);
    const std::string message = error.what();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing(command);
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return wrong_count(command, message);
    }
    if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {
        return wrong_flag(command, message);
    }
    // Our own checks speak the language asked for; CLI11 puts the name of the option before it.
    const std::size_t end = message.find(": ");
    if (end == std::string::npos) return Localized::same_in_both(message);
    return say::option_value(message.substr(0, end), message.substr(end + 2));
}

Localized problem(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
    // The words that nothing asked for, in their order.
    Names words = command.remaining();
    if (words.empty()) words = app.remaining();
    if (words.empty()) return told_by_parser(app, error);
    if (&command == &app && !is_option(words.front())) return unknown_command(app, words.front());
    // The value of an unknown option is among the words as well.
    const auto option = std::find_if(words.begin(), words.end(), is_option);
    if (option != words.end()) return unknown_option(command, *option);
    return say::word_too_many(words.front());
}

/// Where to find help on a problem.
Localized with_help(const CLI::App& app, const Localized& problem) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return say::see_help(problem, chosen.empty() ? "" : chosen.front()->get_name() + " ");
}

// The whole.

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
            attempt.problem = problem(app, chosen.empty() ? app : *chosen.front(), error);
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
