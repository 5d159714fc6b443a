// The reports in LaTeX as pdflatex sets them: no error, and nothing wider or taller than the page.

#include <fmt/format.h>

#include "equations/parsed.h"
#include "random/random_cases.h"
#include "random/random_grafcet.h"
#include "random/random_source.h"
#include "support/chart_files.h"
#include "support/tool_runner.h"
#include "text/utf8.h"

namespace grafwire::testing {

namespace {

constexpr Language languages[] = {Language::english, Language::french};

std::string report(const Grafcet& grafcet, const EquationOptions& options, bool karnaugh,
                   Language language, bool standalone) {
    return write_equations(grafcet, equations_from(grafcet, options),
                           {EquationFormat::latex, karnaugh, language, standalone});
}

/// The report on a chart in every form, one after the other, as fragments.
std::string all_forms(const std::string& chart, Language language) {
    const Grafcet grafcet = parsed(chart);
    std::string text;
    for (const CdxForm cdx : {CdxForm::successor, CdxForm::transition}) {
        for (const bool modes : {true, false}) {
            for (const bool karnaugh : {false, true}) {
                text += report(grafcet, {cdx, modes}, karnaugh, language, false) + "\\clearpage\n";
            }
        }
    }
    return text;
}

/// A document of these fragments: what a whole document begins with, then they.
std::string document_of(const std::string& fragments, Language language) {
    const std::string whole =
        report(parsed("graph G { initial 0 }"), without_modes, false, language, true);
    const std::string begin = "\\begin{document}\n";
    std::string head = whole.substr(0, whole.find(begin) + begin.size());
    if (language == Language::french) head += "\\shorthandoff{:;!?}\n";
    return head + fragments + "\\end{document}\n";
}

/// What pdflatex finds wrong with a document; empty where nothing is.
std::string faults_of(const std::string& document) {
    ToolRunner runner;
    runner.write("report.tex", document);
    const ToolRunner::Result result = runner.run(
        "pdflatex -interaction=nonstopmode -halt-on-error report.tex >messages; "
        "grep -a -A 3 -e '^!' -e Overfull report.log");
    constexpr int nothing_found = 1;
    if (result.status == nothing_found) return "";
    return fmt::format("status {}\n{}", result.status, result.output);
}

/// A name of any characters that a name may hold, some of which LaTeX reads in its own way.
std::string random_long_name(RandomSource& random, std::size_t most) {
    static const std::vector<std::string> parts{
        "a", "m", "W", "M", "i",  "7", "é", "Ç", "_",  "%", "&", "#", "$", "{", "}", "~",
        "^", "<", ">", "|", "\\", "'", "`", "-", ",",  ":", ";", "!", "?", "/", "[", "]",
        "θ", "Δ", "µ", "°", "½",  "œ", "€", "→", "日", "ł", "*", "=", "+", " "};
    std::string name;
    const std::size_t length = 1 + random.below(most);
    for (std::size_t i = 0; i < length; ++i) {
        const bool is_plain = random.below(3) > 0;
        name += is_plain ? parts[random.below(9)] : parts[random.below(parts.size())];
    }
    return name;
}

/// A chart with something of everything, whose names are such ones.
std::string chart_with_long_names(RandomSource& random) {
    std::vector<std::string> name;
    for (std::size_t i = 0; i < 8; ++i) {
        const std::size_t most = random.below(2) == 0 ? 12 : 90;
        name.push_back(fmt::format("\"{}{}\"", random_long_name(random, most), i));
    }
    const std::string step = fmt::format("{}s", name[5].substr(0, name[5].size() - 1));
    return fmt::format(
        "grafcet g {0}\n"
        "input {1}, {2}, {3}\noutput {4}, {0}\ncounter {5} : -30000..30000\n"
        "graph G {{\n"
        "initial {6}\n"
        "step 1 : {4} if /({1}.{2} + {2}.{3} + {1}.{3}), set {0}\n"
        "step 2 : reset {0} on deactivation\n"
        "{6} -> 1 : /({1} + {2} + /({2}.{3} + {1})) . ↑{1} . [{5} + {5} < 12] do {5} := {5} + 1\n"
        "{6} -> 2 : {1}.{2} + /{2}.{3} + {1} ⊕ {3} + ↓({2} + {3})\n"
        "1 -> {6} : 2.5s/({2} + {3})/20ms + /{1}\n"
        "2 -> {6} : {3} . /({1} . 90ms/{2})\n"
        "}}\n",
        name[0], name[1], name[2], name[3], name[4], name[6], step + "\"");
}

}  // namespace

TEST_CASE("the examples in all forms, as fragments of a document") {
    for (const Language language : languages) {
        std::string fragments;
        for (const ChartFiles& example : example_charts()) {
            fragments += all_forms(example.chart, language);
        }
        CHECK(faults_of(document_of(fragments, language)) == "");
    }
}

TEST_CASE("the examples as documents of their own") {
    bool in_french = false;
    for (const ChartFiles& example : example_charts()) {
        INFO(example.name);
        const Language language = in_french ? Language::french : Language::english;
        CHECK(faults_of(report(parsed(example.chart), with_modes, true, language, true)) == "");
        in_french = !in_french;
    }
}

TEST_CASE("random charts") {
    std::string fragments;
    const std::size_t count = case_count(24);
    for (std::size_t i = 0; i < count; ++i) {
        RandomSource random(950'000 + i);
        const Features features;
        fragments += all_forms(random_grafcet(random, features), languages[i % 2]);
    }
    CHECK(faults_of(document_of(fragments, Language::english)) == "");
}

TEST_CASE("names that are long or made of signs") {
    const std::size_t count = case_count(12);
    for (const Language language : languages) {
        std::string fragments;
        for (std::size_t i = 0; i < count; ++i) {
            RandomSource random(960'000 + i);
            fragments += all_forms(chart_with_long_names(random), language);
        }
        CHECK(faults_of(document_of(fragments, language)) == "");
    }
}

TEST_CASE("a sum of a thousand terms, an equation of many pages") {
    std::string chart = "input a, b\ngraph G {\ninitial 0\nstep 1\n1 -> 0 : b\n";
    for (int i = 0; i < 1000; ++i) chart += "0 -> 1 : a . /b\n";
    chart += "}\n";
    const std::string fragment = report(parsed(chart), with_modes, true, Language::english, false);
    CHECK(faults_of(document_of(fragment, Language::english)) == "");
}

}  // namespace grafwire::testing
