// Completions for bash: a table of what may follow which command, and below it the one function
// that reads the words written so far. It needs nothing but bash 4, not even the package of
// completions.

#include <fmt/format.h>

#include "describe/completions.h"
#include "text/joined.h"
#include "text/version.h"

namespace grafwire {

namespace {

/// What stands before and behind the table.
constexpr std::string_view head_of_bash_file =
    R"bash(# Completion of {} for bash. It is made of the table that --help shows.

# _grafwire_words COMMAND: sets which commands may stand below it, and which options; `flags` have no value.
_grafwire_words() {{
    case $1 in
)bash";
constexpr std::string_view between_of_bash_file = R"bash(    esac
}

# _grafwire_value COMMAND OPTION, or the number of an argument: sets what its value may be: words, files
# with these endings (`any`: all), folders.
_grafwire_value() {
    case "$1 $2" in
)bash";
constexpr std::string_view tail_of_bash_file = R"bash(    esac
}

_grafwire() {
    local current=${COMP_WORDS[COMP_CWORD]} command='' option='' place=0 i word ending
    local commands flags options words='' files='' folders=''
    COMPREPLY=()
    _grafwire_words ''
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        if [[ $word == = ]]; then
            continue # bash makes three words of --option=value
        elif [[ -n $option ]]; then
            option=''
        elif [[ " $options " == *" $word "* ]]; then
            option=$word
        elif [[ " $commands " == *" $word "* ]]; then
            command=${command:+$command }$word
            _grafwire_words "$command"
        elif [[ $word != -?* ]]; then
            ((++place))
        fi
    done
    [[ $current != = ]] || current=''
    if [[ -n $option ]]; then
        _grafwire_value "$command" "$option"
    elif [[ $current == -* ]]; then
        words="$flags $options"
    elif [[ -n $commands ]]; then
        words=$commands
    else
        _grafwire_value "$command" "$((place + 1))"
    fi
    if [[ -n $words ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
        return
    fi
    [[ -n $files$folders ]] || return
    compopt -o filenames 2>/dev/null
    if [[ $files == any ]]; then
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
        return
    fi
    mapfile -t COMPREPLY < <(compgen -d -- "$current")
    for ending in $files; do
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -X "!*$ending" -- "$current")
    done
}

complete -F _grafwire grafwire
)bash";

/// What _grafwire_value sets; empty where a value may be any word.
std::string words_for_bash(const OptionDescription& option) {
    if (!option.values.empty()) return fmt::format("words='{}'", joined(option.values, " "));
    if (option.kind == ValueKind::folder) return "folders=any";
    if (option.kind == ValueKind::word) return {};
    return fmt::format("files='{}'",
                       option.extensions.empty() ? "any" : joined(option.extensions, " "));
}

/// Those that are written after the program may be written after its commands too, but for those
/// that have their own.
void add_words(std::string& out, const PlacedCommand& placed, const CommandDescription& program) {
    std::vector<std::string> commands;
    for (const CommandDescription& below : placed.command->commands) commands.push_back(below.name);
    std::vector<std::string> flags;
    std::vector<std::string> options{"--lang"};
    if (placed.command == &program) options.clear();
    for (const OptionDescription& option : placed.command->options) {
        std::vector<std::string>& names = option.value.empty() ? flags : options;
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    out += fmt::format("        '{}') commands='{}' flags='{}' options='{}' ;;\n", placed.path,
                       joined(commands, " "), joined(flags, " "), joined(options, " "));
}

/// A row of the table: the pattern, in quotes, and what it sets.
void add_value(std::string& out, const std::string& pattern, const OptionDescription& option) {
    const std::string value = words_for_bash(option);
    if (!value.empty()) out += fmt::format("        {}) {} ;;\n", pattern, value);
}

void add_values(std::string& out, const PlacedCommand& placed) {
    for (const OptionDescription& option : placed.command->options) {
        for (const std::string& name : option.names) {
            // What is written after the program may be written after every command.
            add_value(out,
                      placed.path.empty() ? fmt::format("*' {}'", name)
                                          : fmt::format("'{} {}'", placed.path, name),
                      option);
        }
    }
    int place = 1;
    for (const OptionDescription& argument : placed.command->arguments) {
        add_value(out,
                  argument.may_be_repeated ? fmt::format("'{} '*", placed.path)
                                           : fmt::format("'{} {}'", placed.path, place++),
                  argument);
    }
}

}  // namespace

std::string bash_completion(const CommandDescription& program) {
    const std::vector<PlacedCommand> commands = placed_commands(program);
    std::string out = fmt::format(head_of_bash_file, program_and_version());
    for (const PlacedCommand& placed : commands) add_words(out, placed, program);
    out += between_of_bash_file;
    for (const PlacedCommand& placed : commands) add_values(out, placed);
    out += tail_of_bash_file;
    return out;
}

}  // namespace grafwire
