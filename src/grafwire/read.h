#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace grafwire::api {

/// The language of messages and reports for people.
enum class Language { english, french };

/// Something to be said of a text, or of what was asked for.
struct Message {
    enum class Severity { warning, error };
    Severity severity = Severity::error;
    std::string text;          ///< in English
    std::string french;        ///< the same in French
    std::uint32_t line = 0;    ///< from 1; 0: it is about the whole
    std::uint32_t column = 0;  ///< in characters, from 1

    const std::string& text_in(Language language) const {
        return language == Language::french ? french : text;
    }
};

/// The messages as compilers show them, a line each: `chart.grafcet:5:12: error: …`.
std::string shown(const std::vector<Message>& messages, std::string_view file,
                  Language language = Language::english);

/// A value, or the errors for which there is none. Warnings come with a value as well.
template <typename Value>
struct Result {
    std::optional<Value> value;
    std::vector<Message> messages;

    explicit operator bool() const { return value.has_value(); }
};

/// A GRAFCET. Copies are cheap and share it; it never changes.
class Chart {
  public:
    std::string name() const;
    std::vector<std::string> steps() const;   ///< in the order of the text
    std::vector<std::string> inputs() const;  ///< without Init, AUdur and AUdoux
    std::vector<std::string> outputs() const;

    struct Parts;  ///< of the library
    explicit Chart(std::shared_ptr<const Parts> parts) : parts_(std::move(parts)) {}
    const Parts& parts() const { return *parts_; }

  private:
    std::shared_ptr<const Parts> parts_;  ///< never null
};

/// Reads a GRAFCET in the `.grafcet` language. `name`: what reports call the text, such as the path
/// of its file.
Result<Chart> read_chart(std::string text, std::string name);

}  // namespace grafwire::api
