#include "command/request_error.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <vector>

#include "text/diagnostics.h"

namespace grafwire {

namespace {

bool is_option(const std::string& word) {
    return word.size() > 1 && word.front() == '-';
}

std::string suggestion(std::string_view mistyped, const std::vector<std::string>& names) {
    const std::vector<std::string_view> views(names.begin(), names.end());
    const std::string_view nearest = nearest_name(mistyped, views);
    return nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
}

std::string unknown_option(const CLI::App& app, const std::string& word) {
    const std::string option = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const CLI::App* level = &app; level != nullptr; level = level->get_parent()) {
        for (const CLI::Option* known : level->get_options()) {
            for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
        }
    }
    return fmt::format("there is no option '{}'{}", option, suggestion(option, names));
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    return fmt::format("there is no command '{}'{} (commands: {})", word, suggestion(word, names),
                       fmt::join(names, ", "));
}

std::string problem(const CLI::App& app, const CLI::App& command, const CLI::ParseError& error) {
    // The words that nothing asked for, in their order.
    std::vector<std::string> words = command.remaining();
    if (words.empty()) words = app.remaining();
    if (words.empty()) return error.what();
    if (&command == &app && !is_option(words.front())) return unknown_command(app, words.front());
    // The value of an unknown option is among the words as well.
    const auto option = std::find_if(words.begin(), words.end(), is_option);
    if (option != words.end()) return unknown_option(command, *option);
    return fmt::format("'{}' is one word too many", words.front());
}

}  // namespace

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    return fmt::format("{}\n'grafwire{}{} --help' shows what there is.",
                       problem(app, command, error), chosen.empty() ? "" : " ",
                       chosen.empty() ? "" : command.get_name());
}

}  // namespace grafwire
