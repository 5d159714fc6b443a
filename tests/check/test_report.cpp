// The report of a check for people, part by part, from results made up here.

#include "check/report.h"
#include "support/small_netlists.h"
#include "trace/stimuli.h"

namespace grafwire::testing {

namespace {

const std::string apart = R"(
assume /(a . b)
input a, b
output lamp
graph G { initial 0 step 1 : lamp
  0 -> 1 : a
  1 -> 0 : b }
)";

CheckSubject wiring() {
    CheckSubject subject;
    subject.file = "chart.grafcet";
    subject.style = "nand";
    subject.cdx = "successor";
    subject.changes = Changes::one;
    return subject;
}

CheckResult equivalent() {
    CheckResult result;
    result.verdict = Verdict::equivalent;
    result.coverage = {2, 17, 1, 0};
    result.complete = true;
    return result;
}

/// After the change of an input at 100 ms, everything as it should be.
Witness witness_of(DifferenceKind kind) {
    Witness witness;
    witness.kind = kind;
    witness.stimuli.end = 100 * millisecond;
    witness.stimuli.changes = {{0, {}, {}}, {100 * millisecond, {{0, true}}, {}}};
    for (const std::string name : {"X0", "X1", "lamp"}) {
        const Logic value = name == "X0" ? Logic::zero : Logic::one;
        witness.values.push_back({name, value, value});
    }
    return witness;
}

CheckResult different(DifferenceKind kind) {
    CheckResult result;
    result.verdict = Verdict::different;
    result.coverage = {2, 5, 0, 1};
    result.witness = witness_of(kind);
    return result;
}

CheckResult equivalent_and(const Together& together) {
    CheckResult result = equivalent();
    result.together = together;
    return result;
}

std::string text_of(const CheckSubject& subject, const CheckResult& result,
                    Language language = Language::english) {
    return write_check_text(subject, grafcet_of(apart), result, {"The story.\n", "", {}, {}},
                            language);
}

/// What stands after the verdict, what it rests on, and the coverage.
std::string rest_of_text(const CheckResult& result, Language language = Language::english) {
    std::string text = text_of(wiring(), result, language);
    for (int line = 0; line < 3; ++line) text.erase(0, text.find('\n') + 1);
    return text;
}

std::string second_line(const CheckSubject& subject, Language language = Language::english) {
    const std::string text = text_of(subject, equivalent(), language);
    const std::size_t begin = text.find('\n') + 1;
    return text.substr(begin, text.find('\n', begin) - begin);
}

}  // namespace

TEST_CASE("the report of a wiring: verdict, what it rests on, coverage") {
    CHECK(text_of(wiring(), equivalent()) ==
          "chart.grafcet: equivalent (style nand, CDX successor)\n"
          "  delays: every gate 1 ns; changes: one input at a time; assumptions: /(a.b); "
          "power-up: Init\n"
          "  2 stable situations, 17 cases compared, 1 without a stable situation\n");
    CHECK(text_of(wiring(), equivalent(), Language::french) ==
          "chart.grafcet : équivalent (style nand, CDX successor)\n"
          "  retards : 1 ns par porte ; changements : une entrée à la fois ; hypothèses : /(a.b) ; "
          "mise sous tension : Init\n"
          "  2 situations stables, 17 cas comparés, 1 sans situation stable\n");
}

TEST_CASE("the report of what is scanned") {
    CheckSubject clocked = wiring();
    clocked.changes.reset();
    clocked.period = "every";
    CHECK(text_of(clocked, equivalent()) ==
          "chart.grafcet: equivalent (style nand, CDX successor)\n"
          "  delays: every gate 1 ns; scan period: any; assumptions: /(a.b); power-up: Init\n"
          "  2 situations, 17 scans compared\n");
    CheckSubject program;
    program.file = "chart.grafcet";
    program.against = "list.awl";
    program.is_program = true;
    program.period = "10ms";
    program.power_up = PowerUp::initial_values;
    CHECK(text_of(program, equivalent()) ==
          "chart.grafcet: equivalent (program list.awl)\n"
          "  scan period: 10ms; assumptions: /(a.b); power-up: initial values\n"
          "  2 situations, 17 scans compared\n");
    CHECK(text_of(program, equivalent(), Language::french) ==
          "chart.grafcet : équivalent (programme list.awl)\n"
          "  période de scrutation : 10 ms ; hypothèses : /(a.b) ; mise sous tension : valeurs "
          "initiales\n"
          "  2 situations, 17 scrutations comparées\n");
}

