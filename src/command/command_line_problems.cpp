// What is wrong with a command line.
//
// CLI11 tells that in English only, and an unknown word without the one that may have been meant.
// What it says is found out again here from what it has read, and told from the catalogue; there
// the English of CLI11's own errors is that of CLI11. Checks of our own (one of a set, a number)
// put their messages into CLI11's errors and need no translation.

#include "command/command_line_problems.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "command/messages.h"
#include "text/joined.h"
#include "text/nearest_name.h"

namespace grafwire {

namespace say = messages::command;

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

}  // namespace

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

namespace {

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

}  // namespace

Localized problem_of(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
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

Localized with_help(const CLI::App& app, const Localized& problem) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    return say::see_help(problem, chosen.empty() ? "" : chosen.front()->get_name() + " ");
}

}  // namespace grafwire
