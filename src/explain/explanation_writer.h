#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "check/witness.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "text/message.h"
#include "text/source.h"

namespace grafwire {

/// What the reference does at the end of a witness: at its last instant, or in the scans since the
/// inputs last changed.
struct ReferenceEnd {
    struct Scan {
        Time at = 0;
        std::vector<TransitionId> cleared;
        BitTable situation;    ///< after it
        bool changes = false;  ///< the situation, or something was cleared
    };
    BitTable before;  ///< the situation before the first of them
    std::vector<Scan> scans;

    /// Whether one of the scans clears a transition.
    bool clears(TransitionId transition) const;
};
/// Runs the reference up to the end of a witness.
ReferenceEnd end_of_reference(const Grafcet& grafcet, const Witness& witness);

/// A witness explained in words, part by part. What the other side did in between is added by its
/// device.
class ExplanationWriter {
  public:
    ExplanationWriter(const Grafcet& grafcet, const Witness& witness, Language language)
        : grafcet_(grafcet), witness_(witness), language_(language) {}

    /// What changes at the last instant.
    void explain_changes();
    /// What the reference makes of it, scan by scan.
    void explain_reference();
    /// Where the two sides part; `other_side`: "the netlist".
    void explain_difference(const Message<>& other_side);

    /// A network of a program: `network 49 (Forcing), line 187`; the comment may be empty and the
    /// line unknown.
    std::string network_text(std::uint32_t number, const std::string& comment,
                             Location where) const;

    void add(std::string_view text) { text_ += text; }
    /// A sentence of the catalogue, in the language of the explanation.
    template <class... Arguments>
    void say(const Message<Arguments...>& message,
             const std::type_identity_t<Arguments>&... arguments) {
        text_ += message.in(language_, arguments...);
    }
    Language language() const { return language_; }
    std::string take() { return std::move(text_); }

  private:
    void explain_scan(const ReferenceEnd::Scan& scan, std::size_t number);
    std::string situation_text(const BitTable& situation) const;

    const Grafcet& grafcet_;
    const Witness& witness_;
    Language language_;
    std::string text_;
};

}  // namespace grafwire
