#pragma once

#include <string_view>

#include "text/message.h"

namespace grafwire::messages::library {

inline constexpr Message<std::string_view, std::string_view> unknown_style{
    "there is no style '{}' (styles: {})", "il n'y a pas de style « {} » (styles : {})"};
inline constexpr Message<std::string_view> no_format_to_read{
    "'{}' is no format to read", "« {} » n'est pas un format qui se lit"};
inline constexpr Message<std::string_view, std::string_view> unknown_format{
    "there is no format '{}' (formats: {})", "il n'y a pas de format « {} » (formats : {})"};
inline constexpr Message<std::string_view> unknown_controller{"there is no controller '{}'",
                                                              "il n'y a pas d'automate « {} »"};
inline constexpr Message<> wrong_period{"a period is positive, and less than 106 days",
                                        "une période est positive, et inférieure à 106 jours"};
inline constexpr Message<> period_without_clock{
    "a period is for clocked netlists: the others have no scans",
    "une période est pour les câblages synchrones : les autres n'ont pas de scrutation"};

}  // namespace grafwire::messages::library
