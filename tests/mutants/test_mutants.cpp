// Does the check find wrong wiring? Every netlist of every example gets one mistake at a time. The
// verdict must be "different", with a witness that shows it again, or "equivalent" after complete
// exploration (some mistakes make no difference: a gate that only orders signals in time, a memory
// that Init sets anyway, a condition that another implies). Nothing bounds the exploration.

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "grafcet/parse_grafcet.h"
#include "mutants/mutate.h"
#include "netlist/netlist_from.h"
#include "random/read_text.h"
#include "slow_build.h"

namespace grafwire::testing {

namespace {

constexpr std::size_t sparser = test::is_slow_build ? 14 : 1;

/// How the mutants of a netlist are dealt with where looking at all of them would take too long.
struct Sampling {
    std::size_t every = 1;          ///< every so many mutants, from the first on
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

struct Counts {
    std::size_t mutants = 0;
    std::size_t tried = 0;
    std::size_t different = 0;
    std::size_t equivalent = 0;
};

std::optional<Netlist> netlist_in(const Grafcet& grafcet, Style style) {
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    Equations equations = equations_from(grafcet, {cdx, true});
    Diagnostics diagnostics;
    return netlist_from(equations, style, diagnostics);
}

CheckResult checked(const Grafcet& grafcet, const Netlist& netlist) {
    return check_equivalence(grafcet, netlist, unit_delays(netlist), {});
}

void try_mutant(const Grafcet& grafcet, const Netlist& netlist, const Mutation& mutation,
                Counts& counts) {
    const Netlist wrong = mutated(netlist, mutation);
    INFO(describe(netlist, mutation));
    REQUIRE(fault_of(wrong) == "");
    const CheckResult result = checked(grafcet, wrong);
    ++counts.tried;
    switch (result.verdict) {
        case Verdict::different:
            ++counts.different;
            REQUIRE(result.witness);
            CHECK(replay(grafcet, with_power_up(wrong, result.witness->power_up),
                         unit_delays(wrong), result.witness->stimuli,
                         result.witness->scan_period));
            break;
        case Verdict::equivalent:
            ++counts.equivalent;
            CHECK(result.complete);
            break;
        case Verdict::undecided:
            FAIL_CHECK("undecided without a bound");
            break;
    }
}

/// One line of the table.
std::string try_mutants(const std::string& example, const std::string& text, Style style) {
    const std::string_view style_name = style_table[static_cast<std::size_t>(style)].name;
    const std::string head = fmt::format("{:<22}{:<9}", example, style_name);
    const Sampling sampling = sampling_for(example, style);
    std::optional<Grafcet> grafcet = read_grafcet(text);
    REQUIRE(grafcet);
    if (sampling.controls_at_rest) {
        Diagnostics diagnostics;
        parse_assumption({"at rest", "/Init . /AUdur . /AUdoux"}, *grafcet, diagnostics);
        REQUIRE_FALSE(diagnostics.has_errors());
    }
    const auto netlist = netlist_in(*grafcet, style);
    if (!netlist) return head + "refused by the style\n";
    const Verdict base = checked(*grafcet, *netlist).verdict;
    if (base == Verdict::different) return head + "different itself, no mutants\n";
    CHECK(base == Verdict::equivalent);

    INFO(example << " as " << style_name);
    Counts counts;
    const std::vector<Mutation> mutations = mutations_of(*netlist);
    counts.mutants = mutations.size();
    for (std::size_t i = 0; i < mutations.size(); i += sampling.every) {
        try_mutant(*grafcet, *netlist, mutations[i], counts);
    }
    CHECK(counts.different != 0);
    return head + fmt::format("{:>7}{:>7}{:>10}{:>11}  {}\n", counts.mutants, counts.tried,
                              counts.different, counts.equivalent,
                              sampling.controls_at_rest ? "Init, AUdur, AUdoux at 0" : "");
}

}  // namespace

TEST_CASE("the check finds wrong wiring of the examples") {
    std::map<std::string, std::string> texts;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(GRAFWIRE_ROOT) + "/examples")) {
        if (entry.path().extension() != ".grafcet") continue;
        std::ifstream file(entry.path(), std::ios::binary);
        std::stringstream text;
        text << file.rdbuf();
        texts[entry.path().stem().string()] = text.str();
    }
    REQUIRE(texts.size() == 13);
    // Row by row as they come: the whole takes minutes.
    fmt::print("{:<31}{:>7}{:>7}{:>10}{:>11}\n", "", "mutants", "tried", "different", "equivalent");
    for (const auto& [name, text] : texts) {
        for (const Style style : {Style::gates, Style::nand, Style::nor, Style::clocked}) {
            fmt::print("{}", try_mutants(name, text, style));
            std::fflush(stdout);
        }
    }
}

}  // namespace grafwire::testing
