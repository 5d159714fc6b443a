// The report of a check for people, part by part; a part that has nothing to say is left out.

#include <fmt/format.h>

#include <algorithm>

#include "check/report.h"
#include "grafcet/write_grafcet.h"
#include "text/utf8.h"

namespace grafwire {

namespace {

/// Two spaces before every line.
std::string indented(const std::string& text) {
    std::string result;
    bool at_start = true;
    for (const char c : text) {
        if (at_start && c != '\n') result += "  ";
        result += c;
        at_start = c == '\n';
    }
    return result;
}

std::string names_text(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

bool all_agree(const Witness& witness) {
    return std::all_of(witness.values.begin(), witness.values.end(),
                       [](const Witness::Value& value) { return value.expected == value.got; });
}

class TextReport {
  public:
    TextReport(const CheckSubject& subject, const Grafcet& grafcet, const CheckResult& result,
               Language language)
        : subject_(subject),
          grafcet_(grafcet),
          result_(result),
          french_(language == Language::french) {}

    std::string make(const ExplainedWitness& explained) {
        write_verdict();
        write_foundation();
        write_coverage();
        write_never();
        write_why_undecided();
        write_unstable();
        write_together();
        write_witness(explained);
        return std::move(text_);
    }

  private:
    std::string_view localized(std::string_view english, std::string_view french) const {
        return french_ ? french : english;
    }
    void add(std::string_view english, std::string_view french) {
        text_ += localized(english, french);
    }
    void add_stimuli(const Stimuli& stimuli) {
        text_ += indented(write_stimuli(stimuli, grafcet_));
    }
    /// `key: value`, as each language spaces it.
    std::string pair(std::string_view english, std::string_view french,
                     std::string_view value) const {
        return fmt::format("{}{} {}", localized(english, french), localized(":", " :"), value);
    }

    std::string_view verdict() const;
    std::string compared_with() const;
    std::string assumptions() const;
    std::string_view power_up() const;
    void write_verdict();
    void write_foundation();
    void write_coverage();
    void write_never();
    void write_why_undecided();
    void write_unstable();
    void write_together();
    void write_not_together(const Together& together);
    void write_witness(const ExplainedWitness& explained);
    void write_kind(const Witness& witness);

    const CheckSubject& subject_;
    const Grafcet& grafcet_;
    const CheckResult& result_;
    bool french_;
    std::string text_;
};

std::string_view TextReport::verdict() const {
    switch (result_.verdict) {
        case Verdict::equivalent:
            return localized("equivalent", "équivalent");
        case Verdict::different:
            return localized("different", "différent");
        case Verdict::undecided:
            return localized("undecided", "indécis");
    }
    return "";
}

std::string TextReport::compared_with() const {
    if (subject_.against.empty())
        return fmt::format("style {}, CDX {}", subject_.style, subject_.cdx);
    return fmt::format(
        "{} {}",
        subject_.is_program ? localized("program", "programme") : localized("netlist", "câblage"),
        visible(subject_.against));
}

std::string TextReport::assumptions() const {
    std::vector<std::string> texts;
    for (const Assumption& assumption : grafcet_.assumptions) {
        texts.push_back(write_expression(grafcet_, grafcet_.expressions, assumption.expression));
    }
    return texts.empty() ? std::string(localized("none", "aucune")) : names_text(texts);
}

std::string_view TextReport::power_up() const {
    switch (subject_.power_up) {
        case PowerUp::init:
            return "Init";
        case PowerUp::initial_values:
            return localized("initial values", "valeurs initiales");
        case PowerUp::given:
            return localized("initial situation, taken as given",
                             "situation initiale, supposée donnée");
        case PowerUp::unknown:
            return localized("unknown", "inconnue");
    }
    return "";
}

void TextReport::write_verdict() {
    text_ += fmt::format("{}: {} ({})\n", visible(subject_.file), verdict(), compared_with());
}

void TextReport::write_foundation() {
    std::vector<std::string> parts;
    if (!subject_.is_program) {
        parts.push_back(pair("delays", "retards", localized("every gate 1 ns", "1 ns par porte")));
    }
    if (subject_.changes) {
        parts.push_back(
            pair("changes", "changements",
                 *subject_.changes == Changes::one
                     ? localized("one input at a time", "une entrée à la fois")
                     : localized("many inputs at once", "plusieurs entrées à la fois")));
    }
    if (subject_.is_scanned()) {
        parts.push_back(pair("scan period", "période de scrutation",
                             subject_.period == "every" ? localized("any", "quelconque")
                                                        : std::string_view(subject_.period)));
    }
    parts.push_back(pair("assumptions", "hypothèses", assumptions()));
    parts.push_back(pair("power-up", "mise sous tension", power_up()));
    text_ += fmt::format("  {}\n", fmt::join(parts, localized("; ", " ; ")));
}

/// What is compared after every scan is so in unstable situations as well.
void TextReport::write_coverage() {
    const Coverage& coverage = result_.coverage;
    if (subject_.is_scanned()) {
        text_ += fmt::format(fmt::runtime(localized("  {} situations, {} scans compared\n",
                                                    "  {} situations, {} cycles comparés\n")),
                             coverage.situations, coverage.cases);
        return;
    }
    text_ += fmt::format(
        fmt::runtime(
            localized("  {} stable situations, {} cases compared, {} without a stable situation\n",
                      "  {} situations stables, {} cas comparés, {} sans situation stable\n")),
        coverage.situations, coverage.cases, coverage.unstable);
}

/// Nothing is said of what an exploration did not exercise that did not go to its end.
void TextReport::write_never() {
    if (!result_.complete && !result_.depends_on_period) return;
    if (result_.verdict == Verdict::different) return;
    const NeverExercised& never = result_.never;
    std::vector<std::string> parts;
    const auto add_part = [&](std::string_view english, std::string_view french,
                              const std::vector<std::string>& names) {
        if (!names.empty()) parts.push_back(pair(english, french, names_text(names)));
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
    add_part("never active", "étapes jamais actives", steps);
    add_part("never cleared", "transitions jamais franchies", transitions);
    add_part("never changed", "entrées jamais changées", inputs);
    add_part("never on", "sorties jamais à 1", outputs);
    if (!parts.empty()) text_ += fmt::format("  {}\n", fmt::join(parts, localized("; ", " ; ")));
}

void TextReport::write_why_undecided() {
    if (result_.verdict != Verdict::undecided) return;
    if (result_.depends_on_period) {
        add("  for no scan period could a difference be shown, nor excluded for every one: give "
            "one "
            "with --scan\n",
            "  pour aucune période de scrutation une différence n'a pu être montrée, ni exclue "
            "pour "
            "toutes : en donner une avec --scan\n");
        return;
    }
    if (result_.is_unexplained) {
        add("  a memory whose value at power-up is not known may make a difference, and no run was "
            "found that shows one: give it an initial value\n",
            "  une mémoire dont la valeur à la mise sous tension est inconnue peut faire une "
            "différence, sans qu'un essai la montre : lui donner une valeur initiale\n");
        return;
    }
    text_ +=
        fmt::format(fmt::runtime(localized(
                        "  exploration incomplete within the bounds given: {} states reached "
                        "are still to be left\n",
                        "  exploration incomplète dans les limites données : {} états atteints "
                        "restent à quitter\n")),
                    result_.coverage.waiting);
}

void TextReport::write_unstable() {
    if (!result_.first_unstable) return;
    text_ += fmt::format(
        fmt::runtime(localized(
            "\nRemark: the GRAFCET itself has no stable situation here ({} keep changing):\n",
            "\nRemarque : le GRAFCET n'a pas de situation stable ici ({} changent sans cesse) "
            ":\n")),
        names_text(result_.first_unstable->changing));
    add_stimuli(result_.first_unstable->stimuli);
}

void TextReport::write_together() {
    if (!result_.together) return;
    switch (result_.together->verdict) {
        case Verdict::equivalent:
            add("\nRemark: it holds as well when many inputs change at once.\n",
                "\nRemarque : cela reste vrai quand plusieurs entrées changent à la fois.\n");
            return;
        case Verdict::different:
            write_not_together(*result_.together);
            return;
        case Verdict::undecided:
            add("\nRemark: whether it holds as well when many inputs change at once is undecided "
                "within the bounds given.\n",
                "\nRemarque : dans les limites données, il reste indécis si cela est vrai aussi "
                "quand plusieurs entrées changent à la fois.\n");
            return;
    }
}

void TextReport::write_not_together(const Together& together) {
    add("\nRemark: it does not hold when many inputs change at once.\n",
        "\nRemarque : cela n'est plus vrai quand plusieurs entrées changent à la fois.\n");
    std::vector<std::string> names;
    for (const std::uint32_t input : together.inputs) {
        names.emplace_back(input_name(grafcet_, input));
    }
    if (names.empty()) {
        add("For instance:\n", "Par exemple :\n");
    } else {
        text_ += fmt::format(
            fmt::runtime(
                together.with_delay
                    ? localized(
                          "{} must not change within a settling time of the end of a delay. "
                          "Otherwise:\n",
                          "{} ne doit pas changer à moins d'un temps de stabilisation de la fin "
                          "d'un retard. Sinon :\n")
                    : localized("These must not change within a settling time of each other: {}. "
                                "Otherwise:\n",
                                "Ces entrées ne doivent pas changer à moins d'un temps de "
                                "stabilisation d'intervalle : {}. Sinon :\n")),
            names_text(names));
    }
    if (together.witness) add_stimuli(together.witness->stimuli);
    if (together.assumption.empty()) return;
    add("It holds where the plant never does that, as the GRAFCET can say:\n",
        "Cela redevient vrai si l'installation ne le fait jamais, ce que le GRAFCET peut dire :\n");
    text_ += fmt::format("  assume {}\n", together.assumption);
}

void TextReport::write_witness(const ExplainedWitness& explained) {
    if (!result_.witness) return;
    add("\nWitness:\n", "\nTémoin :\n");
    add_stimuli(result_.witness->stimuli);
    for (const auto& [net, value] : explained.power_up) {
        text_ += fmt::format("  {}: {} = {}\n", localized("at power-up", "à la mise sous tension"),
                             net, value ? 1 : 0);
    }
    text_ += '\n';
    write_kind(*result_.witness);
    text_ += explained.text;
}

/// What the explanation does not say of some kinds of difference.
void TextReport::write_kind(const Witness& witness) {
    if (witness.kind == DifferenceKind::power_up) {
        add("At power-up nothing brings the netlist into the initial situation. Give it an input "
            "Init or\ninitial values; or check with --power-up initial, if the plant guarantees "
            "that situation.\n\n",
            "À la mise sous tension, rien ne met le câblage dans la situation initiale. Lui donner "
            "une entrée\nInit ou des valeurs initiales ; ou vérifier avec --power-up initial, si "
            "l'installation garantit cette\nsituation.\n\n");
    } else if (witness.kind == DifferenceKind::oscillation && all_agree(witness)) {
        add("Every X and output is right; what keeps changing beside them stands below.\n\n",
            "Chaque X et chaque sortie est juste ; ce qui change sans cesse à côté est dit plus "
            "bas.\n\n");
    }
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

}  // namespace grafwire
