#include <doctest/doctest.h>

#include <algorithm>

#include "grafwire/grafwire.h"
#include "support/run_program.h"

namespace grafwire::testing {

namespace {

namespace gw = grafwire::api;
using namespace std::chrono_literals;

gw::Chart chart(const std::string& name) {
    const auto read = gw::read_chart(text_of(example(name + ".grafcet")), name);
    REQUIRE(read);
    return *read.value;
}

gw::Netlist netlist(const std::string& name, const std::string& style) {
    gw::NetlistOptions options;
    options.style = style;
    const auto made = gw::make_netlist(chart(name), options);
    REQUIRE(made);
    return *made.value;
}

/// What is said where there is no value.
template <typename Value>
std::string refusal(const gw::Result<Value>& result) {
    CHECK(!result);
    return gw::shown(result.messages, "text");
}

}  // namespace

TEST_CASE("reading: a chart, or messages with their places") {
    const gw::Chart read = chart("rule-5");
    CHECK(read.steps() == std::vector<std::string>{"1", "2"});
    CHECK(read.inputs() == std::vector<std::string>{"s", "k"});
    CHECK(read.outputs() == std::vector<std::string>{"present", "loaded"});
    const auto wrong = gw::read_chart("input a\ngraph G {\n  initial 0\n  0 -> 0 : aa\n}\n", "");
    CHECK(!wrong);
    REQUIRE(!wrong.messages.empty());
    CHECK(wrong.messages[0].line == 4);
    CHECK(wrong.messages[0].column == 12);
    CHECK(contains(refusal(wrong), "text:4:12: error: "));
    CHECK(contains(gw::shown(wrong.messages, "text", gw::Language::french),
                   "text:4:12: erreur\u00a0: " + wrong.messages[0].text_in(gw::Language::french)));
}

TEST_CASE("equations in every form") {
    const gw::Chart read = chart("rule-5");
    for (const auto form :
         {gw::EquationForm::text, gw::EquationForm::markdown, gw::EquationForm::latex,
          gw::EquationForm::csv, gw::EquationForm::json}) {
        CHECK(contains(gw::equations(read, form), "present"));
    }
    gw::EquationOptions french;
    french.language = gw::Language::french;
    french.cdx = gw::Cdx::transition;
    CHECK(gw::equations(read, gw::EquationForm::text, french) !=
          gw::equations(read, gw::EquationForm::text));
}

TEST_CASE("netlists: made, written and read back") {
    for (const std::string& style : gw::styles()) {
        INFO("style: " << style);
        const gw::Netlist made = netlist("single-sequence", style);
        CHECK(made.is_clocked() == (style == "clocked"));
        CHECK(made.cell_count() > 0);
        CHECK(made.inputs().size() == (made.is_clocked() ? 7 : 6));
        CHECK(made.outputs()[0] == "X0");
        for (const std::string& format : gw::netlist_formats()) {
            INFO("format: " << format);
            const auto written = gw::write_netlist(made, format);
            REQUIRE(written);
            if (format != "blif" && format != "json") {
                CHECK(!gw::read_netlist(made.chart(), written.value->text, format, "n"));
                continue;
            }
            const auto again = gw::read_netlist(made.chart(), written.value->text, format, "n");
            REQUIRE(again);
            CHECK(gw::check(*again.value).value->verdict == gw::Verdict::equivalent);
        }
    }
    gw::NetlistOptions options;
    options.style = "nad";
    const auto refused = gw::make_netlist(chart("rule-5"), options);
    REQUIRE(refused.messages.size() == 1);
    CHECK(refused.messages[0].text_in(gw::Language::english) == refused.messages[0].text);
    CHECK(contains(refused.messages[0].text_in(gw::Language::french), "il n'y a pas de style"));
    CHECK(contains(refusal(gw::make_netlist(chart("rule-5"), options)), "no style 'nad'"));
    options.style = "clocked";
    options.cdx = gw::Cdx::successor;
    CHECK(contains(refusal(gw::make_netlist(chart("rule-5"), options)), "transition form"));
    CHECK(contains(refusal(gw::make_netlist(chart("batch-counter"))), "counter"));
    CHECK(contains(refusal(gw::write_netlist(netlist("rule-5", "nand"), "bilf")), "'bilf'"));
    gw::NetlistFileOptions file;
    file.period = 0ns;
    CHECK(
        contains(refusal(gw::write_netlist(netlist("rule-5", "nand"), "blif", file)), "positive"));
    CHECK(contains(refusal(gw::read_netlist(chart("rule-5"), ".model m\n.end\n", "blif", "m")),
                   "X1"));
}

TEST_CASE("a netlist with its test bench") {
    gw::NetlistFileOptions options;
    options.stimuli = text_of(example("rule-5.stim"));
    const gw::Netlist made = netlist("rule-5", "nand");
    const auto verilog = gw::write_netlist(made, "verilog", options);
    REQUIRE(verilog);
    CHECK(contains(verilog.value->bench, "$finish"));
    CHECK(gw::write_netlist(made, "verilog").value->bench.empty());
    CHECK(gw::write_netlist(made, "blif", options).value->bench.empty());
    options.stimuli = "0ms : nowhere=1\n";
    CHECK(contains(refusal(gw::write_netlist(made, "verilog", options)), "nowhere"));
}

TEST_CASE("the gates do what the reference does, under the stimuli of the example") {
    const std::string stimuli = text_of(example("rule-5.stim"));
    const auto expected = gw::run(chart("rule-5"), stimuli);
    REQUIRE(expected);
    CHECK(!expected.value->unstable_at);
    CHECK(contains(expected.value->vcd, "$enddefinitions"));
    const auto got = gw::simulate(netlist("rule-5", "nand"), stimuli);
    REQUIRE(got);
    CHECK(got.value->csv == expected.value->csv);
    CHECK(gw::simulate(netlist("rule-5", "nor"), stimuli).value->csv != expected.value->csv);
    const auto scans = gw::run(chart("rule-5"), stimuli, 40ms);
    const auto clocked = gw::simulate(netlist("rule-5", "clocked"), stimuli, 40ms);
    REQUIRE(scans);
    REQUIRE(clocked);
    CHECK(scans.value->csv == clocked.value->csv);
    CHECK(contains(refusal(gw::simulate(netlist("rule-5", "nand"), stimuli, 40ms)), "no scans"));
    CHECK(contains(refusal(gw::run(chart("rule-5"), stimuli, 0ms)), "positive"));
    CHECK(contains(refusal(gw::run(chart("rule-5"), "0ms : z=1\n")), "text:1:"));
}

TEST_CASE("a verdict, its reports and its witness") {
    const auto good = gw::check(netlist("rule-5", "nand"));
    REQUIRE(good);
    CHECK(good.value->verdict == gw::Verdict::equivalent);
    CHECK(good.value->coverage.cases > 0);
    CHECK(good.value->witness.empty());
    CHECK(contains(good.value->json, "\"verdict\": \"equivalent\""));
    const auto bad = gw::check(netlist("rule-5", "nor"));
    REQUIRE(bad);
    CHECK(bad.value->verdict == gw::Verdict::different);
    CHECK(contains(bad.value->report, "different (style nor, CDX successor)"));
    const auto stim =
        std::find_if(bad.value->witness.begin(), bad.value->witness.end(),
                     [](const gw::NamedText& file) { return file.name == "witness.stim"; });
    REQUIRE(stim != bad.value->witness.end());
    CHECK(gw::run(chart("rule-5"), stim->text).value->csv !=
          gw::simulate(netlist("rule-5", "nor"), stim->text).value->csv);
}

TEST_CASE("a check ends when it is told to") {
    gw::CheckOptions options;
    std::uint64_t asked = 0;
    options.keep_going = [&](const gw::Coverage&) { return ++asked < 3; };
    const auto ended = gw::check(netlist("manipulator", "nand"), options);
    REQUIRE(ended);
    CHECK(ended.value->verdict == gw::Verdict::undecided);
    CHECK(asked >= 3);
    options = {};
    options.max_cases = 5;
    CHECK(gw::check(netlist("manipulator", "nand"), options).value->verdict ==
          gw::Verdict::undecided);
    options = {};
    options.period = 10ms;
    CHECK(contains(refusal(gw::check(netlist("rule-5", "nand"), options)), "no scans"));
}

TEST_CASE("programs: written in every format, and read back where that is possible") {
    const gw::Chart read = chart("manipulator");
    for (const std::string& format : gw::program_formats()) {
        INFO("format: " << format);
        const auto written = gw::write_program(read, format);
        REQUIRE(written);
        CHECK(!written.value->empty());
    }
    CHECK(contains(refusal(gw::write_program(read, "cobol")), "no format 'cobol'"));
    gw::ProgramOptions options;
    options.language = gw::Language::french;
    CHECK(contains(*gw::write_program(read, "st", options).value, "étape"));
    options.modes = false;
    CHECK(!contains(*gw::write_program(read, "st", options).value, "AUdur"));
    const gw::Chart sequence = chart("single-sequence");
    const auto ladder =
        gw::check_ladder(sequence, *gw::write_program(sequence, "plcopen").value, "");
    REQUIRE(ladder);
    CHECK(ladder.value->verdict == gw::Verdict::equivalent);
    CHECK(!gw::check_ladder(sequence, "<project/>", ""));
    const auto listing = [&](const std::string& name, const std::string& cpu) {
        return gw::check_listing(read, text_of(example("s7-200/" + name)),
                                 text_of(example("s7-200/manipulator.io")), cpu);
    };
    CHECK(listing("manipulator.awl", "214").value->verdict == gw::Verdict::equivalent);
    CHECK(listing("manipulator.printed.awl", "214").value->verdict == gw::Verdict::different);
    CHECK(contains(refusal(listing("manipulator.awl", "999")), "no controller '999'"));
}

TEST_CASE("the version is that of the program") {
    CHECK(grafwire_with({"--version"}).out == "grafwire " + gw::version() + "\n");
}

}  // namespace grafwire::testing
