// The end of a witness in words: what changed outside, what the reference made of it scan by scan,
// and then backwards from what differs: the equations with the values that decide, the causal chain
// through the gates, and the cause with what helps, where it is a known one:
//
//     Where they part:
//       X1: the reference gives 0, the netlist 1
//         CDX1 = X2 + X3   with X2=1 X3=0
//         in the netlist CDX1 = X3; it has no X2
//         it is decided at +4 ns
//     How it came about, gate by gate:
//       +3 ns  OR gate X2 (line 23) rises, after X2$1
//
// Nothing is worked out here; what an explanation holds (explain.h) is put into the sentences of
// the catalogue, in either language.

#include "explain/write_explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "explain/explain.h"
#include "explain/explanation_writer.h"
#include "explain/messages.h"
#include "text/joined.h"

namespace grafwire {

namespace {

namespace words = messages::explain;
using Fault = Explanation::Fault;
using EquationPair = Explanation::EquationPair;
using Part = Explanation::Part;

constexpr std::size_t most_oscillating = 12;

/// What is said of a known cause, and how programs know it.
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
    {CauseKind::gate_race, "gate-race", words::gate_race, words::gate_race_remedy},
};

/// There is a row for every kind.
const CauseRow& row_of(CauseKind kind) {
    for (const CauseRow& row : rows) {
        if (row.kind == kind) return row;
    }
    return rows[0];
}

/// `X1, X2 and X3`
std::string listed(const std::vector<std::string>& names, Language language) {
    if (names.size() < 2) return names.empty() ? "" : names[0];
    return words::and_last.in(language, joined(std::span(names).first(names.size() - 1), ", "),
                              names.back());
}

/// A sentence with its names.
std::string filled(const words::CauseMessage& sentence, const Cause& cause, Language language) {
    const std::string others = listed(cause.others, language);
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

namespace {

/// The sections of the text, one after the other; a section that has nothing to say is left out.
class ExplanationText {
  public:
    ExplanationText(const Grafcet& grafcet, const Netlist& netlist, const Witness& witness,
                    const Explanation& explanation, const ExplanationOptions& options)
        : netlist_(netlist),
          witness_(witness),
          explanation_(explanation),
          options_(options),
          language_(options.language),
          writer_(grafcet, witness, options.language) {}

    std::string make() {
        write_delays();
        writer_.explain_changes();
        writer_.explain_reference();
        write_parts();
        write_chain();
        write_oscillation();
        write_cause();
        return writer_.take();
    }

  private:
    template <class... Arguments>
    void say(const Message<Arguments...>& message,
             const std::type_identity_t<Arguments>&... arguments) {
        writer_.say(message, arguments...);
    }

    /// The circuit that the witness is about, gate by gate; a gate may take another time later on.
    void write_delays() {
        const std::vector<DelayChange>& changes = witness_.delays.changes;
        if (changes.empty()) return;
        say(words::delays_needed);
        for (const DelayChange& change : changes) {
            const std::string gate = cell_description(netlist_, change.cell, language_);
            const std::string time = format_nanoseconds(change.rise);
            if (change.at <= 0) {
                say(words::delay_of_gate, gate, time);
            } else {
                say(words::delay_of_gate_later, gate, time, format_duration(change.at));
            }
        }
    }

    void write_parts() {
        if (explanation_.parts.empty()) return;
        say(witness_.kind == DifferenceKind::oscillation ? words::keeps_changing
                                                         : words::where_they_part);
        for (const Part& part : explanation_.parts) write_part(part);
    }

    void write_part(const Part& part) {
        if (witness_.kind == DifferenceKind::oscillation) {
            say(words::value_expected, part.name, digit_of(part.expected));
        } else {
            say(words::values_differ, part.name, digit_of(part.expected), words::the_netlist(),
                digit_of(part.got));
        }
        if (!part.follows_from.empty()) {
            say(words::follows_from, joined(part.follows_from, ", "));
            return;
        }
        for (const EquationPair& pair : part.equations) write_equation(part, pair);
        write_fault(part);
    }

    /// As it should be, with the values of its operands; and as the netlist has it, if otherwise.
    void write_equation(const Part& part, const EquationPair& pair) {
        if (pair.operands.empty()) {
            say(words::equation, pair.name, pair.expected);
        } else {
            say(words::equation_with_values, pair.name, pair.expected, values_of(pair.operands));
        }
        if (part.fault == Fault::unread || pair.is_same) return;
        const Localized got =
            pair.got.empty() ? words::another_equation()
                             : Localized::same_in_both(fmt::format("{} = {}", pair.name, pair.got));
        if (pair.missing.empty() && pair.extra.empty()) {
            say(words::in_netlist, got);
        } else if (pair.extra.empty()) {
            say(words::in_netlist_without, got, joined(pair.missing, ", "));
        } else if (pair.missing.empty()) {
            say(words::in_netlist_with, got, joined(pair.extra, ", "));
        } else {
            say(words::in_netlist_otherwise, got, joined(pair.missing, ", "),
                joined(pair.extra, ", "));
        }
    }

    /// `X2=1 X3=0`
    static std::string values_of(const std::vector<Explanation::Operand>& operands) {
        std::vector<std::string> values;
        for (const Explanation::Operand& operand : operands) {
            values.push_back(fmt::format("{}={}", operand.name, digit_of(operand.value)));
        }
        return joined(values, " ");
    }

    /// What the equations do not show by themselves, when it shows, and where the gates stand.
    void write_fault(const Part& part) {
        switch (part.fault) {
            case Fault::no_fault:
                if (!part.equations.empty()) say(words::same_equations);
                break;
            case Fault::priority:
                say(words::deactivation_wins);
                break;
            case Fault::unread:
                if (part.reads.empty()) {
                    say(words::gates_cannot_be_compared);
                } else {
                    say(words::gates_read, values_of(part.reads));
                }
                break;
            case Fault::equation:
            case Fault::order:
                break;
        }
        if (part.decided_at) say(words::decided_at, time_text(*part.decided_at));
        if (part.lines.empty()) return;
        const std::size_t count = part.lines.size();
        writer_.add(options_.source.empty()
                        ? words::gates_in_lines.in(language_, count, ranges(part.lines))
                        : words::gates_in_lines_of.in(language_, count, ranges(part.lines),
                                                      options_.source));
    }

    /// `3, 7-9`.
    static std::string ranges(const std::vector<std::uint32_t>& lines) {
        std::string text;
        for (std::size_t i = 0; i < lines.size();) {
            std::size_t end = i + 1;
            while (end < lines.size() && lines[end] == lines[end - 1] + 1) ++end;
            if (!text.empty()) text += ", ";
            text += end - i == 1 ? fmt::format("{}", lines[i])
                                 : fmt::format("{}-{}", lines[i], lines[end - 1]);
            i = end;
        }
        return text;
    }

    /// A moment of the last instant by what has passed since its beginning, for gates answer within
    /// nanoseconds; an earlier one by the time of the run.
    std::string time_text(Time after) const {
        if (after < 0) {
            return words::at_time.in(language_, format_milliseconds(witness_.stimuli.end + after));
        }
        return words::after_instant.in(language_, format_nanoseconds(after));
    }

    /// What is said of a net that takes a value: by itself, after others, as its delay ends, from
    /// the start.
    struct LinkWords {
        const words::LinkMessage& alone;
        const words::AfterMessage& after;
        const words::LinkMessage& as_delay_ends;
        const words::LinkMessage& from_the_start;
    };
    static LinkWords words_for(Logic value) {
        switch (value) {
            case Logic::one:
                return {words::rises, words::rises_after, words::rises_as_delay_ends,
                        words::rises_from_the_start};
            case Logic::zero:
                return {words::falls, words::falls_after, words::falls_as_delay_ends,
                        words::falls_from_the_start};
            default:
                return {words::becomes_undefined, words::becomes_undefined_after,
                        words::becomes_undefined_as_delay_ends,
                        words::becomes_undefined_from_the_start};
        }
    }

    void write_chain() {
        const std::size_t most_links = options_.most_links;
        say(words::gate_by_gate);
        const std::vector<Explanation::Link>& chain = explanation_.chain;
        if (chain.empty()) {
            say(words::no_gate_changes);
            return;
        }
        std::size_t first = 0;
        if (most_links != 0 && chain.size() > most_links) {
            first = chain.size() - most_links;
            writer_.add(words::links_in_file.in(language_, first));
        }
        for (std::size_t i = first; i < chain.size(); ++i) write_link(chain[i]);
    }

    /// `  +3 ns  OR gate X2 (line 23) rises, after X2$1`
    void write_link(const Explanation::Link& link) {
        const std::string when = time_text(link.after);
        const std::string what = subject_of(link);
        const LinkWords sentences = words_for(link.value);
        if (!link.causes.empty()) {
            say(sentences.after, when, what, joined(link.causes, ", "));
        } else if (link.cell == no_cell) {
            say(sentences.alone, when, what);
        } else if (is_timer(netlist_.cells[link.cell].type)) {
            say(sentences.as_delay_ends, when, what);
        } else {
            say(sentences.from_the_start, when, what);
        }
    }

    /// The input or cell that a link is about; of a cell that was read, its place as well.
    std::string subject_of(const Explanation::Link& link) const {
        if (link.cell == no_cell) return words::input.in(language_, link.net);
        const std::string cell = cell_description(netlist_, link.cell, language_);
        const Origin& origin = netlist_.origin_of(netlist_.cells[link.cell]);
        if (origin.kind != Origin::Kind::other || !origin.where.is_known()) return cell;
        if (options_.source.empty()) {
            return words::cell_in_line.in(language_, cell, origin.where.line);
        }
        return fmt::format("{} ({}:{})", cell, options_.source, origin.where.line);
    }

    void write_oscillation() {
        if (explanation_.oscillating.empty()) return;
        say(words::does_not_settle);
        std::size_t shown = 0;
        for (const CellId cell : explanation_.oscillating) {
            if (shown++ == most_oscillating) {
                writer_.add(words::and_more.in(language_,
                                               explanation_.oscillating.size() - most_oscillating));
                break;
            }
            writer_.add(fmt::format("  {}\n", cell_description(netlist_, cell, language_)));
        }
    }

    void write_cause() {
        if (!explanation_.cause) return;
        const Cause& cause = *explanation_.cause;
        say(words::cause_and_remedy, cause_text(cause, language_),
            filled(row_of(cause.kind).remedy, cause, language_));
    }

    const Netlist& netlist_;
    const Witness& witness_;
    const Explanation& explanation_;
    const ExplanationOptions& options_;
    Language language_;
    ExplanationWriter writer_;
};

}  // namespace

std::string write_explanation(const Grafcet& grafcet, const Netlist& netlist,
                              const Witness& witness, const Explanation& explanation,
                              const ExplanationOptions& options) {
    return ExplanationText(grafcet, netlist, witness, explanation, options).make();
}

}  // namespace grafwire