TEST_CASE("a netlist from elsewhere has no style, and may have no Init") {
    CheckSubject subject = wiring();
    subject.against = "wired.blif";
    subject.changes = Changes::many;
    subject.power_up = PowerUp::given;
    CHECK(text_of(subject, equivalent())
              .starts_with("chart.grafcet: equivalent (netlist wired.blif)\n"));
    CHECK(second_line(subject) ==
          "  delays: every gate 1 ns; changes: many inputs at once; assumptions: /(a.b); "
          "power-up: initial situation, taken as given");
    subject.power_up = PowerUp::unknown;
    CHECK(second_line(subject).ends_with("; power-up: unknown"));
    CHECK(second_line(subject, Language::french).ends_with(" ; mise sous tension : inconnue"));
}

TEST_CASE("without assumptions that is said") {
    const Grafcet grafcet = grafcet_of("graph G { initial 0 }");
    const std::string text =
        write_check_text(wiring(), grafcet, equivalent(), {}, Language::english);
    CHECK(text.find("; assumptions: none; ") != std::string::npos);
}

TEST_CASE("what no case exercised is told of an exploration that went to its end") {
    const Grafcet grafcet = grafcet_of(apart);
    NeverExercised never;
    never.steps = {grafcet.steps.id_at(0), grafcet.steps.id_at(1)};
    never.transitions = {grafcet.transitions.id_at(1)};
    never.inputs = {1, 2};
    never.outputs = {grafcet.outputs.id_at(0)};
    CheckResult result = equivalent();
    result.never = never;
    CHECK(rest_of_text(result) ==
          "  never active: 0, 1; never cleared: (1); never changed: b, Init; never on: lamp\n");
    CHECK(rest_of_text(result, Language::french) ==
          "  étapes jamais actives : 0, 1 ; transitions jamais franchies : (1) ; entrées jamais "
          "changées : b, Init ; sorties jamais à 1 : lamp\n");
    result.never.steps.clear();
    result.never.inputs.clear();
    result.never.outputs.clear();
    CHECK(rest_of_text(result) == "  never cleared: (1)\n");
    result = different(DifferenceKind::situation);
    result.never = never;
    CHECK(rest_of_text(result).find("never") == std::string::npos);
    result = {};
    result.never = never;
    CHECK(rest_of_text(result).find("never") == std::string::npos);
}

TEST_CASE("undecided says why") {
    CheckResult result;
    result.coverage.waiting = 3;
    CHECK(rest_of_text(result) ==
          "  exploration incomplete within the bounds given: 3 states reached are still to be "
          "left\n");
    CHECK(rest_of_text(result, Language::french) ==
          "  exploration incomplète dans les limites données : 3 états atteints restent à "
          "quitter\n");
    result.depends_on_period = true;
    CHECK(rest_of_text(result) ==
          "  for no scan period could a difference be shown, nor excluded for every one: give one "
          "with --scan\n");
    CHECK(rest_of_text(result, Language::french) ==
          "  pour aucune période de scrutation une différence n'a pu être montrée, ni exclue pour "
          "toutes : en donner une avec --scan\n");
}

TEST_CASE("many inputs at once: as well, or undecided") {
    CHECK(rest_of_text(equivalent_and({Verdict::equivalent, {}, {}, false, ""})) ==
          "\nRemark: it holds as well when many inputs change at once.\n");
    CHECK(
        rest_of_text(equivalent_and({Verdict::equivalent, {}, {}, false, ""}), Language::french) ==
        "\nRemarque : cela reste vrai quand plusieurs entrées changent à la fois.\n");
    CHECK(rest_of_text(equivalent_and({})) ==
          "\nRemark: whether it holds as well when many inputs change at once is undecided; "
          "--changes many asks for it.\n");
}

