// The report of a check for people, part by part; a part that has nothing to say is left out. And
// the same text in English, wrapped up for servers that build and test (JUnit).

#include "check/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "check/messages.h"
#include "grafcet/write_grafcet.h"
#include "text/counted.h"
#include "text/escape.h"
#include "text/indented.h"
#include "text/joined.h"
#include "text/shown_duration.h"
#include "text/utf8.h"
#include "text/version.h"

namespace grafwire {

namespace {

namespace words = messages::check;
namespace counted = messages::counted;

std::string names_text(const std::vector<std::string>& names) {
    return joined(names, ", ");
}

bool all_agree(const Witness& witness) {
    return std::all_of(witness.values.begin(), witness.values.end(),
                       [](const Witness::Value& value) { return value.expected == value.got; });
}

class TextReport {
  public:
    TextReport(const CheckSubject& subject, const Grafcet& grafcet, const CheckResult& result,
               Language language)
        : subject_(subject), grafcet_(grafcet), result_(result), language_(language) {}

    std::string make(const ExplainedWitness& explained) {
        write_verdict();
        write_foundation();
        write_interlocks();
        write_coverage();
        write_never();
        write_why_undecided();
        write_unstable();
        write_together();
        write_orders();
        write_witness(explained);
        write_tolerance(explained);
        write_pulses(explained);
        return std::move(text_);
    }

    CheckParts make_parts(const ExplainedWitness& explained) {
        CheckParts parts;
        write_foundation();
        write_interlocks();
        parts.basis = take_trimmed();
        write_coverage();
        parts.coverage = take_trimmed();
        write_never();
        write_why_undecided();
        write_unstable();
        write_together();
        write_orders();
        parts.remarks = take_trimmed();
        write_witness(explained);
        write_tolerance(explained);
        write_pulses(explained);
        parts.witness = take_trimmed();
        return parts;
    }

  private:
    /// What has been written, without blanks and empty lines round it.
    std::string take_trimmed() {
        const std::string text = std::exchange(text_, {});
        const std::size_t begin = text.find_first_not_of(" \n");
        if (begin == std::string::npos) return {};
        return text.substr(begin, text.find_last_not_of(" \n") + 1 - begin);
    }
    template <class... Arguments>
    std::string in_words(const Message<Arguments...>& message,
                         const std::type_identity_t<Arguments>&... arguments) const {
        return message.in(language_, arguments...);
    }
    template <class... Arguments>
    void say(const Message<Arguments...>& message,
             const std::type_identity_t<Arguments>&... arguments) {
        text_ += message.in(language_, arguments...);
    }
    void add_stimuli(const Stimuli& stimuli) {
        text_ += indented(write_stimuli(stimuli, grafcet_));
    }
    /// A line of several parts.
    void add_line(const std::vector<std::string>& parts) {
        text_ += fmt::format("  {}\n", joined(parts, in_words(words::separator)));
    }

    const Message<std::string, std::string>& verdict() const;
    std::string compared_with() const;
    std::string delays() const;
    std::string assumptions() const;
    const Message<>& power_up() const;
    void write_verdict();
    void write_foundation();
    void write_figures();
    void write_interlocks();
    void write_orders();
    void write_coverage();
    void write_never();
    void write_why_undecided();
    void write_unstable();
    void write_together();
    void write_not_together(const Together& together);
    void write_witness(const ExplainedWitness& explained);
    void write_kind(const Witness& witness);
    void write_tolerance(const ExplainedWitness& explained);
    void write_reach(const Tolerance& tolerance);
    void write_pulses(const ExplainedWitness& explained);

