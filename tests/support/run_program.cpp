#include "support/run_program.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

namespace grafwire::testing {

namespace {

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
}

std::string name_of(const std::string& variable) {
    return variable.substr(0, variable.find('='));
}

std::vector<std::string> environment_with(std::vector<std::string> changes) {
    const auto sets = [&](const std::string& name) {
        return std::any_of(changes.begin(), changes.end(),
                           [&](const std::string& item) { return name_of(item) == name; });
    };
    if (!sets("LC_ALL")) changes.emplace_back("LC_ALL=C");
    std::vector<std::string> result = changes;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        if (!sets(name_of(*variable))) result.emplace_back(*variable);
    }
    return result;
}

}  // namespace

Ran run_program(const std::vector<std::string>& command, const std::string& input,
                const std::vector<std::string>& environment) {
    // Files instead of pipes: nothing can wait for anything then.
    const ScratchFolder folder;
    const std::string in = folder.file("in", input);
    const std::string out = folder.path("out");
    const std::string err = folder.path("err");
    posix_spawn_file_actions_t actions;
    REQUIRE(posix_spawn_file_actions_init(&actions) == 0);
    posix_spawn_file_actions_addopen(&actions, 0, in.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT, 0644);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT, 0644);
    std::vector<std::string> arguments = command;
    std::vector<std::string> variables = environment_with(environment);
    pid_t child = 0;
    const int problem = posix_spawnp(&child, arguments.front().c_str(), &actions, nullptr,
                                     pointers_to(arguments).data(), pointers_to(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    if (problem != 0) {
        FAIL("cannot run '" << command.front()
                            << "' (is it installed?): " << std::string(strerror(problem)));
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(out),
            text_of(err)};
}

Ran grafwire_with(std::vector<std::string> arguments, const std::string& input,
                  const std::vector<std::string>& environment) {
    arguments.insert(arguments.begin(), GRAFWIRE_PROGRAM);
    return run_program(arguments, input, environment);
}

std::vector<std::string> choices_of(const std::string& command, const std::string& option) {
    const std::string help = grafwire_with({command, "--help"}).out;
    const std::size_t entry = help.find("\n  " + option + " ");
    REQUIRE(entry != std::string::npos);
    const std::size_t next = std::min(help.find("\n  -", entry + 1), help.find("\n\n", entry));
    const std::string text = help.substr(entry, next - entry);
    // `{a,b,c}` behind its name, or `a: description`, a line each.
    std::vector<std::string> choices;
    const std::size_t begin = text.find('{');
    if (begin != std::string::npos) {
        std::istringstream list(text.substr(begin + 1, text.find('}') - begin - 1));
        for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
        return choices;
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t word = std::min(line.find_first_not_of(' '), line.size());
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos || line.find(' ', word) < colon) continue;
        choices.push_back(line.substr(word, colon - word));
    }
    REQUIRE(!choices.empty());
    return choices;
}

ScratchFolder::ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "grafwire-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    folder_ = name;
}

ScratchFolder::~ScratchFolder() {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
}

std::string ScratchFolder::file(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
}

std::vector<std::string> ScratchFolder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace grafwire::testing