TEST_CASE("many inputs at once: what must not change together") {
    Together together;
    together.verdict = Verdict::different;
    together.witness = witness_of(DifferenceKind::situation);
    const std::string stimuli = "  0s :\n  100ms : a=1\n  100ms : end\n";
    SUBCASE("inputs, and an assumption that keeps them apart") {
        together.inputs = {0, 1};
        together.assumption = "/(a./b)";
        CHECK(rest_of_text(equivalent_and(together)) ==
              "\nRemark: it does not hold when many inputs change at once.\n"
              "These must not change within a settling time of each other: a, b. Otherwise:\n" +
                  stimuli +
                  "It holds where the plant never does that, as the GRAFCET can say:\n"
                  "  assume /(a./b)\n");
        CHECK(rest_of_text(equivalent_and(together), Language::french) ==
              "\nRemarque : cela n'est plus vrai quand plusieurs entrées changent à la fois.\n"
              "Ces entrées ne doivent pas changer à moins d'un temps de stabilisation d'intervalle "
              ": a, b. Sinon :\n" +
                  stimuli +
                  "Cela redevient vrai si l'installation ne le fait jamais, ce que le GRAFCET peut "
                  "dire :\n"
                  "  assume /(a./b)\n");
    }
    SUBCASE("an input and a delay") {
        together.inputs = {0};
        together.with_delay = true;
        CHECK(rest_of_text(equivalent_and(together)) ==
              "\nRemark: it does not hold when many inputs change at once.\n"
              "a must not change within a settling time of the end of a delay. Otherwise:\n" +
                  stimuli);
    }
    SUBCASE("nothing that can be named") {
        CHECK(rest_of_text(equivalent_and(together)) ==
              "\nRemark: it does not hold when many inputs change at once.\nFor instance:\n" +
                  stimuli);
    }
}

TEST_CASE("a witness, and what the story does not say of its kind") {
    const std::string stimuli = "\nWitness:\n  0s :\n  100ms : a=1\n  100ms : end\n\n";
    CHECK(rest_of_text(different(DifferenceKind::situation)) == stimuli + "The story.\n");
    CHECK(rest_of_text(different(DifferenceKind::power_up)) ==
          stimuli +
              "At power-up nothing brings the netlist into the initial situation. Give it an input "
              "Init or\ninitial values; or check with --power-up initial, if the plant guarantees "
              "that situation.\n\nThe story.\n");
    CHECK(rest_of_text(different(DifferenceKind::oscillation)) ==
          stimuli +
              "Every X and output is right; what keeps changing beside them stands below.\n\n"
              "The story.\n");
    CHECK(rest_of_text(different(DifferenceKind::oscillation), Language::french) ==
          "\nContre-exemple :\n  0s :\n  100ms : a=1\n  100ms : end\n\n"
          "Chaque X et chaque sortie est juste ; ce qui change sans cesse à côté est dit plus "
          "bas.\n\nThe story.\n");
    CheckResult result = different(DifferenceKind::oscillation);
    result.witness->values[1].got = Logic::unknown;
    CHECK(rest_of_text(result) == stimuli + "The story.\n");
}

TEST_CASE("what memories hold at power-up stands before the story") {
    const CheckResult result = different(DifferenceKind::situation);
    const ExplainedWitness explained{"The story.\n", "", {}, {{"q", true}, {"p", false}}};
    const auto text = [&](Language language) {
        return write_check_text(wiring(), grafcet_of(apart), result, explained, language);
    };
    const std::string english = text(Language::english);
    CHECK(english.find("  at power-up: q = 1\n  at power-up: p = 0\n") <
          english.find("The story."));
    const std::string french = text(Language::french);
    CHECK(french.find("  à la mise sous tension : q = 1\n  à la mise sous tension : p = 0\n") <
          french.find("The story."));
}

}  // namespace grafwire::testing
