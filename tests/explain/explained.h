#pragma once

#include <string>

#include "check/check_result.h"
#include "explain/explain.h"
#include "support/small_netlists.h"
#include "text/message.h"

namespace grafwire::testing {

/// A chart, a netlist that differs from it, and why.
struct Explained {
    Grafcet grafcet;
    Netlist netlist;
    Witness witness;
    Explanation explanation;

    std::string text(Language language = Language::english, std::size_t most_links = 0) const;
    /// What differs, by name; there must be one of it.
    const Explanation::Part& part(const std::string& name) const;
    /// The identifier of the cause, or empty.
    std::string cause() const;
};

/// The explanation of a difference that the check finds; there must be one.
Explained explained_netlist(const std::string& chart, Netlist netlist,
                            Changes changes = Changes::one);
Explained explained_blif(const std::string& chart, const std::string& blif,
                         Changes changes = Changes::one);
Explained explained_style(const std::string& chart, Style style);

const Explanation::EquationPair& equation(const Explanation::Part& part, const std::string& name);
Logic operand(const Explanation::EquationPair& pair, const std::string& name);

/// Every link but those at which it begins follows from links before it.
void check_chain(const Explanation& explanation);

/// A text with its first `from`, which must be there, replaced.
std::string replaced(std::string text, const std::string& from, const std::string& to);

}  // namespace grafwire::testing
