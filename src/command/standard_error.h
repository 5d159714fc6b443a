#pragma once

#include <string>

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
