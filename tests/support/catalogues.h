#pragma once

// The catalogues of the product, src/**/messages.h, read as text: so that a row is looked at even
// where no test makes the program say it.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace grafwire::testing {

struct CatalogueRow {
    std::string name;
    std::vector<std::string> texts;  ///< English, French; twice that where the row counts
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
    const std::size_t arguments = at;
    at = text.find('{', at);
    const std::size_t name = text.rfind('>', at) + 2;
    row.name = std::string(text.substr(name, at - name));
    row.counts = text.substr(arguments).starts_with("CountedMessage<");
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
        if (!rest.starts_with("Message<") && !rest.starts_with("CountedMessage<")) continue;
        CatalogueRow row = read_row(text, at);
        row.is_same_on_purpose =
            is_commented &&
            text.substr(comment, text.find('\n', comment + 1) - comment).find("same in both") !=
                text.npos;
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace grafwire::testing
