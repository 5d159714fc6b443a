// The end of a witness in words: what changed outside, what the reference made of it scan by scan,
// and then backwards from what differs: the equations with the values that decide, the causal chain
// through the gates, and the cause with what helps, where it is a known one.

#include "explain/write_explanation.h"

#include <fmt/format.h>

#include <algorithm>

#include "explain/explanation_writer.h"
#include "explain/messages.h"

namespace grafwire {

namespace {

namespace words = messages::explain;
using Fault = Explanation::Fault;
using EquationPair = Explanation::EquationPair;
using Part = Explanation::Part;

constexpr std::size_t most_oscillating = 12;

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
            say(words::values_differ, part.name, digit_of(part.expected),
                words::the_netlist.in(language_), digit_of(part.got));
        }
        if (!part.follows_from.empty()) {
            say(words::follows_from, joined(part.follows_from));
            return;
        }
        for (const EquationPair& pair : part.equations) write_equation(part, pair);
        write_fault(part);
    }

    void write_equation(const Part& part, const EquationPair& pair) {
        writer_.add(fmt::format("    {} = {}", pair.name, pair.expected));
        std::vector<std::string> values;
        for (const Explanation::Operand& operand : pair.operands) {
            values.push_back(fmt::format("{}={}", operand.name, digit_of(operand.value)));
        }
        if (!values.empty()) say(words::with_values, fmt::format("{}", fmt::join(values, " ")));
        writer_.add("\n");
        if (part.fault == Fault::unread || pair.is_same) return;
        if (pair.got.empty()) {
            say(words::another_equation);
        } else {
            say(words::equation_in_netlist, pair.name, pair.got);
        }
        if (!pair.missing.empty()) say(words::operands_missing, joined(pair.missing));
        if (!pair.extra.empty()) say(words::operands_extra, joined(pair.extra));
        writer_.add("\n");
    }

    void write_fault(const Part& part) {
        switch (part.fault) {
            case Fault::no_fault:
                if (!part.equations.empty()) say(words::same_equations);
                break;
            case Fault::priority:
                say(words::deactivation_wins);
                break;
            case Fault::unread:
                say(words::gates_cannot_be_compared);
                for (const Explanation::Operand& operand : part.reads) {
                    writer_.add(fmt::format(" {}={}", operand.name, digit_of(operand.value)));
                }
                writer_.add("\n");
                break;
            case Fault::equation:
            case Fault::order:
                break;
        }
        if (part.decided_at) say(words::decided_at, time_text(*part.decided_at));
        if (part.lines.empty()) return;
        say(part.lines.size() == 1 ? words::gates_in_line : words::gates_in_lines,
            options_.source.empty() ? "" : options_.source + ", ", ranges(part.lines));
    }

    static std::string joined(const std::vector<std::string>& names) {
        return fmt::format("{}", fmt::join(names, ", "));
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

    std::string time_text(Time after) const {
        if (after < 0) {
            return fmt::format("{} ms", format_milliseconds(witness_.stimuli.end + after));
        }
        return fmt::format("+{} ns", after / nanosecond);
    }

    static const Message<>& verb_of(Logic value) {
        switch (value) {
            case Logic::one:
                return words::rises;
            case Logic::zero:
                return words::falls;
            default:
                return words::becomes_undefined;
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
            say(words::links_in_file, first);
        }
        for (std::size_t i = first; i < chain.size(); ++i) write_link(chain[i]);
    }

    void write_link(const Explanation::Link& link) {
        writer_.add(fmt::format("  {}  ", time_text(link.after)));
        if (link.cell == no_cell) {
            say(words::input, link.net);
        } else {
            writer_.add(cell_description(netlist_, link.cell, language_));
            const Origin& origin = netlist_.origin_of(netlist_.cells[link.cell]);
            if (origin.kind == Origin::Kind::other && origin.where.is_known()) {
                if (options_.source.empty()) {
                    say(words::in_line, origin.where.line);
                } else {
                    writer_.add(fmt::format(" ({}:{})", options_.source, origin.where.line));
                }
            }
        }
        say(verb_of(link.value));
        if (!link.causes.empty()) {
            say(words::after, joined(link.causes));
        } else if (link.cell != no_cell) {
            say(is_timer(netlist_.cells[link.cell].type) ? words::delay_has_ended
                                                         : words::from_the_start);
        }
        writer_.add("\n");
    }

    void write_oscillation() {
        if (explanation_.oscillating.empty()) return;
        say(words::does_not_settle);
        std::size_t shown = 0;
        for (const CellId cell : explanation_.oscillating) {
            if (shown++ == most_oscillating) {
                say(words::and_more, explanation_.oscillating.size() - most_oscillating);
                break;
            }
            writer_.add(fmt::format("  {}\n", cell_description(netlist_, cell, language_)));
        }
    }

    void write_cause() {
        if (!explanation_.cause) return;
        say(words::cause_and_remedy, cause_text(*explanation_.cause, language_),
            remedy_text(*explanation_.cause, language_));
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
