// grafwire: from a GRAFCET (IEC 60848) to checked wiring.

#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

#include "command/command_line.h"
#include "command/commands.h"
#include "command/files.h"
#include "command/new_file.h"
#include "command/standard_error.h"

namespace {

using namespace grafwire;

Language language_of_locale() {
    for (const char* name : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(name);
        if (value == nullptr || *value == '\0') continue;
        return std::string_view(value).starts_with("fr") ? Language::french : Language::english;
    }
    return Language::english;
}

ExitStatus run(int argc, char** argv) {
    const Language language =
        language_asked_for({argv, static_cast<std::size_t>(argc)}, language_of_locale());
    show_messages_in(language);
    const ReadCommandLine line = read_command_line(argc, argv, all_commands(), language);
    ExitStatus status = ExitStatus::bad_request;
    if (line.action) {
        status = line.action();
    } else if (line.config_messages.has_errors()) {
        show_diagnostics(line.config_messages, line.config);
    } else if (!line.problem) {
        // Help and version are no errors, but results like any other.
        OutputFiles files({});
        files.add("-", line.help);
        status = finish(files, ExitStatus::done);
    } else {
        complain(*line.problem);
    }
    return status;
}

/// Memory has run out where no exception can go on: in a destructor, or while one is made.
[[noreturn]] void end_without_memory() {
    remove_unfinished_files();
    complain_of_memory();
    _exit(static_cast<int>(ExitStatus::bad_request));
}

/// Tables are made before main() begins, and they need memory too.
[[gnu::constructor(101)]] void prepare_for_want_of_memory() {
    std::set_terminate(end_without_memory);
}

}  // namespace

// No code of ours throws; what comes up to here is the want of memory, and on the way all that was
// begun has been undone.
int main(int argc, char** argv) {
    open_standard_error();
    ExitStatus status = ExitStatus::bad_request;
    try {
        status = run(argc, argv);
    } catch (const std::bad_alloc&) {
        complain_of_memory();
    } catch (const std::length_error&) {  // more than any memory could hold
        complain_of_memory();
    }
    return static_cast<int>(status);
}
