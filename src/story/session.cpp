// Lines that change inputs are read by the reader of `.stim` texts, as the second line of a text
// whose first one says what time it is. So a session and a file take the same notation, and the
// same things are refused in the same words.

#include "story/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "grafcet/write_grafcet.h"
#include "story/messages.h"
#include "story/write_story.h"
#include "text/joined.h"
#include "text/trimmed.h"
#include "text/utf8.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

namespace words = messages::story;

constexpr Time until_next_change = millisecond;

/// Cuts off the first word of a line.
std::string_view take_word(std::string_view& line) {
    const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
    const std::string_view word = line.substr(0, end);
    line = trimmed(line.substr(end));
    return word;
}

/// A line as it stands in a `.stim` text: with a colon behind its time.
std::string with_colon(std::string_view line) {
    const std::size_t time_end = std::min(line.find_first_of(" \t:"), line.size());
    const std::string_view rest = trimmed(line.substr(time_end));
    return fmt::format("{} :{}{}", line.substr(0, time_end), rest.starts_with(':') ? "" : " ",
                       rest.starts_with(':') ? rest.substr(1) : rest);
}

SessionReply refused(std::string text) {
    SessionReply reply;
    reply.text = std::move(text);
    reply.is_refusal = true;
    return reply;
}

SessionReply said(std::string text) {
    SessionReply reply;
    reply.text = std::move(text);
    return reply;
}

}  // namespace

Session::Session(const Grafcet& grafcet, std::optional<Time> period, Language language)
    : grafcet_(grafcet), language_(language), run_(grafcet, period) {}

std::string Session::greeting() const {
    std::vector<std::string_view> inputs;
    for (const Input& input : grafcet_.inputs) inputs.push_back(input.name);
    return words::greeting.in(language_, grafcet_.name, joined(inputs, ", "));
}

std::string Session::prompt() const {
    return fmt::format("{} ms> ", format_milliseconds(run_.now()));
}

std::vector<std::string> Session::beginnings() const {
    std::vector<std::string> result;
    for (const auto& word : words::session_words) result.push_back(word.in(language_));
    for (std::size_t i = 0; i < grafcet_.all_input_count(); ++i) {
        result.push_back(fmt::format("{}=", quoted_where_needed(input_name(grafcet_, i))));
    }
    return result;
}

/// `scan=1` changes an input of that name.
std::optional<Session::Word> Session::command_of(std::string_view line,
                                                 std::string_view& rest) const {
    const std::string_view word = take_word(line);
    if (line.starts_with('=')) return std::nullopt;
    rest = line;
    for (std::size_t i = 0; i < std::size(words::session_words); ++i) {
        const auto& names = words::session_words[i];
        if (word == names.in(Language::english) || word == names.in(language_)) {
            return static_cast<Word>(i);
        }
    }
    return std::nullopt;
}

SessionReply Session::answer(std::string_view line) {
    line = trimmed(line);
    if (line.empty() || line.starts_with('#')) return {};
    std::string_view rest;
    if (const auto word = command_of(line, rest)) return obey(*word, rest);
    return change(line);
}

SessionReply Session::obey(Word word, std::string_view rest) {
    if (word != Word::save && !rest.empty()) {
        return refused(words::nothing_follows.in(language_, visible(rest)));
    }
    switch (word) {
        case Word::scan:
            return scan();
        case Word::back:
            return back();
        case Word::show:
            return said(shown());
        case Word::save:
            return save(rest);
        case Word::help:
            return said(
                (run_.period() ? words::session_help_scans : words::session_help).in(language_));
        case Word::quit:
            break;
    }
    SessionReply reply;
    reply.is_over = true;
    return reply;
}

SessionReply Session::scan() {
    const Time next = run_.next_instant();
    if (run_.period() || !run_.has_begun()) return advance(next, {}, true);
    if (next == never && !run_.is_stuck()) return refused(words::no_delay_runs.in(language_));
    return advance(next, {}, false);
}

SessionReply Session::back() {
    if (!run_.can_go_back()) return refused(words::nothing_to_take_back.in(language_));
    run_.go_back();
    return said(shown());
}

SessionReply Session::save(std::string_view path) const {
    if (path.empty()) return refused(words::save_needs_path.in(language_));
    SessionReply reply;
    reply.save_path = path;
    reply.save_stimuli = write_stimuli(run_.stimuli(), grafcet_);
    return reply;
}

SessionReply Session::change(std::string_view line) {
    const bool has_time = line.front() == '+' || is_digit(line.front());
    if (!has_time && line.find('=') == std::string_view::npos) {
        return refused(words::unknown_line.in(language_, visible(shortened(line))));
    }
    const bool is_first = !run_.has_begun();
    std::string text = fmt::format("{} :\n", format_duration(run_.now()));
    if (has_time) {
        text += with_colon(line);
    } else {
        text += fmt::format(
            "+{} : {}", format_duration(is_first || run_.period() ? 0 : until_next_change), line);
    }
    Diagnostics diagnostics;
    const auto read = parse_stimuli({"", text}, grafcet_, diagnostics);
    if (!read) {
        const Diagnostic& first = diagnostics.items().front();
        return refused(first.message.in(language_) + '\n');
    }
    const Stimuli::Change& last = read->changes.back();  // an `end` changes no input
    const auto assignments =
        last.at == read->end ? last.assignments : std::vector<Stimuli::Assignment>();
    const bool is_same_time = read->end == run_.now();
    if (is_same_time && !is_first && !run_.period()) {
        return refused(words::instant_is_over.in(language_, format_milliseconds(run_.now())));
    }
    return advance(read->end, assignments, !run_.period());
}

SessionReply Session::advance(Time to, const std::vector<Stimuli::Assignment>& assignments,
                              bool has_instant) {
    if (run_.is_stuck()) return refused(words::no_way_on.in(language_));
    const bool has_new_inputs = !assignments.empty() || run_.step_count() == 0;
    std::vector<InstantStory> stories;
    const bool is_done = run_.advance(to, assignments, has_instant, [&](InstantStory story) {
        add_story(stories, std::move(story));
    });
    std::string text = write_stories(grafcet_, stories, language_);
    if (has_new_inputs) text += broken_assumptions();
    if (!is_done) {
        text += words::long_way.in(language_, format_milliseconds(run_.now()));
    } else if (run_.period() && run_.has_unread_inputs() && !run_.is_stuck()) {
        text += words::read_by_next_scan.in(language_, format_milliseconds(run_.next_scan()));
    }
    return said(text);
}

/// A line for each that the inputs break, as they are now.
std::string Session::broken_assumptions() const {
    std::string text;
    for (const std::size_t broken : run_.broken_assumptions()) {
        text += words::breaks_assumption.in(
            language_, write_expression(grafcet_, grafcet_.expressions,
                                        grafcet_.assumptions[broken].expression));
    }
    return text;
}

std::string Session::shown() const {
    if (!run_.last()) return words::not_begun.in(language_);
    std::vector<std::string_view> inputs;
    for (std::size_t i = 0; i < run_.inputs().size(); ++i) {
        if (run_.inputs()[i] != 0) inputs.push_back(input_name(grafcet_, i));
    }
    const std::string list = inputs.empty() ? words::no_output.in(language_) : joined(inputs, ", ");
    return words::shown_at.in(language_, format_milliseconds(run_.now()), list) +
           write_end(grafcet_, *run_.last(), language_);
}

}  // namespace grafwire
