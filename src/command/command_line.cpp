// The only file that knows CLI11.

#include "command/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

#include "command/command.h"
#include "text/diagnostics.h"
#include "text/version.h"

namespace grafwire {

AddedOption AddedOption::required() const {
    option_->required();
    return *this;
}

AddedOption AddedOption::one_of(const std::vector<std::string>& values) const {
    option_->check(CLI::IsMember(values));
    return *this;
}

AddedOption AddedOption::shows_default() const {
    option_->capture_default_str();
    return *this;
}

AddedOption CommandLine::add(const char* name, std::string& target, const std::string& help) const {
    return AddedOption(app_.add_option(name, target, help));
}

AddedOption CommandLine::add(const char* name, std::vector<std::string>& target,
                             const std::string& help) const {
    return AddedOption(app_.add_option(name, target, help));
}

AddedOption CommandLine::add(const char* name, std::uint64_t& target,
                             const std::string& help) const {
    // CLI11 takes -1 for the largest number there is.
    const auto check = [](const std::string& text) -> std::string {
        std::uint64_t number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error == std::errc() && end == text.data() + text.size()) return {};
        return "'" + text + "' is no whole number from 0 to 18446744073709551615";
    };
    return AddedOption(app_.add_option(name, target, help)->check(check, "WHOLE"));
}

AddedOption CommandLine::add(const char* name, double& target, const std::string& help) const {
    const auto check = [](const std::string& text) -> std::string {
        double number = 0;
        if (CLI::detail::lexical_cast(text, number) && number >= 0) return {};
        return "'" + text + "' is no number from 0 on";
    };
    return AddedOption(app_.add_option(name, target, help)->check(check, "NONNEGATIVE"));
}

void CommandLine::add_flag(const char* name, bool& target, const std::string& help) const {
    app_.add_flag(name, target, help);
}

CommandLine CommandLine::add_command(const std::string& name, const std::string& help,
                                     const std::string& example) const {
    app_.require_subcommand(1);
    CLI::App* command = app_.add_subcommand(name, help);
    command->footer("Example: " + example);
    return CommandLine(*command);
}

bool CommandLine::has(std::string_view option) const {
    return app_.count(std::string(option)) > 0;
}

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

std::string explain(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    const CLI::App& command = chosen.empty() ? app : *chosen.front();
    return fmt::format("{}\n'grafwire{}{} --help' shows what there is.",
                       problem(app, command, error), chosen.empty() ? "" : " ",
                       chosen.empty() ? "" : command.get_name());
}

}  // namespace

ReadCommandLine read_command_line(int argc, char** argv, std::span<const Command> commands,
                                  Language& language) {
    ReadCommandLine read;
    read.app = std::make_shared<CLI::App>(
        "From a GRAFCET (IEC 60848) to wiring, and a proof that the wiring is right.", "grafwire");
    CLI::App& app = *read.app;
    app.set_version_flag("--version", fmt::format("grafwire {}", version()));
    app.footer(
        "Exit status: 0 done or equivalent; 1 the answer is no; 2 wrong request or input; "
        "3 undecided.\n'grafwire COMMAND --help' shows the options of a command.");
    app.add_option_function<std::string>(
           "--lang",
           [&](const std::string& name) {
               language = name == "fr" ? Language::french : Language::english;
           },
           "language of reports: en or fr (default: from the locale)")
        ->check(CLI::IsMember({"en", "fr"}))
        ->trigger_on_parse();
    app.fallthrough();

    for (const Command& command : commands) {
        const CommandLine line = CommandLine(app).add_command(
            std::string(command.name), std::string(command.summary), std::string(command.example));
        const Task action = command.declare(line, language);
        app.get_subcommand(std::string(command.name))->final_callback([&read, action] {
            read.action = action;
        });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        read.action = nullptr;
        if (error.get_exit_code() == 0) {
            std::ostringstream text;
            app.exit(error, text, text);
            read.help = text.str();
        } else {
            read.problem = explain(app, error);
        }
    }
    return read;
}

}  // namespace grafwire
