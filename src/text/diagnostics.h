#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/location.h"
#include "text/message.h"

namespace grafwire {

/// The text of one input, with the name to show in messages ("-" is shown as "<stdin>").
struct SourceFile {
    std::string name;
    std::string text;
};

enum class Severity { warning, error };

/// What a diagnostic is about; tests and tools match on this, never on the wording. Each folder
/// lists its own codes in its messages.h.
struct Code {
    std::string_view name;

    friend bool operator==(Code, Code) = default;
};

/// What readers of every kind of text may find.
namespace code {
inline constexpr Code unreadable_file{"unreadable-file"};
inline constexpr Code not_utf8{"not-utf8"};
inline constexpr Code unexpected_character{"unexpected-character"};
inline constexpr Code unexpected_token{"unexpected-token"};
inline constexpr Code unterminated_text{"unterminated-text"};
inline constexpr Code number_too_large{"number-too-large"};
inline constexpr Code nested_too_deep{"nested-too-deep"};
inline constexpr Code unknown_name{"unknown-name"};
inline constexpr Code duplicate_name{"duplicate-name"};
}  // namespace code

/// One message with its place. Notes name the other parties (the earlier declaration, the other
/// action, …) and may lie anywhere in the same file.
struct Diagnostic {
    Severity severity = Severity::error;
    Code code;
    Location where;
    Localized message;

    struct Note {
        Location where;
        Localized message;
    };
    std::vector<Note> notes;
};

/// All that is to be said about one source file.
class Diagnostics {
  public:
    /// Both return the diagnostic so that notes can be added to it; the reference lives until the
    /// next call.
    Diagnostic& error(Code code, Location where, Localized message);
    Diagnostic& warning(Code code, Location where, Localized message);

    bool has_errors() const { return error_count_ != 0; }
    std::size_t error_count() const { return error_count_; }
    const std::vector<Diagnostic>& items() const { return items_; }

    /// Puts the messages in the order of their places; those without a place come first.
    void sort_by_place();

  private:
    std::vector<Diagnostic> items_;
    std::size_t error_count_ = 0;
};

/// The messages as shown to people: `file:line:column: error: message`, the source line, a caret
/// under the column, then the notes in the same form. At most `limit` errors and as many warnings
/// are shown, followed by counts of the rest; 0 shows all.
std::string format_diagnostics(const Diagnostics& diagnostics, const SourceFile& source,
                               Language language = Language::english, std::size_t limit = 0);

/// The declared name nearest to a mistyped one, or empty where none is near enough to suggest: a
/// third of its characters may differ, or one of two. Of equally near names the first is taken.
std::string_view nearest_name(std::string_view mistyped,
                              const std::vector<std::string_view>& names);

/// Reports (as code::not_utf8, with its place) the first byte at which `text` is not UTF-8.
/// Returns whether the text is well-formed.
bool check_utf8(std::string_view text, Diagnostics& diagnostics);

}  // namespace grafwire
