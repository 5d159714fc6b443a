// What may be written after a command, as CLI11 takes it. That library is known to this file and to
// those that read a command line (read_command_line.cpp) and tell what is wrong with one
// (command_line_problems.cpp), and to no others: it takes long to compile.

#include "command/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "command/help.h"
#include "command/messages.h"
#include "command/parser_words.h"
#include "text/joined.h"

namespace grafwire {

namespace say = messages::command;
namespace help = messages::help;

namespace {

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

}  // namespace

std::string label(const Message<>& heading, Language language) {
    std::string text = heading.in(language);
    if (text.ends_with(':')) text.pop_back();
    return text;
}

OptionDescription help_option(Language language) {
    return {names_in(help_names), "", help::help.in(language)};
}

AddedOption typed_option(CLI::Option* option, const Message<>& type, OptionDescription& described,
                         Language language) {
    const std::string name = type.in(language);
    option->type_name(name);
    if (described.value.empty()) described.value = name;
    return {option, described, language};
}

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

}  // namespace grafwire
