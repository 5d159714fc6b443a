#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "text/message.h"
#include "text/source.h"

namespace grafwire {

/// An error keeps the text from becoming what it should be; a warning does not.
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

}  // namespace grafwire
