// This file and request_error.cpp are all that knows CLI11.

#include "command/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>

#include "command/command.h"
#include "command/help.h"
#include "command/messages.h"
#include "command/request_error.h"
#include "text/version.h"

namespace grafwire {

namespace say = messages::command;
namespace help = messages::help;

namespace {

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
    const std::string set = fmt::format("{{{}}}", fmt::join(values, ","));
    const auto check = [values, set, language = language_](const std::string& text) {
        const bool is_one = std::find(values.begin(), values.end(), text) != values.end();
        return is_one ? std::string() : say::not_one_of.in(language, text, set);
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

CommandLine CommandLine::add_command(const std::string& name, const Localized& text,
                                     const std::string& example) const {
    app_.require_subcommand(1);
    CLI::App* command = app_.add_subcommand(name, text.in(language_));
    command->group(help::commands.in(language_));
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

namespace {

/// The words of CLI11 itself.
void translate(CLI::App& app, Language language) {
    app.set_help_flag("-h,--help", help::help.in(language));
    app.set_version_flag("--version", fmt::format("grafwire {}", version()),
                         help::version.in(language));
    const auto formatter = app.get_formatter();
    for (const Message<>& label :
         {help::usage, help::a_command, help::positionals, help::required}) {
        formatter->label(label.in(Language::english), label.in(language));
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
            read.help = text.str();
        } else {
            read.problem = request_error(app, error);
        }
    }
    return read;
}

}  // namespace grafwire
