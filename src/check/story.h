#pragma once

#include <string>
#include <string_view>

#include "check/witness.h"
#include "evolution/evolution.h"
#include "grafcet/grafcet.h"
#include "text/language.h"

namespace grafwire {

/// A witness in words, part by part; what the other side did in between is told by whoever knows
/// it.
class Story {
  public:
    Story(const Grafcet& grafcet, const Witness& witness, Language language)
        : grafcet_(grafcet), witness_(witness), french_(language == Language::french) {}

    /// What changes at the last instant.
    void tell_changes();
    /// What the reference makes of it, scan by scan.
    void tell_reference();
    /// Where the two sides part; `other_side`: "the netlist".
    void tell_difference(std::string_view other_side);

    void add(std::string_view text) { text_ += text; }
    std::string_view choose(std::string_view english, std::string_view french) const {
        return french_ ? french : english;
    }
    Language language() const { return french_ ? Language::french : Language::english; }
    std::string take() { return std::move(text_); }

  private:
    void follow_instants(const Evolution& evolution);
    void follow_scans(const Evolution& evolution);
    bool tell_scan(const Evolution& evolution, EvolutionState& state, const InputValues& inputs,
                   Time at, const std::string& label);
    std::string situation_text(const BitTable& situation) const;
    std::string transition_text(TransitionId id) const;

    const Grafcet& grafcet_;
    const Witness& witness_;
    bool french_;
    std::string text_;
};

}  // namespace grafwire
