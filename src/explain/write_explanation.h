#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "check/witness.h"
#include "explain/explain.h"
#include "grafcet/grafcet.h"
#include "netlist/netlist.h"
#include "text/message.h"

namespace grafwire {

/// The identifier of a cause, for programs; it does not change: `two-step-loop`.
std::string_view identifier_of(CauseKind kind);

/// What happens, as a sentence.
std::string cause_text(const Cause& cause, Language language);

/// How an explanation is written.
struct ExplanationOptions {
    Language language = Language::english;
    /// Of the causal chain through the gates this many links, the last ones, with a hint that
    /// witness.txt has the others; 0: all.
    std::size_t most_links = 0;
    std::string source;  ///< the file that the netlist was read from, if it was
};

/// The explanation of a witness in words: what changes at the last instant, which transitions the
/// reference clears, where the two sides part, and the explanation.
std::string write_explanation(const Grafcet& grafcet, const Netlist& netlist,
                              const Witness& witness, const Explanation& explanation,
                              const ExplanationOptions& options);

}  // namespace grafwire
