#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grafcet/grafcet.h"
#include "text/diagnostics.h"

namespace grafwire {

/// What a receptivity is to get besides.
struct AddedCondition {
    TransitionId transition{};
    std::string text;      ///< as the language writes it
    bool is_product_term;  ///< it stands beside a `.` without parentheses
};

/// The text of a chart without errors in which receptivities hold further conditions; all else
/// stands as it was written. Several of one transition are added in their order.
std::string with_added_conditions(const SourceFile& source, const Grafcet& grafcet,
                                  const std::vector<AddedCondition>& conditions);

}  // namespace grafwire