    const CheckSubject& subject_;
    const Grafcet& grafcet_;
    const CheckResult& result_;
    Language language_;
    std::string text_;
};

const Message<std::string, std::string>& TextReport::verdict() const {
    switch (result_.verdict) {
        case Verdict::equivalent:
            return words::equivalent;
        case Verdict::different:
            return words::different;
        case Verdict::undecided:
            break;
    }
    return words::undecided;
}

std::string TextReport::compared_with() const {
    if (subject_.against.empty()) {
        return in_words(words::made_in, subject_.style, subject_.cdx);
    }
    return in_words(subject_.is_program ? words::program : words::netlist,
                    visible(subject_.against));
}

std::string TextReport::assumptions() const {
    std::vector<std::string> texts;
    for (const Assumption& assumption : grafcet_.assumptions) {
        texts.push_back(write_expression(grafcet_, grafcet_.expressions, assumption.expression));
    }
    return texts.empty() ? in_words(words::no_assumptions)
                         : in_words(words::assumptions, names_text(texts));
}

const Message<>& TextReport::power_up() const {
    switch (subject_.power_up) {
        case PowerUp::init:
            return words::power_up_init;
        case PowerUp::initial_values:
            return words::power_up_initial_values;
        case PowerUp::given:
            return words::power_up_given;
        case PowerUp::unknown:
            break;
    }
    return words::power_up_unknown;
}

void TextReport::write_verdict() {
    const bool is_interlocked = subject_.orders && subject_.orders->is_interlocked();
    const std::string file = visible(subject_.file);
    say(verdict(), is_interlocked ? in_words(words::interlocked_file, file) : file,
        compared_with());
}

std::string TextReport::delays() const {
    const DelayBand& gate = subject_.delays.gate;
    switch (subject_.delays.kind) {
        case DelayModel::Kind::fixed:
            return in_words(words::delays, format_nanoseconds(gate.max));
        case DelayModel::Kind::bounded:
            if (subject_.delays.family != nullptr) {
                return in_words(words::family_delays, subject_.delays.family->description());
            }
            return in_words(words::bounded_delays, format_nanoseconds(gate.min),
                            format_nanoseconds(gate.max));
        case DelayModel::Kind::any:
            return in_words(words::any_delays);
        case DelayModel::Kind::any_wire:
            return in_words(words::any_wire_delays);
    }
    return {};
}

void TextReport::write_foundation() {
    std::vector<std::string> parts;
    if (!subject_.is_program) {
        parts.push_back(delays());
    }
    if (subject_.changes) {
        parts.push_back(
            in_words(*subject_.changes == Changes::one ? words::one_change : words::many_changes));
    }
    if (subject_.is_scanned()) {
        const auto period = parse_duration(subject_.period);
        parts.push_back(period ? in_words(words::scan_period, shown_duration(*period))
                               : in_words(words::any_period));
    }
    parts.push_back(assumptions());
    parts.push_back(in_words(power_up()));
    add_line(parts);
    if (!subject_.figures.empty()) write_figures();
}

/// What a part family says of the cells that there are.
void TextReport::write_figures() {
    const auto bounds = [&](DelayBand band) {
        return in_words(words::from_to, format_nanoseconds(band.min), format_nanoseconds(band.max));
    };
    say(words::figures_of_parts);
    for (const UsedFigures& used : subject_.figures) {
        const Localized type = row_of(used.type).description();
        const std::string rise = bounds(used.bands.rise);
        const std::string fall = bounds(used.bands.fall);
        std::string source = in_words(words::composed_of_parts);
        if (used.part != nullptr) {
            source = in_words(words::figures_of_part, used.part->part, used.part->source);
            if (used.part->note != nullptr) {
                source += in_words(words::separator) + in_words(*used.part->note);
            }
        }
        say(words::figures_of_cell,
            used.inputs < 2 ? type.in(language_)
                            : words::cell_with_inputs.in(language_, used.inputs, type),
            rise == fall ? rise : in_words(words::rise_and_fall, rise, fall), source);
    }
}

/// An interlocked chart is not the one in the file, and must not be taken for it.
void TextReport::write_interlocks() {
    if (!subject_.orders || !subject_.orders->is_interlocked()) return;
    say(words::interlocked_reference);
    text_ += indented(subject_.orders->interlock_text.in(language_)) + "\n";
    if (subject_.orders->is_complete && subject_.orders->races.empty()) {
        say(words::order_is_immaterial);
    }
    if (subject_.orders->is_complete) {
        say(words::interlocked_is_alike, subject_.orders->cases);
    } else {
        say(words::interlocked_is_alike_so_far, counted::cases(subject_.orders->cases));
    }
}

void TextReport::write_orders() {
    if (subject_.orders) text_ += subject_.orders->text.in(language_);
}

/// What is compared after every scan is so in unstable situations as well.
void TextReport::write_coverage() {
    const Coverage& coverage = result_.coverage;
    if (subject_.is_scanned()) {
        say(words::scans_compared, counted::situations(coverage.situations),
            counted::compared_scans(coverage.cases));
    } else {
        say(words::cases_compared, counted::stable_situations(coverage.situations),
            counted::compared_cases(coverage.cases), coverage.unstable);
    }
}

/// Nothing is said of what an exploration did not exercise that did not go to its end.
void TextReport::write_never() {
    if (!result_.complete && !result_.depends_on_period) return;
    if (result_.verdict == Verdict::different) return;
    const NeverExercised& never = result_.never;
    std::vector<std::string> parts;
    const auto add_part = [&](const Message<std::string>& message,
                              const std::vector<std::string>& names) {
        if (!names.empty()) parts.push_back(in_words(message, names_text(names)));
    };
    std::vector<std::string> steps;
    for (const StepId id : never.steps) steps.push_back(grafcet_.steps[id].name);
    std::vector<std::string> transitions;
    for (const TransitionId id : never.transitions) {
        transitions.push_back("(" + grafcet_.transitions[id].name + ")");
    }
    std::vector<std::string> inputs;
    for (const std::uint32_t input : never.inputs) inputs.emplace_back(input_name(grafcet_, input));
    std::vector<std::string> outputs;
    for (const OutputId id : never.outputs) outputs.push_back(grafcet_.outputs[id].name);
    add_part(words::never_active, steps);
    add_part(words::never_cleared, transitions);
    add_part(words::never_changed, inputs);
    add_part(words::never_on, outputs);
    if (!parts.empty()) add_line(parts);
}

void TextReport::write_why_undecided() {
    if (result_.verdict != Verdict::undecided) return;
    if (result_.depends_on_period) {
        say(words::depends_on_period);
    } else if (result_.is_unexplained) {
        say(subject_.delays.is_fixed() ? words::depends_on_memory : words::depends_on_delays);
    } else if (result_.has_unexplored_orders) {
        say(words::depends_on_orders);
    } else {
        text_ += words::states_waiting.in(language_, result_.coverage.waiting);
    }
}

void TextReport::write_unstable() {
    if (!result_.first_unstable) return;
    say(words::chart_is_unstable, names_text(result_.first_unstable->changing));
    add_stimuli(result_.first_unstable->stimuli);
}

void TextReport::write_together() {
    if (!result_.together) return;
    switch (result_.together->verdict) {
        case Verdict::equivalent:
            say(words::many_changes_hold);
            return;
        case Verdict::different:
            write_not_together(*result_.together);
            return;
        case Verdict::undecided:
            say(words::many_changes_undecided);
            return;
    }
}

void TextReport::write_not_together(const Together& together) {
    say(words::many_changes_fail);
    std::vector<std::string> names;
    for (const std::uint32_t input : together.inputs) {
        names.emplace_back(input_name(grafcet_, input));
    }
    if (names.empty()) {
        say(words::for_instance);
    } else {
        say(together.with_delay ? words::apart_from_delay : words::apart_from_each_other,
            names_text(names));
    }
    if (together.witness) add_stimuli(together.witness->stimuli);
    if (!together.assumption.empty()) say(words::holds_with_assumption, together.assumption);
}

void TextReport::write_witness(const ExplainedWitness& explained) {
    if (!result_.witness) return;
    say(words::witness);
    add_stimuli(result_.witness->stimuli);
    for (const auto& [net, value] : explained.power_up) say(words::at_power_up, net, value ? 1 : 0);
    text_ += '\n';
    write_kind(*result_.witness);
    text_ += explained.text;
}

/// What the explanation does not say of some kinds of difference.
void TextReport::write_kind(const Witness& witness) {
    if (witness.kind == DifferenceKind::power_up) {
        say(words::no_initial_situation);
    } else if (witness.kind == DifferenceKind::oscillation && all_agree(witness)) {
        say(words::oscillates_beside);
    }
}

/// Tenths, as `1.6` or `12`.
std::string ratio_text(int tenths) {
    return tenths % 10 == 0 ? fmt::format("{}", tenths / 10)
                            : fmt::format("{}.{}", tenths / 10, tenths % 10);
}

/// Up to where it holds.
void TextReport::write_reach(const Tolerance& tolerance) {
    if (tolerance.is_unlimited) {
        say(words::tolerance_unlimited);
    } else if (tolerance.holds != 0) {
        say(words::tolerance_holds, ratio_text(tolerance.holds));
    } else if (tolerance.fails == least_ratio) {
        say(words::tolerance_none);
    } else {
        say(words::tolerance_unproven);
    }
}

void TextReport::write_tolerance(const ExplainedWitness& explained) {
    if (!result_.tolerance) return;
    const Tolerance& tolerance = *result_.tolerance;
    write_reach(tolerance);
    if (tolerance.is_unlimited) return;
    if (!tolerance.witness) {
        say(words::tolerance_open_above);
        return;
    }
    if (tolerance.fails > next_ratio(tolerance.holds)) say(words::tolerance_open_between);
    say(words::tolerance_fails, ratio_text(tolerance.fails));
    add_stimuli(tolerance.witness->stimuli);
    text_ += '\n';
    write_kind(*tolerance.witness);
    for (const ExplainedWitness& beyond : explained.at_tolerance) text_ += beyond.text;
}

/// One section for each X and output, then what is not known.
void TextReport::write_pulses(const ExplainedWitness& explained) {
    if (!result_.pulses) return;
    const Pulses& pulses = *result_.pulses;
    if (!pulses.found.empty()) {
        say(words::pulses);
    } else if (pulses.complete && pulses.open.empty()) {
        say(words::no_pulses);
    } else {
        say(words::no_pulses_found);
    }
    for (std::size_t i = 0; i < pulses.found.size() && i < explained.pulses.size(); ++i) {
        text_ += '\n' + explained.pulses[i].text;
        say(words::stimuli_of_pulse);
        add_stimuli(pulses.found[i].stimuli);
    }
    if (!pulses.found.empty() && (!pulses.open.empty() || !pulses.complete)) text_ += '\n';
    for (const Pulses::Open& open : pulses.open) {
        text_ += words::pulses_open.in(language_, open.cases, open.name);
    }
    if (!pulses.complete) text_ += words::pulses_incomplete.in(language_, pulses.cases);
}

}  // namespace

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return lines;
}

