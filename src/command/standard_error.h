#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command/command_line.h"
#include "command/files.h"
#include "text/diagnostics.h"
#include "text/file_messages.h"
#include "text/message.h"

namespace grafwire {

// What the program says on standard error. All of it goes through show().

/// Keeps what a thread has to say on standard error while it lives; one at a time in each thread.
class MessageRecord {
  public:
    enum class Kind {
        shown,  ///< it is shown all the same
        held    ///< it is not, and waits for who shows it
    };
    explicit MessageRecord(Kind kind = Kind::shown);
    ~MessageRecord();
    MessageRecord(const MessageRecord&) = delete;
    MessageRecord& operator=(const MessageRecord&) = delete;

    /// As it is shown.
    const Localized& text() const { return text_; }
    /// Message by message, with the texts that they are about; one about no text has none.
    const std::vector<FileMessages>& messages() const { return messages_; }

    // For what shows.
    bool holds() const { return kind_ == Kind::held; }
    void add(const Localized& text);
    void add(const SourceFile& source, std::vector<Diagnostic> messages);

  private:
    Kind kind_;
    Localized text_;
    std::vector<FileMessages> messages_;
};

/// The language of all messages from now on; English before.
void show_messages_in(Language language);

/// To be called first. Where standard error is closed, a file of ours would else be opened in its
/// place, and messages would go there.
void open_standard_error();

/// Shows a text in one language as it stands. Where it cannot be written nobody is left to hear
/// that, and the program goes on.
void show_raw(std::string_view text);

/// Shows lines as they stand; the last has no line end in show_lines().
void show(const Localized& text);
void show_lines(const Localized& text);

/// Shows messages about a text, the first of many.
void show_diagnostics(const Diagnostics& diagnostics, const SourceFile& source);

/// Shows messages about the request as a whole, which have no place.
void show_messages(const Diagnostics& messages);

/// Shows a message of the program itself.
void complain(const Localized& message);
void warn(const Localized& message);

/// Says that there is not enough memory, without needing any.
void complain_of_memory();

/// Writes the files; a problem is shown, and turns `status` into bad_request.
ExitStatus finish(OutputFiles& files, ExitStatus status);

}  // namespace grafwire
