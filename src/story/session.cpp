// Every line that has an effect leaves the moment before it behind, whole, so that `back` cannot go
// wrong. What was applied is kept as stimuli: a run over them goes through the same instants.
//
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
#include "text/trimmed.h"
#include "text/utf8.h"
#include "trace/input_values.h"

namespace grafwire {

namespace {

namespace words = messages::story;

/// Of one line; a longer way is gone in several.
constexpr std::size_t most_instants = 100'000;
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
    : grafcet_(grafcet), evolution_(grafcet), period_(period), language_(language) {
    moment_.inputs.assign(grafcet.all_input_count(), 0);
}

std::string Session::greeting() const {
    std::vector<std::string_view> inputs;
    for (const Input& input : grafcet_.inputs) inputs.push_back(input.name);
    return words::greeting.in(language_, grafcet_.name, fmt::format("{}", fmt::join(inputs, ", ")));
}

std::string Session::prompt() const {
    return fmt::format("{} ms> ", format_milliseconds(moment_.now));
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
            return said((period_ ? words::session_help_scans : words::session_help).in(language_));
        case Word::quit:
            break;
    }
    SessionReply reply;
    reply.is_over = true;
    return reply;
}

SessionReply Session::scan() {
    if (period_) return advance(next_scan(), {}, true);
    if (!moment_.run.state) return advance(0, {}, true);
    const Time next = moment_.run.next_delay_end();
    if (next == never && !is_stuck()) return refused(words::no_delay_runs.in(language_));
    return advance(next, {}, false);
}

SessionReply Session::back() {
    if (past_.empty()) return refused(words::nothing_to_take_back.in(language_));
    moment_ = std::move(past_.back());
    past_.pop_back();
    changes_.resize(moment_.change_count);
    return said(shown());
}

/// By scans, inputs that no scan has read yet are left to the next one.
SessionReply Session::save(std::string_view path) const {
    if (path.empty()) return refused(words::save_needs_path.in(language_));
    Stimuli stimuli{changes_, moment_.now};
    if (period_ && moment_.inputs != moment_.run.inputs) {
        const InputValues all_0(moment_.inputs.size(), 0);
        const InputValues& before = moment_.run.state ? moment_.run.inputs : all_0;
        Stimuli::Change change{next_scan(), {}};
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before[i] == moment_.inputs[i]) continue;
            change.assignments.push_back({static_cast<std::uint32_t>(i), moment_.inputs[i] != 0});
        }
        stimuli.end = change.at;
        if (!change.assignments.empty()) stimuli.changes.push_back(std::move(change));
    }
    SessionReply reply;
    reply.save_path = path;
    reply.save_stimuli = write_stimuli(stimuli, grafcet_);
    return reply;
}

SessionReply Session::change(std::string_view line) {
    const bool has_time = line.front() == '+' || is_digit(line.front());
    if (!has_time && line.find('=') == std::string_view::npos) {
        return refused(words::unknown_line.in(language_, visible(shortened(line))));
    }
    const bool is_first = !moment_.run.state;
    std::string text = fmt::format("{} :\n", format_duration(moment_.now));
    if (has_time) {
        text += with_colon(line);
    } else {
        text += fmt::format("+{} : {}",
                            format_duration(is_first || period_ ? 0 : until_next_change), line);
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
    const bool is_same_time = read->end == moment_.now;
    if (is_same_time && !is_first && !period_) {
        return refused(words::instant_is_over.in(language_, format_milliseconds(moment_.now)));
    }
    return advance(read->end, assignments, !period_);
}

/// `has_instant`: at the end of the way there is one in any case.
SessionReply Session::advance(Time to, const std::vector<Stimuli::Assignment>& assignments,
                              bool has_instant) {
    if (is_stuck()) return refused(words::no_way_on.in(language_));
    Moment before = moment_;
    std::vector<InstantStory> stories;
    std::size_t count = 0;
    const auto next = [&] {
        if (period_) return next_scan();
        return moment_.run.state ? moment_.run.next_delay_end() : Time{0};
    };
    while (next() < to && !is_stuck() && count++ < most_instants) {
        do_instant(next(), !moment_.run.state, stories);
    }
    std::string remark;
    if (count > most_instants) {
        remark = words::long_way.in(language_, format_milliseconds(moment_.now));
    } else if (!is_stuck()) {
        for (const Stimuli::Assignment& set : assignments) moment_.inputs[set.input] = set.value;
        const bool is_scan = period_ && next() == to && (has_instant || to != before.now);
        if (is_scan || !period_) do_instant(to, has_instant, stories);
        moment_.now = to;
    }
    past_.push_back(std::move(before));
    if (period_ && moment_.inputs != moment_.run.inputs && remark.empty() && !is_stuck()) {
        remark = words::read_by_next_scan.in(language_, format_milliseconds(next_scan()));
    }
    const bool has_new_inputs = !assignments.empty() || past_.size() == 1;
    std::string text = write_stories(grafcet_, stories, language_);
    if (has_new_inputs) text += broken_assumptions();
    return said(text + remark);
}

/// `is_asked`: the user has named the instant, so it is one of the stimuli even where no input
/// changes; those at which delays end come by themselves.
void Session::do_instant(Time at, bool is_asked, std::vector<InstantStory>& stories) {
    InstantStory story =
        tell_instant(evolution_, moment_.run, moment_.inputs, at, period_.has_value());
    if (!story.inputs.empty() || (is_asked && !period_)) {
        changes_.push_back({at, story.inputs});
    }
    moment_.change_count = changes_.size();
    moment_.now = at;
    moment_.last = story;
    add_story(stories, std::move(story));
}

/// A line for each that the inputs break, as they are now.
std::string Session::broken_assumptions() const {
    std::string text;
    for (std::size_t i = 0; i < grafcet_.assumptions.size(); ++i) {
        if (assumption_holds(grafcet_, i, moment_.inputs)) continue;
        text += words::breaks_assumption.in(
            language_,
            write_expression(grafcet_, grafcet_.expressions, grafcet_.assumptions[i].expression));
    }
    return text;
}

std::string Session::shown() const {
    if (!moment_.last) return words::not_begun.in(language_);
    std::vector<std::string_view> inputs;
    for (std::size_t i = 0; i < moment_.inputs.size(); ++i) {
        if (moment_.inputs[i] != 0) inputs.push_back(input_name(grafcet_, i));
    }
    const std::string list = inputs.empty() ? words::no_output.in(language_)
                                            : fmt::format("{}", fmt::join(inputs, ", "));
    return words::shown_at.in(language_, format_milliseconds(moment_.now), list) +
           write_end(grafcet_, *moment_.last, language_);
}

}  // namespace grafwire
