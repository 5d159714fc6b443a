// All that the program says beside its results. A message exists in both languages until it gets
// here, where the language of the command line is known.

#include "command/standard_error.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "command/messages.h"
#include "text/messages.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

namespace say = messages::command;

/// A broken file can have very many errors; nobody reads more than these.
constexpr std::size_t most_errors = 100;

/// Messages may hold a list of all steps, say.
constexpr std::size_t most_of_message = 4000;

/// Who keeps the messages, if anybody does. Any part of a command may have one to show, so they are
/// caught where they leave the program. Checks that run at the same time have one each.
thread_local MessageRecord* record_of_messages = nullptr;

/// What goes to standard error is in one language, that of the command line.
Language language_of_messages = Language::english;

/// `grafwire: error: …`
void show_message(Severity severity, const Localized& message) {
    const bool is_error = severity == Severity::error;
    const Message<std::string>& labelled =
        is_error ? messages::text::error : messages::text::warning;
    if (record_of_messages != nullptr) {
        record_of_messages->add({}, {{severity, {}, {}, message, {}}});
    }
    const auto line_in = [&](Language language) {
        const std::string text = shortened(message.in(language), most_of_message);
        return fmt::format("grafwire: {}\n", labelled.in(language, visible(text, "\t\n")));
    };
    show({line_in(Language::english), line_in(Language::french)});
}

}  // namespace

MessageRecord::MessageRecord(Kind kind) : kind_(kind) {
    record_of_messages = this;
}

MessageRecord::~MessageRecord() {
    record_of_messages = nullptr;
}

void MessageRecord::add(const Localized& text) {
    text_.english += text.english;
    text_.french += text.french;
}

void MessageRecord::add(const SourceFile& source, std::vector<Diagnostic> messages) {
    if (!messages.empty()) messages_.push_back({source, std::move(messages)});
}

void show_messages_in(Language language) {
    language_of_messages = language;
}

void open_standard_error() {
    if (fcntl(STDERR_FILENO, F_GETFD) >= 0) return;
    const int nothing = open("/dev/null", O_WRONLY);
    if (nothing < 0 || nothing == STDERR_FILENO) return;
    dup2(nothing, STDERR_FILENO);
    close(nothing);
}

void show_raw(std::string_view text) {
    [[maybe_unused]] const std::size_t count = std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void show(const Localized& text) {
    if (record_of_messages != nullptr) record_of_messages->add(text);
    if (record_of_messages == nullptr || !record_of_messages->holds()) {
        show_raw(text.in(language_of_messages));
    }
}

void show_lines(const Localized& text) {
    show({text.english + "\n", text.french + "\n"});
}

void show_diagnostics(const Diagnostics& diagnostics, const SourceFile& source) {
    const auto text_in = [&](Language language) {
        return format_diagnostics(diagnostics, source, language, most_errors);
    };
    if (record_of_messages != nullptr) record_of_messages->add(source, diagnostics.items());
    show({text_in(Language::english), text_in(Language::french)});
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
    show_message(Severity::error, message);
}

void warn(const Localized& message) {
    show_message(Severity::warning, message);
}

void complain_of_memory() {
    const Message<>& message = say::not_enough_memory;
    const bool is_french = language_of_messages == Language::french;
    for (const fmt::string_view text :
         {fmt::string_view("grafwire: "),
          fmt::string_view(is_french ? message.french : message.english)}) {
        // Nobody is left to hear that this cannot be written.
        [[maybe_unused]] const ssize_t count = ::write(STDERR_FILENO, text.data(), text.size());
    }
}

ExitStatus finish(OutputFiles& files, ExitStatus status) {
    if (const auto problem = files.write()) {
        complain(*problem);
        return ExitStatus::bad_request;
    }
    return status;
}

}  // namespace grafwire
