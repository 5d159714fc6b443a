// Does the check find wrong wiring? Every netlist of every example gets one mistake at a time. The
// verdict must be "different", with a witness that shows it again, or "equivalent" after complete
// exploration (some mistakes make no difference: a gate that only orders signals in time, a memory
// that Init sets anyway, a condition that another implies). Nothing bounds the exploration.

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <fmt/format.h>

#include <cstdio>
#include <map>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "grafcet/parse_grafcet.h"
#include "netlist/styles/styles.h"
#include "random/read_text.h"
#include "support/files.h"
#include "support/mutate.h"
#include "support/reviewed_file.h"
#include "support/slow_build.h"
#include "support/styles.h"

namespace grafwire::testing {

namespace {

constexpr const char* file_name = "mutants/no_difference.txt";
constexpr std::size_t sparser = is_slow_build ? 14 : 1;

/// How the mutants of a netlist are dealt with where looking at all of them would take too long.
struct Sampling {
    std::size_t every = 1;          ///< of this many mutants one, from the first on
    bool controls_at_rest = false;  ///< with `assume /Init . /AUdur . /AUdoux`
};

/// In the clocked style counters and edges multiply the states: with the control inputs the larger
/// examples take from 250 000 to several million cases each, so they are left at 0 there.
Sampling sampling_for(const std::string& example, Style style) {
    static const std::map<std::string, std::size_t> clocked{
        {"batch-counter", 347},     // 32 000 cases
        {"level-crossing", 997},    // 142 000 cases
        {"manipulator", 1},         // 400 cases
        {"manipulator-modes", 61},  // 24 000 cases
        {"nine-steps", 1},          // 250 cases
        {"positioning-axis", 5},    // 2 000 cases
        {"press", 67},              // 9 000 cases
    };
    static const std::map<std::string, std::size_t> asynchronous{
        {"manipulator", 5},  // 21 000 cases
        {"manipulator-modes", 23},
        {"nine-steps", 5},  // 34 000 cases
        {"positioning-axis", 23},
    };
    const auto& table = style == Style::clocked ? clocked : asynchronous;
    const auto found = table.find(example);
    if (found == table.end()) return {sparser, false};
    return {found->second * sparser, style == Style::clocked};
}

/// What came out for a netlist; one line of the reviewed file.
struct Row {
    std::string head;    ///< example and style
    std::string remark;  ///< instead of numbers
    std::size_t mutants = 0;
    std::size_t tried = 0;
    std::vector<std::size_t> equivalent;  ///< the numbers of the mutants that make no difference
};

std::string text_of(const Row& row) {
    if (!row.remark.empty()) return row.head + row.remark + "\n";
    return fmt::format("{}{:>7}{:>7}{:>10}{:>11} :{}{}\n", row.head, row.mutants, row.tried,
                       row.tried - row.equivalent.size(), row.equivalent.size(),
                       row.equivalent.empty() ? "" : " ", fmt::join(row.equivalent, " "));
}

/// Of the numbers that a line of the reviewed file ends with, those that this build tries.
std::vector<std::size_t> expected_of(const std::string& line, std::size_t every) {
    std::istringstream numbers(line.substr(std::min(line.size(), line.find(':') + 1)));
    std::vector<std::size_t> expected;
    for (std::size_t number = 0; numbers >> number;) {
        if (number % every == 0) expected.push_back(number);
    }
    return expected;
}

std::optional<Netlist> netlist_in(const Grafcet& grafcet, Style style) {
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    const Equations equations = equations_from(grafcet, {cdx, true});
    Diagnostics diagnostics;
    return netlist_from(grafcet, equations, style, diagnostics);
}

CheckResult checked(const Grafcet& grafcet, const Netlist& netlist) {
    CheckOptions options;
    options.looks_at_many = false;
    return check_equivalence(grafcet, netlist, options);
}

/// Whether the mutant is different.
bool try_mutant(const Grafcet& grafcet, const Netlist& netlist, const Mutation& mutation) {
    const Netlist wrong = mutated(netlist, mutation);
    INFO(describe(netlist, mutation));
    REQUIRE(fault_of(wrong) == "");
    const CheckResult result = checked(grafcet, wrong);
    switch (result.verdict) {
        case Verdict::different:
            REQUIRE(result.witness);
            CHECK(replay(grafcet, with_power_up(wrong, result.witness->power_up),
                         cell_delays(wrong, {}), result.witness->stimuli,
                         result.witness->scan_period));
            return true;
        case Verdict::equivalent:
            CHECK(result.complete);
            break;
        case Verdict::undecided:
            FAIL_CHECK("undecided without a bound");
            break;
    }
    return false;
}

Row try_mutants(const std::string& example, const std::string& text, Style style) {
    const std::string_view style_name = style_table[static_cast<std::size_t>(style)].name;
    Row row;
    row.head = fmt::format("{:<22}{:<10}", example, style_name);
    const Sampling sampling = sampling_for(example, style);
    std::optional<Grafcet> grafcet = read_grafcet(text);
    REQUIRE(grafcet);
    if (sampling.controls_at_rest) {
        Diagnostics diagnostics;
        parse_assumption({"at rest", "/Init . /AUdur . /AUdoux"}, *grafcet, diagnostics);
        REQUIRE_FALSE(diagnostics.has_errors());
    }
    const auto netlist = netlist_in(*grafcet, style);
    if (!netlist) {
        row.remark = "refused by the style";
        return row;
    }
    const Verdict base = checked(*grafcet, *netlist).verdict;
    if (base == Verdict::different) {
        row.remark = "different itself, no mutants";
        return row;
    }
    CHECK(base == Verdict::equivalent);

    INFO(example << " as " << style_name);
    const std::vector<Mutation> mutations = mutations_of(*netlist);
    row.mutants = mutations.size();
    for (std::size_t i = 0; i < mutations.size(); i += sampling.every) {
        ++row.tried;
        if (!try_mutant(*grafcet, *netlist, mutations[i])) row.equivalent.push_back(i);
    }
    CHECK(row.equivalent.size() < row.tried);
    return row;
}

}  // namespace

TEST_CASE("the check finds wrong wiring of the examples") {
    std::map<std::string, std::string> texts;
    for (const std::string& name : example_names()) {
        texts[name] = example_text(name + ".grafcet");
    }
    REQUIRE(texts.size() == 13);
    const std::vector<std::string> reviewed = reviewed_lines(file_name);
    std::string table = fmt::format("{:<32}{:>7}{:>7}{:>10}{:>11}\n", "", "mutants", "tried",
                                    "different", "equivalent");
    std::size_t line = 0;
    for (const auto& [name, text] : texts) {
        for (const Style style : all_styles()) {
            const Row row = try_mutants(name, text, style);
            table += text_of(row);
            // Row by row as they come: the whole takes minutes.
            fmt::print("{}", text_of(row));
            std::fflush(stdout);
            ++line;
            if (renews_reviewed_files()) continue;
            REQUIRE(line < reviewed.size());
            CHECK(row.equivalent == expected_of(reviewed[line], sampling_for(name, style).every));
        }
    }
    // Fewer are tried in a slow build.
    if (!is_slow_build) check_reviewed(file_name, table);
}

}  // namespace grafwire::testing
