// A log is self-contained but for its files, which are named as a repository has them: relative to
// the folder that the program was called in, under the name %SRCROOT%, which servers take for the
// root of what they have checked out. Columns count UTF-16 code units from 1, which is what readers
// expect that do not look at `columnKind`; ours count characters.

#include "workflow/sarif.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "text/utf8.h"
#include "text/version.h"

namespace grafwire {

namespace {

using Json = nlohmann::ordered_json;

/// A text, in which places are found by line and column.
class Places {
  public:
    explicit Places(std::string_view text) : text_(text) {
        starts_.push_back(byte_order_mark_size(text));
        for (std::size_t at = starts_[0]; at < text.size(); ++at) {
            if (text[at] == '\n') starts_.push_back(at + 1);
        }
    }

    /// The region that begins there.
    Json region(Location where) const {
        if (!where.is_known() || where.line > starts_.size()) return {{"startLine", 1}};
        std::uint32_t column = 1;
        std::size_t at = starts_[where.line - 1];
        for (std::uint32_t c = 1; c < where.column && at < text_.size(); ++c) {
            const CodePoint point = decode_utf8(text_, at);
            column += point.value > 0xffff ? 2 : 1;
            at += std::max<std::size_t>(point.length, 1);
        }
        return {{"startLine", where.line}, {"startColumn", column}};
    }

  private:
    std::string_view text_;
    std::vector<std::size_t> starts_;  ///< of the lines
};

Json location(const std::string& uri, const Json& region) {
    Json artifact = {{"uri", uri}};
    if (!uri.starts_with("file://")) artifact["uriBaseId"] = "%SRCROOT%";
    return {{"physicalLocation", {{"artifactLocation", artifact}, {"region", region}}}};
}

Json result(const Diagnostic& message, const std::string& rule, std::size_t rule_index,
            const std::string& uri, const Places& places) {
    Json json;
    json["ruleId"] = rule;
    json["ruleIndex"] = rule_index;
    json["level"] = message.severity == Severity::error ? "error" : "warning";
    json["message"]["text"] = message.message.english;
    json["locations"] = Json::array({location(uri, places.region(message.where))});
    for (const Diagnostic::Note& note : message.notes) {
        Json related = location(uri, places.region(note.where));
        related["message"]["text"] = note.message.english;
        json["relatedLocations"].push_back(std::move(related));
    }
    return json;
}

/// Messages about the request have no code.
std::string rule_of(const Diagnostic& message) {
    return message.code.name.empty() ? "request" : std::string(message.code.name);
}

}  // namespace

std::string sarif_uri(std::string_view path, std::string_view folder) {
    if (!folder.empty() && path.starts_with(folder) &&
        path.substr(folder.size()).starts_with('/')) {
        path.remove_prefix(folder.size() + 1);
    }
    while (path.starts_with("./")) path.remove_prefix(2);
    std::string uri = path.starts_with('/') ? "file://" : "";
    for (const char c : path) {
        constexpr std::string_view plain = "/-._~";
        if (is_ascii_letter(c) || is_digit(c) || plain.find(c) != std::string_view::npos) {
            uri += c;
        } else {
            constexpr std::string_view digits = "0123456789ABCDEF";
            const auto byte = static_cast<unsigned char>(c);
            uri += '%';
            uri += digits[byte >> 4U];
            uri += digits[byte & 15U];
        }
    }
    return uri;
}

std::string write_sarif(std::span<const FileMessages> files, std::string_view folder,
                        std::string_view of_no_file) {
    std::set<std::string> names;
    for (const FileMessages& file : files) {
        for (const Diagnostic& message : file.messages) names.insert(rule_of(message));
    }
    const std::vector<std::string> rules(names.begin(), names.end());
    Json driver = {{"name", "grafwire"}, {"version", version()}, {"rules", Json::array()}};
    for (const std::string& rule : rules) driver["rules"].push_back({{"id", rule}});
    Json results = Json::array();
    std::set<std::string> known;
    for (const FileMessages& file : files) {
        const Places places(file.source.text);
        const std::string uri =
            sarif_uri(file.source.name.empty() ? of_no_file : file.source.name, folder);
        for (const Diagnostic& message : file.messages) {
            const std::string rule = rule_of(message);
            const auto index = static_cast<std::size_t>(
                std::lower_bound(rules.begin(), rules.end(), rule) - rules.begin());
            Json json = result(message, rule, index, uri, places);
            if (known.insert(json.dump(-1, ' ', false, Json::error_handler_t::replace)).second) {
                results.push_back(std::move(json));
            }
        }
    }
    Json run = {
        {"tool", {{"driver", driver}}}, {"columnKind", "utf16CodeUnits"}, {"results", results}};
    const Json log = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                      {"version", "2.1.0"},
                      {"runs", Json::array({run})}};
    return log.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grafwire
