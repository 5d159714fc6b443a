// The language of reports: asked for, or that of the locale; machine formats have none.

#include <doctest/doctest.h>

#include "command/charts.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

std::string shown(const std::vector<std::string>& arguments,
                  const std::vector<std::string>& environment = {}) {
    return grafwire_with(arguments, {}, environment).out;
}

}  // namespace

TEST_CASE("--lang, before the command or behind it") {
    const std::string english = shown({"info", sequence_chart});
    const std::string french = shown({"--lang", "fr", "info", sequence_chart});
    CHECK(contains(english, "1 initial step"));
    CHECK(contains(french, "1 étape initiale"));
    CHECK(shown({"info", sequence_chart, "--lang", "fr"}) == french);
    CHECK(shown({"info", sequence_chart, "--lang=en"}) == english);
}

TEST_CASE("without --lang the locale decides, else it is English") {
    const std::string english = shown({"info", sequence_chart, "--lang", "en"});
    const std::string french = shown({"info", sequence_chart, "--lang", "fr"});
    using Environment = std::vector<std::string>;
    CHECK(shown({"info", sequence_chart}, Environment{"LC_ALL=fr_FR.UTF-8"}) == french);
    CHECK(shown({"info", sequence_chart},
                Environment{"LC_ALL=", "LC_MESSAGES=fr_CA", "LANG=en_US"}) == french);
    CHECK(shown({"info", sequence_chart},
                Environment{"LC_ALL=", "LC_MESSAGES=", "LANG=fr_FR.UTF-8"}) == french);
    CHECK(shown({"info", sequence_chart}, Environment{"LC_ALL=", "LC_MESSAGES=", "LANG="}) ==
          english);
    CHECK(shown({"info", sequence_chart}, Environment{"LC_ALL=de_DE.UTF-8", "LANG=fr_FR.UTF-8"}) ==
          english);
    CHECK(shown({"info", sequence_chart, "--lang", "en"}, Environment{"LC_ALL=fr_FR.UTF-8"}) ==
          english);
}

TEST_CASE("reports are in the language") {
    const std::string wrong = example("rule-5.grafcet");
    CHECK(contains(shown({"check", wrong, "--style", "nor"}), ": different ("));
    CHECK(contains(shown({"check", wrong, "--style", "nor", "--lang", "fr"}), ": différent ("));
    for (const std::string form : {"text", "markdown", "latex"}) {
        INFO("form: " << form);
        CHECK(shown({"equations", sequence_chart, "--to", form, "--lang", "fr"}) !=
              shown({"equations", sequence_chart, "--to", form}));
    }
    const Ran english = grafwire_with(
        {"run", example("positioning-axis.grafcet"), example("positioning-axis-scan.stim")});
    const Ran french = grafwire_with({"run", example("positioning-axis.grafcet"),
                                      example("positioning-axis-scan.stim"), "--lang", "fr"});
    CHECK(contains(english.err, "no stable situation at 100 ms"));
    CHECK(contains(french.err, "pas de situation stable à 100 ms"));
    CHECK(english.out == french.out);
}

TEST_CASE("machine formats do not depend on the language") {
    const std::string wrong = example("rule-5.grafcet");
    for (const std::vector<std::string>& request : std::vector<std::vector<std::string>>{
             {"equations", sequence_chart, "--to", "csv"},
             {"equations", sequence_chart, "--to", "json"},
             {"run", sequence_chart, sequence_stimuli},
             {"simulate", sequence_chart, sequence_stimuli, "--style", "nand"},
             {"netlist", sequence_chart, "--style", "nand", "--to", "verilog"},
             {"netlist", sequence_chart, "--style", "nand", "--to", "blif"},
             {"netlist", sequence_chart, "--style", "nand", "--to", "json"},
             {"check", wrong, "--style", "nor", "--to", "json"}}) {
        INFO("command: " << request.front());
        std::vector<std::string> in_french = request;
        in_french.insert(in_french.end(), {"--lang", "fr"});
        CHECK(shown(in_french) == shown(request));
        CHECK(shown(request, {"LC_ALL=fr_FR.UTF-8"}) == shown(request));
    }
}

}  // namespace grafwire::testing
