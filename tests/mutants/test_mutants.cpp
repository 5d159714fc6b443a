// Does the check find wrong wiring? Every netlist of every example gets one mistake at a time. The
// verdict must be "different", with a witness that shows it again, or "equivalent" after complete
// exploration (some mistakes make no difference: a gate that only orders signals in time, a memory
// that Init sets anyway, a condition that another implies).

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "check/check_equivalence.h"
#include "mutants/mutate.h"
#include "netlist/netlist_from.h"
#include "random/read_text.h"

namespace grafwire::testing {

namespace {

/// How the mutants of a netlist are dealt with where looking at all of them would take too long.
struct Sampling {
    std::size_t every = 1;        ///< every so many mutants, from the first on
    std::uint64_t max_cases = 0;  ///< then "undecided"; 0: none may be undecided
};

Sampling sampling_for(const std::string& example, Style style) {
    // Counters multiply the states: one exploration of these takes 300 000 cases and more.
    static const std::map<std::string, Sampling> large{
        {"batch-counter", {151, 20'000}},
        {"level-crossing", {197, 20'000}},
        {"manipulator-modes", {31, 20'000}},
        {"positioning-axis", {23, 20'000}},
        {"press", {67, 20'000}},
    };
    // Between 20 000 and 35 000 cases.
    static const std::map<std::string, Sampling> medium{
        {"manipulator", {3, 0}},
        {"nine-steps", {3, 0}},
    };
    if (style == Style::clocked) {
        if (const auto found = large.find(example); found != large.end()) return found->second;
    }
    if (const auto found = medium.find(example); found != medium.end()) return found->second;
    return {};
}

struct Counts {
    std::size_t mutants = 0;
    std::size_t tried = 0;
    std::size_t different = 0;
    std::size_t equivalent = 0;
    std::size_t undecided = 0;
};

std::optional<Netlist> netlist_in(const Grafcet& grafcet, Style style) {
    const CdxForm cdx = style_table[static_cast<std::size_t>(style)].default_cdx;
    Equations equations = equations_from(grafcet, {cdx, true});
    Diagnostics diagnostics;
    return netlist_from(equations, style, diagnostics);
}

CheckResult checked(const Grafcet& grafcet, const Netlist& netlist, std::uint64_t max_cases) {
    CheckOptions options;
    options.max_cases = max_cases;
    return check_equivalence(grafcet, netlist, unit_delays(netlist), options);
}

void try_mutant(const Grafcet& grafcet, const Netlist& netlist, const Mutation& mutation,
                const Sampling& sampling, Counts& counts) {
    const Netlist wrong = mutated(netlist, mutation);
    INFO(describe(netlist, mutation));
    REQUIRE(fault_of(wrong) == "");
    const CheckResult result = checked(grafcet, wrong, sampling.max_cases);
    ++counts.tried;
    switch (result.verdict) {
        case Verdict::different:
            ++counts.different;
            REQUIRE(result.witness);
            CHECK(replay(grafcet, wrong, unit_delays(wrong), result.witness->stimuli));
            break;
        case Verdict::equivalent:
            ++counts.equivalent;
            CHECK(result.complete);
            break;
        case Verdict::undecided:
            ++counts.undecided;
            CHECK(sampling.max_cases != 0);
            CHECK(result.impossible_timings == 0);
            break;
    }
}

/// One line of the table.
std::string try_mutants(const std::string& example, const Grafcet& grafcet, Style style) {
    const std::string head =
        fmt::format("{:<22}{:<9}", example, style_table[static_cast<std::size_t>(style)].name);
    const auto netlist = netlist_in(grafcet, style);
    if (!netlist) return head + "refused by the style\n";
    const Sampling sampling = sampling_for(example, style);
    const CheckResult base = checked(grafcet, *netlist, sampling.max_cases);
    if (base.verdict == Verdict::different) return head + "different itself, no mutants\n";
    const bool may_be_undecided = sampling.max_cases != 0;
    CHECK((base.verdict == Verdict::equivalent || may_be_undecided));

    INFO(example << " as " << style_table[static_cast<std::size_t>(style)].name);
    Counts counts;
    const std::vector<Mutation> mutations = mutations_of(*netlist);
    counts.mutants = mutations.size();
    for (std::size_t i = 0; i < mutations.size(); i += sampling.every) {
        try_mutant(grafcet, *netlist, mutations[i], sampling, counts);
    }
    CHECK(counts.different != 0);
    return head + fmt::format(
                      "{:>7}{:>7}{:>10}{:>11}{:>10}  {}\n", counts.mutants, counts.tried,
                      counts.different, counts.equivalent, counts.undecided,
                      may_be_undecided ? fmt::format("bound of {} cases", sampling.max_cases) : "");
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
    fmt::print("{:<31}{:>7}{:>7}{:>10}{:>11}{:>10}\n", "", "mutants", "tried", "different",
               "equivalent", "undecided");
    for (const auto& [name, text] : texts) {
        const auto grafcet = read_grafcet(text);
        REQUIRE(grafcet);
        for (const Style style : {Style::gates, Style::nand, Style::nor, Style::clocked}) {
            fmt::print("{}", try_mutants(name, *grafcet, style));
            std::fflush(stdout);
        }
    }
}

}  // namespace grafwire::testing
