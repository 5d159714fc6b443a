#pragma once

#include <string>
#include <string_view>

#include "command/command_line.h"
#include "command/files.h"
#include "text/diagnostics.h"
#include "text/message.h"

namespace grafwire {

// What the program says on standard error. All of it goes through show().

/// Keeps what is shown on standard error while it lives, in English, as machines read it; one at a
/// time.
class MessageRecord {
  public:
    MessageRecord();
    ~MessageRecord();
    MessageRecord(const MessageRecord&) = delete;
    MessageRecord& operator=(const MessageRecord&) = delete;

    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

/// The language of all messages from now on; English before.
void show_messages_in(Language language);

/// To be called first. Where standard error is closed, a file of ours would else be opened in its
/// place, and messages would go there.
void open_standard_error();

/// Shows a text in one language as it stands. Where it cannot be written nobody is left to hear
/// that, and the program goes on.
void show_raw(std::string_view text);

/// Shows lines as they stand.
void show(const Localized& text);

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
