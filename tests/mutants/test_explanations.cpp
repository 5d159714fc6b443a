// Is a mistake explained? Every netlist of the small examples gets one mistake at a time; where
// that makes a difference, the explanation must hold together: something is wrong, the way there is
// whole, and mostly the wrong equation is named.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "check/check_equivalence.h"
#include "check/netlist_witness.h"
#include "explain/explain.h"
#include "explain/write_explanation.h"
#include "netlist/styles/styles.h"
#include "random/read_text.h"
#include "support/files.h"
#include "support/mutate.h"
#include "support/slow_build.h"

namespace grafwire::testing {

namespace {

constexpr std::size_t every = is_slow_build ? 41 : 3;

struct Counts {
    std::size_t different = 0;
    std::size_t named = 0;  ///< with a wrong equation or priority that shows
    std::map<std::string, std::size_t> causes;
};

/// Every link follows from links before it.
bool is_whole(const Explanation& explanation) {
    std::vector<std::string> changed;
    for (const Explanation::Link& link : explanation.chain) {
        for (const std::string& cause : link.causes) {
            if (std::find(changed.begin(), changed.end(), cause) == changed.end()) return false;
        }
        changed.push_back(link.net);
    }
    return true;
}

void explain_mutant(const Grafcet& grafcet, const Netlist& netlist, const Mutation& mutation,
                    Counts& counts) {
    const Netlist wrong = mutated(netlist, mutation);
    const CellDelays delays = cell_delays(wrong, {});
    const CheckResult result = check_equivalence(grafcet, wrong, {});
    if (!result.witness) return;
    ++counts.different;
    const Explanation explanation = explain(grafcet, wrong, delays, *result.witness);
    const std::string what = describe(netlist, mutation);
    CHECK_MESSAGE(is_whole(explanation), what);
    const bool must_have_parts = result.witness->kind != DifferenceKind::oscillation;
    CHECK_MESSAGE((!must_have_parts || !explanation.parts.empty()), what);
    const bool is_named =
        std::any_of(explanation.parts.begin(), explanation.parts.end(),
                    [](const Explanation::Part& part) { return part.decided_at.has_value(); });
    if (is_named) ++counts.named;
    if (explanation.cause) {
        ++counts.causes[std::string(identifier_of(explanation.cause->kind))];
        // Known causes are for wiring with the right equations.
        CHECK_MESSAGE((!is_named || explanation.cause->kind == CauseKind::reset_priority), what);
    }
    for (const Language language : {Language::english, Language::french}) {
        const std::string text =
            write_explanation(grafcet, wrong, *result.witness, explanation, {language, 0, {}});
        CHECK_MESSAGE(text.find('{') == std::string::npos, what);
    }
}

}  // namespace

TEST_CASE("mistakes in the small examples are explained") {
    Counts counts;
    // Gates that wait for one another have no CAX and CDX of their own to be named.
    Counts of_handshake;
    for (const std::string name :
         {"single-sequence", "selection-divergence", "selection-convergence", "parallel-divergence",
          "parallel-convergence", "rule-5"}) {
        const auto grafcet = read_grafcet(example_text(name + ".grafcet"));
        REQUIRE(grafcet);
        for (const StyleRow& style : style_table) {
            const Equations equations = equations_from(*grafcet, {style.default_cdx, true});
            Diagnostics diagnostics;
            const auto netlist = netlist_from(*grafcet, equations, style.style, diagnostics);
            if (!netlist) {
                CHECK((style.refuse != nullptr));
                continue;
            }
            const std::vector<Mutation> mutations = mutations_of(*netlist);
            for (std::size_t i = 0; i < mutations.size(); i += every) {
                explain_mutant(*grafcet, *netlist, mutations[i],
                               style.style == Style::handshake ? of_handshake : counts);
            }
        }
    }
    std::string causes;
    for (const auto& [name, count] : counts.causes) causes += fmt::format(" {}: {}", name, count);
    MESSAGE(counts.different << " different, " << counts.named << " with the wrong equation named;"
                             << causes);
    CHECK(counts.named * 10 > counts.different * 7);
}

}  // namespace grafwire::testing
