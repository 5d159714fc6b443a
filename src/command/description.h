#pragma once

#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/message.h"

namespace grafwire {

struct Command;

/// What a value on the command line is.
enum class ValueKind {
    word,    ///< a word or a number
    file,    ///< the name of a file
    folder,  ///< the name of a folder
};

/// An option, or an argument without a name, as --help shows it.
struct OptionDescription {
    std::vector<std::string> names{};  ///< `-h`, `--help`; of an argument none
    std::string value{};               ///< what stands for its value: `TEXT`; of a flag nothing
    std::string help{};                ///< a sentence, and in lines below it the values it may have
    ValueKind kind = ValueKind::word;
    std::vector<std::string> extensions{};  ///< of files: `.io`; none: of any name
    std::vector<std::string> values{};      ///< the words it may be; none: others as well
    std::string default_value{};            ///< as help shows it; else nothing
    bool is_required = false;
    bool may_be_repeated = false;
};

/// What may be written after `grafwire`, or after a command, in one language: what --help shows,
/// for those who show it elsewhere.
struct CommandDescription {
    std::string name;     ///< `check`
    std::string summary;  ///< what it does
    std::string example;  ///< a request that works
    std::deque<OptionDescription> arguments;
    std::deque<OptionDescription> options;
    std::deque<CommandDescription> commands;  ///< one of these must be given, where there are any
};

/// The program with these commands. What is described is what is read: both come of one
/// declaration.
CommandDescription describe_program(std::span<const Command> commands, Language language);

}  // namespace grafwire
