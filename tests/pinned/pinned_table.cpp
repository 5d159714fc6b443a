#include "pinned/pinned_table.h"

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <fstream>

#include "support/reviewed_file.h"
#include "text/version.h"

namespace grafwire::testing {

namespace {

/// Between the key of a line and the rest of it.
constexpr std::string_view separator = " | ";
/// Of a text that differs, this much is shown.
constexpr std::size_t shown_bytes = 20'000;

}  // namespace

PinnedTable::PinnedTable(std::string name) : name_("pinned/" + std::move(name)) {
    if (renews_reviewed_files()) return;
    for (const std::string& line : reviewed_lines(name_)) {
        const std::size_t at = line.find(separator);
        REQUIRE_MESSAGE(at != std::string::npos, name_ << ": " << line);
        expected_.emplace(line.substr(0, at), line.substr(at + separator.size()));
    }
}

std::string of_any_version(std::string text) {
    const std::string program = program_and_version();
    for (const std::string& line : {"<!-- " + program + " -->\n", "[*] " + program + '\n'}) {
        for (std::size_t at = 0; (at = text.find(line, at)) != std::string::npos;)
            text.erase(at, line.size());
    }
    const std::string number = program.substr(program.find(' '));
    for (std::size_t at = 0; (at = text.find(program, at)) != std::string::npos;)
        text.erase(at + program.size() - number.size(), number.size());
    return text;
}

void PinnedTable::add(const std::string& key, const PinnedCase& pinned) {
    const std::string rest =
        fmt::format("{} | {}", pinned.summary, digest(of_any_version(pinned.text)));
    ++count_;
    if (renews_reviewed_files()) {
        lines_ += fmt::format("{}{}{}\n", key, separator, rest);
        return;
    }
    const auto found = expected_.find(key);
    if (found == expected_.end()) {
        FAIL_CHECK(name_ << " has no case " << key);
    } else if (found->second != rest) {
        FAIL_CHECK(name_ << ": " << key << "\nwas: " << found->second << "\nis:  " << rest << "\n"
                         << pinned.text.substr(0, shown_bytes));
    }
}

void PinnedTable::finish(bool is_whole) {
    CHECK(count_ != 0);
    if (renews_reviewed_files()) {
        REQUIRE_MESSAGE(is_whole, name_ << " is written by a build that tries every case");
        std::ofstream(std::string(GRAFWIRE_ROOT) + "/tests/" + name_, std::ios::binary) << lines_;
    } else if (is_whole) {
        CHECK_MESSAGE(count_ == expected_.size(), name_ << " has cases that are tried no more");
    }
}

std::string digest(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char byte : text) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    return fmt::format("{:016x}", hash);
}

}  // namespace grafwire::testing
