// Completions for zsh: a function for each command and language, which hands what may follow to
// _arguments.

#include <fmt/format.h>

#include "describe/completions.h"
#include "text/joined.h"
#include "text/version.h"

namespace grafwire {

namespace {

constexpr std::string_view head_of_zsh_file = R"zsh(#compdef grafwire
# Completion of {} for zsh. It is made of the table that --help shows.

)zsh";
constexpr std::string_view tail_of_zsh_file = R"zsh(
case ${LC_ALL:-${LC_MESSAGES:-$LANG}} in
    fr*) _grafwire_fr "$@" ;;
    *) _grafwire_en "$@" ;;
esac
)zsh";

/// `_grafwire_en_s7_run`.
std::string function_name(const std::string& path, std::string_view language) {
    std::string name = fmt::format("_grafwire_{}", language);
    if (path.empty()) return name;
    name += '_' + path;
    for (char& c : name) {
        if (c == ' ' || c == '-') c = '_';
    }
    return name;
}

/// A text with a backslash before each of these characters.
std::string escaped(const std::string& text, std::string_view characters) {
    std::string out;
    for (const char c : text) {
        if (characters.find(c) != std::string_view::npos) out += '\\';
        out += c;
    }
    return out;
}

/// What _arguments does for a value: `:TEXT:(a b)`.
std::string action_for_zsh(const OptionDescription& option) {
    std::string action;
    if (!option.values.empty()) {
        action = fmt::format("({})", joined(option.values, " "));
    } else if (option.kind == ValueKind::folder) {
        action = "_files -/";
    } else if (option.kind == ValueKind::file && option.extensions.empty()) {
        action = "_files";
    } else if (option.kind == ValueKind::file) {
        std::vector<std::string> patterns;
        for (const std::string& extension : option.extensions) patterns.push_back("*" + extension);
        action = fmt::format("_files -g \"{}\"", joined(patterns, " "));
    }
    return fmt::format(":{}:{}", escaped(option.value, "\\:"), action);
}

/// The arguments of _arguments that stand for an option, one for each of its names.
std::vector<std::string> specifications(const OptionDescription& option) {
    const std::string help = "[" + escaped(first_line(option), "\\[]") + "]";
    const std::string others =
        option.names.size() > 1 ? "(" + joined(option.names, " ") + ")" : std::string();
    std::vector<std::string> result;
    for (const std::string& name : option.names) {
        // Behind a long name its value may follow with `=`, behind a short one at once.
        const std::string_view joint = option.value.empty()     ? ""
                                       : name.starts_with("--") ? "="
                                                                : "+";
        result.push_back(shell_quoted((option.may_be_repeated ? "*" : others) + name +
                                      std::string(joint) + help +
                                      (option.value.empty() ? "" : action_for_zsh(option))));
    }
    return result;
}

/// `1:FILE:…`, `2::STIM:…` where it may be left out, `*:FILE:…` where it may be repeated.
std::string specification(const OptionDescription& argument, std::size_t number) {
    const std::string place = argument.may_be_repeated ? "*" : std::to_string(number);
    return shell_quoted(place + (argument.is_required ? "" : ":") + action_for_zsh(argument));
}

void add_function(std::string& out, const PlacedCommand& placed, const CommandDescription& program,
                  std::string_view language) {
    const CommandDescription& command = *placed.command;
    std::vector<std::string> words;
    const auto add_options = [&words](const CommandDescription& of, bool only_values) {
        for (const OptionDescription& option : of.options) {
            if (only_values && option.value.empty()) continue;
            for (std::string& word : specifications(option)) words.push_back(std::move(word));
        }
    };
    add_options(command, false);
    if (&command != &program) add_options(program, true);
    for (std::size_t i = 0; i < command.arguments.size(); ++i) {
        words.push_back(specification(command.arguments[i], i + 1));
    }
    if (!command.commands.empty()) {
        words.insert(words.end(), {"'1: :->command'", "'*:: :->below'"});
    }
    const std::string name = function_name(placed.path, language);
    out += fmt::format(
        "{}() {{\n    local curcontext=\"$curcontext\" state line\n    _arguments -C", name);
    for (const std::string& word : words) out += " \\\n        " + word;
    out += '\n';
    if (!command.commands.empty()) {
        out += "    case $state in\n    command)\n        local -a commands=(";
        for (const CommandDescription& below : command.commands) {
            out += "\n            " +
                   shell_quoted(escaped(below.name, ":") + ':' + escaped(below.summary, "\\:"));
        }
        out += ")\n        _describe command commands ;;\n";
        out += fmt::format(
            "    below) (( $+functions[{0}_$words[1]] )) && {0}_$words[1] ;;\n    esac\n", name);
    }
    out += "}\n";
}

}  // namespace

std::string zsh_completion(const CommandDescription& english, const CommandDescription& french) {
    std::string out = fmt::format(head_of_zsh_file, program_and_version());
    for (const PlacedCommand& placed : placed_commands(english)) {
        add_function(out, placed, english, "en");
    }
    for (const PlacedCommand& placed : placed_commands(french)) {
        add_function(out, placed, french, "fr");
    }
    out += tail_of_zsh_file;
    return out;
}

}  // namespace grafwire
