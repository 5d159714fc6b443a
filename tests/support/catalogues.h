#pragma once

// The catalogues of the product read as text: so that a row is looked at even where no test makes
// the program say it. A catalogue is a header of src with rows `inline constexpr Message<…> name{`:
// messages.h of a folder, and what several folders share.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace grafwire::testing {

struct CatalogueRow {
    std::string name;                ///< of an array of messages with `[]`
    std::vector<std::string> texts;  ///< English, French; twice that where the row counts
    std::string type;                ///< `Message<std::size_t, Localized>`, or an alias
    std::string comment;             ///< the line above it, if that is a comment
    bool counts = false;
    bool is_same_on_purpose = false;
};

/// Reads the literal that begins at `at`, which ends behind it.
inline std::string read_literal(std::string_view text, std::size_t& at) {
    std::string result;
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        if (text[at] != '\\') {
            result += text[at];
            continue;
        }
        ++at;
        result += text[at] == 'n' ? '\n' : text[at] == 't' ? '\t' : text[at];
    }
    ++at;
    return result;
}

/// Literals that stand side by side are one text, as for the compiler.
inline CatalogueRow read_row(std::string_view text, std::size_t& at) {
    CatalogueRow row;
    const std::size_t type = at;
    at = text.find('{', at);
    const std::size_t name_end = text.find_last_not_of(" =", at - 1) + 1;
    const std::size_t name = text.find_last_of(" \n", name_end - 1) + 1;
    row.name = std::string(text.substr(name, name_end - name));
    row.type = std::string(text.substr(type, name - 1 - type));
    row.counts = row.type.starts_with("CountedMessage<");
    bool goes_on = false;
    while (at < text.size() && text[at] != ';') {
        if (text[at] == '"') {
            if (!goes_on) row.texts.emplace_back();
            row.texts.back() += read_literal(text, at);
            goes_on = true;
            continue;
        }
        if (text[at] == ',' || text[at] == '{' || text[at] == '}') goes_on = false;
        ++at;
    }
    return row;
}

/// The rows of one catalogue, in order.
inline std::vector<CatalogueRow> rows_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), {});
    constexpr std::string_view beginning = "inline constexpr ";
    std::vector<CatalogueRow> rows;
    for (std::size_t at = text.find(beginning); at != text.npos; at = text.find(beginning, at)) {
        const std::size_t comment = text.rfind("\n/// ", at);
        const bool is_commented = comment != text.npos && text.find('\n', comment + 1) + 1 == at;
        at += beginning.size();
        const std::string_view rest = std::string_view(text).substr(at);
        const std::string_view type = rest.substr(0, rest.find_first_of("< "));
        if (!type.ends_with("Message")) continue;
        CatalogueRow row = read_row(text, at);
        if (is_commented) {
            row.comment = text.substr(comment, text.find('\n', comment + 1) - comment);
        }
        row.is_same_on_purpose = row.comment.find("same in both") != row.comment.npos;
        rows.push_back(std::move(row));
    }
    return rows;
}

struct Catalogue {
    std::filesystem::path path;
    std::vector<CatalogueRow> rows;
};

/// All of them, in the order of their paths.
inline std::vector<Catalogue> all_catalogues() {
    std::vector<Catalogue> catalogues;
    const std::filesystem::path root = std::filesystem::path(GRAFWIRE_ROOT) / "src";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".h") continue;
        std::vector<CatalogueRow> rows = rows_of(entry.path());
        if (!rows.empty()) catalogues.push_back({entry.path(), std::move(rows)});
    }
    std::sort(catalogues.begin(), catalogues.end(),
              [](const Catalogue& a, const Catalogue& b) { return a.path < b.path; });
    return catalogues;
}

}  // namespace grafwire::testing
