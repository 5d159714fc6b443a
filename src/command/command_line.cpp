#include "command/command_line.h"

#include <CLI/CLI.hpp>
#include <charconv>

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

void CommandLine::when_read(std::function<void()> action) const {
    app_.final_callback(std::move(action));
}

bool CommandLine::has(const std::string& option) const {
    return app_.count(option) > 0;
}

}  // namespace grafwire
