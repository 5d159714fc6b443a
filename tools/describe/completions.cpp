#include "describe/completions.h"

namespace grafwire {

namespace {

void place(const CommandDescription& command, const std::string& path,
           std::vector<PlacedCommand>& placed) {
    placed.push_back({path, &command});
    for (const CommandDescription& below : command.commands) {
        place(below, path.empty() ? below.name : path + ' ' + below.name, placed);
    }
}

}  // namespace

std::vector<PlacedCommand> placed_commands(const CommandDescription& program) {
    std::vector<PlacedCommand> placed;
    place(program, "", placed);
    return placed;
}

std::string first_line(const OptionDescription& option) {
    return option.help.substr(0, option.help.find('\n'));
}

std::string shell_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'') {
            out += "'\\''";
        } else {
            out += c;
        }
    }
    return out + '\'';
}

}  // namespace grafwire
