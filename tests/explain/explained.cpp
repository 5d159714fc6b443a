#include "explain/explained.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "check/check_equivalence.h"
#include "check/compare_ports.h"
#include "explain/write_explanation.h"
#include "formats/blif/read_blif.h"

namespace grafwire::testing {

std::string Explained::text(Language language, std::size_t most_links) const {
    return write_explanation(grafcet, netlist, witness, explanation, {language, most_links, {}});
}

const Explanation::Part& Explained::part(const std::string& name) const {
    const auto found = std::find_if(explanation.parts.begin(), explanation.parts.end(),
                                    [&](const auto& part) { return part.name == name; });
    REQUIRE(found != explanation.parts.end());
    return *found;
}

std::string Explained::cause() const {
    return explanation.cause ? std::string(identifier_of(explanation.cause->kind)) : "";
}

Explained explained_netlist(const std::string& chart, Netlist netlist, Changes changes) {
    Grafcet grafcet = grafcet_of(chart);
    const CellDelays delays = cell_delays(netlist, {});
    CheckOptions options;
    options.changes = changes;
    const CheckResult result = check_equivalence(grafcet, netlist, options);
    REQUIRE(result.witness);
    Explanation explanation = explain(grafcet, netlist, delays, *result.witness);
    return {std::move(grafcet), std::move(netlist), *result.witness, std::move(explanation)};
}

Explained explained_blif(const std::string& chart, const std::string& blif, Changes changes) {
    Diagnostics diagnostics;
    auto netlist = read_blif({"wiring.blif", blif}, diagnostics);
    REQUIRE(netlist);
    adopt_ports(grafcet_of(chart), *netlist);
    return explained_netlist(chart, std::move(*netlist), changes);
}

Explained explained_style(const std::string& chart, Style style) {
    return explained_netlist(chart, netlist_of(grafcet_of(chart), style));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

const Explanation::EquationPair& equation(const Explanation::Part& part, const std::string& name) {
    const auto found = std::find_if(part.equations.begin(), part.equations.end(),
                                    [&](const auto& pair) { return pair.name == name; });
    REQUIRE(found != part.equations.end());
    return *found;
}

Logic operand(const Explanation::EquationPair& pair, const std::string& name) {
    const auto found = std::find_if(pair.operands.begin(), pair.operands.end(),
                                    [&](const auto& item) { return item.name == name; });
    REQUIRE(found != pair.operands.end());
    return found->value;
}

void check_chain(const Explanation& explanation) {
    REQUIRE_FALSE(explanation.chain.empty());
    CHECK(explanation.chain.front().is_begin);
    std::vector<std::string> changed;
    for (const Explanation::Link& link : explanation.chain) {
        for (const std::string& cause : link.causes) {
            CHECK(std::find(changed.begin(), changed.end(), cause) != changed.end());
        }
        changed.push_back(link.net);
    }
}

}  // namespace grafwire::testing
