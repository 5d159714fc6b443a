// The session itself (story/session.h) neither reads nor writes; here are its lines, its words and
// its files.

#include "command/step_by_step.h"

#include <fmt/format.h>

#include <cstdio>

#include "command/line_reader.h"
#include "command/messages.h"
#include "command/standard_error.h"
#include "command/terminal.h"
#include "story/session.h"
#include "text/utf8.h"
#include "text/wrapped.h"

namespace grafwire {

namespace {

namespace say = messages::command;

void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout);
}

/// Whether the file could be written.
bool save(const std::string& chart, const SessionReply& reply, Language language) {
    OutputFiles files({chart});
    files.add(reply.save_path, reply.save_stimuli);
    if (finish(files, ExitStatus::done) != ExitStatus::done) return false;
    print(say::saved.in(language, visible(reply.save_path)) + "\n");
    return true;
}

}  // namespace

ExitStatus step_by_step(const std::string& path, const Chart& chart, std::optional<Time> period,
                        Language language) {
    Session session(chart.grafcet, period, language);
    LineReader lines(session.beginnings());
    if (lines.is_terminal()) print(session.greeting());
    bool all_obeyed = true;
    while (const auto line = lines.next(session.prompt())) {
        const SessionReply reply = session.answer(*line);
        if (reply.is_over) break;
        if (reply.is_refusal) {
            std::string text = reply.text;
            while (text.ends_with('\n')) text.pop_back();
            complain(Localized::same_in_both(text));
            all_obeyed = false;
        } else if (!reply.save_path.empty()) {
            all_obeyed = save(path, reply, language) && all_obeyed;
        } else {
            print(wrapped(reply.text, width_of_output()));
        }
    }
    return all_obeyed || lines.is_terminal() ? ExitStatus::done : ExitStatus::bad_request;
}

}  // namespace grafwire
