// Completions for fish: one `complete` for each option of each command, with the descriptions in
// two languages.

#include <fmt/format.h>

#include "describe/completions.h"
#include "text/joined.h"
#include "text/version.h"

namespace grafwire {

namespace {

/// The commands that others stand below are in its list.
constexpr std::string_view head_of_fish_file =
    R"fish(# Completion of {} for fish. It is made of the table that --help shows.

# Whether this is the command that has been written so far; without an argument: none yet.
function __grafwire_at
    set -l command
    set -l is_value 0
    for word in (commandline -opc)[2..-1]
        if test $is_value = 1
            set is_value 0
        else if test "$word" = --lang
            set is_value 1
        else if not string match -q -- '-*' "$word"
            set -a command $word
            contains -- "$word" {} || break
        end
    end
    test "$command" = "$argv"
end

# Files with these endings, and folders.
function __grafwire_files
    for row in (__fish_complete_path (commandline -ct))
        set -l name (string split -f 1 \t -- $row)
        if string match -q -- '*/' $name
            echo $row
        else
            for ending in $argv
                string match -q -- "*$ending" $name && echo $row
            end
        end
    end
end

complete -c grafwire -f
set -l locale $LANG
test -n "$LC_MESSAGES" && set locale $LC_MESSAGES
test -n "$LC_ALL" && set locale $LC_ALL
)fish";

std::string quoted_for_fish(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') out += '\\';
        out += c;
    }
    return out + '\'';
}

/// What is offered for a value: `-x -a 'on off'`.
std::string offer_for_fish(const OptionDescription& option) {
    if (option.value.empty()) return {};
    if (!option.values.empty()) return fmt::format(" -x -a '{}'", joined(option.values, " "));
    if (option.kind == ValueKind::folder) return " -x -a '(__fish_complete_directories)'";
    if (option.kind == ValueKind::word) return " -x";
    if (option.extensions.empty()) return " -r -F";
    return fmt::format(" -x -a '(__grafwire_files {})'", joined(option.extensions, " "));
}

/// `condition`: where the options stand; empty: everywhere.
void add_options(std::string& out, const CommandDescription& command,
                 const std::string& condition) {
    for (const OptionDescription& option : command.options) {
        out += "    complete -c grafwire" + condition;
        for (const std::string& name : option.names) {
            out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        }
        out += offer_for_fish(option) + " -d " + quoted_for_fish(first_line(option)) + '\n';
    }
}

void add_command(std::string& out, const PlacedCommand& placed) {
    const CommandDescription& command = *placed.command;
    const std::string condition = placed.path.empty()
                                      ? " -n __grafwire_at"
                                      : fmt::format(" -n '__grafwire_at {}'", placed.path);
    for (const CommandDescription& below : command.commands) {
        out += fmt::format("    complete -c grafwire{} -a {} -d {}\n", condition, below.name,
                           quoted_for_fish(below.summary));
    }
    std::vector<std::string> endings;
    for (const OptionDescription& argument : command.arguments) {
        endings.insert(endings.end(), argument.extensions.begin(), argument.extensions.end());
    }
    if (!endings.empty()) {
        out += fmt::format("    complete -c grafwire{} -a '(__grafwire_files {})'\n", condition,
                           joined(endings, " "));
    }
    add_options(out, command, condition);
}

void add_language(std::string& out, const CommandDescription& program) {
    for (const PlacedCommand& placed : placed_commands(program)) add_command(out, placed);
    // What has a value after the program may be written after every command.
    for (const OptionDescription& option : program.options) {
        if (option.value.empty()) continue;
        CommandDescription everywhere;
        everywhere.options.push_back(option);
        add_options(out, everywhere, "");
    }
}

}  // namespace

std::string fish_completion(const CommandDescription& english, const CommandDescription& french) {
    std::vector<std::string> with_others_below;
    for (const PlacedCommand& placed : placed_commands(english)) {
        if (!placed.path.empty() && !placed.command->commands.empty()) {
            with_others_below.push_back(placed.command->name);
        }
    }
    std::string out =
        fmt::format(head_of_fish_file, program_and_version(), joined(with_others_below, " "));
    out += "if string match -q 'fr*' -- \"$locale\"\n";
    add_language(out, french);
    out += "else\n";
    add_language(out, english);
    out += "end\n";
    return out;
}

}  // namespace grafwire