std::string write_check_text(const CheckSubject& subject, const Grafcet& grafcet,
                             const CheckResult& result, const ExplainedWitness& explained,
                             Language language) {
    return TextReport(subject, grafcet, result, language).make(explained);
}

CheckParts check_parts(const CheckSubject& subject, const Grafcet& grafcet,
                       const CheckResult& result, const ExplainedWitness& explained,
                       Language language) {
    return TextReport(subject, grafcet, result, language).make_parts(explained);
}

// The report of checks for servers that build and test.

namespace {

std::string_view element_of(JunitCase::Outcome outcome) {
    switch (outcome) {
        case JunitCase::Outcome::passed:
            return "system-out";
        case JunitCase::Outcome::failed:
            return "failure";
        case JunitCase::Outcome::error:
            return "error";
        case JunitCase::Outcome::skipped:
            break;
    }
    return "skipped";
}

std::string xml_of(const JunitCase& item) {
    std::string text = fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">\n",
                                   xml_attribute(visible(item.file)),
                                   xml_attribute(visible(item.name)), item.seconds);
    const std::string_view element = element_of(item.outcome);
    const std::string message = item.outcome == JunitCase::Outcome::passed
                                    ? ""
                                    : fmt::format(" message=\"{}\"", xml_attribute(item.message));
    text +=
        fmt::format("    <{}{}>{}</{}>\n", element, message, xml_attribute(item.details), element);
    return text + "  </testcase>\n";
}

}  // namespace

