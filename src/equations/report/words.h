#pragma once

#include <array>
#include <string_view>

#include "text/language.h"

namespace grafwire {

/// What the reports on equations say, in one language.
struct Words {
    std::string_view title;  ///< before the name of the GRAFCET
    std::string_view successor_form;
    std::string_view transition_form;
    std::string_view with_modes;
    std::string_view without_modes;
    std::string_view conditions;
    std::string_view step;
    std::string_view steps;
    std::string_view outputs;
    std::string_view stored;
    std::string_view variable;
    std::string_view set;
    std::string_view reset;
    std::string_view counters;
    std::string_view counter;
    std::string_view range;
    std::string_view when;
    std::string_view write;
    std::string_view time_conditions;
    std::string_view time_condition;
    std::string_view operand;
    std::string_view on_after;
    std::string_view off_after;
    std::string_view edges;
    std::string_view edge;
    std::string_view karnaugh;
    std::string_view group;
    std::string_view covers;
    std::string_view cells;
    std::string_view smaller;
    std::string_view remark;
    /// Per row of the truth table of X, in the order of X, CAX, CDX counted in binary.
    std::array<std::string_view, 8> remarks;
};

const Words& words(Language language);

}  // namespace grafwire
