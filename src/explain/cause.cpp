#include "explain/cause.h"

#include "explain/messages.h"

namespace grafwire {

namespace {

namespace words = messages::explain;

struct CauseRow {
    CauseKind kind;
    std::string_view identifier;
    const words::CauseMessage& text;
    const words::CauseMessage& remedy;
};

constexpr CauseRow rows[] = {
    {CauseKind::two_step_loop, "two-step-loop", words::two_step_loop, words::two_step_loop_remedy},
    {CauseKind::two_tokens, "two-tokens", words::two_tokens, words::two_tokens_remedy},
    {CauseKind::long_pulse, "long-pulse", words::long_pulse, words::long_pulse_remedy},
    {CauseKind::fleeting_follower, "fleeting-follower", words::fleeting_follower,
     words::fleeting_follower_remedy},
    {CauseKind::reset_priority, "reset-priority", words::reset_priority,
     words::reset_priority_remedy},
    {CauseKind::set_and_reset, "set-and-reset", words::set_and_reset, words::set_and_reset_remedy},
    {CauseKind::input_race, "input-race", words::input_race, words::input_race_remedy},
};

const CauseRow& row_of(CauseKind kind) {
    for (const CauseRow& row : rows) {
        if (row.kind == kind) return row;
    }
    return rows[0];
}

/// A sentence with its names.
std::string filled(const words::CauseMessage& sentence, const Cause& cause, Language language) {
    const std::string last = words::and_last.in(language);
    std::string others;
    for (std::size_t i = 0; i < cause.others.size(); ++i) {
        if (i != 0) others += i + 1 == cause.others.size() ? last : ", ";
        others += cause.others[i];
    }
    const auto transition = [&](std::size_t i) {
        return i < cause.transitions.size() ? cause.transitions[i] : std::string();
    };
    return sentence.in(language, cause.step, others, transition(0), transition(1));
}

}  // namespace

std::string_view identifier_of(CauseKind kind) {
    return row_of(kind).identifier;
}

std::string cause_text(const Cause& cause, Language language) {
    return filled(row_of(cause.kind).text, cause, language);
}

std::string remedy_text(const Cause& cause, Language language) {
    return filled(row_of(cause.kind).remedy, cause, language);
}

}  // namespace grafwire