JunitCase junit_case(const CheckSubject& subject, const Grafcet& grafcet, const CheckResult& result,
                     const ExplainedWitness& explained, double seconds) {
    ExplainedWitness in_english = explained;
    in_english.text = fmt::format("{}\n", joined(explained.lines, "\n"));
    for (ExplainedWitness& beyond : in_english.at_tolerance) {
        beyond.text = fmt::format("{}\n", joined(beyond.lines, "\n"));
    }
    for (ExplainedPulse& pulse : in_english.pulses) {
        pulse.text = fmt::format("{}\n", joined(pulse.lines, "\n"));
    }
    JunitCase item;
    item.file = subject.file;
    item.name = subject.name;
    item.details = write_check_text(subject, grafcet, result, in_english, Language::english);
    item.seconds = seconds;
    if (result.verdict == Verdict::different) {
        item.outcome = JunitCase::Outcome::failed;
        item.message = name_of(result.witness->kind);
    } else if (result.verdict == Verdict::undecided) {
        item.outcome = JunitCase::Outcome::error;
        item.message = "undecided";
    }
    return item;
}

JunitCase unchecked_junit_case(const CheckSubject& subject, bool is_skipped, std::string messages,
                               double seconds) {
    return {is_skipped ? JunitCase::Outcome::skipped : JunitCase::Outcome::error,
            subject.file,
            subject.name,
            is_skipped ? "the style cannot hold this GRAFCET" : "not checked",
            std::move(messages),
            seconds};
}

std::string write_junit(std::span<const JunitCase> cases) {
    const auto count = [&](JunitCase::Outcome outcome) {
        return std::count_if(cases.begin(), cases.end(),
                             [&](const JunitCase& item) { return item.outcome == outcome; });
    };
    double seconds = 0;
    for (const JunitCase& item : cases) seconds += item.seconds;
    const auto skipped = count(JunitCase::Outcome::skipped);
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text += fmt::format("<!-- {} -->\n", program_and_version());
    text += fmt::format(
        "<testsuite name=\"grafwire check\" tests=\"{}\" failures=\"{}\" errors=\"{}\"{} "
        "time=\"{:.3f}\">\n",
        cases.size(), count(JunitCase::Outcome::failed), count(JunitCase::Outcome::error),
        skipped == 0 ? "" : fmt::format(" skipped=\"{}\"", skipped), seconds);
    for (const JunitCase& item : cases) text += xml_of(item);
    return text + "</testsuite>\n";
}

}  // namespace grafwire
