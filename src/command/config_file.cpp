// The file is found from the charts and not from where the program is called: a server and a desk
// that call it in different folders get the same options.

#include "command/config_file.h"

#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include <filesystem>

#include "command/messages.h"
#include "command/path_pattern.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace fs = std::filesystem;
namespace say = messages::command;

constexpr const char* config_name = "grafwire.toml";

/// The folder that a word is about.
fs::path folder_of(const std::string& word) {
    std::error_code error;
    if (word == "-") return ".";
    if (fs::is_directory(word, error)) return word;
    fs::path folder;
    for (const fs::path& part : fs::path(word).parent_path()) {
        if (has_wildcards(part.string()) && !fs::exists(folder / part, error)) break;
        folder /= part;
    }
    return folder.empty() ? "." : folder;
}

Location place_of(const toml::source_region& region) {
    return {region.begin.line, region.begin.column};
}

/// One value as a word of the command line; none where it can be none.
std::optional<std::string> word_for(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* number = node.as_integer()) return std::to_string(number->get());
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
    return std::nullopt;
}

/// Empty, and told, where the value is of no kind that an option takes.
std::optional<SharedOption> read_option(const toml::key& key, const toml::node& node,
                                        Diagnostics& diagnostics) {
    SharedOption option;
    const std::string name(key.str());
    option.name = (name.size() == 1 ? "-" : "--") + name;
    option.where = place_of(key.source());
    bool is_good = true;
    const auto add = [&](const toml::node& value) {
        if (const auto word = word_for(value)) {
            option.values.push_back(*word);
        } else {
            is_good = false;
        }
    };
    if (const auto* truth = node.as_boolean()) {
        option.truth = truth->get();
    } else if (const auto* list = node.as_array()) {
        for (const toml::node& value : *list) add(value);
        is_good = is_good && !list->empty();
    } else {
        add(node);
    }
    if (is_good) return option;
    diagnostics.error(code::bad_config, place_of(node.source()),
                      say::no_value_of_option(visible(option.name)));
    return std::nullopt;
}

/// A path from here, or from the root, whichever is shorter to read.
std::string shorter_path(const fs::path& path) {
    std::error_code error;
    const std::string from_here = path.lexically_proximate(fs::current_path(error)).string();
    return from_here.size() < path.string().size() ? from_here : path.string();
}

}  // namespace

std::string config_file_for(const std::string& word) {
    std::error_code error;
    fs::path folder = fs::absolute(folder_of(word), error).lexically_normal();
    if (folder.filename().empty()) folder = folder.parent_path();  // `charts/`
    while (!error) {
        if (fs::is_regular_file(folder / config_name, error)) {
            return shorter_path(folder / config_name);
        }
        if (fs::exists(folder / ".git", error) || folder == folder.parent_path()) break;
        folder = folder.parent_path();
        error.clear();
    }
    return {};
}

std::vector<SharedOptions> read_config(const SourceFile& source, Diagnostics& diagnostics) {
    if (!check_utf8(source.text, diagnostics)) return {};
    const toml::parse_result result = toml::parse(source.text);
    if (!result) {
        const toml::parse_error& error = result.error();
        diagnostics.error(code::bad_config, place_of(error.source()),
                          say::no_toml(std::string(error.description())));
        return {};
    }
    std::vector<SharedOptions> all;
    for (const auto& [key, node] : result.table()) {
        const auto* table = node.as_table();
        if (table == nullptr) {
            diagnostics.error(code::bad_config, place_of(key.source()),
                              say::option_below_no_command(visible(key.str())));
            continue;
        }
        SharedOptions& of_command = all.emplace_back();
        of_command.command = key.str();
        of_command.where = place_of(key.source());
        for (const auto& [name, value] : *table) {
            if (auto option = read_option(name, value, diagnostics)) {
                of_command.options.push_back(std::move(*option));
            }
        }
    }
    return all;
}

}  // namespace grafwire
