#include "command/messages.h"

#include <fmt/format.h>

#include <cstdio>

#include "text/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// A broken file can have very many errors; nobody reads more than these.
constexpr std::size_t most_errors = 100;

/// Messages may hold a list of all steps, say.
constexpr std::size_t most_of_message = 4000;

/// Who keeps the messages, if anybody does. Any part of a command may have one to show, so they are
/// caught where they leave the program.
std::string* kept_messages = nullptr;

/// What goes to standard error is in one language, that of the command line.
Language language_of_messages = Language::english;

void show_message(const Message<>& kind, const std::string& message) {
    show(fmt::format("grafwire: {}: {}\n", kind.in(language_of_messages),
                     visible(shortened(message, most_of_message), "\t\n")));
}

}  // namespace

MessageRecord::MessageRecord() {
    kept_messages = &text_;
}

MessageRecord::~MessageRecord() {
    kept_messages = nullptr;
}

void show_messages_in(Language language) {
    language_of_messages = language;
}

void show(std::string_view text) {
    fmt::print(stderr, "{}", text);
    if (kept_messages != nullptr) *kept_messages += text;
}

void show_diagnostics(const Diagnostics& diagnostics, const SourceFile& source) {
    show(format_diagnostics(diagnostics, source, language_of_messages, most_errors));
}

void show_messages(const Diagnostics& messages) {
    for (const Diagnostic& item : messages.items()) {
        if (item.severity == Severity::error) {
            complain(item.message);
        } else {
            warn(item.message);
        }
    }
}

void complain(const Localized& message) {
    show_message(messages::text::error, message.in(language_of_messages));
}

void warn(const Localized& message) {
    show_message(messages::text::warning, message.in(language_of_messages));
}

ExitStatus finish(OutputFiles& files, ExitStatus status) {
    if (const auto problem = files.write()) {
        complain(*problem);
        return ExitStatus::bad_request;
    }
    return status;
}

}  // namespace grafwire
