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

#include "command/help.h"
#include "command/messages.h"
#include "command/wrapped_help.h"
#include "text/joined.h"
#include "text/nearest_name.h"
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

/// The kind of value as help shows it.
AddedOption text_option(CLI::Option* option, Language language) {
    option->type_name(help::text.in(language));
    return {option, language};
}

}  // namespace

AddedOption AddedOption::required() const {
    option_->required();
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
    return *this;
}

AddedOption AddedOption::shows_default() const {
    option_->capture_default_str();
    return *this;
}

void CommandLine::add_argument(const Message<>& name, std::string& target,
                               const Localized& text) const {
    const std::string shown = name.in(language_);
    text_option(app_.add_option(shown, target, text.in(language_)), language_).required();
}

void CommandLine::add_optional_argument(const Message<>& name, std::string& target,
                                        const Localized& text) const {
    text_option(app_.add_option(name.in(language_), target, text.in(language_)), language_);
}

void CommandLine::add_arguments(const Message<>& name, std::vector<std::string>& targets,
                                const Localized& text) const {
    const std::string shown = name.in(language_);
    text_option(app_.add_option(shown, targets, text.in(language_)), language_).required();
}

AddedOption CommandLine::add(const char* name, std::string& target, const Localized& text) const {
    return text_option(app_.add_option(name, target, text.in(language_)), language_);
}

AddedOption CommandLine::add(const char* name, std::vector<std::string>& target,
                             const Localized& text) const {
    return text_option(app_.add_option(name, target, text.in(language_)), language_);
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
    option->type_name(help::whole.in(language_));
    option->check(check, help::of_64_bits.in(language_));
    return {option, language_};
}

AddedOption CommandLine::add(const char* name, double& target, const Localized& text) const {
    const auto check = [language = language_](const std::string& word) -> std::string {
        double number = 0;
        if (CLI::detail::lexical_cast(word, number) && number >= 0) return {};
        return say::no_number.in(language, word);
    };
    CLI::Option* option = app_.add_option(name, target, text.in(language_));
    option->type_name(help::number.in(language_));
    option->check(check, help::not_negative.in(language_));
    return {option, language_};
}

void CommandLine::add_flag(const char* name, bool& target, const Localized& text) const {
    app_.add_flag(name, target, text.in(language_));
}

void CommandLine::add_strict() const {
    app_.add_flag("--strict")->description(help::strict.in(language_));
}

CommandLine CommandLine::add_command(const std::string& name, const Localized& text,
                                     const std::string& example) const {
    app_.require_subcommand(1);
    CLI::App* command = app_.add_subcommand(name, text.in(language_));
    command->group(label(help::commands, language_));
    command->get_help_ptr()->group(label(help::options, language_));
    command->footer(help::example.in(language_, example));
    return {*command, language_};
}

bool CommandLine::has(std::string_view option) const {
    return app_.count(std::string(option)) > 0;
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

/// What is wrong with a command line that CLI11 has refused, with a suggestion and where to find
/// help.
Localized request_error(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    return say::see_help(problem(app, command, error),
                         chosen.empty() ? "" : command.get_name() + " ");
}

// The whole.

/// The words of CLI11 itself.
void translate(CLI::App& app, Language language) {
    app.option_defaults()->group(label(help::options, language));
    app.set_help_flag("-h,--help", help::help.in(language));
    app.set_version_flag("--version", fmt::format("grafwire {}", version()),
                         help::version.in(language));
    const auto formatter = app.get_formatter();
    for (const Message<>& heading :
         {help::usage, help::a_command, help::positionals, help::required}) {
        formatter->label(label(heading, Language::english), label(heading, language));
    }
}

}  // namespace

ReadCommandLine read_command_line(int argc, char** argv, std::span<const Command> commands,
                                  Language language) {
    ReadCommandLine read;
    read.app = std::make_shared<CLI::App>(help::program.in(language), "grafwire");
    CLI::App& app = *read.app;
    translate(app, language);
    app.footer(help::exit_statuses.in(language));
    // language_asked_for() has read it; here it is checked, each time that it stands there.
    CLI::Option* lang = app.add_option_function<std::string>(
        "--lang", [](const std::string&) {}, help::language.in(language));
    text_option(lang, language).one_of({"en", "fr"});
    lang->trigger_on_parse();
    app.fallthrough();

    const CommandLine line(app, language);
    for (const Command& command : commands) {
        const std::string name(command.name);
        const Task action = command.declare(
            line.add_command(name, command.summary(), std::string(command.example)));
        app.get_subcommand(name)->final_callback([&read, action] { read.action = action; });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        read.action = nullptr;
        if (error.get_exit_code() == 0) {
            std::ostringstream text;
            app.exit(error, text, text);
            read.help = wrapped_help(text.str(), language);
        } else {
            read.problem = request_error(app, error);
        }
    }
    return read;
}

}  // namespace grafwire
